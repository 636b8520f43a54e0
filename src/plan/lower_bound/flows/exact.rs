//! The value of the potentials as they are, over all legs.

use super::super::space::Step;
use super::super::walks::relax;
use super::FlowBound;
use super::record::Record;
use crate::order::{real, sort_by};

impl FlowBound {
    /// The least potential of the states left by a step, for each knot of the item.
    pub(super) fn leaves(&self, step: &Step, least: &mut Vec<f64>) {
        least.clear();
        least.resize(self.ground.items[step.from].knots, f64::INFINITY);
        for &s in &self.net.sources[step.sources.clone()] {
            for (l, &v) in least.iter_mut().zip(&self.potentials[self.net.range(s)]) {
                *l = if v < *l { v } else { *l };
            }
        }
    }

    /// For each item the least potential of all its states, and the greatest of the state in which nothing is barred.
    pub(super) fn extremes(&self) -> (Vec<f64>, Vec<f64>) {
        let low = |states: &Vec<usize>| {
            let all = states.iter().flat_map(|&s| &self.potentials[self.net.range(s)]);
            all.fold(f64::INFINITY, |m, &v| m.min(v))
        };
        let high = |fresh: &Option<usize>| {
            let all = fresh.iter().flat_map(|&s| &self.potentials[self.net.range(s)]);
            all.fold(f64::NEG_INFINITY, |m, &v| m.max(v))
        };
        (self.net.of.iter().map(low).collect(), self.net.fresh.iter().map(high).collect())
    }

    /// What legs pay at each item at least, and the sum of it, which is the value. The best one is written down.
    pub(super) fn look(&mut self) -> f64 {
        self.price_crossings();
        let ground = &self.ground;
        let count = ground.items.len();
        let mut row = vec![f64::INFINITY; self.net.width];
        let mut least = Vec::new();
        for step in &self.net.steps {
            let item = self.net.keys[step.to].0;
            self.leaves(step, &mut least);
            if ground.items[step.from].paired {
                least.chunks_exact_mut(2).for_each(|ends| ends.swap(0, 1));
            }
            let given = self.crossing[step.from * count + item];
            relax(&mut row[self.net.range(step.to)], &least, -given, ground.legs(step.pair));
        }
        self.pays.fill(f64::INFINITY);
        for (s, key) in self.net.keys.iter().enumerate() {
            for (arrives, potential) in row[self.net.range(s)].iter().zip(&self.potentials[self.net.range(s)])
            {
                self.pays[key.0] = self.pays[key.0].min(arrives - potential);
            }
        }
        let mut missing: Vec<(f64, [usize; 2])> = Vec::new();
        let (low, high) = self.extremes();
        for (to, far) in self.net.far.iter().enumerate() {
            let near = self.pays[to];
            for &(from, gap) in far {
                let pay = low[from] + gap - self.crossing[from * count + to] - high[to];
                if pay < near {
                    missing.push((near - pay, [from.min(to), from.max(to)]));
                    self.pays[to] = self.pays[to].min(pay);
                }
            }
        }
        // The end of an open path is home, too.
        self.pays[1..ground.first].fill(0.0);
        sort_by(&mut missing, |m| [u64::MAX - real(m.0), m.1[0] as u64, m.1[1] as u64]);
        self.missing = missing.into_iter().map(|m| m.1).collect();
        let prices: f64 = self.cuts.iter().map(|c| c.price).sum();
        let value = self.pays.iter().sum::<f64>() + 2.0 * prices;
        let safe = value - self.guard(prices);
        if safe.is_finite() && safe > self.best {
            self.best = safe;
            self.record = Some(Box::new(Record::new(&self.ground, &self.net, &self.potentials, &self.cuts)));
        }
        value
    }

    /// What rounding can add to the value: each item's part is a sum of a leg, two potentials and the prices between two items.
    fn guard(&self, prices: f64) -> f64 {
        let most = self.potentials.iter().chain(&self.pays).fold(0.0, |m: f64, &v| m.max(v.abs()));
        let count = (self.ground.items.len() + self.cuts.len()) as f64;
        8.0 * f64::EPSILON * count * (4.0 * most + count * prices)
    }
}
