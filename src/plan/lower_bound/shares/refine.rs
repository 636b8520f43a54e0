//! Halves pieces of contours where the solution uses legs that are priced below their real seconds.

use super::super::halving;
use super::super::pairs::Pairs;
use super::ShareBound;
use crate::geometry::DVec2;

/// Pairs that are used less lose nothing worth looking at.
const USED: f64 = 1e-4;

impl ShareBound {
    /// Halves the pieces beside the knots with the largest losses. Returns whether there were any.
    pub(super) fn refine(&mut self) -> bool {
        let marks = halving::marks(&self.items, &self.lost());
        marks.is_some_and(|marks| {
            self.halve(&marks);
            true
        })
    }

    /// For each knot the seconds by which the legs that are used at it are priced too low.
    fn lost(&self) -> Vec<Vec<f64>> {
        let places: Vec<Vec<DVec2>> = self.items.iter().map(halving::places).collect();
        let mut lost: Vec<Vec<f64>> = self.items.iter().map(|i| vec![0.0; i.knots]).collect();
        if self.prices.given() {
            return lost;
        }
        for (e, pair) in self.pairs.list.iter().enumerate().filter(|(e, _)| self.usage[*e] >= USED) {
            let [a, b] = pair.items;
            if a < self.first && a > 0 {
                // The end of an open path, whose legs cost nothing.
                continue;
            }
            for l in self.starts[e]..self.starts[e + 1] {
                let [i, j] = [self.active[l].i, self.active[l].j].map(|v| v as usize);
                let real = self.prices.real([(a, i), (b, j)].map(|(k, v)| (&self.items[k], v, places[k][v])));
                let by = self.uses[l] * (real - self.active[l].seconds).max(0.0);
                lost[a][i] += by;
                lost[b][j] += by;
            }
        }
        lost
    }

    /// Halves the marked pieces; shares of new knots are the means of those beside them.
    fn halve(&mut self, marks: &[Vec<bool>]) {
        // For each new knot the two old ones around it, or twice the same.
        let mut around: Vec<Vec<[usize; 2]>> = Vec::with_capacity(self.items.len());
        for (item, marked) in self.items.iter_mut().zip(marks) {
            let Some((finer, of)) = halving::halved(item, marked) else {
                around.push((0..item.knots).map(|v| [v; 2]).collect());
                continue;
            };
            around.push(of);
            *item = finer;
        }
        self.cuts.iter_mut().for_each(|cut| cut.places.halve(&around));
        self.lay_out();
        let mut pairs = Pairs::new(self.items.len());
        let mut shares = Vec::new();
        for (pair, at) in self.pairs.list.iter().zip(&mut self.at) {
            pairs.add(&self.items, &self.prices, pair.items, true);
            for (start, k) in at.iter_mut().zip(pair.items) {
                let old = *start;
                *start = shares.len();
                shares.extend(
                    around[k].iter().map(|[v, w]| 0.5 * (self.shares[old + v] + self.shares[old + w])),
                );
            }
        }
        self.pairs = pairs;
        self.wanted = vec![0.0; shares.len()];
        self.offered = vec![0.0; shares.len()];
        self.shares = shares;
    }
}
