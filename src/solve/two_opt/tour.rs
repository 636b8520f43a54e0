//! The tour as an array: nodes in order of visit between two fixed ends, with prices, changes and their undoing.
//!
//! Position 0 is the start at home and position n + 1 the end: home again, or nowhere, when the head may stay where
//! it is. Prices are between points; a point is a node's entry (twice its id) or exit (one more).

use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::{Solution, Stop};

/// No item, or no position.
const NONE: u32 = u32::MAX;

/// What can be done to a tour, and undone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    /// The stops from the first to the second position run the other way.
    Reverse(usize, usize),
    /// The stops from the first position to before the second change places with those from there to the third.
    Swap(usize, usize, usize),
    /// The stop at a position is entered at another node of its item.
    Enter(usize, NodeId),
}

/// Prices of legs between points. Two nodes beyond those of the problem stand for both ends of the tour.
pub(super) struct Pricer {
    air: AirTime,
    points: Vec<DVec2>,
    /// Travel to points from this one on costs nothing: the end of an open tour.
    free: u32,
}

impl Pricer {
    pub(super) fn new(problem: &Problem) -> Self {
        let ends = [problem.home; 4];
        let points: Vec<DVec2> = problem.nodes.iter().flat_map(|n| [n.entry, n.exit]).chain(ends).collect();
        let free = if problem.closed { NONE } else { node_id(points.len() - 2) };
        Self { air: AirTime::new(&problem.machine), points, free }
    }

    /// The node where the tour starts.
    pub(super) fn home(&self) -> NodeId {
        node_id(self.points.len() / 2 - 2)
    }

    /// The node where the tour ends.
    pub(super) fn end(&self) -> NodeId {
        node_id(self.points.len() / 2 - 1)
    }

    /// Seconds between two points.
    pub(super) fn price(&self, a: u32, b: u32) -> f64 {
        if a.max(b) >= self.free {
            return 0.0;
        }
        self.air.seconds(self.points[a as usize], self.points[b as usize])
    }

    /// Seconds from one node to the next.
    pub(super) fn leg(&self, a: NodeId, b: NodeId) -> f64 {
        self.price(2 * a + 1, 2 * b)
    }
}

/// A tour and what is needed to price and change it.
pub(super) struct Tour<'p> {
    pub(super) problem: &'p Problem,
    pub(super) pricer: Pricer,
    order: Vec<NodeId>,
    /// Position by item.
    position: Vec<u32>,
    /// Item by node; [`NONE`] for both ends.
    item: Vec<ItemId>,
    /// Outer item by item, and inner items by item as ranges of `inner`.
    outer: Vec<ItemId>,
    inner: Vec<ItemId>,
    inner_from: Vec<u32>,
    /// Whether inner items must come before their outer one: off while the search looks for a good shape.
    pub(super) nested: bool,
    /// Changes since the last [`Tour::keep`].
    log: Vec<Change>,
    /// Stops moved or looked at so far beside priced moves: the part of the work that grows with the tour.
    pub(super) handled: u64,
}

impl<'p> Tour<'p> {
    /// The tour of these nodes, one of each item that has any.
    pub(super) fn new(problem: &'p Problem, nodes: &[NodeId]) -> Self {
        let pricer = Pricer::new(problem);
        let outer: Vec<ItemId> = problem.items.iter().map(|i| i.before.unwrap_or(NONE)).collect();
        let (inner, inner_from) = inner_lists(&outer);
        let mut tour = Self {
            problem,
            order: vec![pricer.home(), pricer.end()],
            pricer,
            position: vec![NONE; problem.items.len()],
            item: problem.nodes.iter().map(|n| n.item).chain([NONE; 2]).collect(),
            outer,
            inner,
            inner_from,
            nested: true,
            log: Vec::new(),
            handled: 0,
        };
        tour.reset(nodes);
        tour
    }

    /// Another order of the same items; nothing to undo.
    pub(super) fn reset(&mut self, nodes: &[NodeId]) {
        let end = self.order.len() - 1;
        self.order.splice(1..end, nodes.iter().copied());
        self.place(1, nodes.len());
        self.log.clear();
    }

    /// Stops.
    pub(super) fn len(&self) -> usize {
        self.order.len() - 2
    }

    /// The nodes in order of visit.
    pub(super) fn nodes(&self) -> &[NodeId] {
        &self.order[1..self.order.len() - 1]
    }

    /// The node at a position.
    pub(super) fn at(&self, position: usize) -> NodeId {
        self.order[position]
    }

    /// The item at a position; `None` at the ends.
    pub(super) fn item_at(&self, position: usize) -> Option<ItemId> {
        Some(self.item[self.order[position] as usize]).filter(|&i| i != NONE)
    }

    /// The position of a node's item.
    pub(super) fn position_of(&self, node: NodeId) -> usize {
        self.position[self.item[node as usize] as usize] as usize
    }

    /// The position of an item, when it is in the tour.
    pub(super) fn position(&self, item: ItemId) -> Option<usize> {
        self.position.get(item as usize).filter(|&&p| p != NONE).map(|&p| p as usize)
    }

    /// The same item entered at the other end.
    pub(super) fn twin(&self, node: NodeId) -> NodeId {
        self.problem.nodes[node as usize].twin
    }

    /// Seconds between two points.
    pub(super) fn price(&self, a: u32, b: u32) -> f64 {
        self.pricer.price(a, b)
    }

    /// Seconds from the stop at a position to the next one.
    pub(super) fn leg(&self, position: usize) -> f64 {
        self.pricer.leg(self.order[position], self.order[position + 1])
    }

    /// The tour as a solution, its cost summed up afresh.
    pub(super) fn solution(&self) -> Solution {
        Solution::new(self.problem, self.nodes().iter().map(|&node| Stop::at(self.problem, node)).collect())
    }

    /// Whether the stops from `lo` to `hi` may run the other way: one rank, and none inside another.
    pub(super) fn may_reverse(&mut self, lo: usize, hi: usize) -> bool {
        self.same_rank(lo, hi) && !self.holds_nested(lo, hi, lo, hi)
    }

    /// Whether the stops from `lo` to before `mid` may change places with those from there to `hi`.
    pub(super) fn may_swap(&mut self, lo: usize, mid: usize, hi: usize) -> bool {
        self.same_rank(lo, hi) && !self.holds_nested(lo, mid - 1, mid, hi)
    }

    /// Positions are sorted by rank, so the ends tell.
    fn same_rank(&self, lo: usize, hi: usize) -> bool {
        let rank = |p| self.item_at(p).map(|i| self.problem.items[i as usize].rank);
        rank(lo) == rank(hi)
    }

    /// Whether an item at `from..=to` lies inside one at `lo..=hi`, which does not begin before it. Looks at the
    /// shorter side: at the outer ones of the first range, or at the inner ones of the second.
    fn holds_nested(&mut self, from: usize, to: usize, lo: usize, hi: usize) -> bool {
        if !self.nested {
            return false;
        }
        let within = |item: ItemId, lo: usize, hi: usize| {
            item != NONE && (lo..=hi).contains(&(self.position[item as usize] as usize))
        };
        let inner_of = |p: usize| {
            let item = self.item[self.order[p] as usize] as usize;
            &self.inner[self.inner_from[item] as usize..self.inner_from[item + 1] as usize]
        };
        let by_outer = to - from + 1;
        // Long ranges hold many inner items too; only short ones are worth counting.
        let by_inner =
            if hi + 1 - lo < by_outer { (lo..=hi).map(|p| 1 + inner_of(p).len()).sum() } else { usize::MAX };
        if by_inner < by_outer {
            self.handled += by_inner as u64;
            (lo..=hi).any(|p| inner_of(p).iter().any(|&i| within(i, from, to)))
        } else {
            self.handled += by_outer as u64;
            (from..=to).any(|p| within(self.outer[self.item[self.order[p] as usize] as usize], lo, hi))
        }
    }

    /// Does a change and remembers it.
    pub(super) fn apply(&mut self, change: Change) {
        let undo = self.change(change);
        self.log.push(undo);
    }

    /// From here on there is nothing to undo.
    pub(super) fn keep(&mut self) {
        self.log.clear();
    }

    /// Takes back everything since the last [`Tour::keep`].
    pub(super) fn undo(&mut self) {
        while let Some(change) = self.log.pop() {
            self.change(change);
        }
    }

    /// Does a change and says what would undo it.
    fn change(&mut self, change: Change) -> Change {
        match change {
            Change::Reverse(lo, hi) => {
                self.order[lo..=hi].reverse();
                for p in lo..=hi {
                    self.order[p] = self.twin(self.order[p]);
                }
                self.place(lo, hi);
                change
            }
            Change::Swap(lo, mid, hi) => {
                self.order[lo..=hi].rotate_left(mid - lo);
                self.place(lo, hi);
                Change::Swap(lo, hi + 1 - (mid - lo), hi)
            }
            Change::Enter(position, node) => {
                Change::Enter(position, std::mem::replace(&mut self.order[position], node))
            }
        }
    }

    fn place(&mut self, lo: usize, hi: usize) {
        self.handled += (hi + 1 - lo) as u64;
        for (p, node) in (node_id(lo)..).zip(&self.order[lo..=hi]) {
            self.position[self.item[*node as usize] as usize] = p;
        }
    }
}

/// Inner items of each item, one list after the other, and where each begins; one more at the end.
fn inner_lists(outer: &[ItemId]) -> (Vec<ItemId>, Vec<u32>) {
    let mut from = vec![0; outer.len() + 1];
    for &o in outer.iter().filter(|&&o| o != NONE) {
        from[o as usize + 1] += 1;
    }
    for i in 1..from.len() {
        from[i] += from[i - 1];
    }
    let mut next = from.clone();
    let mut inner = vec![0; from.last().copied().unwrap_or(0) as usize];
    for (item, &o) in (0..).zip(outer).filter(|(_, o)| **o != NONE) {
        inner[next[o as usize] as usize] = item;
        next[o as usize] += 1;
    }
    (inner, from)
}

fn node_id(index: usize) -> NodeId {
    NodeId::try_from(index).unwrap_or(NONE)
}
