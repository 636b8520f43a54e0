//! The value of the shares as they are, with the real minima; and the certificate of it.

use super::super::certificate::{Certificate, PricedCut, SharedLegs, unit, units};
use super::super::pairs::box_seconds;
use super::cut::Cut;
use super::soft::cheapest_two;
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

    /// The value of the current shares, up to rounding. Legs between items without shares that would be used get shares.
    pub(super) fn look(&mut self) -> f64 {
        self.price_crossings();
        let shares = self.fitted();
        let far = self.far(&shares);
        let stars: f64 = (0..self.items.len()).map(|k| self.least(&shares, k).0).sum();
        let cuts: f64 = self.cuts.iter().map(|c| c.price).sum();
        let missing = self.missing(&far);
        let lost: f64 = missing.iter().map(|m| m.1).sum();
        for (ends, _) in &missing {
            self.pairs.add(&self.items, &self.prices, *ends, true);
            let e = self.pairs.list.len() - 1;
            self.share_evenly(e);
            self.usage.push(0.0);
            self.crossing.push(0.0);
            self.active.push(Vec::new());
            self.cuts.iter_mut().filter(|c| c.crosses(*ends)).for_each(|c| c.pairs.push(e));
        }
        stars + 2.0 * cuts - lost
    }

    /// The shares raised or lowered until the cheapest leg of each pair is paid exactly.
    fn fitted(&self) -> Vec<f64> {
        let mut shares = self.shares.clone();
        for (e, pair) in self.pairs.list.iter().enumerate() {
            let [n, m] = pair.items.map(|k| self.items[k].knots);
            let table = self.pairs.table(pair, n * m);
            let [a, b] = self.at[e];
            for (i, row) in table.chunks_exact(m).enumerate() {
                let least = row.iter().zip(&shares[b..]).map(|(t, s)| t - s).fold(f64::INFINITY, f64::min);
                shares[a + i] += 0.5 * (least - self.crossing[e] - shares[a + i]);
            }
            for j in 0..m {
                let left = |i: usize| table[i * m + j] - shares[a + i];
                shares[b + j] = (0..n).map(left).fold(f64::INFINITY, f64::min) - self.crossing[e];
            }
        }
        shares
    }

    /// The least that an item pays, and its cheapest share.
    fn least(&self, shares: &[f64], k: usize) -> (f64, f64) {
        let legs: Vec<usize> = self.pairs.of[k].iter().map(|&(e, side)| self.at[e][side]).collect();
        let two: Vec<[(f64, usize); 2]> =
            (0..self.items[k].knots).map(|v| cheapest_two(shares, &legs, v)).collect();
        let cheapest = two.iter().map(|t| t[0].0).fold(f64::INFINITY, f64::min);
        let of_ends = |ends: &[[(f64, usize); 2]]| {
            let [a, b] = [ends[0], ends[1]];
            if a[0].1 == b[0].1 { (a[0].0 + b[1].0).min(a[1].0 + b[0].0) } else { a[0].0 + b[0].0 }
        };
        let sum = match self.kinds[k] {
            Kind::End => cheapest,
            Kind::Closed => two.iter().map(|t| t[0].0 + t[1].0).fold(f64::INFINITY, f64::min),
            Kind::Paired => two.chunks_exact(2).map(of_ends).fold(f64::INFINITY, f64::min),
        };
        (sum, cheapest)
    }

    /// What each item can pay for legs without shares at least, so that none of them is among its cheapest two.
    fn far(&self, shares: &[f64]) -> Vec<f64> {
        let enough = |k: usize| {
            let (sum, cheapest) = self.least(shares, k);
            (sum - cheapest).max(0.5 * sum)
        };
        (0..self.items.len()).map(enough).collect()
    }

    /// Pairs without shares whose legs take less than is paid for them, and by how much.
    fn missing(&self, far: &[f64]) -> Vec<([usize; 2], f64)> {
        let count = self.items.len();
        let mut missing = Vec::new();
        if self.prices.given() {
            return missing;
        }
        let mut most = far.to_vec();
        for cut in &self.cuts {
            cut.members.iter().for_each(|&k| most[k] += cut.price);
        }
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
                    let crossing: f64 = self.cuts.iter().filter(|c| c.crosses([a, b])).map(|c| c.price).sum();
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
    /// would be.
    pub(super) fn written(&self) -> Option<Certificate> {
        let shares = self.fitted();
        let far = self.far(&shares);
        let (power, _) = unit(&self.items, &self.prices, &self.problem);
        let whole = |values: &[f64]| values.iter().map(|&s| units(s, power)).collect::<Vec<i64>>();
        let legs = self.pairs.list.iter().zip(&self.at).map(|(pair, at)| SharedLegs {
            items: pair.items,
            shares: [0, 1]
                .map(|side| whole(&shares[at[side]..at[side] + self.items[pair.items[side]].knots])),
        });
        let cuts = self.cuts.iter().filter(|c| c.price > 0.0);
        let priced = |c: &Cut| PricedCut { members: c.members.clone(), price: units(c.price, power) };
        let mut certificate = Certificate {
            unit: power,
            knots: self.items.iter().map(|i| i.along.clone()).collect(),
            legs: legs.collect(),
            far: whole(&far),
            cuts: cuts.map(priced).collect(),
            bound: 0,
        };
        certificate.bound = i64::try_from(certificate.proven(&self.problem).ok()?).ok()?;
        Some(certificate)
    }
}
