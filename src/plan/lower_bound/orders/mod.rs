//! The last step of a proof: every order of the items that may still be better than the known path.
//!
//! Dynamic programming over sets of visited items (Held & Karp, 1962) doubles its work with every item. Here a set with its
//! last item is dropped as soon as no walk that completes it is better than the known path. What walks take at least from any
//! item to the end, the table of the walks says, with all its rows from the end (state space relaxation as a completion bound:
//! Christofides, Mingozzi & Toth, 1981). When walks prove 98 % of the optimum, few sets are left, and precedence and "each item
//! once" hold exactly.
//!
//! If nothing is left, no path is better than the known one. Otherwise the least of what is left is a bound, and the orders
//! that are left show which pieces of contours they use and which are still priced too low.

mod back;

use super::charges::Charges;
use super::space::{Space, remembered};
use super::walks::{Ground, Pass, Visit, relax, relax_all};
use rustc_hash::FxHashMap;

/// Most items: their sets are the bits of a number.
const MOST_ITEMS: usize = 128;

/// What is left of all orders.
#[derive(Debug)]
pub(super) enum Left {
    /// No order is better than the known path.
    Nothing,
    /// Orders that are better than the known path.
    Orders(Better),
    /// More sets of items than there is room for.
    TooMany,
}

/// Orders that are better than the known path.
#[derive(Debug, Default)]
pub(super) struct Better {
    /// The least travel of them, s.
    pub(super) seconds: f64,
    /// The best order for each last item.
    pub(super) walks: Vec<Vec<Visit>>,
    /// For each item which of its knots they may use.
    pub(super) in_use: Vec<Vec<bool>>,
}

/// A set of visited items, as bits, and the last of them.
type Key = (u128, usize);

/// The look at all orders, in pieces of work.
#[derive(Debug)]
pub(super) struct Orders {
    /// What walks and orders pay.
    charges: Charges,
    /// Orders that take longer than this, with charges, are dropped.
    limit: f64,
    /// The walks from the end.
    pass: Pass,
    /// For each state of the walks from the end the items it remembers, as bits.
    memories: Vec<u128>,
    /// For each item those that must come before it.
    earlier: Vec<u128>,
    /// For each item the pairs of legs to it, by the item left.
    legs: Vec<Vec<Option<(usize, usize)>>>,
    /// The sets that are good enough, by their number of items, as far as they are known.
    levels: Vec<Level>,
    /// The sets with one item more: those still to be looked at, and those that are good enough.
    now: Level,
    queue: Vec<(Key, usize)>,
    kept: Level,
    /// The sets that continue those.
    next: Level,
    /// Numbers in `levels`, and most of them in all levels.
    numbers: usize,
    room: usize,
    /// The knot of home where the path starts.
    start: usize,
    /// All levels are known, and are now looked at from the last to the first: how many of them still.
    back: usize,
    better: Better,
}

/// Sets with the same number of items.
#[derive(Debug, Default)]
struct Level {
    /// Where the values of each set start.
    at: FxHashMap<Key, usize>,
    /// For each knot of the last item of a set the least seconds up to there, with charges.
    values: Vec<f64>,
    /// And from there to the end, as far as it is known.
    rest: Vec<f64>,
}

impl Level {
    /// Each set and where its values start, always in the same order.
    fn sets(&self) -> Vec<(Key, usize)> {
        let mut sets: Vec<_> = self.at.iter().map(|(&key, &at)| (key, at)).collect();
        sets.sort_unstable();
        sets
    }
}

impl Orders {
    /// Looks for orders that take less than `upper` s of travel; `None` if there are too many items.
    pub(super) fn new(ground: &Ground, charges: &Charges, upper: f64, room: usize) -> Option<Self> {
        if ground.count() > MOST_ITEMS {
            return None;
        }
        let (first, count) = (ground.first, ground.items.len());
        let bits = |items: &mut dyn Iterator<Item = usize>| items.fold(0, |set, i| set | 1 << (i - first));
        let end = ground.spaces.last()?;
        let memory =
            |s: &super::space::State| bits(&mut remembered(&ground.ng_sets, s.item, s.memory).into_iter());
        let before =
            |next: usize| bits(&mut (first..count).filter(|&past| ground.order.forbids(next, past, false)));
        let directed = ground.prices.directed();
        Some(Self {
            limit: upper + charges.back(),
            charges: charges.clone(),
            pass: Pass::default(),
            memories: end.states.iter().map(memory).collect(),
            earlier: (0..count).map(|i| if i < first { 0 } else { before(i) }).collect(),
            legs: (0..count).map(|to| Space::legs_to(&ground.pairs, to, directed, false)).collect(),
            levels: Vec::new(),
            now: Level::default(),
            queue: Vec::new(),
            kept: Level::default(),
            next: Level::default(),
            numbers: 0,
            room,
            start: 0,
            back: 0,
            better: Better {
                seconds: f64::INFINITY,
                walks: Vec::new(),
                in_use: ground.items.iter().enumerate().map(|(k, i)| vec![k < first; i.knots]).collect(),
            },
        })
    }

    /// Orders that take as long as this many seconds of travel are not looked for.
    pub(super) fn goal(&self) -> f64 {
        self.limit - self.charges.back()
    }

    /// Does one piece of work: its size, and what is left when all is done.
    pub(super) fn once(&mut self, ground: &Ground) -> (u64, Option<Left>) {
        if self.pass.rows() < ground.count() {
            let side = ground.spaces.len() - 1;
            ground.advance(side, &mut self.pass, &self.charges);
            return (ground.work(side), None);
        }
        if self.back > 0 {
            return self.look_back(ground);
        }
        if let Some((key, at)) = self.queue.pop() {
            let work = self.look_at(ground, key, at);
            let parts = [&self.now, &self.kept, &self.next];
            let full = self.numbers + parts.iter().map(|l| l.values.len()).sum::<usize>() > self.room;
            return (work, full.then_some(Left::TooMany));
        }
        if self.now.at.is_empty() && self.levels.is_empty() {
            self.begin(ground);
        } else {
            let kept = std::mem::take(&mut self.kept);
            self.numbers += kept.values.len();
            self.levels.push(kept);
            self.now = std::mem::take(&mut self.next);
        }
        let all = self.levels.len() == ground.count();
        self.back = if all { self.levels.len() } else { 0 };
        let next = if all { self.levels.last() } else { Some(&self.now) };
        self.queue = next.map(Level::sets).unwrap_or_default();
        (1 + self.queue.len() as u64, None)
    }

    /// The sets of one item.
    fn begin(&mut self, ground: &Ground) {
        for item in ground.first..ground.items.len() {
            if self.earlier[item] == 0 {
                self.now.at.insert((1 << (item - ground.first), item), self.now.values.len());
                for knot in 0..ground.items[item].knots {
                    let seconds = self.seconds(ground, (0, self.start), (item, knot));
                    self.now.values.push(seconds + self.charges.of_leg(0, item));
                }
            }
        }
    }

    /// Keeps a set and continues it by every item that may follow, unless no walk that completes it is good enough. Returns
    /// the work done.
    fn look_at(&mut self, ground: &Ground, (visited, item): Key, at: usize) -> u64 {
        let (from, first) = (&ground.items[item], ground.first);
        let mut values = self.now.values[at..at + from.knots].to_vec();
        // Stops that are still to be made, this one included.
        let rest = ground.count() - self.levels.len();
        let mut work = self.forget(ground, (visited, item), &mut values, rest);
        let low = values.iter().fold(f64::INFINITY, |m, &v| m.min(v));
        if low == f64::INFINITY {
            return work;
        }
        self.kept.at.insert((visited, item), self.kept.values.len());
        self.kept.values.extend_from_slice(&values);
        if from.paired {
            values.chunks_exact_mut(2).for_each(|ends| ends.swap(0, 1));
        }
        let Some(least) = self.pass.least(rest - 1) else { return work };
        for (next, least) in least.iter().enumerate().skip(first) {
            let bit = 1 << (next - first);
            if visited & bit != 0 || self.earlier[next] & !visited != 0 {
                continue;
            }
            let to = &ground.items[next];
            let leg = self.legs[next][item];
            let seconds = leg.map_or_else(|| ground.gap(item, next), |(e, _)| ground.pairs.list[e].least);
            if low + seconds - self.charges.between(item, next) + least > self.limit {
                continue;
            }
            let place = self.next.values.len();
            let at = *self.next.at.entry((visited | bit, next)).or_insert(place);
            if at == place {
                self.next.values.resize(place + to.knots, f64::INFINITY);
            }
            let (row, pay) = (&mut self.next.values[at..at + to.knots], self.charges.of_leg(item, next));
            match leg {
                Some(leg) => relax(row, &values, pay, ground.legs(leg)),
                None => relax_all(row, low + seconds + pay),
            }
            work += (from.knots * to.knots) as u64;
        }
        work
    }

    /// Forgets the knots of a set from where no walk with `rest` stops, this one included, is good enough. Returns the work.
    fn forget(&self, ground: &Ground, (visited, item): Key, values: &mut [f64], rest: usize) -> u64 {
        let (Some(space), Some(row)) = (ground.spaces.last(), self.pass.row(rest)) else { return 1 };
        let past = visited & !(1 << (item - ground.first));
        let mut best = vec![f64::INFINITY; values.len()];
        let mut work = space.of[item].len();
        for &s in space.of[item].iter().filter(|&&s| self.memories[s] & past == 0) {
            work += values.len();
            for (b, &v) in best.iter_mut().zip(&row[space.at[s]..]) {
                *b = if v < *b { v } else { *b };
            }
        }
        if ground.items[item].paired {
            // A walk from the end arrives where the path leaves.
            best.chunks_exact_mut(2).for_each(|ends| ends.swap(0, 1));
        }
        for (value, rest) in values.iter_mut().zip(best) {
            if *value + rest - self.charges.of(item) > self.limit {
                *value = f64::INFINITY;
            }
        }
        work as u64
    }

    /// What the bound charges for a leg from a knot of an item to a knot of another, s.
    fn seconds(&self, ground: &Ground, (from, left): (usize, usize), (to, knot): (usize, usize)) -> f64 {
        let (a, b) = (&ground.items[from], &ground.items[to]);
        match self.legs[to][from].map(|leg| ground.legs(leg)) {
            Some((table, true)) => table[left * b.knots + knot],
            Some((table, false)) => table[knot * a.knots + left],
            None => ground.gap(from, to),
        }
    }
}
