//! The nodes from which partitions hang: where they may, in which order an item is left there, and what that costs.

use super::forest::Forest;
use super::graph::Graph;
use crate::order::{real, sort_by};
use crate::problem::{ItemId, LeavePoint, NodeId};
use glam::DVec2;

/// Where a partition hangs: the points from which the head goes to it and to which it returns, and the seconds of leaving
/// and resuming.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hook {
    pub(super) out: DVec2,
    pub(super) back: DVec2,
    pub(super) seconds: f64,
}

impl Hook {
    fn at(point: &LeavePoint) -> Self {
        Self { out: point.ends[0], back: point.ends[1], seconds: point.seconds }
    }

    /// Seconds of a partition that begins and ends at these nodes, without those inside it.
    pub(super) fn around(&self, g: &Graph, first: NodeId, last: NodeId) -> f64 {
        g.air(self.out, g.entry(first)) + g.air(g.exit(last), self.back) + self.seconds
    }
}

impl Forest {
    /// Whether an item may be left at a node: a contour that may be left, or a pierce group whose path passes the node.
    pub(super) fn may_leave(&self, g: &Graph, node: NodeId) -> bool {
        let item = g.item(node);
        if g.is_group(item) { g.leave_point(self.entry(item), node).is_some() } else { g.may_leave(item) }
    }

    /// Whether a partition may be attached to a node of an assigned contour.
    pub(super) fn is_free(&self, g: &Graph, node: NodeId) -> bool {
        self.entry(g.item(node)) != node && self.child(node).is_none() && self.may_leave(g, node)
    }

    /// Whether a contour may be entered at a node: no partition is attached to it. A pierce group may be cut by another path
    /// if that passes the nodes from which partitions hang.
    pub(super) fn may_enter(&self, g: &Graph, node: NodeId) -> bool {
        self.child(node).is_none() && self.hung_seconds(g, node).is_finite()
    }

    /// Seconds of what hangs from a pierce group that is entered at a node: leaving and resuming it, and the air moves to its
    /// partitions and back. Infinite if the path does not pass one of their nodes; 0 for a contour, whose nodes stay.
    pub(super) fn hung_seconds(&self, g: &Graph, entry: NodeId) -> f64 {
        let item = g.item(entry);
        if self.children(item) == 0 || !g.is_group(item) {
            return 0.0;
        }
        let seconds = |n: NodeId| {
            let items = self.items(self.child(n)?);
            let (first, last) = (self.entry(*items.first()?), self.entry(*items.last()?));
            let hook = g.leave_point(entry, n).map(Hook::at);
            Some(hook.map_or(f64::INFINITY, |hook| hook.around(g, first, last)))
        };
        g.parent_nodes(item).filter_map(seconds).sum()
    }

    /// Seconds that an entry costs by its place, with what hangs from a pierce group, beyond what that costs now.
    pub(super) fn extra(&self, g: &Graph, entry: NodeId) -> f64 {
        let now = self.entry(g.item(entry));
        let hung = if now == entry { 0.0 } else { self.hung_seconds(g, entry) - self.hung_seconds(g, now) };
        g.extra(entry) + hung
    }

    /// What a partition at a node costs besides its own route. Infinite seconds: the path of the group does not pass the
    /// node.
    pub(super) fn hook(&self, g: &Graph, node: NodeId) -> Hook {
        let item = g.item(node);
        if !g.is_group(item) || self.entry(item) == node {
            let seconds = if g.is_group(item) { 0.0 } else { g.charge(node) };
            return Hook { out: g.exit(node), back: g.entry(node), seconds };
        }
        match g.leave_point(self.entry(item), node) {
            Some(point) => Hook::at(point),
            None => Hook { out: g.problem.home, back: g.problem.home, seconds: f64::INFINITY },
        }
    }

    /// Seconds of leaving and resuming an item for a route; 0 for the root.
    pub(super) fn leaving(&self, g: &Graph, route: u32) -> f64 {
        self.at(route).map_or(0.0, |node| self.hook(g, node).seconds)
    }

    /// The nodes of an item from which partitions hang, in the order in which it is left there.
    pub(super) fn hanging(&self, g: &Graph, item: ItemId) -> Vec<NodeId> {
        if g.is_group(item) { self.hanging_from_group(g, item) } else { self.around(g, item).collect() }
    }

    /// The node at which an item is left for the time after `done` others.
    pub(super) fn next_hanging(&self, g: &Graph, item: ItemId, done: usize) -> Option<NodeId> {
        if self.children(item) as usize <= done {
            return None;
        }
        if g.is_group(item) {
            self.hanging_from_group(g, item).get(done).copied()
        } else {
            self.around(g, item).nth(done)
        }
    }

    /// The nodes of a contour from which partitions hang, from its entry on.
    fn around(&self, g: &Graph, item: ItemId) -> impl Iterator<Item = NodeId> {
        let (entry, nodes) = (self.entry(item), g.nodes(item));
        let count = if self.children(item) == 0 { 0 } else { nodes.end - nodes.start };
        (1..count)
            .map(move |k| nodes.start + (entry - nodes.start + k) % count)
            .filter(|&n| self.child(n).is_some())
    }

    /// The nodes of a pierce group from which partitions hang, along its path.
    fn hanging_from_group(&self, g: &Graph, item: ItemId) -> Vec<NodeId> {
        if self.children(item) == 0 {
            return Vec::new();
        }
        let mut used: Vec<NodeId> = g.parent_nodes(item).filter(|&n| self.child(n).is_some()).collect();
        let along = |n: NodeId| g.leave_point(self.entry(item), n).map_or(f64::INFINITY, |p| p.along);
        sort_by(&mut used, |&n| [real(along(n)), n.into(), 0]);
        used
    }

    /// The leave node of a pierce group by which a route depends on it, directly or through others.
    pub(super) fn hangs_at(&self, g: &Graph, route: u32, group: ItemId) -> Option<NodeId> {
        let parent =
            |&r: &u32| self.routes.get(r as usize).and_then(|r| r.at).map(|n| self.route_of(g.item(n)));
        std::iter::successors(Some(route), parent)
            .filter_map(|r| self.routes.get(r as usize).and_then(|r| r.at))
            .find(|&n| g.item(n) == group)
    }

    /// Whether a node of a pierce group is passed while the area around an item still holds.
    pub(super) fn holds_at(&self, g: &Graph, node: NodeId, item: ItemId) -> bool {
        let entry = self.entry(g.item(node));
        let path = g.problem.items[g.item(node) as usize].path(entry);
        let due = path.map_or(f64::INFINITY, |p| p.due(g.problem.items[item as usize].area));
        g.leave_point(entry, node).is_none_or(|p| p.along < due)
    }

    /// Whether an item inside a pierce group is cut while the group is left, but after the area around it has fallen out.
    pub(super) fn is_late(&self, g: &Graph, item: ItemId) -> bool {
        let group = g.problem.items[item as usize].before.filter(|&o| g.is_group(o));
        let at = group.and_then(|group| self.hangs_at(g, self.route_of(item), group));
        at.is_some_and(|node| !self.holds_at(g, node, item))
    }
}
