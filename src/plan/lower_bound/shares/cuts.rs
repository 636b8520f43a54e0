//! Sets of places with too few legs to the others. A tour that stops at one of them enters and leaves the set.

use super::super::gather::{Search, Usage};
use super::cut::Cut;
use super::{ROUGH, ShareBound, WARM};

/// Legs below this share of what there should be are a fault: the smooth solution is nowhere exact.
const ENOUGH: f64 = 0.985;
/// Legs missing below this are no fault either.
const LITTLE: f64 = 0.01;
/// Most cuts, as a multiple of the number of items: each takes time in every step.
const MOST_CUTS: usize = 40;

impl ShareBound {
    /// Adds cuts: joins places by the most used legs first, and looks at each set that comes about. Places are knots, and then
    /// whole items. Cuts that have no price and enough legs are forgotten.
    pub(super) fn separate(&mut self) {
        let little = 1e-9 * self.mean;
        self.cuts.retain(|c| c.price > little || c.legs < c.target);
        let mut usage = Usage::new(&self.items, self.first);
        for (pair, starts) in self.pairs.list.iter().zip(self.starts.windows(2)) {
            let [a, b] = pair.items;
            for (leg, &uses) in self.active.iter().zip(&self.uses).take(starts[1]).skip(starts[0]) {
                usage.add([(a, leg.i as usize), (b, leg.j as usize)], uses);
            }
        }
        // While it is hot every item stops everywhere a little, and pieces are still long: no set of knots means anything yet.
        let cold = self.rounds >= ROUGH && self.temperature <= 1.001 * WARM * self.mean;
        let kinds = [(true, true), (true, false), (false, false)];
        for (knots, relative) in kinds.into_iter().filter(|kind| cold || !kind.0) {
            for places in usage.sets(Search { knots, relative, enough: ENOUGH, little: LITTLE }) {
                let room = self.cuts.len() < MOST_CUTS * self.items.len();
                if room && self.cuts.iter().all(|c| c.places != places) {
                    self.cuts.push(Cut::new(places));
                }
            }
        }
    }
}
