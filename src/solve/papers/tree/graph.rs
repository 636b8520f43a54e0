//! The nodes of a problem as the method needs them: seconds between nodes, costs of leaving contours, near nodes, and
//! nesting.

use crate::geometry::{Aabb, Buckets};
use crate::machine::AirTime;
use crate::problem::{ItemId, NodeId, Problem};
use glam::DVec2;

/// Number of near nodes of a node. With two per contour these cover the nearest six contours or more, which contain all but
/// a few edges of good planar tours.
const NEAR: usize = 12;
/// Largest number of near nodes of the same contour. One may be its entry, to which nothing can be attached.
const SAME: usize = 2;

/// The nodes of a problem with their costs and neighbours.
pub(super) struct Graph<'p> {
    pub(super) problem: &'p Problem,
    air: AirTime,
    /// Near nodes by node, filled contour by contour.
    near: Vec<Vec<NodeId>>,
    buckets: Buckets,
    /// The contours directly inside each contour.
    pub(super) inner: Vec<Vec<ItemId>>,
    /// Contours that contain others, the most deeply nested first.
    pub(super) inwards: Vec<ItemId>,
}

impl<'p> Graph<'p> {
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

    /// Whether the paper's model covers a problem: precedence comes from nesting only.
    pub(super) fn is_one_tree(problem: &Problem) -> bool {
        problem.table().is_none()
            && problem.pairs.is_empty()
            && problem.groups.is_empty()
            && problem.items.iter().all(|i| i.rank == problem.items[0].rank)
    }

    /// The point where the head arrives.
    pub(super) fn entry(&self, node: NodeId) -> DVec2 {
        self.problem.nodes[node as usize].entry
    }

    /// The point where the head leaves.
    pub(super) fn exit(&self, node: NodeId) -> DVec2 {
        self.problem.nodes[node as usize].exit
    }

    pub(super) fn item(&self, node: NodeId) -> ItemId {
        self.problem.nodes[node as usize].item
    }

    pub(super) fn nodes(&self, item: ItemId) -> std::ops::Range<NodeId> {
        self.problem.items[item as usize].nodes.clone()
    }

    /// Seconds of an air move between two points.
    pub(super) fn air(&self, from: DVec2, to: DVec2) -> f64 {
        self.air.seconds(from, to)
    }

    /// Seconds from the exit of one node to the entry of the next.
    pub(super) fn leg(&self, from: NodeId, to: NodeId) -> f64 {
        self.air.seconds(self.exit(from), self.entry(to))
    }

    /// Seconds that an entry costs by its place.
    pub(super) fn extra(&self, node: NodeId) -> f64 {
        let n = &self.problem.nodes[node as usize];
        self.problem.items[n.item as usize].extra(node, n.along)
    }

    /// Whether a contour may be left unfinished.
    pub(super) fn may_leave(&self, item: ItemId) -> bool {
        self.problem.items[item as usize].leave.is_some()
    }

    /// Seconds of leaving a contour at a node and resuming it there: the pre-cut, and the cost of the place.
    pub(super) fn charge(&self, node: NodeId) -> f64 {
        self.problem.items[self.item(node) as usize].resume() + self.extra(node)
    }

    /// Near nodes of other contours, the nearest first.
    pub(super) fn near(&self, node: NodeId) -> &[NodeId] {
        self.near.get(node as usize).map_or(&[], Vec::as_slice)
    }

    /// Finds the near nodes of the next contour. Returns the number of nodes priced, or `None` when all are found.
    pub(super) fn list_near(&mut self) -> Option<u64> {
        let first = self.problem.nodes.get(self.near.len())?.item;
        let mut priced = 1;
        while let Some(node) = self.problem.nodes.get(self.near.len()).filter(|n| n.item == first) {
            let mut found = Vec::with_capacity(NEAR + 1);
            // A contour that is left at another point than it is entered (an open one) has neighbours at both.
            for place in [node.exit, node.entry].into_iter().take(1 + usize::from(node.exit != node.entry)) {
                priced += self.find_near(&mut found, first, place);
            }
            self.near.push(found.into_iter().map(|f| f.1).collect());
        }
        Some(priced)
    }

    /// Finds nodes of other contours near a point. Returns the number of nodes priced.
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

    /// Inserts a node into the sorted list, which holds a few nodes of each contour.
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
