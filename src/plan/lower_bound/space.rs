//! The states of walks: the item where a walk is, and which items of that item's own list it remembers.
//!
//! Each item has a list of others, its ng-set. A walk remembers an item as long as it is in the ng-set of every item passed
//! since (ng-routes: Baldacci, Mingozzi & Roberti, 2011). It does not go back to an item it remembers, nor to one that must
//! come before an item it remembers. With empty lists a walk may go back and forth; with complete lists it is a tour. Lists
//! grow where walks go in circles.

use super::order::Order;
use super::pairs::Pairs;
use crate::order::sort_by;
use std::ops::Range;

/// Most states times items: sorting a million legs takes some tenths of a second.
const MOST_LEGS: usize = 1_000_000;

/// An item, and the members of its ng-set that are remembered, as bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) item: usize,
    pub(super) memory: u32,
}

/// Legs from one item to a state of another, between items whose pair has a table.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) from: usize,
    pub(super) to: usize,
    /// The pair and which of its two items is left.
    pub(super) pair: (usize, usize),
    /// The states left, a range of [`Space::sources`].
    pub(super) sources: Range<usize>,
}

/// All states and the legs between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Space {
    pub(super) states: Vec<State>,
    /// Where each state's knots start in a row of values.
    pub(super) at: Vec<usize>,
    /// Length of a row.
    pub(super) width: usize,
    /// By the state they lead to.
    pub(super) steps: Vec<Step>,
    pub(super) sources: Vec<usize>,
    /// The states of each item; the first of them remembers nothing.
    pub(super) of: Vec<Vec<usize>>,
    /// For each item those from where a walk may come without a table, with the seconds between their boxes. Such a walk forgets everything, so
    /// that these legs, which are most of all but seldom good, need no sums for each state and knot.
    pub(super) far: Vec<Vec<(usize, f64)>>,
}

impl Space {
    /// All states a walk can come to, for walks along the order or against it; `None` when there are too many.
    /// `ng_sets`: which items each remembers; contours are the items from `first` on; `directed`: prices differ by
    /// direction; `gap`: the seconds between the boxes of two items.
    pub(super) fn new(
        (ng_sets, first): (&[Vec<usize>], usize),
        order: &Order,
        pairs: &Pairs,
        [directed, backwards]: [bool; 2],
        gap: impl Fn(usize, usize) -> f64,
    ) -> Option<Self> {
        let count = ng_sets.len();
        let mut space = Self { of: vec![Vec::new(); count], far: vec![Vec::new(); first], ..Self::default() };
        let table: Vec<Vec<Option<(usize, usize)>>> =
            (0..count).map(|to| Self::legs_to(pairs, to, directed, backwards)).collect();
        let mut near: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (to, table) in table.iter().enumerate().skip(first) {
            let allowed = |&from: &usize| from != to && !order.forbids(from, to, backwards);
            let (with, without): (Vec<usize>, Vec<usize>) =
                (first..count).filter(allowed).partition(|&from| table[from].is_some());
            with.into_iter().for_each(|from| near[from].push(to));
            space.far.push(without.into_iter().map(|from| (from, gap(from, to))).collect());
        }
        for item in first..count {
            space.state(item, 0);
        }
        // State led to, item left, state left.
        let mut legs: Vec<[usize; 3]> = Vec::new();
        let mut s = 0;
        while s < space.states.len() {
            if space.states.len() * count > MOST_LEGS {
                return None;
            }
            let State { item, memory } = space.states[s];
            let past = remembered(ng_sets, item, memory);
            for &next in &near[item] {
                let out = past.iter().any(|&p| p == next || order.forbids(p, next, backwards));
                if out {
                    continue;
                }
                let kept = |c: &usize| *c == item || past.contains(c);
                let bits = ng_sets[next].iter().enumerate().filter(|(_, c)| kept(c));
                let to = space.state(next, bits.fold(0, |m, (bit, _)| m | 1 << bit));
                legs.push([to, item, s]);
            }
            s += 1;
        }
        sort_by(&mut legs, |l| l.map(|x| x as u64));
        for [to, from, source] in legs {
            let last = space.steps.last_mut().filter(|l| l.to == to && l.from == from);
            if let Some(step) = last {
                step.sources.end += 1;
            } else {
                let Some(pair) = table[space.states[to].item][from] else { continue };
                let start = space.sources.len();
                space.steps.push(Step { from, to, pair, sources: start..start + 1 });
            }
            space.sources.push(source);
        }
        Some(space)
    }

    /// The pairs that have a table of the legs to an item, by the item left, and which of the two items of the pair is left.
    pub(super) fn legs_to(
        pairs: &Pairs,
        to: usize,
        directed: bool,
        backwards: bool,
    ) -> Vec<Option<(usize, usize)>> {
        let mut known = vec![None; pairs.of.len()];
        for &(e, side) in &pairs.of[to] {
            // Of two tables, one each way, that for legs to this item; backwards: from it.
            if !directed || (side == 1) != backwards {
                known[pairs.list[e].items[1 - side]] = Some((e, 1 - side));
            }
        }
        known
    }

    /// Lays the knots of all states out in a row.
    pub(super) fn lay_out(&mut self, knots: impl Fn(usize) -> usize) {
        self.width = 0;
        self.at.clear();
        for s in &self.states {
            self.at.push(self.width);
            self.width += knots(s.item);
        }
    }

    fn state(&mut self, item: usize, memory: u32) -> usize {
        let known = self.of[item].iter().find(|&&s| self.states[s].memory == memory);
        known.copied().unwrap_or_else(|| {
            self.of[item].push(self.states.len());
            self.states.push(State { item, memory });
            self.states.len() - 1
        })
    }
}

/// The items remembered at an item.
pub(super) fn remembered(ng_sets: &[Vec<usize>], item: usize, memory: u32) -> Vec<usize> {
    ng_sets[item].iter().enumerate().filter(|(bit, _)| memory >> bit & 1 == 1).map(|(_, &c)| c).collect()
}
