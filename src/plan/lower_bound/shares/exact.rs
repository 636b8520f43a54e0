//! The value of the shares as they are, with the real minima; and the certificate of it.

use super::super::certificate::{Certificate, Certified, SharedLegs, unit, units};
use super::super::pairs::box_seconds;
use super::super::priced_cuts::{Part, PricedCut};
use super::cut::Cut;
use super::soft::{Two, cheapest_two};
use super::{Kind, ShareBound};

impl ShareBound {
    /// Shares a new pair's legs evenly.
    pub(super) fn share_evenly(&mut self, e: usize) {
        let [n, m] = self.pairs.list[e].items.map(|k| self.items[k].knots);
        let start = self.shares.len();
        self.at.push([start, start + n]);
        let table = self.pairs.table(&self.pairs.list[e], n * m);
        let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
        let rows = table.chunks_exact(m).map(|row| 0.5 * least(&mut row.iter().copied()));
        let columns = (0..m).map(|j| 0.5 * least(&mut (0..n).map(|i| table[i * m + j])));
        self.shares.extend(rows.chain(columns));
        self.wanted.resize(self.shares.len(), 0.0);
        self.offered.resize(self.shares.len(), 0.0);
    }

    /// What each leg costs less the prices of the cuts that it crosses, table by table.
    pub(super) fn adjust(&mut self) {
        let of = self.priced_cuts();
        self.cost.clear();
        self.cost_at.clear();
        let mut price = Vec::new();
        for pair in &self.pairs.list {
            let [n, m] = pair.items.map(|k| self.items[k].knots);
            let start = self.cost.len();
            self.cost_at.push(start);
            self.cost.extend_from_slice(self.pairs.table(pair, n * m));
            let [a, b] = pair.items;
            let later = of[b].iter().filter(|c| of[a].binary_search(c).is_err());
            for &c in of[a].iter().chain(later) {
                let cut = &self.cuts[c];
                if !cut.places.may_cross(pair.items) {
                    continue;
                }
                let [x, y] = pair.items.map(|k| cut.places.of(k));
                // The price of a leg from outside, and from inside.
                price.clear();
                price.extend((0..m).map(|j| if y.holds(j) { cut.price } else { 0.0 }));
                for (i, row) in self.cost[start..].chunks_exact_mut(m).enumerate() {
                    if x.holds(i) {
                        row.iter_mut().zip(&price).for_each(|(s, p)| *s -= cut.price - p);
                    } else {
                        row.iter_mut().zip(&price).for_each(|(s, p)| *s -= p);
                    }
                }
            }
        }
    }

    /// For each item the cuts with a price that hold some of it.
    fn priced_cuts(&self) -> Vec<Vec<usize>> {
        let mut of: Vec<Vec<usize>> = vec![Vec::new(); self.items.len()];
        for (c, cut) in self.cuts.iter().enumerate().filter(|c| c.1.price > 0.0) {
            cut.places.held.iter().for_each(|h| of[h.0].push(c));
        }
        of
    }

    /// The value of the current shares, up to rounding. Legs between items without shares that would be used get shares.
    pub(super) fn look(&mut self) -> f64 {
        self.price_stops();
        self.adjust();
        let shares = self.fitted();
        let least: Vec<(f64, f64)> = (0..self.items.len()).map(|k| self.least(&shares, k)).collect();
        let far = far(&least);
        let stars: f64 = least.iter().map(|l| l.0).sum();
        let cuts: f64 = self.cuts.iter().filter(|c| c.places.visited.is_none()).map(|c| c.price).sum();
        let missing = self.missing(&far);
        let lost: f64 = missing.iter().map(|m| m.1).sum();
        for (ends, _) in &missing {
            self.pairs.add(&self.items, &self.prices, *ends, true);
            self.share_evenly(self.pairs.list.len() - 1);
            self.usage.push(0.0);
        }
        if !missing.is_empty() {
            self.adjust();
        }
        stars + 2.0 * cuts - lost
    }

    /// The shares raised or lowered until the cheapest leg of each pair is paid exactly.
    fn fitted(&self) -> Vec<f64> {
        let mut shares = self.shares.clone();
        for (e, pair) in self.pairs.list.iter().enumerate() {
            let [n, m] = pair.items.map(|k| self.items[k].knots);
            let cost = &self.cost[self.cost_at[e]..self.cost_at[e] + n * m];
            let [a, b] = self.at[e];
            let (of_a, of_b) = shares[a..a + n + m].split_at_mut(b - a);
            let mut left = vec![f64::INFINITY; m];
            for (row, share) in cost.chunks_exact(m).zip(of_a) {
                let least = row.iter().zip(&*of_b).map(|(t, s)| t - s).fold(f64::INFINITY, f64::min);
                *share += 0.5 * (least - *share);
                for (left, t) in left.iter_mut().zip(row) {
                    *left = left.min(t - *share);
                }
            }
            of_b.copy_from_slice(&left);
        }
        shares
    }

    /// The least that an item pays, and its cheapest single leg with what the stop pays.
    fn least(&self, shares: &[f64], k: usize) -> (f64, f64) {
        let legs = self.legs_of(k);
        let (n, base) = (self.items[k].knots, self.base[k]);
        let two = cheapest_two(shares, &legs, n);
        let pay = &self.pay[base..base + n];
        let cheapest = two.iter().zip(pay).map(|(t, p)| t[0].0 + p).fold(f64::INFINITY, f64::min);
        let of_ends = |(ends, pay): (&[Two], &[f64])| {
            let [a, b] = [ends[0], ends[1]];
            let legs =
                if a[0].1 == b[0].1 { (a[0].0 + b[1].0).min(a[1].0 + b[0].0) } else { a[0].0 + b[0].0 };
            legs + pay[0]
        };
        let sum = match self.kinds[k] {
            Kind::End => cheapest,
            Kind::Closed => {
                two.iter().zip(pay).map(|(t, p)| t[0].0 + t[1].0 + p).fold(f64::INFINITY, f64::min)
            }
            Kind::Paired => {
                two.chunks_exact(2).zip(pay.chunks_exact(2)).map(of_ends).fold(f64::INFINITY, f64::min)
            }
        };
        (sum, cheapest)
    }

    /// Pairs without shares whose legs take less than is paid for them, and by how much at most.
    fn missing(&self, far: &[f64]) -> Vec<([usize; 2], f64)> {
        let count = self.items.len();
        let mut missing = Vec::new();
        if self.prices.given() {
            return missing;
        }
        let mut most = far.to_vec();
        for cut in &self.cuts {
            cut.places.held.iter().for_each(|h| most[h.0] += cut.price);
        }
        let of = self.priced_cuts();
        let mut known = vec![usize::MAX; count];
        for a in self.first..count {
            for &(e, side) in &self.pairs.of[a] {
                known[self.pairs.list[e].items[1 - side]] = a;
            }
            let p = self.items[a].around;
            for b in (a + 1..count).filter(|&b| known[b] != a) {
                let q = self.items[b].around;
                let seconds = box_seconds(&self.prices, p.min, p.max, q.min, q.max);
                if seconds < most[a] + most[b] {
                    let later = of[b].iter().filter(|c| of[a].binary_search(c).is_err());
                    let cuts = of[a].iter().chain(later).map(|&c| &self.cuts[c]);
                    let crossing: f64 = cuts.filter(|c| c.places.may_cross([a, b])).map(|c| c.price).sum();
                    let lost = far[a] + far[b] + crossing - seconds;
                    if lost > 0.0 {
                        missing.push(([a, b], lost));
                    }
                }
            }
        }
        missing
    }

    /// The certificate of the current shares; `None` if its numbers do not fit each other, which a fault of this program
    /// would be. The tables must have been adjusted.
    pub(super) fn written(&self) -> Option<Certificate> {
        let shares = self.fitted();
        let least: Vec<(f64, f64)> = (0..self.items.len()).map(|k| self.least(&shares, k)).collect();
        let (power, _) = unit(&self.items, &self.prices, &self.problem);
        let whole = |values: &[f64]| values.iter().map(|&s| units(s, power)).collect::<Vec<i64>>();
        let legs = self.pairs.list.iter().zip(&self.at).map(|(pair, at)| SharedLegs {
            items: pair.items,
            shares: [0, 1]
                .map(|side| whole(&shares[at[side]..at[side] + self.items[pair.items[side]].knots])),
        });
        let cuts = self.cuts.iter().filter(|c| c.price > 0.0);
        let mut certificate = Certificate {
            unit: power,
            knots: self.items.iter().map(|i| i.along.clone()).collect(),
            legs: legs.collect(),
            far: whole(&far(&least)),
            cuts: cuts.map(|c| priced(c, units(c.price, power))).collect(),
            bound: 0,
        };
        certificate.bound = i64::try_from(certificate.adds_up_to(&self.problem).ok()?).ok()?;
        Some(certificate)
    }
}

/// What each item can pay for legs without shares at least, so that none of them is among its cheapest two.
fn far(least: &[(f64, f64)]) -> Vec<f64> {
    least.iter().map(|&(sum, cheapest)| (sum - cheapest).max(0.5 * sum)).collect()
}

fn priced(cut: &Cut, price: i64) -> PricedCut {
    let part = |(item, held): &(usize, Option<Vec<bool>>)| {
        let held = held.as_ref()?;
        Some(Part { item: *item, knots: held.iter().enumerate().filter(|v| *v.1).map(|v| v.0).collect() })
    };
    PricedCut {
        members: cut.places.held.iter().filter(|h| h.1.is_none()).map(|h| h.0).collect(),
        parts: cut.places.held.iter().filter_map(part).collect(),
        visited: cut.places.visited,
        price,
    }
}
