//! How a cut is begun: pierced, at the end of a chain, or on a kerf if the contour of that kerf has been cut before.
//!
//! A contour may have several nodes that leave it at the same place and differ only in how the cut begins (`problem::Starts`). What comes after
//! it is the same for all of them, so the quickest one that is allowed is the best one, whatever the order.

use crate::geometry::DVec2;
use crate::machine::{AirTime, PLANS_ALL_LEVERS};
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::traits::{Solution, Stop};

/// Where the head is before a cut: its place, and the node that it has left.
#[derive(Clone, Copy)]
pub(super) struct Head {
    pub(super) at: DVec2,
    pub(super) left: Option<NodeId>,
}

/// Seconds of the way to a node that is entered at `entry`: a chain if there is one, otherwise a move with the beam off.
pub(super) fn travel(problem: &Problem, air: &AirTime, head: Head, node: NodeId, entry: DVec2) -> f64 {
    let link = head.left.and_then(|left| problem.links.between(left, node));
    link.map_or_else(|| air.seconds(head.at, entry), |link| link.seconds)
}

/// The quickest node that leaves an item where `node` does and that may be used, with the seconds of the way to it, and by how much more
/// than `node` it takes in the item. `is_cut`: whether an item has been cut before.
pub(super) fn quickest(
    problem: &Problem,
    air: &AirTime,
    head: Head,
    node: NodeId,
    is_cut: impl Fn(ItemId) -> bool,
) -> Option<(NodeId, f64)> {
    let item = problem.items.get(problem.nodes.get(node as usize)?.item as usize)?;
    let extra = |node: NodeId| problem.nodes.get(node as usize).map(|n| item.extra(node, n.along));
    let own = extra(node)?;
    let allowed = |n: &&NodeId| problem.starts.kerf(**n).is_none_or(&is_cut);
    let price = |&n: &NodeId| {
        let seconds = travel(problem, air, head, n, problem.nodes.get(n as usize)?.entry);
        Some((n, seconds + extra(n)? - own))
    };
    let ways = problem.starts.alike(node).iter().filter(allowed).filter_map(price);
    ways.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)))
}

/// The stops of a solution, each begun in the quickest way that what was cut before it allows.
pub fn begun(problem: &Problem, stops: &[Stop]) -> Vec<Stop> {
    if !PLANS_ALL_LEVERS || problem.starts.is_empty() {
        return stops.to_vec();
    }
    let air = AirTime::new(&problem.machine);
    let mut head = Head { at: problem.home, left: None };
    let mut cut = vec![false; problem.items.len()];
    let stop = |stop: &Stop| {
        let is_cut = |item: ItemId| cut.get(item as usize).is_some_and(|c| *c);
        let node = quickest(problem, &air, head, stop.node, is_cut).map(|q| q.0);
        let stop = node.filter(|n| *n != stop.node).map_or(*stop, |node| Stop::at(problem, node));
        if let (Some((_, exit)), Some(node)) = (stop.ends(problem), problem.nodes.get(stop.node as usize)) {
            head = Head { at: exit, left: Some(stop.node) };
            if let Some(cut) = cut.get_mut(node.item as usize) {
                *cut = true;
            }
        }
        stop
    };
    stops.iter().map(stop).collect()
}

/// The same as a solution, with its cost.
pub(super) fn begun_solution(problem: &Problem, stops: &[Stop], cost: f64) -> Solution {
    Solution { stops: begun(problem, stops), cost }
}
