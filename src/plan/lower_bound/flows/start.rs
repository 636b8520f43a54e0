//! Which pairs of items have tables at first.

use super::super::pairs::Scan;
use super::super::walks::Ground;
use crate::order::{real, sort_by};
use std::collections::BTreeSet;

/// Items that each item must be able to go to and to come from, by tables: without enough of them there may be no circulation, where the nearest
/// items of an outer contour are its own holes, which come before it.
const REACHABLE: usize = 8;

/// The pairs that have tables at first: near items, and home with every item.
pub(super) fn first_pairs(ground: &Ground) -> Vec<[usize; 2]> {
    let Ground { items, first, prices, order, .. } = ground;
    let mut scan = Scan::new(items, *first);
    while scan.next(items, *first, prices).is_some() {}
    let mut wanted = scan.wanted(*first, items.len());
    if !prices.given() {
        let mut known: BTreeSet<[usize; 2]> = wanted.iter().copied().collect();
        for a in *first..items.len() {
            for ahead in [true, false] {
                let barred =
                    |b: usize| if ahead { order.forbids(a, b, false) } else { order.forbids(b, a, false) };
                let others = (*first..items.len()).filter(|&b| b != a && !barred(b));
                let mut near: Vec<(f64, usize)> = others.map(|b| (ground.gap(a, b), b)).collect();
                sort_by(&mut near, |n| [real(n.0), n.1 as u64, 0]);
                let ends = near.iter().take(REACHABLE).map(|n| [a.min(n.1), a.max(n.1)]);
                wanted.extend(ends.filter(|ends| known.insert(*ends)));
            }
        }
    }
    if prices.directed() {
        let back: Vec<[usize; 2]> = wanted.iter().map(|&[a, b]| [b, a]).collect();
        wanted.extend(back);
    }
    wanted
}
