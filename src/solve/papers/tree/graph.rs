//! The nodes of a problem as the method needs them: seconds between nodes, costs of leaving contours, near nodes, and
//! nesting.
//!
//! Partitions hang from nodes. A contour is entered and left at the same nodes, those of the problem. A pierce group is
//! entered by one of its paths, which are its nodes in the problem. It may be left at the nodes of its net, whatever the path:
//! they have the numbers after all nodes of the problem. What leaving there costs depends on the path ([`Graph::leave_point`]).

use crate::geometry::{Aabb, Buckets};
use crate::machine::AirTime;
use crate::order::real;
use crate::problem::{ItemId, LeavePoint, NodeId, Problem};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Where moves and connections lead.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Neighbourhood {
    /// To a few near nodes; sub-sequences have at most 50 contours.
    Near,
    /// To all nodes, with sub-sequences of any length, as in the paper. The memory grows with the square of the number of
    /// nodes, and the work faster.
    All,
}

/// Number of near nodes of a node. With two per contour these cover the nearest six contours or more, which contain all but
/// a few edges of good planar tours.
const NEAR: usize = 12;
/// Largest number of near nodes of the same contour. One may be its entry, to which nothing can be attached. The same number
/// of nodes where a pierce group is left come in addition.
const SAME: usize = 2;

/// A node at which a pierce group may be left.
struct LeaveNode<'p> {
    item: ItemId,
    place: DVec2,
    /// By path: the cheapest leave point there, the first of several.
    points: Vec<Option<&'p LeavePoint>>,
}

/// The nodes of a problem with their costs and neighbours.
pub(super) struct Graph<'p> {
    pub(super) problem: &'p Problem,
    air: AirTime,
    neighbourhood: Neighbourhood,
    /// Near nodes by node, filled contour by contour.
    near: Vec<Vec<NodeId>>,
    buckets: Buckets,
    /// The contours directly inside each contour.
    pub(super) inner: Vec<Vec<ItemId>>,
    /// Contours that contain others, the most deeply nested first.
    pub(super) inwards: Vec<ItemId>,
    leave_nodes: Vec<LeaveNode<'p>>,
    /// By item: its leave nodes; empty if there are none.
    leave_ranges: Vec<Range<NodeId>>,
}

impl<'p> Graph<'p> {
    pub(super) fn new(problem: &'p Problem, neighbourhood: Neighbourhood) -> Self {
        let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
        let mut buckets = Buckets::new(bounds, problem.nodes.len());
        for (id, node) in (0..).zip(&problem.nodes) {
            buckets.insert(id, node.entry);
        }
        let (leave_nodes, leave_ranges) = leave_nodes(problem);
        let first = NodeId::try_from(problem.nodes.len()).unwrap_or(NodeId::MAX);
        for (id, node) in (first..).zip(&leave_nodes) {
            buckets.insert(id, node.place);
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
        let air = AirTime::new(&problem.machine);
        Self {
            problem,
            air,
            neighbourhood,
            near: Vec::new(),
            buckets,
            inner,
            inwards,
            leave_nodes,
            leave_ranges,
        }
    }

    /// Whether the paper's model covers a problem: precedence comes from nesting only.
    pub(super) fn is_one_tree(problem: &Problem) -> bool {
        problem.table().is_none()
            && problem.pairs.is_empty()
            && problem.groups.is_empty()
            && problem.items.iter().all(|i| i.rank == problem.items[0].rank)
    }

    /// How many of something a move takes into account: a few, or all.
    pub(super) fn at_most(&self, few: usize) -> usize {
        match self.neighbourhood {
            Neighbourhood::Near => few,
            Neighbourhood::All => usize::MAX,
        }
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
        self.leave_node(node).map_or_else(|| self.problem.nodes[node as usize].item, |n| n.item)
    }

    fn leave_node(&self, node: NodeId) -> Option<&LeaveNode<'p>> {
        self.leave_nodes.get((node as usize).checked_sub(self.problem.nodes.len())?)
    }

    /// Where a node is; of a node where an item is entered, where the head arrives.
    fn place(&self, node: NodeId) -> DVec2 {
        self.leave_node(node).map_or_else(|| self.entry(node), |n| n.place)
    }

    /// The nodes where an item is entered.
    pub(super) fn nodes(&self, item: ItemId) -> Range<NodeId> {
        self.problem.items[item as usize].nodes.clone()
    }

    /// The nodes from which partitions of an item may hang, unless it is entered there.
    pub(super) fn parent_nodes(&self, item: ItemId) -> Range<NodeId> {
        if self.is_group(item) {
            return self.leave_ranges.get(item as usize).cloned().unwrap_or_default();
        }
        self.nodes(item)
    }

    /// Number of all nodes, with those where pierce groups may be left.
    pub(super) fn count(&self) -> usize {
        self.problem.nodes.len() + self.leave_nodes.len()
    }

    /// Whether an item is a pierce group.
    pub(super) fn is_group(&self, item: ItemId) -> bool {
        self.problem.items[item as usize].is_pierce_group()
    }

    /// Where the path of a pierce group that is entered at `entry` may be left at one of its leave nodes.
    pub(super) fn leave_point(&self, entry: NodeId, node: NodeId) -> Option<&'p LeavePoint> {
        let node = self.leave_node(node)?;
        let path = entry.checked_sub(self.nodes(node.item).start)?;
        node.points.get(path as usize).copied().flatten()
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

    /// Seconds of leaving a contour at a node and resuming it there: the pre-cut, and the cost of the place. Pierce groups
    /// have other nodes for that.
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
            let mut found = Vec::new();
            // A contour that is left at another point than it is entered (an open one) has neighbours at both.
            let places = [node.exit, node.entry];
            let places = &places[..1 + usize::from(node.exit != node.entry)];
            match self.neighbourhood {
                Neighbourhood::Near => {
                    for &place in places {
                        priced += self.find_near(&mut found, first, place);
                    }
                }
                Neighbourhood::All => {
                    found.extend(self.others(first, places));
                    priced += found.len() as u64;
                    crate::order::sort_by(&mut found, |f| [real(f.0), f.1.into(), 0]);
                }
            }
            self.near.push(found.into_iter().map(|f| f.1).collect());
        }
        Some(priced)
    }

    /// All nodes of other contours, with the seconds from the nearest of these places.
    fn others<'g>(&'g self, own: ItemId, places: &'g [DVec2]) -> impl Iterator<Item = (f64, NodeId)> + 'g {
        let count = NodeId::try_from(self.count()).unwrap_or(NodeId::MAX);
        (0..count).filter(move |&node| self.item(node) != own).map(|node| {
            let seconds = places.iter().map(|&p| self.air(p, self.place(node)));
            (seconds.fold(f64::INFINITY, f64::min), node)
        })
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
                self.keep(found, (self.air(place, self.place(other)), other));
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
        let kind = |node: NodeId| (self.item(node), self.leave_node(node).is_some());
        let own = kind(new.1);
        let mut same = (0..found.len()).filter(|&k| kind(found[k].1) == own);
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

/// The nodes at which pierce groups may be left, group by group, and those of each item.
fn leave_nodes(problem: &Problem) -> (Vec<LeaveNode<'_>>, Vec<Range<NodeId>>) {
    let (mut nodes, mut ranges) = (Vec::new(), Vec::new());
    let count =
        |nodes: &Vec<LeaveNode>| NodeId::try_from(problem.nodes.len() + nodes.len()).unwrap_or(NodeId::MAX);
    for (id, item) in (0..).zip(&problem.items).filter(|(_, i)| i.is_pierce_group()) {
        ranges.resize(problem.items.len(), 0..0);
        let first = nodes.len();
        // By node of the group's net: its leave node.
        let mut known: Vec<Option<usize>> = Vec::new();
        for (path, k) in item.paths.iter().zip(0..) {
            for point in &path.leave_points {
                let own = point.node as usize;
                known.resize(known.len().max(own + 1), None);
                let at = *known[own].get_or_insert_with(|| {
                    let points = vec![None; item.paths.len()];
                    nodes.push(LeaveNode { item: id, place: point.ends[0], points });
                    nodes.len() - 1
                });
                let best: &mut Option<&LeavePoint> = &mut nodes[at].points[k];
                if best.is_none_or(|b| point.seconds < b.seconds) {
                    *best = Some(point);
                }
            }
        }
        let from = NodeId::try_from(problem.nodes.len() + first).unwrap_or(NodeId::MAX);
        ranges[id as usize] = from..count(&nodes);
    }
    (nodes, ranges)
}
