//! Restores feasibility (section 4.6). A contour that is finished before something inside it is moved, as a whole, to after
//! the last contour inside it. What was attached to it stays in its old place, in the order in which it was cut.

use super::forest::Forest;
use super::graph::Graph;
use super::visits::finished;
use crate::problem::{ItemId, NodeId};

/// Repairs the contours from the innermost outwards, so that each is moved at most once. Returns the moved contours and the
/// work in moves.
pub(super) fn repair(g: &Graph, forest: &mut Forest) -> (Vec<ItemId>, u64) {
    let mut moved = Vec::new();
    let mut work = 1;
    for &outer in &g.inwards {
        let ends = finished(g, forest);
        work += ends.len() as u64;
        let last = g.inner[outer as usize]
            .iter()
            .copied()
            .filter(|&i| ends[i as usize] != u32::MAX)
            .max_by_key(|&i| ends[i as usize]);
        let Some(last) = last.filter(|&i| ends[i as usize] > ends[outer as usize]) else { continue };
        shift(g, forest, outer, last);
        moved.push(outer);
    }
    (moved, work)
}

/// Moves a contour to after another one.
fn shift(g: &Graph, forest: &mut Forest, item: ItemId, behind: ItemId) {
    let nodes = g.nodes(item);
    let entry = forest.entry(item);
    let count = nodes.end - nodes.start;
    let around = (1..count).map(|k| nodes.start + (entry - nodes.start + k) % count);
    let mut left: Vec<ItemId> = Vec::new();
    for node in around.collect::<Vec<NodeId>>() {
        if let Some(route) = forest.child(node) {
            left.extend(forest.take(g, route, 0..forest.items(route).len()));
        }
    }
    let (route, pos) = (forest.route_of(item), forest.pos(item));
    forest.splice(route, pos, left);
    let pos = forest.pos(item);
    let taken = forest.take(g, route, pos..pos + 1);
    forest.splice(forest.route_of(behind), forest.pos(behind) + 1, taken);
}
