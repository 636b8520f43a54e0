//! 2-opt and Or-opt over near items, an item at a time, the best of its moves taken while one gains; items whose
//! neighbours changed come again.
//!
//! A stretch is turned by entering each of its items at its twin node, so ways inside it stay what they are: open
//! contours run the other way. With a table whose ways back differ nothing is turned.

use super::super::legs::Legs;
use super::near::Near;
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use std::collections::VecDeque;

/// Longest chain of items moved by Or-opt (Or 1976).
const CHAIN: usize = 3;
/// Places shifted in memory for the price of one leg.
const SHIFTS: u64 = 8;

/// What local search stands on.
pub(in super::super) struct Ground<'p> {
    /// Ways.
    pub(in super::super) legs: Legs<'p>,
    /// Near items.
    pub(in super::super) near: Near,
    /// Stretches may be turned.
    pub(in super::super) turns: bool,
}

impl<'p> Ground<'p> {
    /// For ways; nothing is near yet.
    pub(in super::super) fn new(legs: Legs<'p>) -> Self {
        let turns = legs.problem().table().is_none_or(crate::problem::Table::is_symmetric);
        Self { legs, near: Near::default(), turns }
    }

    fn problem(&self) -> &'p Problem {
        self.legs.problem()
    }

    fn item(&self, node: NodeId) -> ItemId {
        self.problem().nodes[node as usize].item
    }

    /// The node at which a turned stretch enters an item.
    fn twin(&self, node: NodeId) -> NodeId {
        if self.problem().table().is_some() { node } else { self.problem().nodes[node as usize].twin }
    }
}

/// A tour being improved.
pub(in super::super) struct Polish {
    tour: Vec<NodeId>,
    /// By item: where it stands.
    place: Vec<usize>,
    queue: VecDeque<ItemId>,
    waiting: Vec<bool>,
    /// Places at the front that keep their item.
    held: usize,
    /// The first keeps its node, too.
    pinned: bool,
}

/// A change of the tour.
#[derive(Clone, Copy)]
enum Move {
    /// Another entry.
    Enter { at: usize, node: NodeId },
    /// The places from..=to turned.
    Turn { from: usize, to: usize },
    /// The places from..=to to before the place `gap`, turned or not; a single one with that node.
    Shift { from: usize, to: usize, gap: usize, turned: bool, node: NodeId },
}

/// The best change of an item so far.
struct Pick {
    gain: f64,
    change: Option<Move>,
    priced: u64,
}

impl Pick {
    fn offer(&mut self, gain: f64, legs: u64, change: Move) {
        self.priced += legs;
        if gain > self.gain {
            (self.gain, self.change) = (gain, Some(change));
        }
    }
}

impl Polish {
    /// For tours of a problem: whether a place is held in front, and with its node.
    pub(in super::super) fn new(problem: &Problem, held: bool, pinned: bool) -> Self {
        let items = problem.items.len();
        let (place, waiting) = (vec![usize::MAX; items], vec![false; items]);
        Self { tour: Vec::new(), place, queue: VecDeque::new(), waiting, held: held.into(), pinned }
    }

    /// Begins with a tour. `settled`: one that nothing gained for; where the tour runs as that one did, nothing is tried.
    pub(in super::super) fn begin(&mut self, ground: &Ground, tour: Vec<NodeId>, settled: &[NodeId]) {
        let around =
            |tour: &[NodeId], i: usize| (i.checked_sub(1).map(|b| tour[b]), tour.get(i + 1).copied());
        for (i, &node) in settled.iter().enumerate() {
            self.place[ground.item(node) as usize] = i;
        }
        self.tour = tour;
        self.queue.clear();
        for i in 0..self.tour.len() {
            let item = ground.item(self.tour[i]);
            let was = self.place[item as usize];
            let same = settled.get(was).is_some_and(|&node| {
                let (now, then) = (around(&self.tour, i), around(settled, was));
                node == self.tour[i] && (now == then || ground.turns && now == (then.1, then.0))
            });
            self.waiting[item as usize] = !same;
            if !same {
                self.queue.push_back(item);
            }
        }
        for (i, &node) in self.tour.iter().enumerate() {
            self.place[ground.item(node) as usize] = i;
        }
    }

    /// The tour as it stands.
    pub(in super::super) fn tour(&self) -> &[NodeId] {
        &self.tour
    }

    /// The best move of the next item; its price, or nothing when no item is left that could gain.
    pub(in super::super) fn piece(&mut self, ground: &Ground) -> Option<u64> {
        let item = self.queue.pop_front()?;
        self.waiting[item as usize] = false;
        let mut pick = Pick { gain: EPSILON, change: None, priced: 1 };
        let at = self.place[item as usize];
        self.enter(ground, at, &mut pick);
        if ground.turns {
            self.turn(ground, at, &mut pick);
        }
        self.shift(ground, item, &mut pick);
        let shifted = pick.change.map_or(0, |change| self.perform(ground, change));
        if shifted > 0 {
            self.wait(item);
        }
        Some(pick.priced + shifted / SHIFTS)
    }

    fn link(&self, ground: &Ground, from: Option<NodeId>, to: Option<NodeId>) -> f64 {
        // With no way back to the first node of a table's cycle the first would not matter; with one it is held.
        ground.legs.link(from, to, self.tour[0])
    }

    fn before(&self, at: usize) -> Option<NodeId> {
        at.checked_sub(1).map(|b| self.tour[b])
    }

    fn get(&self, at: usize) -> Option<NodeId> {
        self.tour.get(at).copied()
    }

    /// Other entries of the item.
    fn enter(&self, ground: &Ground, at: usize, pick: &mut Pick) {
        let nodes = &ground.problem().items[ground.item(self.tour[at]) as usize].nodes;
        // The cycle of a table comes back to the first node: which one is for the keys to say.
        if nodes.len() < 2 || at == 0 && (self.pinned || ground.problem().table().is_some()) {
            return;
        }
        let (before, after) = (self.before(at), self.get(at + 1));
        let by = |node| self.link(ground, before, Some(node)) + self.link(ground, Some(node), after);
        let now = by(self.tour[at]);
        for node in nodes.clone() {
            pick.offer(now - by(node), 2, Move::Enter { at, node });
        }
    }

    /// 2-opt: stretches that begin or end at the item, to the near ones and to the ends of the tour.
    fn turn(&self, ground: &Ground, at: usize, pick: &mut Pick) {
        let last = self.tour.len() - 1;
        let mut offer = |from: usize, to: usize| {
            if from >= self.held && from <= to {
                let (before, after) = (self.before(from), self.get(to + 1));
                let (a, b) = (self.tour[from], self.tour[to]);
                let now = self.link(ground, before, Some(a)) + self.link(ground, Some(b), after);
                let (b, a) = (ground.twin(b), ground.twin(a));
                let then = self.link(ground, before, Some(b)) + self.link(ground, Some(a), after);
                pick.offer(now - then, 4, Move::Turn { from, to });
            }
        };
        offer(at, last);
        offer(at + 1, last);
        offer(self.held, at);
        let here = self.tour[at];
        let ahead = self.link(ground, Some(here), self.get(at + 1));
        let longest = ahead.max(self.link(ground, self.before(at), Some(here)));
        // The new way from the item must be shorter than one of those it replaces.
        for &(least, near) in ground.near.of(ground.item(here)) {
            if least >= longest {
                break;
            }
            let (low, high) = match self.place[near as usize] {
                other if other < at => (other, at),
                other => (at, other),
            };
            offer(low + 1, high);
            offer(low, high - 1);
        }
    }

    /// Or-opt: chains that begin or end with the item, to beside the near ones and to the ends of the tour.
    fn shift(&self, ground: &Ground, item: ItemId, pick: &mut Pick) {
        let at = self.place[item as usize];
        for length in 1..=CHAIN {
            for (from, to) in [(at, at + length - 1), ((at + 1).wrapping_sub(length), at)] {
                if from < self.held || to >= self.tour.len() || from > to {
                    continue;
                }
                let (before, after) = (self.before(from), self.get(to + 1));
                let ends = (self.tour[from], self.tour[to]);
                let freed = self.link(ground, before, Some(ends.0)) + self.link(ground, Some(ends.1), after)
                    - self.link(ground, before, after);
                pick.priced += 3;
                if freed > pick.gain {
                    let near = ground.near.of(item).iter().take_while(|n| n.0 < freed);
                    let near = near.map(|n| self.place[n.1 as usize]);
                    let gaps = near.flat_map(|place| [place, place + 1]);
                    for gap in gaps.chain([self.held, self.tour.len()]) {
                        if gap >= self.held && (gap < from || gap > to + 1) {
                            self.insert(ground, (from, to), gap, freed, pick);
                        }
                    }
                }
                if length == 1 {
                    break;
                }
            }
        }
    }

    fn insert(&self, ground: &Ground, (from, to): (usize, usize), gap: usize, freed: f64, pick: &mut Pick) {
        let (before, after) = (self.before(gap), self.get(gap));
        let closed = self.link(ground, before, after);
        let mut offer = |a: NodeId, b: NodeId, turned: bool| {
            let opened = self.link(ground, before, Some(a)) + self.link(ground, Some(b), after) - closed;
            pick.offer(freed - opened, 2, Move::Shift { from, to, gap, turned, node: a });
        };
        if from == to {
            for node in ground.problem().items[ground.item(self.tour[from]) as usize].nodes.clone() {
                offer(node, node, false);
            }
            return;
        }
        offer(self.tour[from], self.tour[to], false);
        if ground.turns {
            offer(ground.twin(self.tour[to]), ground.twin(self.tour[from]), true);
        }
    }

    /// Makes a change; how many places it touched.
    fn perform(&mut self, ground: &Ground, change: Move) -> u64 {
        let (low, high) = match change {
            Move::Enter { at, node } => {
                self.tour[at] = node;
                (at, at)
            }
            Move::Turn { from, to } => {
                self.reverse(ground, from, to);
                (from, to)
            }
            Move::Shift { from, to, gap, turned, node } => {
                let length = to + 1 - from;
                let first = if gap > to {
                    self.tour[from..gap].rotate_left(length);
                    gap - length
                } else {
                    self.tour[gap..=to].rotate_right(length);
                    gap
                };
                if turned {
                    self.reverse(ground, first, first + length - 1);
                } else if length == 1 {
                    self.tour[first] = node;
                }
                (from.min(gap), to.max(gap.saturating_sub(1)))
            }
        };
        for at in low..=high {
            self.place[ground.item(self.tour[at]) as usize] = at;
        }
        match change {
            Move::Shift { from, to, gap, .. } => {
                let length = to + 1 - from;
                let (first, seam) = if gap > to { (gap - length, from) } else { (gap, to) };
                self.disturb(ground, &[first, first + length - 1, seam]);
            }
            _ => self.disturb(ground, &[low, high]),
        }
        (high - low + 1) as u64
    }

    fn reverse(&mut self, ground: &Ground, from: usize, to: usize) {
        self.tour[from..=to].reverse();
        for node in &mut self.tour[from..=to] {
            *node = ground.twin(*node);
        }
    }

    /// The items at places and beside them come again.
    fn disturb(&mut self, ground: &Ground, places: &[usize]) {
        for &place in places {
            for at in place.saturating_sub(1)..(place + 2).min(self.tour.len()) {
                self.wait(ground.item(self.tour[at]));
            }
        }
    }

    fn wait(&mut self, item: ItemId) {
        if !std::mem::replace(&mut self.waiting[item as usize], true) {
            self.queue.push_back(item);
        }
    }
}
