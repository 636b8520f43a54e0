//! Halves pieces of contours where the solution uses legs that are priced below their real seconds.

use super::super::net::Item;
use super::super::pairs::Pairs;
use super::ShareBound;
use crate::geometry::DVec2;
use crate::order::{real, sort_by};

/// Share of all lost seconds at the knots beside which pieces are halved: the rest costs more time than it gains.
const SHARE: f64 = 0.9;
/// Pairs that are used less lose nothing worth looking at.
const USED: f64 = 1e-4;

impl ShareBound {
    /// Halves the pieces beside the knots with the largest losses. Returns whether there were any.
    pub(super) fn refine(&mut self) -> bool {
        let lost = self.lost();
        let of_item = |(k, knots): (usize, &Vec<f64>)| {
            let halves = self.items[k].can_halve();
            knots.iter().enumerate().filter(|_| halves).map(|(v, &s)| (s, k, v)).collect::<Vec<_>>()
        };
        let mut ranked: Vec<(f64, usize, usize)> = lost.iter().enumerate().flat_map(of_item).collect();
        ranked.retain(|r| r.0 > 0.0);
        sort_by(&mut ranked, |r| [u64::MAX - real(r.0), r.1 as u64, r.2 as u64]);
        let mut rest = SHARE * ranked.iter().map(|r| r.0).sum::<f64>();
        let mut marks: Vec<Vec<bool>> = self.items.iter().map(|i| vec![false; i.pieces.len()]).collect();
        for &(seconds, k, v) in ranked.iter().take_while(|r| {
            let more = rest > 0.0;
            rest -= r.0;
            more
        }) {
            debug_assert!(seconds > 0.0, "sorted by what is lost");
            for (mark, piece) in marks[k].iter_mut().zip(&self.items[k].pieces) {
                *mark |= piece.knots.contains(&v);
            }
        }
        if !ranked.is_empty() {
            self.halve(&marks);
        }
        !ranked.is_empty()
    }

    /// For each knot the seconds by which the legs that are used at it are priced too low.
    fn lost(&self) -> Vec<Vec<f64>> {
        let places: Vec<Vec<DVec2>> = self.items.iter().map(places).collect();
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
                let real = self.prices.minorant.air().seconds(places[a][i], places[b][j]);
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
            let finer = if marked.contains(&true) { item.halved(marked) } else { None };
            let Some(finer) = finer else {
                around.push((0..item.knots).map(|v| [v; 2]).collect());
                continue;
            };
            let beside = |s: &f64| {
                let next = item.along.partition_point(|x| x < s);
                let same = item.along.get(next).is_some_and(|x| x.to_bits() == s.to_bits());
                let before = (next + item.knots - 1) % item.knots;
                if same { [next; 2] } else { [before, next % item.knots] }
            };
            around.push(finer.along.iter().map(beside).collect());
            *item = finer;
        }
        for cut in &mut self.cuts {
            for (k, held) in &mut cut.held {
                // A new knot between one inside and one outside is outside.
                if let Some(knots) = held {
                    *knots = around[*k].iter().map(|[v, w]| knots[*v] && knots[*w]).collect();
                }
            }
        }
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

/// Where the knots of an item are.
fn places(item: &Item) -> Vec<DVec2> {
    let mut places = vec![DVec2::ZERO; item.knots];
    for piece in &item.pieces {
        places[piece.knots[0]] = piece.ends[0];
        places[piece.knots[1]] = piece.ends[1];
    }
    places
}
