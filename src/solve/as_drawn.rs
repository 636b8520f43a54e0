//! The path "as drawn": items in a given order, each from its first node. A controller without planning does this. It is a
//! baseline and may cut a part free before its holes and marks.

use super::traits::{Solution, Stop};
use crate::problem::{ItemId, Problem};

/// The items in this order, each from its first node. A baseline: it respects neither precedence nor rank.
pub fn in_order(problem: &Problem, order: impl IntoIterator<Item = ItemId>) -> Solution {
    let node = |item: ItemId| problem.items.get(item as usize)?.nodes.clone().next();
    Solution::new(problem, order.into_iter().filter_map(node).map(|node| Stop::at(problem, node)).collect())
}
