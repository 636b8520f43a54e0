//! Restoring feasibility (section 4.6): a contour that is finished before something inside it is moved behind the last of
//! what lies inside it, whole. What hung from it stays where it is, in the contour's old place, in the order in which it was
//! cut.

use super::forest::Forest;
use super::ground::Ground;
use super::walk::finished;
use crate::problem::{ItemId, NodeId};

/// Repairs the contours from the innermost outwards, so that each is moved once at most; how many were moved, and what the
/// work cost.
pub(super) fn repair(g: &Ground, forest: &mut Forest) -> (Vec<ItemId>, u64) {
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

/// Moves a contour behind another one.
fn shift(g: &Ground, forest: &mut Forest, item: ItemId, behind: ItemId) {
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
