//! States and the legs between them.
//!
//! Each item has a list of others, its ng-set. In a state of the item, some of them are **barred**: a tour must not visit them any more, because
//! it has been there, or because they should have come before an item it has been to. What is barred stays known as long as it is in
//! the ng-sets of all items since (ng-routes: Baldacci, Mingozzi & Roberti, 2011). Home is a state like others, where tours begin and end.

use super::super::space::Step;
use super::super::walks::Ground;
use super::reach::{Key, Leg, on_circles};
use crate::order::sort_by;
use std::collections::BTreeMap;
use std::ops::Range;

/// Most legs between states: 100 MB with all that belongs to them.
pub(super) const MOST_LEGS: usize = 2_000_000;

/// All states that a circle through home comes to, and the legs between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Net {
    /// The last is home.
    pub(super) keys: Vec<Key>,
    /// Where each state's knots start in a row of numbers.
    pub(super) at: Vec<usize>,
    /// Length of a row.
    pub(super) width: usize,
    /// By the state they lead to, those of home last.
    pub(super) steps: Vec<Step>,
    pub(super) sources: Vec<usize>,
    /// The states of each item.
    pub(super) of: Vec<Vec<usize>>,
    /// For each item the state in which nothing is barred, if there is one.
    pub(super) fresh: Vec<Option<usize>>,
    /// States that tours come to and from which they do not come home.
    pub(super) dead_ends: Vec<Key>,
    /// For each item those from where a tour may come without a table, with the seconds between their boxes. All else is forgotten then.
    pub(super) far: Vec<Vec<(usize, f64)>>,
}

impl Net {
    /// `None` when there would be too many legs.
    pub(super) fn new(ground: &Ground) -> Option<Self> {
        let count = ground.items.len();
        let (mut keys, legs) = states(ground)?;
        let home = keys.len();
        keys.push((0, 0));
        let mut net = Self { keys, of: vec![Vec::new(); count], fresh: vec![None; count], ..Self::default() };
        net.add_far(ground);
        let legs = net.with_home(legs, ground);
        let [comes, goes] = on_circles(&net.keys, &legs, &net.far);
        let stays: Vec<bool> = comes.iter().zip(&goes).map(|(a, b)| *a && *b).collect();
        let dead = |s: &usize| comes[*s] && !goes[*s];
        net.dead_ends = (0..home).filter(dead).map(|s| net.keys[s]).collect();
        let mut new = vec![usize::MAX; home + 1];
        let all = std::mem::take(&mut net.keys);
        for (s, &(item, barred)) in all.iter().enumerate().filter(|(s, _)| stays[*s]) {
            new[s] = net.keys.len();
            net.of[item].push(new[s]);
            if barred == 0 {
                net.fresh[item] = Some(new[s]);
            }
            net.keys.push((item, barred));
            net.at.push(net.width);
            net.width += ground.items[item].knots;
        }
        for (item, far) in net.far.iter_mut().enumerate() {
            if net.fresh[item].is_none() {
                far.clear();
            }
        }
        for [to, from, source] in legs.into_iter().filter(|&[to, _, source]| stays[to] && stays[source]) {
            let to = new[to];
            if let Some(last) = net.steps.last_mut().filter(|l| l.to == to && l.from == from) {
                last.sources.end += 1;
            } else {
                let item = net.keys[to].0;
                // The end of an open path is home too.
                let pair = ground.pair(from, if item == 0 { ground.first - 1 } else { item })?;
                let start = net.sources.len();
                net.steps.push(Step { from, to, pair, sources: start..start + 1 });
            }
            net.sources.push(new[source]);
        }
        Some(net)
    }

    /// The state of home.
    pub(super) fn home(&self) -> usize {
        self.keys.len() - 1
    }

    /// The numbers of a state in a row.
    pub(super) fn range(&self, state: usize) -> Range<usize> {
        self.at[state]..self.at.get(state + 1).copied().unwrap_or(self.width)
    }

    fn add_far(&mut self, ground: &Ground) {
        let count = ground.items.len();
        let mut near = vec![false; count * count];
        for pair in &ground.pairs.list {
            let [a, b] = pair.items;
            near[a * count + b] = true;
            near[b * count + a] = true;
        }
        let far = |to: usize| {
            let may = |&from: &usize| {
                from != to && !near[from * count + to] && !ground.order.forbids(from, to, false)
            };
            if to < ground.first {
                return Vec::new();
            }
            (ground.first..count).filter(may).map(|from| (from, ground.gap(from, to))).collect()
        };
        self.far = (0..count).map(far).collect();
    }

    /// All legs with those from home and to it, in order.
    fn with_home(&self, mut legs: Vec<Leg>, ground: &Ground) -> Vec<Leg> {
        let home = self.home();
        for (s, &(item, barred)) in self.keys.iter().enumerate().take(home) {
            if barred == 0 && ground.order.places[item][0] <= 1 {
                legs.push([s, 0, home]);
            }
            if ground.order.places[item][1] >= ground.count() {
                legs.push([home, item, s]);
            }
        }
        sort_by(&mut legs, |l| l.map(|x| x as u64));
        legs
    }
}

/// The states that tours come to between items with tables, and the legs between them.
fn states(ground: &Ground) -> Option<(Vec<Key>, Vec<Leg>)> {
    let (count, first) = (ground.items.len(), ground.first);
    let order = &ground.order;
    let is_barred = |past: usize, item: usize| item == past || order.forbids(past, item, false);
    let mut near: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (from, near) in near.iter_mut().enumerate().skip(first) {
        let leads = |&&(_, side): &&(usize, usize)| side == 0 || !ground.prices.directed();
        let pairs = ground.pairs.of[from].iter().filter(leads);
        let others = pairs.map(|&(e, side)| ground.pairs.list[e].items[1 - side]);
        near.extend(others.filter(|&to| to >= first && !order.forbids(from, to, false)));
        near.sort_unstable();
        near.dedup();
    }
    let mut known: BTreeMap<Key, usize> = BTreeMap::new();
    let mut keys: Vec<Key> = Vec::new();
    let mut state = |keys: &mut Vec<Key>, key: Key| {
        *known.entry(key).or_insert_with(|| {
            keys.push(key);
            keys.len() - 1
        })
    };
    for item in first..count {
        state(&mut keys, (item, 0));
    }
    let mut legs = Vec::new();
    let mut s = 0;
    while let Some(&(item, bits)) = keys.get(s) {
        let past: Vec<usize> = barred(&ground.ng_sets, (item, bits)).chain([item]).collect();
        for &next in near[item].iter().filter(|&&next| !past.iter().any(|&p| is_barred(p, next))) {
            let kept = |c: &usize| past.iter().any(|&p| is_barred(p, *c));
            let bits = ground.ng_sets[next].iter().enumerate().filter(|(_, c)| kept(c));
            let to = state(&mut keys, (next, bits.fold(0, |m, (bit, _)| m | 1 << bit)));
            legs.push([to, item, s]);
        }
        if legs.len() > MOST_LEGS {
            return None;
        }
        s += 1;
    }
    Some((keys, legs))
}

/// The items barred in a state.
pub(super) fn barred(ng_sets: &[Vec<usize>], (item, bits): Key) -> impl Iterator<Item = usize> + '_ {
    ng_sets[item].iter().enumerate().filter(move |(bit, _)| bits >> bit & 1 == 1).map(|(_, &c)| c)
}
