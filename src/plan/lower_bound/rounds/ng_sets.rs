//! The first ng-set of each item: the items that walks remember before any round has extended it.

use super::super::net::Item;
use super::super::pairs::Pairs;
use crate::order::{real, sort_by};

/// Nearest items in the first ng-set of each item: with fewer, the first rounds would only find these.
const FIRST_SIZE: usize = 4;

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
