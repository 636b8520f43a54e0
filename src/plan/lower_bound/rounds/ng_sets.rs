//! The ng-set of each item: the items that walks remember there. It begins with the nearest, and rounds extend it.

use super::super::net::Item;
use super::super::pairs::Pairs;
use crate::order::{real, sort_by};

/// Nearest items in the first ng-set of each item: with fewer, the first rounds would only find these.
const FIRST_SIZE: usize = 4;
/// Largest ng-set of an item: its states may double with each member.
const LARGEST: usize = 16;

/// The [`FIRST_SIZE`] nearest items of each item.
pub(in super::super) fn nearest_ng_sets(items: &[Item], first: usize, pairs: &Pairs) -> Vec<Vec<usize>> {
    let mut ng_sets = vec![Vec::new(); items.len()];
    for (i, list) in ng_sets.iter_mut().enumerate().skip(first) {
        let mut near: Vec<(usize, f64)> = pairs.of[i]
            .iter()
            .map(|&(e, side)| (pairs.list[e].items[1 - side], pairs.list[e].least))
            .filter(|n| n.0 >= first)
            .collect();
        sort_by(&mut near, |n| [real(n.1), n.0 as u64, 0]);
        list.extend(near.iter().take(FIRST_SIZE).map(|n| n.0));
    }
    ng_sets
}

/// Adds an item to the ng-set of another one, if there is room. Returns whether it is new there.
pub(in super::super) fn extend_ng_set(ng_sets: &mut [Vec<usize>], of: usize, by: usize) -> bool {
    let Some(list) = ng_sets.get_mut(of) else { return false };
    let is_new = list.len() < LARGEST && of != by && !list.contains(&by);
    if is_new {
        list.push(by);
    }
    is_new
}
