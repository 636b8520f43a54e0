//! The best of all orders, in whole numbers: which tours take less than what a certificate states.
//!
//! Dynamic programming over the sets of items that are still to come, from the end of the tour to its beginning. A set with its first item is kept only if
//! some walk from home leads there (`shortest.rs`) so cheaply that both together may take less than stated. Such a walk knows less than a tour: nothing
//! is dropped that a better tour needs. Where no set is left, no tour takes less. The search for the bound (`orders`) goes the other way, from home.

use super::super::fault::CertificateFault;
use super::shortest::{Costs, NONE, Walks, lower};
use std::collections::BTreeMap;

/// Most items: their sets are the bits of a number.
const MOST_ITEMS: usize = 128;
/// Most numbers in the rows of all stops: 200 MB. The search for the bound has room for half of it, but drops pieces of contours.
const MOST_NUMBERS: usize = 25_000_000;
/// Most numbers of the sets of one size: with the sets at most 250 MB. The search for the bound has room for four times as many in the sets of all sizes.
const MOST_IN_LEVEL: usize = 3_000_000;
/// Most sums beside those of the walks: about twenty seconds in wasm.
const MOST_WORK: u64 = 20_000_000_000;

/// Items still to come, as bits, and the first of them.
type Key = (u128, usize);

/// Sets of one size.
#[derive(Default)]
struct Level {
    /// Where the values of each set start.
    at: BTreeMap<Key, usize>,
    /// For each set the least that is still to be paid after the stop at its first item, by the knot where the tour arrives there.
    rest: Vec<i64>,
}

/// The look at all orders.
struct Orders<'c> {
    walks: &'c Walks<'c>,
    costs: &'c Costs,
    /// Tours that cost as much are not looked for.
    limit: i64,
    /// The values of walks from home, by their number of stops.
    rows: Vec<Vec<i64>>,
    /// For each of these the least value of each item.
    least: Vec<Vec<i64>>,
    /// For each item its states, with what is barred there, as bits.
    states: Vec<Vec<(usize, u128)>>,
    /// For each item those that come later in every tour.
    later: Vec<u128>,
    /// For each item those from where a tour may come, with the least that such a leg costs.
    before: Vec<Vec<(usize, i64)>>,
}

impl Walks<'_> {
    /// The least that tours cost which cost less than `limit`, and `limit` if none does.
    pub(super) fn best_tour(
        &self,
        costs: &Costs,
        ng_sets: &[Vec<usize>],
        limit: i64,
    ) -> Result<i64, CertificateFault> {
        let orders = Orders::new(self, costs, ng_sets, limit)?;
        let mut level = orders.ends();
        let mut work = 0;
        for ahead in 2..=orders.count() {
            level = orders.prepend(&level, ahead, &mut work)?;
        }
        let whole =
            level.at.iter().flat_map(|(&key, &at)| orders.whole(key, orders.rest(&level, key, at), 1));
        Ok(whole.fold(limit, i64::min))
    }
}

impl<'c> Orders<'c> {
    fn new(
        walks: &'c Walks<'c>,
        costs: &'c Costs,
        ng_sets: &[Vec<usize>],
        limit: i64,
    ) -> Result<Self, CertificateFault> {
        let (first, items) = (walks.first, walks.items.len());
        if items - first > MOST_ITEMS {
            return Err(CertificateFault::TooMuch("items in orders"));
        }
        if costs.width * (items - first) > MOST_NUMBERS {
            return Err(CertificateFault::TooMuch("knots in states of orders"));
        }
        let bits =
            |list: &mut dyn Iterator<Item = usize>| list.fold(0, |set, item| set | 1 << (item - first));
        let mut states = vec![Vec::new(); items];
        for (state, &item) in walks.states.item.iter().enumerate() {
            states[item].push((state, bits(&mut walks.states.barred_in(state, ng_sets))));
        }
        let must_follow =
            |item: usize| bits(&mut (first..items).filter(|&other| walks.order.forbids(other, item, false)));
        // Legs that are priced by boxes have no tables.
        let near = |to: usize| {
            let least = move |from: usize| costs.legs.between(from, to).0.iter().min();
            (first..items).filter_map(move |from| Some((from, *least(from)?)))
        };
        let before = |(to, far): (usize, &Vec<(usize, i64)>)| far.iter().copied().chain(near(to)).collect();
        let mut orders = Self {
            walks,
            costs,
            limit,
            rows: Vec::new(),
            least: Vec::new(),
            states,
            later: (0..items).map(|item| if item < first { 0 } else { must_follow(item) }).collect(),
            before: costs.legs.far.iter().enumerate().map(before).collect(),
        };
        for stop in 1..=items - first {
            let row = walks.row(orders.rows.last().map_or(&[], Vec::as_slice), stop, costs);
            let mut least = vec![NONE; items];
            for (&item, &at) in walks.states.item.iter().zip(&costs.at) {
                let values = row[at..at + walks.items[item].knots].iter().copied();
                least[item] = values.fold(least[item], i64::min);
            }
            orders.rows.push(row);
            orders.least.push(least);
        }
        Ok(orders)
    }

    /// How many items a tour visits.
    fn count(&self) -> usize {
        self.walks.items.len() - self.walks.first
    }

    /// The sets of one item, which is the last of the tour.
    fn ends(&self) -> Level {
        let (first, end) = (self.walks.first, self.walks.first - 1);
        let mut level = Level::default();
        for item in (first..self.walks.items.len()).filter(|&item| self.later[item] == 0) {
            let home = vec![0; self.walks.items[end].knots];
            let mut rest = vec![NONE; self.walks.items[item].knots];
            let (table, rows_left) = self.costs.legs.between(item, end);
            lower(&mut rest, &home, (table, !rows_left));
            self.keep((1 << (item - first), item), &rest, self.count(), &mut level);
        }
        level
    }

    /// The sets with one item more, `ahead` in all. `work`: sums of legs so far.
    fn prepend(&self, level: &Level, ahead: usize, work: &mut u64) -> Result<Level, CertificateFault> {
        let (first, stop) = (self.walks.first, self.count() + 1 - ahead);
        let mut found = Level::default();
        for (&(set, to), &at) in &level.at {
            // What is to be paid from the leg to this item on.
            let rest = self.rest(level, (set, to), at);
            let arrives: Vec<i64> =
                rest.iter().zip(&self.costs.pays[to]).map(|(rest, pay)| rest + pay).collect();
            let low = arrives.iter().copied().min().unwrap_or(NONE);
            for &(from, least) in &self.before[to] {
                let bit = 1 << (from - first);
                let follows = set & bit == 0 && self.later[from] & !set == 0;
                if !follows || self.least[stop - 1][from] + least + low >= self.limit {
                    continue;
                }
                let knots = self.walks.items[from].knots;
                let at = *found.at.entry((set | bit, from)).or_insert(found.rest.len());
                found.rest.resize(found.rest.len().max(at + knots), NONE);
                let rest = &mut found.rest[at..at + knots];
                let (table, rows_left) = self.costs.legs.between(from, to);
                if table.is_empty() {
                    rest.iter_mut().for_each(|r| *r = (least + low).min(*r));
                } else {
                    lower(rest, &arrives, (table, !rows_left));
                }
                *work += (knots * arrives.len()) as u64;
            }
            if found.rest.len() > MOST_IN_LEVEL || *work > MOST_WORK {
                return Err(CertificateFault::TooMuch("orders"));
            }
        }
        let mut kept = Level::default();
        for (&key, &at) in &found.at {
            let rest = self.rest(&found, key, at);
            *work += (self.states[key.1].len() * rest.len()) as u64;
            self.keep(key, rest, stop, &mut kept);
        }
        Ok(kept)
    }

    /// What is still to be paid after the stop at the first item of a set, whose values start at `at`.
    fn rest<'l>(&self, level: &'l Level, key: Key, at: usize) -> &'l [i64] {
        &level.rest[at..at + self.walks.items[key.1].knots]
    }

    /// Adds a set, unless no walk from home to its first item, the stop of this number, is cheap enough. `rest`: what is still to be paid, by the knot
    /// where that item is left.
    fn keep(&self, key: Key, rest: &[i64], stop: usize, level: &mut Level) {
        let mut rest = self.walks.left(key.1, rest);
        let whole: Vec<i64> = self.whole(key, &rest, stop).collect();
        rest.iter_mut().zip(&whole).filter(|r| *r.1 >= self.limit).for_each(|r| *r.0 = NONE);
        if whole.iter().any(|&whole| whole < self.limit) {
            level.at.insert(key, level.rest.len());
            level.rest.append(&mut rest);
        }
    }

    /// For each knot of the first item of a set, the stop of this number, the least that walks to there cost which have not been to the others, together
    /// with what is still to be paid.
    fn whole<'r>(&self, (set, item): Key, rest: &'r [i64], stop: usize) -> impl Iterator<Item = i64> + 'r {
        let others = set & !(1 << (item - self.walks.first));
        let mut come = vec![NONE; rest.len()];
        for &(state, _) in self.states[item].iter().filter(|s| s.1 & others == 0) {
            let row = &self.rows[stop - 1][self.costs.at[state]..];
            come.iter_mut().zip(row).for_each(|(c, &value)| *c = value.min(*c));
        }
        come.into_iter().zip(rest).map(|(come, rest)| if *rest < NONE / 2 { come + rest } else { NONE })
    }
}
