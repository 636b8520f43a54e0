//! A step of the smooth problem: how often items want their legs, how often legs want to be used, and the shares that bring
//! both together.

use super::{Kind, ShareBound};
use crate::geometry::math::{exp, ln};

/// Legs that are too expensive by more temperatures than this do not matter: e^-40 is below the precision of a number.
const CUTOFF: f64 = 40.0;
/// Length of a step: a quarter never overshoots, because a choice of an item and a leg have two shares each.
const STEP: f64 = 0.25;
/// Length of a step of a cut's price: half as long, because a leg crosses several cuts.
const CUT_STEP: f64 = 0.125;
/// Most temperatures by which a share moves in a step, before [`STEP`].
const MOST: f64 = 4.0;
/// The least probability whose logarithm is taken.
const LEAST: f64 = 1e-200;

impl ShareBound {
    /// Selects the knots between which legs are cheap enough to matter at this temperature.
    pub(super) fn select(&mut self) {
        self.price_crossings();
        self.active.clear();
        for (e, pair) in self.pairs.list.iter().enumerate() {
            let [n, m] = pair.items.map(|k| self.items[k].knots);
            let table = self.pairs.table(pair, n * m);
            let [a, b] = self.at[e];
            let most = CUTOFF * self.temperature + self.crossing[e];
            let mut chosen = Vec::new();
            for (i, row) in table.chunks_exact(m).enumerate() {
                let most = most + self.shares[a + i];
                let cheap = |(j, &seconds): (usize, &f64)| {
                    (seconds - self.shares[b + j] < most).then_some((i, j, seconds))
                };
                chosen.extend(row.iter().enumerate().filter_map(cheap));
            }
            self.active.push(chosen);
        }
    }

    /// Moves all shares and all prices of cuts once.
    pub(super) fn step(&mut self) {
        self.price_crossings();
        for k in 0..self.items.len() {
            match self.kinds[k] {
                Kind::End => self.want_one(k),
                Kind::Closed => self.want_from_a_knot(k),
                Kind::Paired => self.want_from_ends(k),
            }
        }
        for e in 0..self.pairs.list.len() {
            self.offer(e);
        }
        let by = STEP * self.temperature;
        for ((share, wanted), offered) in self.shares.iter_mut().zip(&self.wanted).zip(&self.offered) {
            *share += by * (ln(wanted.max(LEAST)) - ln(offered.max(LEAST))).clamp(-MOST, MOST);
        }
        for cut in &mut self.cuts {
            cut.legs = cut.pairs.iter().map(|&e| self.usage[e]).sum();
            let by = CUT_STEP * self.temperature * ln(2.0 / cut.legs.max(1e-3));
            cut.price = (cut.price + by).max(0.0);
        }
    }

    pub(super) fn price_crossings(&mut self) {
        self.crossing.fill(0.0);
        for cut in &self.cuts {
            for &e in &cut.pairs {
                self.crossing[e] += cut.price;
            }
        }
    }

    /// How often a pair's leg is used, and between which knots: its probability falls with what it costs beyond the shares.
    fn offer(&mut self, e: usize) {
        let [a, b] = self.at[e];
        let [n, m] = self.pairs.list[e].items.map(|k| self.items[k].knots);
        self.offered[a..a + n].fill(0.0);
        self.offered[b..b + m].fill(0.0);
        self.usage[e] = 0.0;
        let left = |&(i, j, seconds): &(usize, usize, f64)| {
            seconds - self.crossing[e] - self.shares[a + i] - self.shares[b + j]
        };
        let low = self.active[e].iter().map(left).fold(0.0, f64::min);
        let mut total = 0.0;
        for leg in &self.active[e] {
            let weight = exp((low - left(leg)) / self.temperature);
            self.offered[a + leg.0] += weight;
            self.offered[b + leg.1] += weight;
            total += weight;
        }
        if total > 0.0 {
            let all = total + exp(low / self.temperature);
            self.usage[e] = total / all;
            self.offered[a..a + n].iter_mut().for_each(|q| *q /= all);
            self.offered[b..b + m].iter_mut().for_each(|q| *q /= all);
        }
    }

    /// The share of each leg of an item, as places in the list of shares: for each leg where those of its knots start.
    fn legs_of(&self, k: usize) -> Vec<usize> {
        self.pairs.of[k].iter().map(|&(e, side)| self.at[e][side]).collect()
    }

    /// One leg, from any knot.
    fn want_one(&mut self, k: usize) {
        let (legs, n) = (self.legs_of(k), self.items[k].knots);
        let all = || legs.iter().flat_map(|&at| at..at + n);
        let low = all().map(|s| self.shares[s]).fold(f64::INFINITY, f64::min);
        let mut total = 0.0;
        for s in all() {
            self.wanted[s] = exp((low - self.shares[s]) / self.temperature);
            total += self.wanted[s];
        }
        all().for_each(|s| self.wanted[s] /= total);
    }

    /// Two legs to different items from one knot. The cheapest leg of each knot is kept apart, so that no small number is
    /// the difference of two large ones.
    fn want_from_a_knot(&mut self, k: usize) {
        let (legs, n) = (self.legs_of(k), self.items[k].knots);
        let mut total = 0.0;
        let two: Vec<[(f64, usize); 2]> = (0..n).map(|v| cheapest_two(&self.shares, &legs, v)).collect();
        let base = two.iter().map(|t| t[0].0 + t[1].0).fold(f64::INFINITY, f64::min);
        let mut weights = vec![0.0; n];
        for (v, [(s1, top), (s2, _)]) in two.iter().enumerate() {
            let (mut sum, mut squares) = (0.0, 0.0);
            for (l, &at) in legs.iter().enumerate().filter(|(l, _)| l != top) {
                let x = exp((s2 - self.shares[at + v]) / self.temperature);
                self.wanted[legs[l] + v] = x;
                sum += x;
                squares += x * x;
            }
            // How likely it is that the cheapest leg is not one of the two.
            let without = exp((s1 - s2) / self.temperature);
            weights[v] = exp((base - s1 - s2) / self.temperature);
            total += weights[v] * (sum + without * 0.5 * (sum * sum - squares).max(0.0));
            for (l, &at) in legs.iter().enumerate() {
                let x = &mut self.wanted[at + v];
                *x = if l == *top { sum } else { *x * (1.0 + without * (sum - *x)) };
            }
        }
        for at in legs {
            self.wanted[at..at + n].iter_mut().zip(&weights).for_each(|(x, w)| *x *= w / total);
        }
    }

    /// Two legs to different items from the two ends of a pair of knots.
    fn want_from_ends(&mut self, k: usize) {
        let (legs, n) = (self.legs_of(k), self.items[k].knots);
        let low: Vec<f64> = (0..n).map(|v| cheapest_two(&self.shares, &legs, v)[0].0).collect();
        let base = low.chunks_exact(2).map(|ends| ends[0] + ends[1]).fold(f64::INFINITY, f64::min);
        let mut total = 0.0;
        for v in (0..n).step_by(2) {
            let weight = exp((base - low[v] - low[v + 1]) / self.temperature);
            let (mut sums, mut same) = ([0.0; 2], 0.0);
            for &at in &legs {
                let ends =
                    [v, v + 1].map(|v| exp((low[v] - self.shares[at + v]) / self.temperature).max(LEAST));
                [self.wanted[at + v], self.wanted[at + v + 1]] = ends;
                sums = [sums[0] + ends[0], sums[1] + ends[1]];
                same += ends[0] * ends[1];
            }
            total += weight * (sums[0] * sums[1] - same).max(LEAST);
            for &at in &legs {
                let [x, y] = [self.wanted[at + v], self.wanted[at + v + 1]];
                self.wanted[at + v] = weight * x * (sums[1] - y).max(0.0);
                self.wanted[at + v + 1] = weight * y * (sums[0] - x).max(0.0);
            }
        }
        for at in legs {
            self.wanted[at..at + n].iter_mut().for_each(|q| *q /= total);
        }
    }
}

/// The two smallest shares of a knot, and the legs they belong to.
pub(super) fn cheapest_two(shares: &[f64], legs: &[usize], knot: usize) -> [(f64, usize); 2] {
    let mut two = [(f64::INFINITY, usize::MAX); 2];
    for (l, &at) in legs.iter().enumerate() {
        let leg = (shares[at + knot], l);
        if leg.0 < two[0].0 {
            two = [leg, two[0]];
        } else if leg.0 < two[1].0 {
            two[1] = leg;
        }
    }
    two
}
