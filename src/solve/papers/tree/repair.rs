//! Restores feasibility (section 4.6). A contour that is finished before something inside it is moved, as a whole, to after
//! the last contour inside it. What was attached to it stays in its old place, in the order in which it was cut. A pierce
//! group is moved as a whole too, as in the paper; it must also be moved if an area of it falls out before something inside.

use super::forest::Forest;
use super::graph::Graph;
use super::visits::finished;
use crate::problem::ItemId;

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
        let late = g.inner[outer as usize].iter().any(|&i| forest.is_late(g, i));
        let Some(last) = last.filter(|&i| late || ends[i as usize] > ends[outer as usize]) else { continue };
        shift(g, forest, outer, last);
        moved.push(outer);
    }
    (moved, work)
}

/// Moves a contour to after another one.
fn shift(g: &Graph, forest: &mut Forest, item: ItemId, behind: ItemId) {
    let mut left: Vec<ItemId> = Vec::new();
    for node in forest.hanging(g, item) {
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
