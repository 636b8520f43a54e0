//! The first set of repartitioning moves: a partition is hung up elsewhere; a partition of one contour with a child of one
//! contour (and a child of that one) is merged with it and hung up elsewhere, or at the same node (figure 6).

use super::entries::{cheapest, orders};
use super::forest::Forest;
use super::ground::Ground;
use super::moves::{Found, Move};
use crate::problem::{ItemId, NodeId};
use crate::solve::epsilon::EPSILON;

/// Near nodes of each node of a merged partition at which it is tried to hang.
const NEAR: usize = 4;

/// Moves of the partition of a contour; where it is hung up anew, the contour is its first or its last.
pub(super) fn look(g: &Ground, forest: &Forest, item: ItemId, found: &mut Found) {
    let route = forest.route_of(item);
    let Some(at) = forest.at(route) else { return };
    let items = forest.items(route);
    let count = items.len();
    let all = 0..count;
    let node = |k: usize| forest.entry(items[k % count]);
    let ring = |first: usize, at: NodeId| {
        // Broken before `first`.
        let inside = if count > 1 {
            g.leg(node(count - 1), node(0)) - g.leg(node(first + count - 1), node(first))
        } else {
            0.0
        };
        inside + g.leg(at, node(first)) + g.leg(node(first + count - 1), at) + g.charge(at)
    };
    let now = ring(0, at);
    let mut offer = |gain: f64, first: usize, to: NodeId, enter: Option<NodeId>| {
        found.priced += 1;
        if gain > EPSILON && forest.is_free(g, to) && !forest.hangs_from(g, g.item(to), route, &all) {
            found.moves.push((gain, Move::Reattach { route, first, node: to, enter }));
        }
    };
    if count == 1 {
        let entered = forest.entry(item);
        for enter in g.nodes(item).filter(|&n| forest.may_enter(n)) {
            let turned = g.extra(enter) - g.extra(entered);
            for &to in g.near(enter) {
                let cost = g.leg(to, enter) + g.leg(enter, to) + g.charge(to) + turned;
                offer(now - cost, 0, to, Some(enter));
            }
        }
        merges(g, forest, item, found);
        return;
    }
    let pos = forest.pos(item);
    for &to in g.near(forest.entry(item)) {
        for first in [pos, (pos + 1) % count] {
            offer(now - ring(first, to), first, to, None);
        }
    }
}

/// Children of a contour that are of one contour each.
fn single_children(g: &Ground, forest: &Forest, item: ItemId) -> Vec<ItemId> {
    let singles = |n| forest.child(n).filter(|&r| forest.items(r).len() == 1);
    g.nodes(item).filter_map(singles).map(|r| forest.items(r)[0]).collect()
}

/// Mergers of a partition of one contour with its child, and with its grandchild.
fn merges(g: &Ground, forest: &Forest, item: ItemId, found: &mut Found) {
    for child in single_children(g, forest, item) {
        merge(g, forest, &[item, child], found);
        for grandchild in single_children(g, forest, child) {
            merge(g, forest, &[item, child, grandchild], found);
        }
    }
}

/// The best merger of these, each the only contour of the child of the one before.
fn merge(g: &Ground, forest: &Forest, items: &[ItemId], found: &mut Found) {
    let route = forest.route_of(items[0]);
    let now: f64 = items.iter().map(|&i| forest.route_seconds(g, forest.route_of(i))).sum();
    // Nodes at which they hang from each other become free.
    let freed = |n: NodeId| items[1..].iter().any(|&i| forest.at(forest.route_of(i)) == Some(n));
    let layer =
        |i: ItemId| -> Vec<NodeId> { g.nodes(i).filter(|&n| forest.may_enter(n) || freed(n)).collect() };
    let orders: Vec<Vec<Vec<NodeId>>> =
        orders(items.len()).iter().map(|o| o.iter().map(|&k| layer(items[k])).collect()).collect();
    let mut places: Vec<NodeId> = items
        .iter()
        .flat_map(|&i| g.nodes(i))
        .flat_map(|n| g.near(n).iter().take(NEAR).copied())
        .filter(|&to| forest.is_free(g, to) && !forest.hangs_from(g, g.item(to), route, &(0..1)))
        .chain(forest.at(route))
        .collect();
    crate::order::sort_by(&mut places, |&n| [n.into(), 0, 0]);
    places.dedup();
    let mut best: Option<(f64, Vec<NodeId>, NodeId)> = None;
    for to in places {
        for layers in &orders {
            found.priced += layers.windows(2).map(|w| (w[0].len() * w[1].len()) as u64).sum::<u64>();
            let (cost, nodes) = cheapest(g, layers, (g.exit(to), Some(g.entry(to))));
            let gain = now - cost - g.charge(to);
            if gain > best.as_ref().map_or(EPSILON, |b| b.0) {
                best = Some((gain, nodes, to));
            }
        }
    }
    if let Some((gain, nodes, node)) = best {
        found.moves.push((gain, Move::Merge { route, nodes, node }));
    }
}
