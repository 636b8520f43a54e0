//! The partition-tree: contours in partitions, each a route that hangs at a node of a contour in its parent partition;
//! the root's hangs at home. At a node hangs one partition at most, and none at the node where its contour is entered.
//!
//! Seconds are a sum over routes (air from the parent node around to it again), entries and pre-cuts: they do not depend
//! on the order in which the partitions of a contour are visited. Precedence does; see `walk.rs`.

use super::ground::Ground;
use crate::problem::{ItemId, NodeId};
use glam::DVec2;

/// No partition.
pub(super) const NONE: u32 = u32::MAX;
/// The partition of home.
pub(super) const ROOT: u32 = 0;

/// A partition.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Route {
    /// Its contours in order. Only the root may have none; others without are free to be used again.
    pub(super) items: Vec<ItemId>,
    /// Its parent node; none: home, or nothing as yet.
    pub(super) at: Option<NodeId>,
}

/// All partitions.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Forest {
    pub(super) routes: Vec<Route>,
    /// Partition of each contour, and its place there.
    route_of: Vec<u32>,
    pos: Vec<u32>,
    /// Where each contour is entered.
    entry: Vec<NodeId>,
    /// The partition that hangs at each node.
    child: Vec<u32>,
    /// How many hang from each contour.
    kids: Vec<u32>,
}

impl Forest {
    /// All contours out, home alone.
    pub(super) fn new(g: &Ground) -> Self {
        let items = g.problem.items.len();
        Self {
            routes: vec![Route { items: Vec::new(), at: None }],
            route_of: vec![NONE; items],
            pos: vec![0; items],
            entry: g.problem.items.iter().map(|i| i.nodes.start).collect(),
            child: vec![NONE; g.problem.nodes.len()],
            kids: vec![0; items],
        }
    }

    /// The partition of a contour; [`NONE`] while it is out.
    pub(super) fn route_of(&self, item: ItemId) -> u32 {
        self.route_of[item as usize]
    }

    /// Its place in its partition.
    pub(super) fn pos(&self, item: ItemId) -> usize {
        self.pos[item as usize] as usize
    }

    /// Where it is entered.
    pub(super) fn entry(&self, item: ItemId) -> NodeId {
        self.entry[item as usize]
    }

    /// How many partitions hang from it.
    pub(super) fn kids(&self, item: ItemId) -> u32 {
        self.kids[item as usize]
    }

    /// The partition that hangs at a node.
    pub(super) fn child(&self, node: NodeId) -> Option<u32> {
        Some(self.child[node as usize]).filter(|&r| r != NONE)
    }

    pub(super) fn items(&self, route: u32) -> &[ItemId] {
        &self.routes[route as usize].items
    }

    /// Its parent node.
    pub(super) fn at(&self, route: u32) -> Option<NodeId> {
        self.routes[route as usize].at
    }

    /// Partitions with contours.
    pub(super) fn used(&self) -> impl Iterator<Item = u32> + '_ {
        (0..).zip(&self.routes).filter(|(_, r)| !r.items.is_empty()).map(|(id, _)| id)
    }

    /// Whether a partition may hang at a node of a contour that is in.
    pub(super) fn is_free(&self, g: &Ground, node: NodeId) -> bool {
        let item = g.item(node);
        g.may_leave(item) && self.entry(item) != node && self.child[node as usize] == NONE
    }

    /// Whether a contour may be entered at a node: nothing else hangs there.
    pub(super) fn may_enter(&self, node: NodeId) -> bool {
        self.child[node as usize] == NONE
    }

    /// Where a route starts, and where it has to end.
    pub(super) fn ends(&self, g: &Ground, route: u32) -> (DVec2, Option<DVec2>) {
        match self.at(route) {
            Some(node) => (g.entry(node), Some(g.entry(node))),
            None => (g.problem.home, Some(g.problem.home).filter(|_| g.problem.closed)),
        }
    }

    /// Where the head comes from to the contour at a place of a route; the place may be one behind its last.
    pub(super) fn before(&self, g: &Ground, route: u32, pos: usize) -> DVec2 {
        match pos.checked_sub(1).and_then(|p| self.items(route).get(p)) {
            Some(&item) => g.exit(self.entry(item)),
            None => self.ends(g, route).0,
        }
    }

    /// Where it goes from a gap before that place; nowhere, at the end of an open path.
    pub(super) fn after(&self, g: &Ground, route: u32, pos: usize) -> Option<DVec2> {
        match self.items(route).get(pos) {
            Some(&item) => Some(g.entry(self.entry(item))),
            None => self.ends(g, route).1,
        }
    }

    /// Whether a contour hangs, by whatever way, from those at the places of a route, or is one of them.
    pub(super) fn hangs_from(
        &self,
        g: &Ground,
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

    /// How many partitions there are on the way from home to one, without the root.
    pub(super) fn depth(&self, g: &Ground, route: u32) -> u32 {
        let parent = |&r: &u32| self.at(r).map(|node| self.route_of(g.item(node)));
        std::iter::successors(Some(route), parent).skip(1).fold(0, |n, _| n + 1)
    }

    /// Seconds of a route: air and entries, and the pre-cut of its parent node.
    pub(super) fn route_seconds(&self, g: &Ground, route: u32) -> f64 {
        let items = self.items(route);
        if items.is_empty() {
            return 0.0;
        }
        let air: f64 = (0..=items.len())
            .filter_map(|k| self.after(g, route, k).map(|to| g.air(self.before(g, route, k), to)))
            .sum();
        let entries: f64 = items.iter().map(|&i| g.extra(self.entry(i))).sum();
        air + entries + self.at(route).map_or(0.0, |node| g.charge(node))
    }

    /// Seconds of all of it.
    pub(super) fn seconds(&self, g: &Ground) -> f64 {
        self.used().map(|r| self.route_seconds(g, r)).sum()
    }

    /// A partition of its own for contours that are out, not yet hung up.
    pub(super) fn open(&mut self, items: Vec<ItemId>) -> u32 {
        let free = (0..).zip(&self.routes).skip(1).find(|(_, r)| r.items.is_empty()).map(|(id, _)| id);
        let route = free.unwrap_or_else(|| {
            self.routes.push(Route { items: Vec::new(), at: None });
            u32::try_from(self.routes.len() - 1).unwrap_or(NONE)
        });
        self.splice(route, 0, items);
        route
    }

    /// Puts contours that are out into a route before a place.
    pub(super) fn splice(&mut self, route: u32, pos: usize, items: Vec<ItemId>) {
        self.routes[route as usize].items.splice(pos..pos, items);
        self.number(route, pos);
    }

    /// Takes contours out of a route, with what hangs from them; a route without any comes off its node.
    pub(super) fn take(&mut self, g: &Ground, route: u32, places: std::ops::Range<usize>) -> Vec<ItemId> {
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

    /// Hangs a partition at a free node.
    pub(super) fn hang(&mut self, g: &Ground, route: u32, node: NodeId) {
        debug_assert!(self.is_free(g, node), "node {node} is not free");
        self.routes[route as usize].at = Some(node);
        self.child[node as usize] = route;
        self.kids[g.item(node) as usize] += 1;
    }

    /// Takes it off its node.
    pub(super) fn unhang(&mut self, g: &Ground, route: u32) {
        if let Some(node) = self.routes[route as usize].at.take() {
            self.child[node as usize] = NONE;
            self.kids[g.item(node) as usize] -= 1;
        }
    }

    /// Enters a contour elsewhere; nothing hangs there.
    pub(super) fn enter(&mut self, item: ItemId, node: NodeId) {
        debug_assert!(self.may_enter(node), "something hangs at node {node}");
        self.entry[item as usize] = node;
    }

    /// The contour at a place of a route comes first, those before it go behind the last one: the ring is broken elsewhere.
    pub(super) fn rotate(&mut self, route: u32, pos: usize) {
        self.routes[route as usize].items.rotate_left(pos);
        self.number(route, 0);
    }

    /// The same contours in the order of these nodes, each entered there.
    pub(super) fn order(&mut self, g: &Ground, route: u32, nodes: &[NodeId]) {
        for (k, &node) in nodes.iter().enumerate() {
            self.routes[route as usize].items[k] = g.item(node);
            self.enter(g.item(node), node);
        }
        self.number(route, 0);
    }

    /// Whether all links agree: for tests.
    #[cfg(test)]
    pub(super) fn is_sound(&self, g: &Ground) -> bool {
        let items = (0..).zip(&g.problem.items).filter(|(_, i)| !i.nodes.is_empty()).all(|(id, item)| {
            let route = self.route_of(id);
            let hangs = item.nodes.clone().filter(|&n| self.child(n).is_some()).count();
            route != NONE
                && self.items(route).get(self.pos(id)) == Some(&id)
                && item.nodes.contains(&self.entry(id))
                && self.may_enter(self.entry(id))
                && hangs == self.kids(id) as usize
                && (hangs == 0 || item.leave.is_some())
        });
        let routes = self.used().all(|r| match self.at(r) {
            Some(node) => self.child(node) == Some(r),
            None => r == ROOT,
        });
        items && routes
    }
}
