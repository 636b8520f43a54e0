//! What the method sees of a problem: seconds between nodes, charges, near nodes, what lies in what.

use crate::geometry::{Aabb, Buckets};
use crate::machine::AirTime;
use crate::problem::{ItemId, NodeId, Problem};
use glam::DVec2;

/// Near nodes of a node: with two to an item these are the nearest five contours or more, which hold all but a few
/// edges of good planar tours.
const NEAR: usize = 12;
/// Near nodes of the same contour: one may be its entry, where nothing can hang.
const SAME: usize = 2;

/// A problem, ready to be priced.
pub(super) struct Ground<'p> {
    pub(super) problem: &'p Problem,
    air: AirTime,
    /// Near nodes by node; filled item by item.
    near: Vec<Vec<NodeId>>,
    buckets: Buckets,
    /// What lies in each contour.
    pub(super) inner: Vec<Vec<ItemId>>,
    /// Contours by the depth at which they lie, the deepest first; those with something in them only.
    pub(super) inwards: Vec<ItemId>,
}

impl<'p> Ground<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
        let mut buckets = Buckets::new(bounds, problem.nodes.len());
        for (id, node) in (0..).zip(&problem.nodes) {
            buckets.insert(id, node.entry);
        }
        let mut inner = vec![Vec::new(); problem.items.len()];
        for (id, item) in (0..).zip(&problem.items) {
            if let Some(list) = item.before.and_then(|o| inner.get_mut(o as usize)) {
                list.push(id);
            }
        }
        let outer = |i: ItemId| problem.items.get(i as usize).and_then(|i| i.before);
        let most = problem.items.len();
        let depth = |i: ItemId| std::iter::successors(outer(i), |&o| outer(o)).take(most).count() as u64;
        let mut inwards: Vec<ItemId> =
            (0..).zip(&inner).filter(|(_, list)| !list.is_empty()).map(|(id, _)| id).collect();
        crate::order::sort_by(&mut inwards, |&i| [u64::MAX - depth(i), 0, 0]);
        Self { problem, air: AirTime::new(&problem.machine), near: Vec::new(), buckets, inner, inwards }
    }

    /// Whether the paper's model covers a problem: precedence by nesting, and nothing else.
    pub(super) fn is_one_tree(problem: &Problem) -> bool {
        problem.table().is_none()
            && problem.pairs.is_empty()
            && problem.groups.is_empty()
            && problem.items.iter().all(|i| i.rank == problem.items[0].rank)
    }

    /// Where the head arrives.
    pub(super) fn entry(&self, node: NodeId) -> DVec2 {
        self.problem.nodes[node as usize].entry
    }

    /// Where it leaves.
    pub(super) fn exit(&self, node: NodeId) -> DVec2 {
        self.problem.nodes[node as usize].exit
    }

    pub(super) fn item(&self, node: NodeId) -> ItemId {
        self.problem.nodes[node as usize].item
    }

    pub(super) fn nodes(&self, item: ItemId) -> std::ops::Range<NodeId> {
        self.problem.items[item as usize].nodes.clone()
    }

    /// Seconds between two places.
    pub(super) fn air(&self, from: DVec2, to: DVec2) -> f64 {
        self.air.seconds(from, to)
    }

    /// From leaving at one node to entering at the next.
    pub(super) fn leg(&self, from: NodeId, to: NodeId) -> f64 {
        self.air.seconds(self.exit(from), self.entry(to))
    }

    /// Seconds an entry costs by its place.
    pub(super) fn extra(&self, node: NodeId) -> f64 {
        let n = &self.problem.nodes[node as usize];
        self.problem.items[n.item as usize].extra(node, n.along)
    }

    /// Whether a contour may be left unfinished.
    pub(super) fn may_leave(&self, item: ItemId) -> bool {
        self.problem.items[item as usize].leave.is_some()
    }

    /// Seconds of leaving a contour at a node and resuming it there: the pre-cut, and what its place costs.
    pub(super) fn charge(&self, node: NodeId) -> f64 {
        self.problem.items[self.item(node) as usize].resume() + self.extra(node)
    }

    /// Nodes of other contours near to one, the nearest first.
    pub(super) fn near(&self, node: NodeId) -> &[NodeId] {
        self.near.get(node as usize).map_or(&[], Vec::as_slice)
    }

    /// Looks for the near nodes of the next contour; how many nodes were priced, or nothing when all are found.
    pub(super) fn list_near(&mut self) -> Option<u64> {
        let first = self.problem.nodes.get(self.near.len())?.item;
        let mut priced = 1;
        while let Some(node) = self.problem.nodes.get(self.near.len()).filter(|n| n.item == first) {
            let mut found = Vec::with_capacity(NEAR + 1);
            // What is left elsewhere than it is entered has neighbours at both ends.
            for place in [node.exit, node.entry].into_iter().take(1 + usize::from(node.exit != node.entry)) {
                priced += self.find_near(&mut found, first, place);
            }
            self.near.push(found.into_iter().map(|f| f.1).collect());
        }
        Some(priced)
    }

    /// Nodes of contours other than that one near to a place; how many were priced.
    fn find_near(&self, found: &mut Vec<(f64, NodeId)>, own: ItemId, place: DVec2) -> u64 {
        let mut priced = 0;
        for r in 0..self.buckets.rings(place) {
            let least = self.air.seconds_at_least(self.buckets.distance_of_ring(r));
            if found.get(NEAR - 1).is_some_and(|f| f.0 <= least) {
                break;
            }
            for other in self.buckets.ring(place, r).filter(|&other| self.item(other) != own) {
                priced += 1;
                self.keep(found, (self.air(place, self.entry(other)), other));
            }
        }
        priced
    }

    /// Keeps the nearest in order, a few of each contour.
    fn keep(&self, found: &mut Vec<(f64, NodeId)>, new: (f64, NodeId)) {
        if found.get(NEAR - 1).is_some_and(|last| *last <= new) {
            return;
        }
        match found.iter().position(|f| f.1 == new.1) {
            Some(known) if found[known] <= new => return,
            Some(known) => drop(found.remove(known)),
            None => {}
        }
        let item = self.item(new.1);
        let mut same = (0..found.len()).filter(|&k| self.item(found[k].1) == item);
        if let Some(last) = same.nth(SAME - 1) {
            if found[last] <= new {
                return;
            }
            found.remove(last);
        }
        let place = found.partition_point(|f| *f < new);
        found.insert(place, new);
        found.truncate(NEAR);
    }
}
