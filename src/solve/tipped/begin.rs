//! How a cut is begun: pierced, at the end of a chain, or on a kerf if the contour of that kerf has been cut before.
//!
//! However a cut is begun, it ends at the same place (`problem::Start`). So the quickest way that is there by then is the best one, whatever
//! comes after it.

use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{ItemId, NodeId, Problem, Start};
use crate::solve::traits::Stop;

/// Where the head is before a cut: its place, and the node that it has left.
#[derive(Clone, Copy)]
pub(super) struct Head {
    pub(super) at: DVec2,
    pub(super) left: Option<NodeId>,
}

/// The quickest way to begin the cut of a node that is entered at `entry`, and its seconds: a start without piercing, or `None` for a chain if there is
/// one, otherwise a move with the beam off. `is_cut`: whether an item has been cut before.
pub(super) fn begin(
    problem: &Problem,
    air: &AirTime,
    head: Head,
    (node, entry): (NodeId, DVec2),
    is_cut: impl Fn(ItemId) -> bool,
) -> (Option<Start>, f64) {
    let link = head.left.and_then(|left| problem.links.between(left, node));
    let plain = link.map_or_else(|| air.seconds(head.at, entry), |link| link.seconds);
    let mut best = (None, plain);
    for start in problem.starts.of(node).iter().filter(|s| s.kerf.is_none_or(&is_cut)) {
        let seconds = air.seconds(head.at, start.from) + start.seconds;
        if seconds < best.1 {
            best = (Some(*start), seconds);
        }
    }
    best
}

/// How each cut of a sequence of stops is begun, if not pierced or joined to the one before it.
pub fn begun(problem: &Problem, stops: &[Stop]) -> Vec<Option<Start>> {
    if problem.starts.is_empty() {
        return Vec::new();
    }
    let air = AirTime::new(&problem.machine);
    let mut head = Head { at: problem.home, left: None };
    let mut cut = vec![false; problem.items.len()];
    let start = |stop: &Stop| {
        let (entry, exit) = stop.ends(problem)?;
        let is_cut = |item: ItemId| cut.get(item as usize).is_some_and(|c| *c);
        let start = begin(problem, &air, head, (stop.node, entry), is_cut).0;
        head = Head { at: exit, left: Some(stop.node) };
        let item = problem.nodes.get(stop.node as usize)?.item;
        if let Some(cut) = cut.get_mut(item as usize) {
            *cut = true;
        }
        start
    };
    stops.iter().map(start).collect()
}
