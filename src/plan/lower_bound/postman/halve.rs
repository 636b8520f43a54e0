//! Halves pieces of contours where the smooth solution uses legs that are priced below their real seconds.

use super::super::halving;
use super::super::net::Item;
use super::super::pairs::Pairs;
use super::{LOST, StopBound};

/// Legs that are used less lose nothing worth looking at.
const USED: f64 = 1e-3;

impl StopBound {
    /// Halves the pieces beside the knots with the largest losses. Returns whether there were any.
    pub(super) fn refine(&mut self) -> bool {
        let items: Vec<Item> = self.members.iter().map(|m| m.item.clone()).collect();
        let places: Vec<_> = items.iter().map(halving::places).collect();
        let mut lost: Vec<Vec<f64>> = items.iter().map(|i| vec![0.0; i.knots]).collect();
        // Pairs that were added since legs were selected have none yet.
        for (pair, legs) in self.pairs.list.iter().zip(self.starts.windows(2)) {
            let [a, b] = pair.items;
            if a < self.first && a > 0 {
                // The end of an open path, whose legs cost nothing.
                continue;
            }
            for l in legs[0]..legs[1] {
                if self.uses[l] < USED {
                    continue;
                }
                let [i, j] = self.active[l].ends.map(|v| v as usize);
                let (i, j) = (i - self.base[a], j - self.base[b]);
                let real = self.prices.real([(a, i), (b, j)].map(|(k, v)| (&items[k], v, places[k][v])));
                let by = self.uses[l] * (real - self.active[l].seconds).max(0.0);
                lost[a][i] += by;
                lost[b][j] += by;
            }
        }
        let all = 0.5 * lost.iter().flatten().sum::<f64>();
        if all < LOST * self.best {
            return false;
        }
        let Some(marks) = halving::marks(&items, &lost) else { return false };
        let mut potential = Vec::new();
        for (k, (item, marked)) in items.iter().zip(&marks).enumerate() {
            let old = &self.potential[self.base[k]..self.base[k] + item.knots];
            let Some((finer, around)) = halving::halved(item, marked) else {
                potential.extend_from_slice(old);
                continue;
            };
            potential.extend(around.iter().map(|[v, w]| 0.5 * (old[*v] + old[*w])));
            for cut in &mut self.cuts {
                if let Ok(at) = cut.held.binary_search_by(|h| h.0.cmp(&k)) {
                    let parts = &mut cut.held[at].1;
                    // A new knot between two parts is in the first.
                    *parts = around.iter().map(|[v, _]| parts[*v]).collect();
                }
            }
            self.members[k].item = finer;
        }
        self.potential = potential;
        self.lay_out();
        let items: Vec<Item> = self.members.iter().map(|m| m.item.clone()).collect();
        let mut pairs = Pairs::new(items.len());
        for pair in &self.pairs.list {
            pairs.add(&items, &self.prices, pair.items, true);
        }
        self.pairs = pairs;
        true
    }
}
