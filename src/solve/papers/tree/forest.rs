//! The partition-tree. Contours are divided into partitions. Each partition is a route that is attached to a node of a
//! contour in its parent partition; the root is attached to home. At most one partition is attached to a node, and none to
//! the node where its contour is entered. Partitions of a pierce group hang from nodes of its net, while the path through the
//! group passes them.
//!
//! The cost is a sum over routes (air moves from the parent node around and back to it), entries and pre-cuts, in seconds.
//! It does not depend on the order in which the partitions of a contour are visited. Precedence does; see `visits.rs`.

use super::graph::Graph;
use crate::problem::{ItemId, NodeId};
use glam::DVec2;

/// The index of no partition.
pub(super) const NONE: u32 = u32::MAX;
/// The root partition, which is attached to home.
pub(super) const ROOT: u32 = 0;

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
