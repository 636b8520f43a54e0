//! The cheapest walk that starts at home, makes as many stops as there are items, and ends at home.
//!
//! Dynamic programming: for each number of stops, state and knot, the least cost of a walk up to there, with the charge of
//! each stop. Walks from both ends meet in the middle.

use super::net::Item;
use super::order::Order;
use super::pairs::{Pairs, box_seconds};
use super::prices::Prices;
use super::space::{Space, remembered};

/// The data of the walks.
#[derive(Clone, Debug)]
pub(super) struct Ground {
    pub(super) items: Vec<Item>,
    /// Index of the first contour; the items before it are home.
    pub(super) first: usize,
    pub(super) prices: Prices,
    pub(super) pairs: Pairs,
    pub(super) order: Order,
    /// Which items each item remembers.
    pub(super) company: Vec<Vec<usize>>,
    /// States forwards from home, and backwards from the end if they differ.
    pub(super) spaces: Vec<Space>,
}

/// The values of all stops so far, from one end.
#[derive(Clone, Debug, Default)]
pub(super) struct Pass {
    /// A row for each number of stops, from 1.
    rows: Vec<Vec<f64>>,
}

impl Pass {
    pub(super) fn rows(&self) -> usize {
        self.rows.len()
    }

    /// The row of values after this number of stops.
    pub(super) fn row(&self, stops: usize) -> Option<&[f64]> {
        self.rows.get(stops.checked_sub(1)?).map(Vec::as_slice)
    }
}

/// A stop of a walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visit {
    pub(super) item: usize,
    /// The knot where it arrives.
    pub(super) knot: usize,
}

impl Ground {
    /// Number of items to visit.
    pub(super) fn count(&self) -> usize {
        self.items.len() - self.first
    }

    /// The states of walks along the order or against it, as the company now is; `None` when there are too many.
    pub(super) fn space(&self, backwards: bool) -> Option<Space> {
        let directed = self.prices.directed();
        Space::new((&self.company, self.first), &self.order, &self.pairs, [directed, backwards])
    }

    /// The number of stops that the passes from both ends make.
    pub(super) fn stops(&self) -> [usize; 2] {
        let forth = self.count().div_ceil(2);
        let back = self.count() + 1 - forth;
        if self.spaces.len() == 1 { [forth.max(back), 0] } else { [forth, back] }
    }

    /// Work of one more stop.
    pub(super) fn work(&self, side: usize) -> u64 {
        let entries = |s: &super::space::Step| {
            self.items[s.from].knots
                * (s.sources.len()
                    + s.pair.map_or(1, |_| self.items[self.spaces[side].states[s.to].item].knots))
        };
        1 + self.spaces[side].steps.iter().map(|s| entries(s) as u64).sum::<u64>()
    }

    /// Adds a row to a pass.
    pub(super) fn advance(&self, side: usize, pass: &mut Pass, pay: &[f64]) {
        let space = &self.spaces[side];
        let mut row = vec![f64::INFINITY; space.width];
        let stop = pass.rows.len() + 1;
        let open = |item: usize| {
            let [low, high] = self.order.places[item];
            let place = if side == 0 { stop } else { self.count() + 1 - stop };
            (low..=high).contains(&place)
        };
        let Some(last) = pass.rows.last() else {
            let home = if side == 0 { 0 } else { self.first - 1 };
            let homes = self.items[home].knots;
            for &(e, end) in &self.pairs.of[home] {
                let pair = &self.pairs.list[e];
                let item = pair.items[1 - end];
                if item < self.first || !open(item) || (self.prices.directed() && end != side) {
                    continue;
                }
                let at = space.at[space.of[item][0]];
                let knots = self.items[item].knots;
                for (i, seconds) in self.pairs.table(pair, homes * knots).iter().enumerate() {
                    let value = &mut row[at + if end == 0 { i % knots } else { i / homes }];
                    *value = value.min(seconds + pay[item]);
                }
            }
            pass.rows.push(row);
            return;
        };
        let mut least: Vec<f64> = Vec::new();
        for step in &space.steps {
            let item = space.states[step.to].item;
            if !open(item) {
                continue;
            }
            let (from, to) = (&self.items[step.from], &self.items[item]);
            least.clear();
            least.resize(from.knots, f64::INFINITY);
            for &s in &space.sources[step.sources.clone()] {
                for (l, &v) in least.iter_mut().zip(&last[space.at[s]..]) {
                    *l = if v < *l { v } else { *l };
                }
            }
            if from.paired {
                for ends in least.chunks_exact_mut(2) {
                    ends.swap(0, 1);
                }
            }
            let at = space.at[step.to];
            relax(&mut row[at..at + to.knots], &least, pay[item], self.legs(step.pair), || {
                let (a, b) = (from.around, to.around);
                box_seconds(&self.prices, a.min, a.max, b.min, b.max)
            });
        }
        pass.rows.push(row);
    }

    /// The table of a leg, and whether its rows are those of the item left.
    pub(super) fn legs(&self, pair: Option<(usize, usize)>) -> Option<(&[f64], bool)> {
        pair.map(|(e, side)| {
            let pair = &self.pairs.list[e];
            (
                self.pairs.table(pair, self.items[pair.items[0]].knots * self.items[pair.items[1]].knots),
                side == 0,
            )
        })
    }

    /// The cheapest walk over both passes: its cost and its stops.
    pub(super) fn meet(&self, passes: &[Pass; 2], pay: &[f64]) -> Option<(f64, Vec<Visit>)> {
        let forth = self.count().div_ceil(2);
        let back = self.count() + 1 - forth;
        let other = self.spaces.len() - 1;
        let (f, g) = (passes[0].rows.get(forth - 1)?, passes[other].rows.get(back - 1)?);
        let mut best = (f64::INFINITY, [0, 0], [0, 0]);
        for (item, at) in self.items.iter().enumerate().skip(self.first) {
            for &s in &self.spaces[0].of[item] {
                for &t in &self.spaces[other].of[item] {
                    if !self.fit(item, self.spaces[0].states[s].memory, self.spaces[other].states[t].memory) {
                        continue;
                    }
                    for k in 0..at.knots {
                        let l = if at.paired { k ^ 1 } else { k };
                        let value = f[self.spaces[0].at[s] + k] + g[self.spaces[other].at[t] + l] - pay[item];
                        if value < best.0 {
                            best = (value, [s, t], [k, l]);
                        }
                    }
                }
            }
        }
        let (value, [s, t], [k, l]) = best;
        if value == f64::INFINITY {
            return None;
        }
        let mut walk = self.trace(0, &passes[0].rows[..forth], s, k, pay);
        walk.reverse();
        let rest = self.trace(other, &passes[other].rows[..back], t, l, pay);
        // A backward walk arrives where the tour leaves.
        walk.extend(
            rest.into_iter()
                .skip(1)
                .map(|v| if self.items[v.item].paired { Visit { knot: v.knot ^ 1, ..v } } else { v }),
        );
        Some((value, walk))
    }

    /// Whether the memories of a forward and a backward walk to an item are compatible.
    fn fit(&self, item: usize, past: u32, future: u32) -> bool {
        if past & future != 0 {
            return false;
        }
        if self.order.is_free() || past == 0 || future == 0 {
            return true;
        }
        let later = remembered(&self.company, item, future);
        let earlier = remembered(&self.company, item, past);
        !earlier.iter().any(|&p| later.iter().any(|&l| self.order.forbids(p, l, false)))
    }

    /// The stops of the cheapest walk to a state and knot, last first.
    fn trace(
        &self,
        side: usize,
        rows: &[Vec<f64>],
        mut state: usize,
        mut knot: usize,
        pay: &[f64],
    ) -> Vec<Visit> {
        let space = &self.spaces[side];
        let mut walk = vec![Visit { item: space.states[state].item, knot }];
        for row in rows.iter().rev().skip(1) {
            let item = space.states[state].item;
            let to = &self.items[item];
            let start = space.steps.partition_point(|s| s.to < state);
            let mut best = (f64::INFINITY, 0, 0);
            for step in space.steps[start..].iter().take_while(|s| s.to == state) {
                let from = &self.items[step.from];
                let legs = self.legs(step.pair);
                for &source in &space.sources[step.sources.clone()] {
                    for k in 0..from.knots {
                        let left = if from.paired { k ^ 1 } else { k };
                        let seconds = match legs {
                            Some((table, true)) => table[left * to.knots + knot],
                            Some((table, false)) => table[knot * from.knots + left],
                            None => box_seconds(
                                &self.prices,
                                from.around.min,
                                from.around.max,
                                to.around.min,
                                to.around.max,
                            ),
                        };
                        let value = row[space.at[source] + k] + seconds + pay[item];
                        if value < best.0 {
                            best = (value, source, k);
                        }
                    }
                }
            }
            (state, knot) = (best.1, best.2);
            walk.push(Visit { item: space.states[state].item, knot });
        }
        walk
    }
}

/// Lowers the values of a state by legs from one item.
pub(super) fn relax(
    row: &mut [f64],
    least: &[f64],
    pay: f64,
    legs: Option<(&[f64], bool)>,
    gap: impl Fn() -> f64,
) {
    match legs {
        Some((table, true)) => {
            for (&l, seconds) in least.iter().zip(table.chunks_exact(row.len().max(1))) {
                let base = l + pay;
                if base < f64::INFINITY {
                    for (value, s) in row.iter_mut().zip(seconds) {
                        let new = base + s;
                        *value = if new < *value { new } else { *value };
                    }
                }
            }
        }
        Some((table, false)) => {
            for (value, seconds) in row.iter_mut().zip(table.chunks_exact(least.len().max(1))) {
                let new = least
                    .iter()
                    .zip(seconds)
                    .fold(f64::INFINITY, |m, (l, s)| if l + s < m { l + s } else { m })
                    + pay;
                *value = if new < *value { new } else { *value };
            }
        }
        None => {
            let base = least.iter().fold(f64::INFINITY, |m, &l| m.min(l));
            if base < f64::INFINITY {
                let new = base + gap() + pay;
                for value in row {
                    *value = value.min(new);
                }
            }
        }
    }
}
