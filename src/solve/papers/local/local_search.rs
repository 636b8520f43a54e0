//! 2-opt and Or-opt over near items.
//!
//! Items wait in a queue. For each item the best of its moves is applied until none improves the tour; a move puts the
//! items whose neighbours it changed back on the queue.
//!
//! A stretch is reversed by entering each of its items at its twin node, so that the lengths inside it stay the same: open
//! contours are cut in the other direction. With an asymmetric table of costs nothing is reversed.

use super::search_space::SearchSpace;
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use std::collections::VecDeque;

/// Largest number of items that Or-opt moves together (Or 1976).
const CHAIN: usize = 3;
/// Number of positions shifted in memory in the time that pricing one leg takes.
const SHIFTS: u64 = 8;

/// A tour that is being improved.
pub(in super::super) struct LocalSearch {
    tour: Vec<NodeId>,
    /// For each item, its position in the tour.
    place: Vec<usize>,
    queue: VecDeque<ItemId>,
    waiting: Vec<bool>,
    /// Number of positions at the front whose item is fixed.
    held: usize,
    /// Whether the first node is fixed as well.
    pinned: bool,
}

/// A change of the tour.
#[derive(Clone, Copy)]
enum TourMove {
    /// Enters an item at another node.
    Enter { at: usize, node: NodeId },
    /// Reverses the positions `from..=to`.
    Turn { from: usize, to: usize },
    /// Moves the positions `from..=to` to before the position `gap`, reversed or not. A single item is entered at `node`.
    Shift { from: usize, to: usize, gap: usize, turned: bool, node: NodeId },
}

/// The best move of an item so far.
struct BestMove {
    gain: f64,
    change: Option<TourMove>,
    priced: u64,
}

impl BestMove {
    fn offer(&mut self, gain: f64, legs: u64, change: TourMove) {
        self.priced += legs;
        if gain > self.gain {
            (self.gain, self.change) = (gain, Some(change));
        }
    }
}

impl LocalSearch {
    /// For tours of a problem. `held` fixes the item at the front, `pinned` its node as well.
    pub(in super::super) fn new(problem: &Problem, held: bool, pinned: bool) -> Self {
        let items = problem.items.len();
        let (place, waiting) = (vec![usize::MAX; items], vec![false; items]);
        Self { tour: Vec::new(), place, queue: VecDeque::new(), waiting, held: held.into(), pinned }
    }

    /// Starts with a tour. `settled` is a tour that no move improves; an item whose neighbours are the same in both is not
    /// queued.
    pub(in super::super) fn begin(&mut self, space: &SearchSpace, tour: Vec<NodeId>, settled: &[NodeId]) {
        let around =
            |tour: &[NodeId], i: usize| (i.checked_sub(1).map(|b| tour[b]), tour.get(i + 1).copied());
        for (i, &node) in settled.iter().enumerate() {
            self.place[space.item(node) as usize] = i;
        }
        self.tour = tour;
        self.queue.clear();
        for i in 0..self.tour.len() {
            let item = space.item(self.tour[i]);
            let was = self.place[item as usize];
            let same = settled.get(was).is_some_and(|&node| {
                let (now, then) = (around(&self.tour, i), around(settled, was));
                node == self.tour[i] && (now == then || space.turns && now == (then.1, then.0))
            });
            self.waiting[item as usize] = !same;
            if !same {
                self.queue.push_back(item);
            }
        }
        for (i, &node) in self.tour.iter().enumerate() {
            self.place[space.item(node) as usize] = i;
        }
    }

    /// The current tour.
    pub(in super::super) fn tour(&self) -> &[NodeId] {
        &self.tour
    }

    /// Applies the best move of the next item. Returns its cost in legs, or `None` when no item is left that could improve.
    pub(in super::super) fn piece(&mut self, space: &SearchSpace) -> Option<u64> {
        let item = self.queue.pop_front()?;
        self.waiting[item as usize] = false;
        let mut best = BestMove { gain: EPSILON, change: None, priced: 1 };
        let at = self.place[item as usize];
        self.enter(space, at, &mut best);
        if space.turns {
            self.turn(space, at, &mut best);
        }
        self.shift(space, item, &mut best);
        let shifted = best.change.map_or(0, |change| self.perform(space, change));
        if shifted > 0 {
            self.wait(item);
        }
        Some(best.priced + shifted / SHIFTS)
    }

    fn link(&self, space: &SearchSpace, from: Option<NodeId>, to: Option<NodeId>) -> f64 {
        // `tour[0]` matters only with a table, whose cycle returns to it; there it is fixed.
        space.legs.link(from, to, self.tour[0])
    }

    fn before(&self, at: usize) -> Option<NodeId> {
        at.checked_sub(1).map(|b| self.tour[b])
    }

    fn get(&self, at: usize) -> Option<NodeId> {
        self.tour.get(at).copied()
    }

    /// Tries other entries of the item.
    fn enter(&self, space: &SearchSpace, at: usize, best: &mut BestMove) {
        let nodes = &space.problem().items[space.item(self.tour[at]) as usize].nodes;
        // The cycle of a table returns to the first node, so the keys decide which node that is.
        if nodes.len() < 2 || at == 0 && (self.pinned || space.problem().table().is_some()) {
            return;
        }
        let (before, after) = (self.before(at), self.get(at + 1));
        let by = |node| self.link(space, before, Some(node)) + self.link(space, Some(node), after);
        let now = by(self.tour[at]);
        for node in nodes.clone() {
            best.offer(now - by(node), 2, TourMove::Enter { at, node });
        }
    }

    /// 2-opt: tries to reverse the stretches between the item and its near items, and between the item and the ends of the
    /// tour.
    fn turn(&self, space: &SearchSpace, at: usize, best: &mut BestMove) {
        let last = self.tour.len() - 1;
        let mut offer = |from: usize, to: usize| {
            if from >= self.held && from <= to {
                let (before, after) = (self.before(from), self.get(to + 1));
                let (a, b) = (self.tour[from], self.tour[to]);
                let now = self.link(space, before, Some(a)) + self.link(space, Some(b), after);
                let (b, a) = (space.twin(b), space.twin(a));
                let then = self.link(space, before, Some(b)) + self.link(space, Some(a), after);
                best.offer(now - then, 4, TourMove::Turn { from, to });
            }
        };
        offer(at, last);
        offer(at + 1, last);
        offer(self.held, at);
        let here = self.tour[at];
        let ahead = self.link(space, Some(here), self.get(at + 1));
        let longest = ahead.max(self.link(space, self.before(at), Some(here)));
        // A reversal helps only if the new leg at the item is shorter than one of the legs it replaces.
        for &(least, near) in space.near.of(space.item(here)) {
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

    /// Or-opt: tries to move the chains that begin or end with the item next to its near items, and to the ends of the
    /// tour.
    fn shift(&self, space: &SearchSpace, item: ItemId, best: &mut BestMove) {
        let at = self.place[item as usize];
        for length in 1..=CHAIN {
            for (from, to) in [(at, at + length - 1), ((at + 1).wrapping_sub(length), at)] {
                if from < self.held || to >= self.tour.len() || from > to {
                    continue;
                }
                let (before, after) = (self.before(from), self.get(to + 1));
                let ends = (self.tour[from], self.tour[to]);
                let freed = self.link(space, before, Some(ends.0)) + self.link(space, Some(ends.1), after)
                    - self.link(space, before, after);
                best.priced += 3;
                if freed > best.gain {
                    let near = space.near.of(item).iter().take_while(|n| n.0 < freed);
                    let near = near.map(|n| self.place[n.1 as usize]);
                    let gaps = near.flat_map(|place| [place, place + 1]);
                    for gap in gaps.chain([self.held, self.tour.len()]) {
                        if gap >= self.held && (gap < from || gap > to + 1) {
                            self.insert(space, (from, to), gap, freed, best);
                        }
                    }
                }
                if length == 1 {
                    break;
                }
            }
        }
    }

    fn insert(
        &self,
        space: &SearchSpace,
        (from, to): (usize, usize),
        gap: usize,
        freed: f64,
        best: &mut BestMove,
    ) {
        let (before, after) = (self.before(gap), self.get(gap));
        let closed = self.link(space, before, after);
        let mut offer = |a: NodeId, b: NodeId, turned: bool| {
            let opened = self.link(space, before, Some(a)) + self.link(space, Some(b), after) - closed;
            best.offer(freed - opened, 2, TourMove::Shift { from, to, gap, turned, node: a });
        };
        if from == to {
            for node in space.problem().items[space.item(self.tour[from]) as usize].nodes.clone() {
                offer(node, node, false);
            }
            return;
        }
        offer(self.tour[from], self.tour[to], false);
        if space.turns {
            offer(space.twin(self.tour[to]), space.twin(self.tour[from]), true);
        }
    }

    /// Applies a change and returns how many positions it touched.
    fn perform(&mut self, space: &SearchSpace, change: TourMove) -> u64 {
        let (low, high) = match change {
            TourMove::Enter { at, node } => {
                self.tour[at] = node;
                (at, at)
            }
            TourMove::Turn { from, to } => {
                self.reverse(space, from, to);
                (from, to)
            }
            TourMove::Shift { from, to, gap, turned, node } => {
                let length = to + 1 - from;
                let first = if gap > to {
                    self.tour[from..gap].rotate_left(length);
                    gap - length
                } else {
                    self.tour[gap..=to].rotate_right(length);
                    gap
                };
                if turned {
                    self.reverse(space, first, first + length - 1);
                } else if length == 1 {
                    self.tour[first] = node;
                }
                (from.min(gap), to.max(gap.saturating_sub(1)))
            }
        };
        for at in low..=high {
            self.place[space.item(self.tour[at]) as usize] = at;
        }
        match change {
            TourMove::Shift { from, to, gap, .. } => {
                let length = to + 1 - from;
                let (first, seam) = if gap > to { (gap - length, from) } else { (gap, to) };
                self.disturb(space, &[first, first + length - 1, seam]);
            }
            _ => self.disturb(space, &[low, high]),
        }
        (high - low + 1) as u64
    }

    fn reverse(&mut self, space: &SearchSpace, from: usize, to: usize) {
        self.tour[from..=to].reverse();
        for node in &mut self.tour[from..=to] {
            *node = space.twin(*node);
        }
    }

    /// Queues the items at these positions and their neighbours.
    fn disturb(&mut self, space: &SearchSpace, places: &[usize]) {
        for &place in places {
            for at in place.saturating_sub(1)..(place + 2).min(self.tour.len()) {
                self.wait(space.item(self.tour[at]));
            }
        }
    }

    fn wait(&mut self, item: ItemId) {
        if !std::mem::replace(&mut self.waiting[item as usize], true) {
            self.queue.push_back(item);
        }
    }
}
