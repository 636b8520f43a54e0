//! Rebuilds the partition-tree from an arborescence (section 4.4, figure 5). Connections are resolved from the root
//! outwards. There are four cases, which depend on whether the nodes of the connection are the entries of their contours:
//!
//! * (a) Only the child's node is an entry: the child is attached to the parent's node.
//! * (b) Neither is an entry: the contour of the child's node becomes a partition of its own, attached to the parent's node
//!   and entered at the connection's node; the rest is attached to its old entry.
//! * (c) Only the parent's node is an entry: the contour is inserted into the parent partition next to the parent's
//!   contour; the rest is attached to its old entry.
//! * (d) Both are entries: the partitions are merged.
//!
//! Two partitions at one node are merged. The ring of the inserted partition is opened before or after the contour of the
//! connection, whichever costs less. Home counts as a contour that is entered at home.

use super::connect::Connection;
use super::forest::{Forest, ROOT};
use super::graph::Graph;
use crate::problem::{ItemId, NodeId};
use std::collections::VecDeque;

/// Attaches all partitions by these connections. There is one connection to each partition in use, and the root reaches all
/// of them.
pub(super) fn resolve(g: &Graph, forest: &mut Forest, chosen: &[Connection]) {
    let mut from: Vec<Vec<&Connection>> = vec![Vec::new(); forest.routes.len()];
    for connection in chosen {
        from[connection.arc.from].push(connection);
    }
    let used: Vec<u32> = forest.used().collect();
    for route in used {
        forest.unhang(g, route);
    }
    let mut queue = VecDeque::from([ROOT as usize]);
    while let Some(vertex) = queue.pop_front() {
        for c in &from[vertex] {
            connect(g, forest, c.from, c.to);
            queue.push_back(c.arc.to);
        }
    }
}

/// Attaches the partition of `to`, which is not attached, at `from`.
pub(super) fn connect(g: &Graph, forest: &mut Forest, from: Option<NodeId>, to: NodeId) {
    let item = g.item(to);
    let route = forest.route_of(item);
    let entered = forest.entry(item);
    forest.rotate(route, forest.pos(item));
    let mut items = forest.take(g, route, 0..forest.items(route).len());
    if entered == to {
        // The ring is opened before the contour, unless opening it after the contour costs less.
        let mut last = items.clone();
        last.rotate_left(1);
        items = if cost(g, forest, from, &last) < cost(g, forest, from, &items) { last } else { items };
        place(g, forest, from, items);
    } else {
        let rest = items.split_off(1);
        forest.enter(item, to);
        place(g, forest, from, items);
        if !rest.is_empty() {
            let route = forest.open(rest);
            forest.hang(g, route, entered);
        }
    }
}

/// The route and positions where contours may be inserted at a node; `None` if they are attached to the node itself.
fn gaps(g: &Graph, forest: &Forest, from: Option<NodeId>) -> Option<(u32, [usize; 2])> {
    match from {
        None => Some((ROOT, [0, forest.items(ROOT).len()])),
        // A contour that may not be left, and whose entry has changed since, can only be a parent next to its entry; so can
        // a pierce group whose new path does not pass the node.
        Some(node) if forest.entry(g.item(node)) == node || !forest.may_leave(g, node) => {
            let pos = forest.pos(g.item(node));
            Some((forest.route_of(g.item(node)), [pos, pos + 1]))
        }
        Some(node) => forest.child(node).map(|route| (route, [0, forest.items(route).len()])),
    }
}

/// Inserts unassigned contours at a node.
fn place(g: &Graph, forest: &mut Forest, from: Option<NodeId>, items: Vec<ItemId>) {
    match (gaps(g, forest, from), from) {
        (Some((route, places)), _) => {
            let more = |pos| added(g, forest, route, pos, &items);
            let pos = if more(places[1]) <= more(places[0]) { places[1] } else { places[0] };
            forest.splice(route, pos, items);
        }
        (None, Some(node)) => {
            let route = forest.open(items);
            forest.hang(g, route, node);
        }
        (None, None) => {}
    }
}

/// Seconds of the air moves to the first contour and from the last, at the cheapest of the places at a node.
fn cost(g: &Graph, forest: &Forest, from: Option<NodeId>, items: &[ItemId]) -> f64 {
    match (gaps(g, forest, from), from) {
        (Some((route, places)), _) => {
            places.into_iter().map(|pos| added(g, forest, route, pos, items)).fold(f64::INFINITY, f64::min)
        }
        (None, Some(node)) => {
            let hook = forest.hook(g, node);
            ends(g, forest, items, hook.out, Some(hook.back))
        }
        (None, None) => 0.0,
    }
}

/// Additional seconds of air moves with contours in a gap.
fn added(g: &Graph, forest: &Forest, route: u32, pos: usize, items: &[ItemId]) -> f64 {
    let (from, to) = (forest.before(g, route, pos), forest.after(g, route, pos));
    ends(g, forest, items, from, to) - to.map_or(0.0, |to| g.air(from, to))
}

/// Seconds of the air moves to the first contour and from the last.
fn ends(g: &Graph, forest: &Forest, items: &[ItemId], from: glam::DVec2, to: Option<glam::DVec2>) -> f64 {
    let (Some(&first), Some(&last)) = (items.first(), items.last()) else { return 0.0 };
    let home = to.map_or(0.0, |to| g.air(g.exit(forest.entry(last)), to));
    // The leg that closed the ring of these contours is saved.
    let ring = g.leg(forest.entry(last), forest.entry(first));
    g.air(from, g.entry(forest.entry(first))) + home - if items.len() > 1 { ring } else { 0.0 }
}
