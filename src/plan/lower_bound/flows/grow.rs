//! What a round prepares for the next: what must be remembered, which pairs need tables, and which pieces of contours are halved.

use super::super::halving;
use super::super::net::Item;
use super::super::pairs::Pairs;
use super::super::rounds::{extend_ng_set, nearest_ng_sets};
use super::before::Before;
use super::net::{MOST_LEGS, Net};
use super::{FlowBound, Task};
use crate::order::{real, sort_by};
use std::collections::{BTreeMap, BTreeSet};

/// States that a round adds, about, as a share of those there are: after the first of them other circles are best.
const ADDED: f64 = 0.3;
/// Far pairs that are used more often than this get tables.
const USED: f64 = 0.01;
/// Seconds lost, as a share of the value, that are not worth halving pieces.
const LITTLE: f64 = 0.002;
/// Most numbers in the tables of legs, and in a row: 64 and 16 MB.
const MOST_NUMBERS: usize = 8_000_000;
const MOST_WIDTH: usize = 2_000_000;
/// No round adds anything when more legs matter than this: 100 MB, and up to three times as many in the next round.
const MOST_USED: usize = 4_000_000;

impl FlowBound {
    /// Makes the states, with the potentials that they had. Returns whether there is room for them.
    pub(super) fn lay_out(&mut self) -> bool {
        let ground = &mut self.ground;
        if ground.ng_sets.iter().all(Vec::is_empty) {
            ground.ng_sets = nearest_ng_sets(&ground.items, ground.first, &ground.pairs);
        }
        let before = self.before.take();
        let mut net = Net::new(ground);
        if net.is_none()
            && let Some(before) = &before
        {
            // Too many states: what was remembered before must do.
            ground.ng_sets.iter_mut().zip(&before.members).for_each(|(list, &n)| list.truncate(n));
            net = Net::new(ground);
        }
        let Some(net) = net else { return false };
        self.net = net;
        self.potentials = match before {
            None => vec![0.0; self.net.width],
            Some(before) => self.taken_over(&before),
        };
        self.flow.usage = vec![0.0; self.ground.pairs.list.len()];
        self.flow.far.clear();
        self.find_crossings();
        true
    }

    /// The potentials of the states before: of a state that has just come about, those of the one in which less was barred.
    fn taken_over(&self, before: &Before) -> Vec<f64> {
        let known: BTreeMap<_, _> = before.net.keys.iter().zip(0..).map(|(key, s)| (*key, s)).collect();
        let mut potentials = vec![0.0; self.net.width];
        for (s, &(item, barred)) in self.net.keys.iter().enumerate() {
            let then = barred & (1_u32 << before.members[item]).wrapping_sub(1);
            let of_item = before.net.of[item].first();
            let Some(&old) = known.get(&(item, then)).or(of_item) else { continue };
            let old = &before.potentials[before.net.range(old)];
            let new = before.around[item].iter().map(|[v, w]| 0.5 * (old[*v] + old[*w]));
            potentials[self.net.range(s)].iter_mut().zip(new).for_each(|(potential, new)| *potential = new);
        }
        potentials
    }

    /// The first potentials: the cheapest leg that leaves an item, and not only that which comes to it, pays all it costs.
    pub(super) fn reduce(&mut self) {
        self.look();
        let mut leaves = vec![f64::INFINITY; self.ground.items.len()];
        for step in &self.net.steps {
            let least = self.ground.pairs.list[step.pair.0].least - self.pays[self.net.keys[step.to].0];
            leaves[step.from] = leaves[step.from].min(least);
        }
        for (s, key) in self.net.keys.iter().enumerate().filter(|k| leaves[k.1.0].is_finite()) {
            self.potentials[self.net.range(s)].fill(-leaves[key.0].max(0.0));
        }
    }

    /// Gives tables to the far pairs that are used or hold the value back.
    pub(super) fn add_tables(&mut self) {
        if self.want_tables() {
            let next = self.ground.pairs.list.len();
            self.prepare(self.members(), self.same_knots(), next);
        }
    }

    /// Begins a round. Returns whether anything is different in it.
    pub(super) fn grow(&mut self) -> bool {
        self.select();
        self.step();
        let full = self.net.sources.len() > MOST_LEGS / 2
            || self.net.width > MOST_WIDTH
            || self.legs.legs.len() > MOST_USED;
        let members = self.members();
        let fuller = !full && self.remember();
        let around = if full { None } else { self.halve() };
        let nearer = self.want_tables();
        if !(fuller || nearer || around.is_some()) {
            return false;
        }
        let next = if around.is_some() { 0 } else { self.ground.pairs.list.len() };
        let around = around.unwrap_or_else(|| self.same_knots());
        self.prepare(members, around, next);
        true
    }

    /// The size of each ng-set.
    fn members(&self) -> Vec<usize> {
        self.ground.ng_sets.iter().map(Vec::len).collect()
    }

    /// For each knot of each item itself twice: see [`Before::around`].
    fn same_knots(&self) -> Vec<Vec<[usize; 2]>> {
        self.ground.items.iter().map(|i| (0..i.knots).map(|v| [v; 2]).collect()).collect()
    }

    /// Keeps the potentials, and goes on with the tables of pairs from `next` on. `members`: the size of each ng-set when the states of these potentials were
    /// made; `around`: see [`Before::around`].
    fn prepare(&mut self, members: Vec<usize>, around: Vec<Vec<[usize; 2]>>, next: usize) {
        self.before = Some(Before {
            net: std::mem::take(&mut self.net),
            potentials: std::mem::take(&mut self.potentials),
            members,
            around,
        });
        if next == 0 {
            self.ground.pairs = Pairs::new(self.ground.items.len());
        }
        self.task = Task::Table(next);
    }

    /// Excludes the circles that are used most for each state that this costs. Returns whether there were any.
    fn remember(&mut self) -> bool {
        let states: Vec<usize> = self.net.of.iter().map(Vec::len).collect();
        let mut faults = self.faults();
        sort_by(&mut faults, |(walk, uses)| {
            let cost: usize = walk[1..walk.len() - 1].iter().map(|&i| states[i]).sum();
            [u64::MAX - real(*uses as f64 / cost.max(1) as f64), walk.len() as u64, 0]
        });
        let mut left = ADDED * self.net.keys.len() as f64;
        let mut added = false;
        for (walk, _) in &faults {
            let last = walk.len() - 1;
            for &between in &walk[1..last] {
                for fault in [walk[0], walk[last]] {
                    if extend_ng_set(&mut self.ground.ng_sets, between, fault) {
                        left -= states[between] as f64;
                        added = true;
                    }
                }
            }
            if left < 0.0 {
                break;
            }
        }
        added
    }

    /// Notes which far pairs shall have tables: half as many as there are items at most. Returns whether there are any.
    fn want_tables(&mut self) -> bool {
        let used = self.flow.far.iter().filter(|f| f.2 > USED).map(|f| [f.0.min(f.1), f.0.max(f.1)]);
        let mut known: BTreeSet<[usize; 2]> = self.wanted.iter().copied().collect();
        let before = self.wanted.len();
        let most = before + self.ground.count().div_ceil(2);
        for ends in used.chain(std::mem::take(&mut self.missing)) {
            if self.wanted.len() < most && known.insert(ends) {
                self.wanted.push(ends);
            }
        }
        self.wanted.len() > before
    }

    /// Halves the pieces beside the knots with the largest losses. Returns for each new knot the two old ones around it; `None` if nothing is halved.
    fn halve(&mut self) -> Option<Vec<Vec<[usize; 2]>>> {
        let lost = self.lost();
        let numbers: usize =
            self.wanted.iter().map(|&[a, b]| self.ground.items[a].knots * self.ground.items[b].knots).sum();
        if lost.iter().flatten().sum::<f64>() < LITTLE * self.best || numbers > MOST_NUMBERS / 2 {
            return None;
        }
        let marks = halving::marks(&self.ground.items, &lost)?;
        let halve = |(item, marked): (&mut Item, &Vec<bool>)| {
            let same = (0..item.knots).map(|v| [v; 2]).collect();
            halving::halved(item, marked).map_or(same, |(finer, around)| {
                *item = finer;
                around
            })
        };
        Some(self.ground.items.iter_mut().zip(&marks).map(halve).collect())
    }
}
