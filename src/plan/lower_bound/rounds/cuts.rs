//! Cuts: sets of items that the mixture of walks comes to too seldom.

use super::super::charges::{Cut, HAS_CUTS};
use super::Strong;
use crate::order::{real, sort_by};

/// Fewest items: with fewer, walks come so near to tours that all orders can be looked at, for which cuts are in the way.
const FEWEST: usize = 65;
/// Legs that must be missing across a border.
const MISSING: f64 = 0.1;
/// Most cuts for each item, and most items for each cut that is added at once: each cut takes time in every step of the charges.
const MOST: usize = 4;
const AT_ONCE: usize = 2;

impl Strong {
    /// Adds cuts and moves the charges. Returns the work done, if there are any.
    pub(super) fn separate(&mut self, upper: f64) -> Option<u64> {
        if !HAS_CUTS {
            return None;
        }
        let count = self.ground.items.len();
        let (once, all) = (count / AT_ONCE, count * MOST);
        if self.without_cuts || self.ground.count() < FEWEST || self.charges.cuts().len() >= all {
            return None;
        }
        let mut cuts = missed(&self.legs(), self.ground.first, count);
        cuts.retain(|c| !self.charges.cuts().contains(&c.1));
        sort_by(&mut cuts, |c| [real(c.0), 0, 0]);
        cuts.truncate(once);
        if cuts.is_empty() {
            return None;
        }
        let cuts = cuts.into_iter().map(|c| c.1).collect();
        Some(self.bundle.add_cuts(cuts, &mut self.charges, upper))
    }

    /// How often the mixture goes from one of two items to the other, for all pairs, in rows.
    fn legs(&self) -> Vec<f64> {
        let count = self.ground.items.len();
        let mut legs = vec![0.0; count * count];
        let home = self.ground.first - 1;
        for (weight, walk) in self.bundle.mixture(false) {
            let mut last = 0;
            for item in walk.iter().map(|v| v.item).chain([home]) {
                legs[last * count + item] += weight;
                legs[item * count + last] += weight;
                last = item;
            }
        }
        legs
    }
}

/// Joins the two sets with the most legs between them again and again. Returns those sets that have too few legs to the rest: how many, and the set.
pub(super) fn missed(legs: &[f64], first: usize, count: usize) -> Vec<(f64, Cut)> {
    let mut between: Vec<Vec<f64>> = legs.chunks_exact(count).map(<[f64]>::to_vec).collect();
    let single = |item: usize| (0..count).map(|i| i == item).collect();
    let mut sets: Vec<Option<Cut>> = (0..count).map(|i| (i >= first).then(|| single(i))).collect();
    let mut missed = Vec::new();
    for _ in first..count {
        let mut best = (0.0, 0, 0);
        for a in (first..count).filter(|&a| sets[a].is_some()) {
            for b in (a + 1..count).filter(|&b| sets[b].is_some()) {
                if between[a][b] > best.0 {
                    best = (between[a][b], a, b);
                }
            }
        }
        let (most, a, b) = best;
        if most <= 0.0 {
            break;
        }
        let joined = sets[b].take();
        if let (Some(set), Some(more)) = (&mut sets[a], joined) {
            set.iter_mut().zip(more).for_each(|(s, m)| *s |= m);
        }
        let more = between[b].clone();
        for (c, more) in more.into_iter().enumerate() {
            between[a][c] += more;
            between[c][a] += more;
        }
        between[a][a] = 0.0;
        let out: f64 =
            (0..count).filter(|&c| c < first || (c != a && sets[c].is_some())).map(|c| between[a][c]).sum();
        if let Some(set) = sets[a].as_ref().filter(|_| out < 2.0 - MISSING) {
            missed.push((out, set.clone()));
        }
    }
    missed
}
