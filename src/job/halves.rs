//! Skeleton cuts that begin where they cross another one (`levers.chains.edge_starts`): in a path for drawing, such a cut has two stops, one to each of
//! its ends, between which the head goes back with the beam off.

use crate::geometry::DVec2;
use crate::machine::PLANS_ALL_LEVERS;
use crate::problem::{Problem, Start};
use crate::sheet::Sheet;
use crate::solve::Stop;

/// A stop of such a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Half {
    pub(super) contour: u32,
    /// Where it begins and ends, mm.
    pub(super) ends: [DVec2; 2],
    /// The arc lengths of these places from the stored start, mm.
    pub(super) along: f64,
    pub(super) until: f64,
    pub(super) reversed: bool,
}

/// The two stops of a visit that begins at `begins`; `None` if it is no skeleton cut or begins at one of its ends.
pub(super) fn halves(sheet: &Sheet, problem: &Problem, stop: Stop, begins: Start) -> Option<[Half; 2]> {
    let node = problem.nodes.get(stop.node as usize)?;
    let line = sheet.contours.get(node.item as usize).filter(|c| PLANS_ALL_LEVERS && c.skeleton)?;
    let along = begins.from.distance(line.path.start()?);
    let half = |to: DVec2, reversed: bool| Half {
        contour: node.item,
        ends: [begins.from, to],
        along,
        until: if reversed { 0.0 } else { line.length },
        reversed,
    };
    let between = begins.from != node.entry && begins.from != node.exit;
    between.then(|| [half(node.entry, !node.reversed), half(node.exit, node.reversed)])
}

/// The visit whose two stops have these places and directions; `None` if they are no such cut.
#[expect(clippy::float_cmp, reason = "both begin at one place, bit for bit")]
pub(super) fn joined(problem: &Problem, contour: u32, stops: [(f64, f64, bool); 2]) -> Option<Stop> {
    let [(along, until, back), (second, _, on)] = stops;
    let apart = along == second && along != until && back != on;
    let item = problem.items.get(contour as usize).filter(|_| PLANS_ALL_LEVERS && apart)?;
    let begins = |node: u32| problem.starts.of(node).iter().any(|s| s.kerf.is_some());
    let way = |node: u32| problem.nodes.get(node as usize).is_some_and(|n| n.reversed == on);
    item.nodes.clone().find(|&n| begins(n) && way(n)).map(|n| Stop::at(problem, n))
}
