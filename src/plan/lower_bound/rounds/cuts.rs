//! Cuts: sets of items that the mixture of walks comes to too seldom.

use super::super::charges::{Cut, HAS_CUTS};
use super::super::gather::{Search, Usage};
use super::super::places::Places;
use super::Strong;
use super::excess::legs;

/// Fewest items: with fewer, walks come so near to tours that all orders can be looked at, for which cuts are in the way.
const FEWEST: usize = 65;
/// Legs that must be missing across a border.
const MISSING: f64 = 0.1;
/// Most cuts for each item, and most items for each cut that is added at once: each cut takes time in every step of the charges.
const MOST: usize = 4;
const AT_ONCE: usize = 2;

impl Strong {
    /// Adds cuts, if there are any, and moves the charges. Returns the work done.
    pub(super) fn separate(&mut self, upper: f64) -> u64 {
        if !HAS_CUTS {
            return 0;
        }
        let count = self.ground.items.len();
        let (once, all) = (count / AT_ONCE, count * MOST);
        if self.without_cuts || self.ground.count() < FEWEST || self.charges.cuts().len() >= all {
            return 0;
        }
        let mut cuts = self.missed();
        cuts.truncate(once);
        if cuts.is_empty() {
            return 0;
        }
        self.bundle.add_cuts(cuts, &mut self.charges, upper)
    }

    /// Sets of items that the mixture comes to too seldom and that are not cuts yet.
    fn missed(&self) -> Vec<Cut> {
        let items = &self.ground.items;
        let mut usage = Usage::new(items, self.ground.first);
        for (weight, walk) in self.bundle.mixture() {
            for ends in legs(&walk, &self.ground) {
                usage.add(ends.map(|v| (v.item, v.knot)), weight);
            }
        }
        let sets = usage.sets(Search { knots: false, relative: false, enough: 1.0, little: MISSING });
        let cut = |set: Places| -> Cut { (0..items.len()).map(|i| set.holds(i)).collect() };
        sets.into_iter().map(cut).filter(|cut| !self.charges.cuts().contains(cut)).collect()
    }
}
