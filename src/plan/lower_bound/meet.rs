//! Where walks from both ends meet, and which stops they make.

use super::charges::Charges;
use super::space::remembered;
use super::walks::{Ground, Pass, Visit};

/// A walk, and what it takes with charges.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) value: f64,
    pub(super) walk: Vec<Visit>,
}

impl Ground {
    /// Work of finding this many walks through all items.
    pub(super) fn work_of_meeting(&self, walks: usize) -> u64 {
        let Some(space) = self.spaces.first() else { return 1 };
        let legs: usize = space.steps.iter().map(|s| self.items[s.from].knots * s.sources.len()).sum();
        let far: usize = space.far.iter().map(Vec::len).sum();
        (walks * self.count() * (legs / space.states.len().max(1) + far / space.far.len().max(1))) as u64
    }

    /// The cheapest walks over both passes that come from both ends to each item, the cheapest of all first.
    pub(super) fn meet(&self, passes: &[Pass; 2], charges: &Charges) -> Vec<Found> {
        let forth = self.count().div_ceil(2);
        let back = self.count() + 1 - forth;
        let other = self.spaces.len() - 1;
        let (Some(f), Some(g)) = (passes[0].rows.get(forth - 1), passes[other].rows.get(back - 1)) else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for (item, at) in self.items.iter().enumerate().skip(self.first) {
            let mut best = (f64::INFINITY, [0, 0], [0, 0]);
            for &s in &self.spaces[0].of[item] {
                for &t in &self.spaces[other].of[item] {
                    if !self.fit(item, self.spaces[0].states[s].memory, self.spaces[other].states[t].memory) {
                        continue;
                    }
                    for k in 0..at.knots {
                        let l = if at.paired { k ^ 1 } else { k };
                        let value =
                            f[self.spaces[0].at[s] + k] + g[self.spaces[other].at[t] + l] - charges.of(item);
                        if value < best.0 {
                            best = (value, [s, t], [k, l]);
                        }
                    }
                }
            }
            let (value, [s, t], [k, l]) = best;
            if value == f64::INFINITY {
                continue;
            }
            let mut walk = self.trace(0, (&passes[0], forth), s, k, charges);
            walk.reverse();
            let rest = self.trace(other, (&passes[other], back), t, l, charges);
            // A backward walk arrives where the tour leaves.
            walk.extend(
                rest.into_iter()
                    .skip(1)
                    .map(|v| if self.items[v.item].paired { Visit { knot: v.knot ^ 1, ..v } } else { v }),
            );
            found.push(Found { value, walk });
            let last = found.len() - 1;
            if value < found[0].value {
                found.swap(0, last);
            }
        }
        found
    }

    /// Whether a walk of this ground stops at these items in turn.
    pub(super) fn is_walk(&self, walk: &[Visit]) -> bool {
        let mut past: Vec<usize> = Vec::new();
        for v in walk {
            if past.iter().any(|&p| p == v.item || self.order.forbids(p, v.item, false)) {
                return false;
            }
            past.push(v.item);
            past.retain(|p| *p == v.item || self.ng_sets[v.item].contains(p));
        }
        true
    }

    /// Whether the memories of a forward and a backward walk to an item are compatible.
    fn fit(&self, item: usize, past: u32, future: u32) -> bool {
        if past & future != 0 {
            return false;
        }
        if self.order.is_free() || past == 0 || future == 0 {
            return true;
        }
        let later = remembered(&self.ng_sets, item, future);
        let earlier = remembered(&self.ng_sets, item, past);
        !earlier.iter().any(|&p| later.iter().any(|&l| self.order.forbids(p, l, false)))
    }

    /// The stops of the cheapest walk to a state and knot, last first.
    fn trace(
        &self,
        side: usize,
        (pass, stops): (&Pass, usize),
        mut state: usize,
        mut knot: usize,
        charges: &Charges,
    ) -> Vec<Visit> {
        let space = &self.spaces[side];
        let mut walk = vec![Visit { item: space.states[state].item, knot }];
        for (row, least) in pass.rows.iter().zip(&pass.least).take(stops - 1).rev() {
            let item = space.states[state].item;
            let to = &self.items[item];
            let start = space.steps.partition_point(|s| s.to < state);
            let mut best = (f64::INFINITY, 0, 0);
            for step in space.steps[start..].iter().take_while(|s| s.to == state) {
                let from = &self.items[step.from];
                let (table, rows_left) = self.legs(step.pair);
                let pay = charges.of_leg(step.from, item);
                for &source in &space.sources[step.sources.clone()] {
                    for k in 0..from.knots {
                        let left = if from.paired { k ^ 1 } else { k };
                        let at = if rows_left { left * to.knots + knot } else { knot * from.knots + left };
                        let value = row[space.at[source] + k] + table[at] + pay;
                        if value < best.0 {
                            best = (value, source, k);
                        }
                    }
                }
            }
            if space.of[item][0] == state {
                for &(from, gap) in &space.far[item] {
                    let gap = gap + charges.of_leg(from, item);
                    if least[from] + gap >= best.0 {
                        continue;
                    }
                    for &source in &space.of[from] {
                        let values = &row[space.at[source]..space.at[source] + self.items[from].knots];
                        if let Some(k) = values.iter().position(|&v| v <= least[from]) {
                            best = (values[k] + gap, source, k);
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
