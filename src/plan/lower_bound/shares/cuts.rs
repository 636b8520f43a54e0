//! Sets of items with fewer than two legs to the others: every tour has two or more.

use super::ShareBound;
use super::cut::Cut;
use crate::order::{real, sort_by};

/// Fewer legs than this are a fault: the smooth solution is nowhere exact.
const ENOUGH: f64 = 1.98;
/// Pairs that are used less do not hold a set together.
const USED: f64 = 1e-3;

impl ShareBound {
    /// Adds cuts: joins items by the most used pairs first, and looks at each set that comes about. Cuts without a price
    /// and with legs enough are forgotten.
    pub(super) fn separate(&mut self) {
        let count = self.items.len();
        let little = 1e-9 * self.mean;
        self.cuts.retain(|c| c.price > little || c.legs < 2.0);
        let joins = |e: &usize| self.usage[*e] > USED && self.pairs.list[*e].items[0] >= self.first;
        let mut order: Vec<usize> = (0..self.pairs.list.len()).filter(joins).collect();
        sort_by(&mut order, |&e| [u64::MAX - real(self.usage[e]), e as u64, 0]);
        let mut group: Vec<usize> = (0..count).collect();
        let mut members: Vec<Vec<usize>> = (0..count).map(|k| vec![k]).collect();
        for e in order {
            let [mut a, mut b] = self.pairs.list[e].items.map(|k| group[k]);
            if a == b {
                continue;
            }
            if members[a].len() < members[b].len() {
                std::mem::swap(&mut a, &mut b);
            }
            let moved = std::mem::take(&mut members[b]);
            moved.iter().for_each(|&k| group[k] = a);
            members[a].extend(moved);
            if members[a].len() < count - self.first {
                self.offer_cut(&members[a], &group, a);
            }
        }
    }

    /// Adds a set as a cut if it has too few legs and is new.
    fn offer_cut(&mut self, members: &[usize], group: &[usize], of: usize) {
        let out = |&&(e, side): &&(usize, usize)| group[self.pairs.list[e].items[1 - side]] != of;
        let mut pairs: Vec<usize> = Vec::new();
        for &k in members {
            pairs.extend(self.pairs.of[k].iter().filter(out).map(|l| l.0));
        }
        let legs: f64 = pairs.iter().map(|&e| self.usage[e]).sum();
        if legs >= ENOUGH {
            return;
        }
        let mut members = members.to_vec();
        sort_by(&mut members, |&k| [k as u64, 0, 0]);
        if self.cuts.iter().all(|c| c.members != members) {
            self.cuts.push(Cut { members, pairs, price: 0.0, legs });
        }
    }
}
