//! Walks that follow the flow, and what they tell: circles, and seconds lost where legs are priced too low.

use super::super::halving;
use super::FlowBound;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::collections::BTreeMap;

/// Walks from each item.
const WALKS: usize = 10;
/// Most legs of a walk: longer circles need many states, and cuts see them too.
const LONGEST: usize = 12;
/// Legs that are used less lose nothing worth looking at.
const USED: f64 = 1e-5;

impl FlowBound {
    /// Circles of the flow, and ways on which items are out of order: the items on each from the first to the last, and how many of the walks took it.
    /// Walks start where the flow enters each item.
    pub(super) fn faults(&self) -> Vec<(Vec<usize>, usize)> {
        let ways = self.ways();
        // Any seed is as good as any other.
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut faults: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        for item in self.ground.first..self.ground.items.len() {
            let starts: Vec<usize> = self.net.of[item].iter().flat_map(|&s| self.net.range(s)).collect();
            for _ in 0..WALKS {
                let weight = |&at: &usize| self.flow.inflow[at];
                let Some(&(mut at)) = drawn(&starts, weight, random.random()) else { break };
                let mut walk = vec![item];
                for _ in 0..LONGEST {
                    let legs = ways.get(&at).map_or(&[][..], Vec::as_slice);
                    let Some(&(to, next, _)) = drawn(legs, |leg| leg.2, random.random()) else { break };
                    walk.push(next);
                    let is_wrong = next == item || self.ground.order.forbids(item, next, false);
                    if next < self.ground.first || is_wrong {
                        if next >= self.ground.first {
                            *faults.entry(walk).or_default() += 1;
                        }
                        break;
                    }
                    at = to;
                }
            }
        }
        faults.into_iter().collect()
    }

    /// For each knot of each state the legs that leave it: the knot and the item they lead to, and how much each is used.
    fn ways(&self) -> BTreeMap<usize, Vec<(usize, usize, f64)>> {
        let mut ways: BTreeMap<usize, Vec<(usize, usize, f64)>> = BTreeMap::new();
        for (slot, legs) in self.legs.each() {
            let step = &self.net.steps[slot.step as usize];
            let item = self.net.keys[step.to].0;
            let sources = &self.net.sources[step.sources.clone()];
            for (part, &s) in self.legs.parts[slot.parts as usize..].iter().zip(sources) {
                let of = ways.entry(self.net.at[s] + slot.knot as usize).or_default();
                let all = self.legs.legs[legs.clone()].iter().zip(&self.legs.uses[legs.clone()]);
                of.extend(all.map(|(leg, uses)| (leg.to as usize, item, part * uses)).filter(|w| w.2 > USED));
            }
        }
        ways
    }

    /// For each knot the seconds by which the legs that are used at it are priced too low.
    pub(super) fn lost(&self) -> Vec<Vec<f64>> {
        let items = &self.ground.items;
        let places: Vec<_> = items.iter().map(halving::places).collect();
        let mut lost: Vec<Vec<f64>> = items.iter().map(|i| vec![0.0; i.knots]).collect();
        if self.ground.prices.given() {
            return lost;
        }
        for (slot, legs) in self.legs.each() {
            let step = &self.net.steps[slot.step as usize];
            let (from, to) = (step.from, self.net.keys[step.to].0);
            if to == 0 && self.ground.first == 2 {
                // The end of an open path, whose legs cost nothing.
                continue;
            }
            let knot = slot.knot as usize;
            let left = if items[from].paired { knot ^ 1 } else { knot };
            for (leg, &uses) in self.legs.legs[legs.clone()].iter().zip(&self.legs.uses[legs.clone()]) {
                let k = leg.to as usize - self.net.at[step.to];
                let stops = [(from, left), (to, k)].map(|(i, knot)| (&items[i], knot, places[i][knot]));
                let real = self.ground.prices.real(stops);
                let by = if uses > USED { uses * (real - leg.seconds).max(0.0) } else { 0.0 };
                lost[from][left] += by;
                lost[to][k] += by;
            }
        }
        lost
    }
}

/// One of some choices by lot. `lot`: from 0 to 1.
fn drawn<T>(choices: &[T], weight: impl Fn(&T) -> f64, lot: f64) -> Option<&T> {
    let mut left = lot * choices.iter().map(&weight).sum::<f64>();
    let chosen = choices.iter().find(|choice| {
        left -= weight(choice);
        left < 0.0
    });
    chosen.or(choices.last())
}
