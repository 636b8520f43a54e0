//! Cuts as certificates by shares, by walks and by flows list them, and as their checks read them.

use super::net::Item;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Most knots of items that cuts hold in part, a knot once for each of them: at most 160 MB.
pub(super) const MOST_HELD: usize = 20_000_000;

/// Places that a tour enters and leaves if it stops at one of them: whole items, and some knots of others.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PricedCut {
    /// The items it holds whole, without home, in ascending order.
    pub members: Vec<usize>,
    /// The items of which it holds some knots, in ascending order.
    pub parts: Vec<Part>,
    /// The item of `parts` that pays twice the price where a tour stops at one of its knots here. Without one, every tour pays
    /// it, because it stops at a member.
    pub visited: Option<usize>,
    /// What each leg into it or out of it pays, in units; not negative.
    pub price: i64,
}

/// Some knots of an item.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// The item.
    pub item: usize,
    /// Its knots in the cut, in ascending order; of the two ends of an open contour both or none.
    pub knots: Vec<usize>,
}

/// The cuts as the check reads them.
pub(super) struct Cuts<'c> {
    list: &'c [PricedCut],
    /// For each item the cuts that hold some of it: which of its knots, or all.
    of: Vec<BTreeMap<usize, Option<Vec<bool>>>>,
    /// For each item the prices of the cuts that hold some of it.
    pub(super) touching: Vec<i128>,
    /// For each knot of each item what a stop there pays.
    pub(super) pay: Vec<Vec<i128>>,
    /// What is added because every tour pays it.
    pub(super) back: i128,
}

impl<'c> Cuts<'c> {
    /// `None` if the cuts do not fit the items.
    pub(super) fn read(list: &'c [PricedCut], items: &[Item], first: usize) -> Option<Self> {
        let mut cuts = Self {
            list,
            of: vec![BTreeMap::new(); items.len()],
            touching: vec![0; items.len()],
            pay: items.iter().map(|i| vec![0; i.knots]).collect(),
            back: 0,
        };
        let mut all_held = 0;
        for (c, cut) in list.iter().enumerate() {
            let price = i128::from(cut.price);
            let inside = |item: usize| item >= first && item < items.len();
            let ascending =
                cut.members.is_sorted_by(|a, b| a < b) && cut.parts.is_sorted_by(|a, b| a.item < b.item);
            if price < 0 || !ascending {
                return None;
            }
            for &m in cut.members.iter().filter(|m| inside(**m)) {
                cuts.of[m].insert(c, None);
            }
            for part in cut.parts.iter().filter(|p| inside(p.item)) {
                let held = held(part, &items[part.item])?;
                all_held += held.len();
                if all_held > MOST_HELD {
                    return None;
                }
                if cut.visited == Some(part.item) {
                    cuts.pay[part.item]
                        .iter_mut()
                        .zip(&held)
                        .filter(|p| *p.1)
                        .for_each(|p| *p.0 += 2 * price);
                }
                cuts.of[part.item].insert(c, Some(held));
            }
            let touched = cuts.of.iter_mut().zip(&mut cuts.touching).filter(|(of, _)| of.contains_key(&c));
            let known = touched.map(|(_, touching)| *touching += price).count();
            // An item that is not there, or in both lists, is missing.
            let named = cut.visited.is_none_or(|v| cut.parts.iter().any(|p| p.item == v));
            if known != cut.members.len() + cut.parts.len() || !named {
                return None;
            }
            if cut.visited.is_none() {
                if cut.members.is_empty() {
                    return None;
                }
                cuts.back += 2 * price;
            }
        }
        Some(cuts)
    }

    /// How many cuts hold one of two items in part, or at most twice as many as do.
    pub(super) fn in_part(&self, items: [usize; 2]) -> usize {
        items.iter().map(|&k| self.of[k].values().filter(|held| held.is_some()).count()).sum()
    }

    /// For each leg between two items, row by row, the prices of the cuts it crosses.
    pub(super) fn between(&self, [a, b]: [usize; 2], [n, m]: [usize; 2]) -> Vec<i128> {
        let mut crossing = vec![0; n * m];
        // The prices of cuts that all of these legs cross.
        let mut all = 0;
        let mut add = |c: usize| {
            let [x, y] = [a, b].map(|k| self.of[k].get(&c));
            match (x, y) {
                (Some(None), Some(None)) => return,
                (Some(None), None) | (None, Some(None)) => {
                    all += i128::from(self.list[c].price);
                    return;
                }
                _ => {}
            }
            let holds = |held: Option<&Option<Vec<bool>>>, knot: usize| {
                held.is_some_and(|knots| knots.as_ref().is_none_or(|knots| knots[knot]))
            };
            for (k, paid) in crossing.iter_mut().enumerate() {
                if holds(x, k / m) != holds(y, k % m) {
                    *paid += i128::from(self.list[c].price);
                }
            }
        };
        self.of[a].keys().for_each(|&c| add(c));
        self.of[b].keys().filter(|c| !self.of[a].contains_key(c)).for_each(|&c| add(c));
        crossing.iter_mut().for_each(|paid| *paid += all);
        crossing
    }

    /// At least what any leg between two items pays to the cuts.
    pub(super) fn most_between(&self, [a, b]: [usize; 2]) -> i128 {
        let price = |c: &usize| i128::from(self.list[*c].price);
        let crossed = |(c, held): (&usize, &Option<Vec<bool>>)| match self.of[b].get(c) {
            Some(None) if held.is_none() => 0,
            _ => price(c),
        };
        let of_a: i128 = self.of[a].iter().map(crossed).sum();
        of_a + self.of[b].keys().filter(|c| !self.of[a].contains_key(c)).map(price).sum::<i128>()
    }
}

/// Which knots of its item a part holds; `None` if they do not fit it.
fn held(part: &Part, item: &Item) -> Option<Vec<bool>> {
    let mut held = vec![false; item.knots];
    for &knot in &part.knots {
        let before = std::mem::replace(held.get_mut(knot)?, true);
        if before {
            return None;
        }
    }
    let whole_pairs = !item.paired || held.chunks_exact(2).all(|ends| ends[0] == ends[1]);
    whole_pairs.then_some(held)
}
