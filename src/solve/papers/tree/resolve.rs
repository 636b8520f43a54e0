//! From an arborescence back to a partition-tree (section 4.4, figure 5). Every connection, from the root outwards, is one
//! of four cases, by whether its nodes are the ones where their contours are entered:
//!
//! * (a) the child's is, the parent's is not: the child hangs at the parent's node.
//! * (b) neither is: the contour of the child's node leaves its partition and becomes one of its own that hangs at the
//!   parent's node, entered at the connection node; the rest hangs at its old entry.
//! * (c) the parent's is, the child's is not: the contour goes into the parent partition beside the parent's contour; the
//!   rest hangs at its old entry.
//! * (d) both are: the partitions become one.
//!
//! Where two partitions would hang at one node, they become one. A ring goes in broken before or behind the connection
//! node's contour, whichever costs less. Home counts as a contour entered at home.

use super::connect::Connection;
use super::forest::{Forest, ROOT};
use super::ground::Ground;
use crate::problem::{ItemId, NodeId};
use std::collections::VecDeque;

/// Hangs up all partitions by these connections: one to each of those in use, which the root reaches.
pub(super) fn resolve(g: &Ground, forest: &mut Forest, chosen: &[Connection]) {
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

/// Hangs up the partition of `to`, which hangs nowhere, at `from`.
pub(super) fn connect(g: &Ground, forest: &mut Forest, from: Option<NodeId>, to: NodeId) {
    let item = g.item(to);
    let route = forest.route_of(item);
    let entered = forest.entry(item);
    forest.rotate(route, forest.pos(item));
    let mut items = forest.take(g, route, 0..forest.items(route).len());
    if entered == to {
        // Broken before the contour, unless behind it costs less.
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

/// Where contours may go in at a node: places of a route, or the node itself.
fn gaps(g: &Ground, forest: &Forest, from: Option<NodeId>) -> Option<(u32, [usize; 2])> {
    match from {
        None => Some((ROOT, [0, forest.items(ROOT).len()])),
        // What may not be left, and was entered elsewhere since, is no parent but beside its entry.
        Some(node) if forest.entry(g.item(node)) == node || !g.may_leave(g.item(node)) => {
            let pos = forest.pos(g.item(node));
            Some((forest.route_of(g.item(node)), [pos, pos + 1]))
        }
        Some(node) => forest.child(node).map(|route| (route, [0, forest.items(route).len()])),
    }
}

/// Puts contours that are out in at a node.
fn place(g: &Ground, forest: &mut Forest, from: Option<NodeId>, items: Vec<ItemId>) {
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

/// Air that contours at a node take on the way to the first and from the last, at the least.
fn cost(g: &Ground, forest: &Forest, from: Option<NodeId>, items: &[ItemId]) -> f64 {
    match (gaps(g, forest, from), from) {
        (Some((route, places)), _) => {
            places.into_iter().map(|pos| added(g, forest, route, pos, items)).fold(f64::INFINITY, f64::min)
        }
        (None, Some(node)) => ends(g, forest, items, g.exit(node), Some(g.entry(node))),
        (None, None) => 0.0,
    }
}

/// Air more with contours in a gap.
fn added(g: &Ground, forest: &Forest, route: u32, pos: usize, items: &[ItemId]) -> f64 {
    let (from, to) = (forest.before(g, route, pos), forest.after(g, route, pos));
    ends(g, forest, items, from, to) - to.map_or(0.0, |to| g.air(from, to))
}

/// Air to the first of some contours and from the last.
fn ends(g: &Ground, forest: &Forest, items: &[ItemId], from: glam::DVec2, to: Option<glam::DVec2>) -> f64 {
    let (Some(&first), Some(&last)) = (items.first(), items.last()) else { return 0.0 };
    let home = to.map_or(0.0, |to| g.air(g.exit(forest.entry(last)), to));
    // What closes the ring of these contours falls away where it is broken.
    let ring = g.leg(forest.entry(last), forest.entry(first));
    g.air(from, g.entry(forest.entry(first))) + home - if items.len() > 1 { ring } else { 0.0 }
}
