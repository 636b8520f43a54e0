//! The partition-tree. Contours are divided into partitions. Each partition is a route that is attached to a node of a
//! contour in its parent partition; the root is attached to home. At most one partition is attached to a node, and none to
//! the node where its contour is entered. Partitions of a pierce group hang from nodes of its net, while the path through the
//! group passes them.
//!
//! The cost is a sum over routes (air moves from the parent node around and back to it), entries and pre-cuts, in seconds.
//! It does not depend on the order in which the partitions of a contour are visited. Precedence does; see `visits.rs`.

use super::graph::Graph;
use crate::order::{real, sort_by};
use crate::problem::{ItemId, LeavePoint, NodeId};
use glam::DVec2;

/// The index of no partition.
pub(super) const NONE: u32 = u32::MAX;
/// The root partition, which is attached to home.
pub(super) const ROOT: u32 = 0;

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

/// A partition.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Route {
    /// Its contours in order. Only the root may be empty; other empty partitions are unused and available.
    pub(super) items: Vec<ItemId>,
    /// Its parent node; `None` for the root, and for a partition that is not attached yet.
    pub(super) at: Option<NodeId>,
}

/// All partitions.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Forest {
    pub(super) routes: Vec<Route>,
    /// The partition of each contour, and its position there.
    route_of: Vec<u32>,
    pos: Vec<u32>,
    /// The node where each contour is entered.
    entry: Vec<NodeId>,
    /// The partition that is attached to each node.
    child: Vec<u32>,
    /// Number of partitions attached to each contour.
    children: Vec<u32>,
}

impl Forest {
    /// Starts with an empty root; all contours are unassigned.
    pub(super) fn new(g: &Graph) -> Self {
        let items = g.problem.items.len();
        Self {
            routes: vec![Route { items: Vec::new(), at: None }],
            route_of: vec![NONE; items],
            pos: vec![0; items],
            entry: g.problem.items.iter().map(|i| i.nodes.start).collect(),
            child: vec![NONE; g.count()],
            children: vec![0; items],
        }
    }

    /// The partition of a contour; [`NONE`] while it is unassigned.
    pub(super) fn route_of(&self, item: ItemId) -> u32 {
        self.route_of[item as usize]
    }

    /// Its position in its partition.
    pub(super) fn pos(&self, item: ItemId) -> usize {
        self.pos[item as usize] as usize
    }

    /// The node where it is entered.
    pub(super) fn entry(&self, item: ItemId) -> NodeId {
        self.entry[item as usize]
    }

    /// Number of partitions attached to it.
    pub(super) fn children(&self, item: ItemId) -> u32 {
        self.children[item as usize]
    }

    /// The partition that is attached to a node.
    pub(super) fn child(&self, node: NodeId) -> Option<u32> {
        Some(self.child[node as usize]).filter(|&r| r != NONE)
    }

    pub(super) fn items(&self, route: u32) -> &[ItemId] {
        &self.routes[route as usize].items
    }

    /// The parent node of a partition.
    pub(super) fn at(&self, route: u32) -> Option<NodeId> {
        self.routes[route as usize].at
    }

    /// Partitions that contain contours.
    pub(super) fn used(&self) -> impl Iterator<Item = u32> + '_ {
        (0..).zip(&self.routes).filter(|(_, r)| !r.items.is_empty()).map(|(id, _)| id)
    }

    /// Whether an item may be left at a node: a contour that may be left, or a pierce group whose path passes the node.
    pub(super) fn may_leave(&self, g: &Graph, node: NodeId) -> bool {
        let item = g.item(node);
        if g.is_group(item) { g.leave_point(self.entry(item), node).is_some() } else { g.may_leave(item) }
    }

    /// Whether a partition may be attached to a node of an assigned contour.
    pub(super) fn is_free(&self, g: &Graph, node: NodeId) -> bool {
        self.entry(g.item(node)) != node && self.child[node as usize] == NONE && self.may_leave(g, node)
    }

    /// Whether a contour may be entered at a node: no partition is attached to it. A pierce group may be cut by another path
    /// if that passes the nodes from which partitions hang.
    pub(super) fn may_enter(&self, g: &Graph, node: NodeId) -> bool {
        self.child[node as usize] == NONE && self.hung_seconds(g, node).is_finite()
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

    /// Start and end point of a route; no end point for an open path.
    pub(super) fn ends(&self, g: &Graph, route: u32) -> (DVec2, Option<DVec2>) {
        match self.at(route) {
            Some(node) => {
                let hook = self.hook(g, node);
                (hook.out, Some(hook.back))
            }
            None => (g.problem.home, Some(g.problem.home).filter(|_| g.problem.closed)),
        }
    }

    /// The point from which the head reaches a position of a route; the position may be one after the last.
    pub(super) fn before(&self, g: &Graph, route: u32, pos: usize) -> DVec2 {
        match pos.checked_sub(1).and_then(|p| self.items(route).get(p)) {
            Some(&item) => g.exit(self.entry(item)),
            None => self.ends(g, route).0,
        }
    }

    /// The point that the head moves to after a gap before that position; `None` at the end of an open path.
    pub(super) fn after(&self, g: &Graph, route: u32, pos: usize) -> Option<DVec2> {
        match self.items(route).get(pos) {
            Some(&item) => Some(g.entry(self.entry(item))),
            None => self.ends(g, route).1,
        }
    }

    /// Whether a contour is, or depends through its ancestors on, one of the contours at these positions of a route.
    pub(super) fn hangs_from(
        &self,
        g: &Graph,
        item: ItemId,
        route: u32,
        places: &std::ops::Range<usize>,
    ) -> bool {
        let mut item = item;
        loop {
            let own = self.route_of(item);
            if own == route {
                return places.contains(&self.pos(item));
            }
            match self.routes.get(own as usize).and_then(|r| r.at) {
                Some(node) => item = g.item(node),
                None => return false,
            }
        }
    }

    /// Number of partitions from the root to this one, not counting the root.
    pub(super) fn depth(&self, g: &Graph, route: u32) -> u32 {
        let parent = |&r: &u32| self.at(r).map(|node| self.route_of(g.item(node)));
        std::iter::successors(Some(route), parent).skip(1).fold(0, |n, _| n + 1)
    }

    /// Cost of a route in seconds: air moves, entries, and the pre-cut at its parent node.
    pub(super) fn route_seconds(&self, g: &Graph, route: u32) -> f64 {
        let items = self.items(route);
        if items.is_empty() {
            return 0.0;
        }
        let air: f64 = (0..=items.len())
            .filter_map(|k| self.after(g, route, k).map(|to| g.air(self.before(g, route, k), to)))
            .sum();
        let entries: f64 = items.iter().map(|&i| g.extra(self.entry(i))).sum();
        air + entries + self.leaving(g, route)
    }

    /// Cost of all routes in seconds.
    pub(super) fn seconds(&self, g: &Graph) -> f64 {
        self.used().map(|r| self.route_seconds(g, r)).sum()
    }

    /// Makes a partition of unassigned contours. It is not attached yet.
    pub(super) fn open(&mut self, items: Vec<ItemId>) -> u32 {
        let free = (0..).zip(&self.routes).skip(1).find(|(_, r)| r.items.is_empty()).map(|(id, _)| id);
        let route = free.unwrap_or_else(|| {
            self.routes.push(Route { items: Vec::new(), at: None });
            u32::try_from(self.routes.len() - 1).unwrap_or(NONE)
        });
        self.splice(route, 0, items);
        route
    }

    /// Inserts unassigned contours into a route before a position.
    pub(super) fn splice(&mut self, route: u32, pos: usize, items: Vec<ItemId>) {
        self.routes[route as usize].items.splice(pos..pos, items);
        self.number(route, pos);
    }

    /// Removes contours from a route, with everything attached to them. A route that becomes empty is detached.
    pub(super) fn take(&mut self, g: &Graph, route: u32, places: std::ops::Range<usize>) -> Vec<ItemId> {
        let first = places.start;
        let taken: Vec<ItemId> = self.routes[route as usize].items.drain(places).collect();
        for &item in &taken {
            self.route_of[item as usize] = NONE;
        }
        self.number(route, first);
        if self.items(route).is_empty() {
            self.unhang(g, route);
        }
        taken
    }

    fn number(&mut self, route: u32, from: usize) {
        for (place, &item) in (0..).zip(&self.routes[route as usize].items).skip(from) {
            self.route_of[item as usize] = route;
            self.pos[item as usize] = place;
        }
    }

    /// Attaches a partition to a free node.
    pub(super) fn hang(&mut self, g: &Graph, route: u32, node: NodeId) {
        debug_assert!(self.is_free(g, node), "node {node} is not free");
        self.routes[route as usize].at = Some(node);
        self.child[node as usize] = route;
        self.children[g.item(node) as usize] += 1;
    }

    /// Detaches a partition from its node.
    pub(super) fn unhang(&mut self, g: &Graph, route: u32) {
        if let Some(node) = self.routes[route as usize].at.take() {
            self.child[node as usize] = NONE;
            self.children[g.item(node) as usize] -= 1;
        }
    }

    /// Enters a contour at another node, to which nothing is attached.
    pub(super) fn enter(&mut self, item: ItemId, node: NodeId) {
        debug_assert!(self.child(node).is_none(), "something hangs at node {node}");
        self.entry[item as usize] = node;
    }

    /// Rotates a route so that the contour at this position comes first: its ring is opened elsewhere.
    pub(super) fn rotate(&mut self, route: u32, pos: usize) {
        self.routes[route as usize].items.rotate_left(pos);
        self.number(route, 0);
    }

    /// Puts the same contours in the order of these nodes, at which they are entered.
    pub(super) fn order(&mut self, g: &Graph, route: u32, nodes: &[NodeId]) {
        for (k, &node) in nodes.iter().enumerate() {
            self.routes[route as usize].items[k] = g.item(node);
            self.enter(g.item(node), node);
        }
        self.number(route, 0);
    }

    /// Whether all links are consistent.
    #[cfg(test)]
    pub(super) fn is_sound(&self, g: &Graph) -> bool {
        let items = (0..).zip(&g.problem.items).filter(|(_, i)| !i.nodes.is_empty()).all(|(id, item)| {
            let route = self.route_of(id);
            let hangs = g.parent_nodes(id).filter(|&n| self.child(n).is_some()).count();
            let may_be_left = self.hanging(g, id).into_iter().all(|n| self.may_leave(g, n));
            route != NONE
                && self.items(route).get(self.pos(id)) == Some(&id)
                && item.nodes.contains(&self.entry(id))
                && self.may_enter(g, self.entry(id))
                && hangs == self.children(id) as usize
                && may_be_left
        });
        let routes = self.used().all(|r| match self.at(r) {
            Some(node) => self.child(node) == Some(r),
            None => r == ROOT,
        });
        items && routes
    }
}
