//! Cuts: sets of items that the flow enters too seldom.

use super::super::gather::{Search, Usage};
use super::super::pairs::Pair;
use super::super::powers::ln;
use super::FlowBound;
use super::cut::Cut;

/// Legs below this share of two are a fault: the smooth solution is nowhere exact.
const ENOUGH: f64 = 0.985;
/// Legs missing below this are no fault either.
const LITTLE: f64 = 0.01;
/// Most cuts, as a multiple of the number of items: each takes time in every step.
const MOST_CUTS: usize = 10;
/// While the temperature is a larger share of an average leg, every item has legs everywhere and no set means anything yet.
const MEANS_SOMETHING: f64 = 0.06;
/// Length of a step of a price, divided by the root of the number of cuts that its legs cross: they all move the same legs.
const STEP: f64 = 0.25;
/// Most temperatures by which a price moves in a step, before [`STEP`].
const MOST: f64 = 4.0;
/// The least number of legs whose logarithm is taken.
const FEW: f64 = 1e-3;

impl FlowBound {
    /// Adds cuts: joins items by the most used legs first, and looks at each set that comes about. Cuts that have no price and
    /// enough legs are forgotten.
    pub(super) fn separate(&mut self) {
        if self.temperature > MEANS_SOMETHING * self.mean {
            return;
        }
        let little = 1e-9 * self.mean;
        self.cuts.retain(|c| c.price > little || c.legs < 2.0);
        let items = &self.ground.items;
        let mut usage = Usage::new(items, self.ground.first);
        for (pair, &uses) in self.ground.pairs.list.iter().zip(&self.flow.usage) {
            usage.add(pair.items.map(|item| (item, 0)), uses);
        }
        for &(from, to, uses) in &self.flow.far {
            usage.add([(from, 0), (to, 0)], uses);
        }
        for relative in [true, false] {
            for places in usage.sets(Search { knots: false, relative, enough: ENOUGH, little: LITTLE }) {
                let set: Vec<bool> = (0..items.len()).map(|i| places.holds(i)).collect();
                let room = self.cuts.len() < MOST_CUTS * items.len();
                if room && self.cuts.iter().all(|c| c.set != set) {
                    self.cuts.push(Cut { set, price: 0.0, pairs: Vec::new(), legs: 0.0 });
                }
            }
        }
        self.find_crossings();
    }

    /// Finds the pairs that cross each cut.
    pub(super) fn find_crossings(&mut self) {
        let pairs = &self.ground.pairs.list;
        for cut in &mut self.cuts {
            let crosses = |pair: &&Pair| cut.set[pair.items[0]] != cut.set[pair.items[1]];
            cut.pairs.clear();
            cut.pairs.extend((0..).zip(pairs).filter(|(_, pair)| crosses(pair)).map(|(e, _)| e));
        }
    }

    /// Adds the prices between each two items up.
    pub(super) fn price_crossings(&mut self) {
        let count = self.ground.items.len();
        self.crossing.fill(0.0);
        for cut in self.cuts.iter().filter(|c| c.price > 0.0) {
            for (row, &a) in self.crossing.chunks_exact_mut(count).zip(&cut.set) {
                row.iter_mut().zip(&cut.set).filter(|x| *x.1 != a).for_each(|(s, _)| *s += cut.price);
            }
        }
    }

    /// Moves the prices: up where fewer than two legs cross. `crossed`: how many cuts each pair crosses.
    pub(super) fn move_prices(&mut self, crossed: &[f64]) {
        let by = STEP * self.temperature;
        let flow = &self.flow;
        for cut in &mut self.cuts {
            let (mut legs, mut all) = (0.0, 0.0);
            for e in cut.pairs.iter().map(|&e| e as usize) {
                legs += flow.usage[e];
                all += flow.usage[e] * crossed[e];
            }
            for &(from, to, uses) in &flow.far {
                if cut.set[from] != cut.set[to] {
                    legs += uses;
                    all += uses;
                }
            }
            cut.legs = legs;
            let by = by * (legs.max(FEW) / all.max(FEW)).min(1.0).sqrt();
            let fault = ln(2.0) - ln(legs.max(FEW));
            cut.price = (cut.price + by * fault.clamp(-MOST, MOST)).max(0.0);
        }
    }
}
