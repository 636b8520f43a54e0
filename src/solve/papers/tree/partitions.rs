//! The first set of repartitioning moves. A partition is attached elsewhere. A partition of one contour is merged with a
//! child of one contour (and a child of that one), and attached elsewhere or at the same node (figure 6).

use super::entries::{cheapest, orders};
use super::forest::Forest;
use super::graph::Graph;
use super::moves::{GainfulMoves, Reattach, TreeMove};
use crate::problem::{ItemId, NodeId};
use crate::solve::epsilon::EPSILON;

/// Number of near nodes of each node of a merged partition that are tried as its parent.
const NEAR: usize = 4;

/// Moves of the partition of a contour. Where the partition is attached elsewhere, the contour becomes its first or its
/// last; with [`Reattach::AsItIs`] it has to be that already, and keeps its entry.
pub(super) fn look(g: &Graph, forest: &Forest, item: ItemId, found: &mut GainfulMoves) {
    let route = forest.route_of(item);
    let Some(at) = forest.at(route) else { return };
    let items = forest.items(route);
    let count = items.len();
    let all = 0..count;
    let node = |k: usize| forest.entry(items[k % count]);
    let ring = |first: usize, at: NodeId| {
        // The ring is opened before `first`.
        let inside = if count > 1 {
            g.leg(node(count - 1), node(0)) - g.leg(node(first + count - 1), node(first))
        } else {
            0.0
        };
        inside + forest.hook(g, at).around(g, node(first), node(first + count - 1))
    };
    let now = ring(0, at);
    let as_it_is = found.reattach == Reattach::AsItIs;
    let mut offer = |gain: f64, first: usize, to: NodeId, enter: Option<NodeId>| {
        found.priced += 1;
        if gain > EPSILON && forest.is_free(g, to) && !forest.hangs_from(g, g.item(to), route, &all) {
            found.moves.push((gain, TreeMove::Reattach { route, first, node: to, enter }));
        }
    };
    if count == 1 {
        let entered = forest.entry(item);
        for enter in g.nodes(item).filter(|&n| forest.may_enter(g, n) && (!as_it_is || n == entered)) {
            let turned = forest.extra(g, enter) - g.extra(entered);
            for &to in g.near(enter) {
                let cost = forest.hook(g, to).around(g, enter, enter) + turned;
                offer(now - cost, 0, to, Some(enter));
            }
        }
        merges(g, forest, item, found);
        return;
    }
    let pos = forest.pos(item);
    let firsts = [pos, (pos + 1) % count];
    for &to in g.near(forest.entry(item)) {
        for first in firsts.into_iter().filter(|&first| !as_it_is || first == 0) {
            offer(now - ring(first, to), first, to, None);
        }
    }
}

/// Children of a contour that consist of one contour each.
fn single_children(g: &Graph, forest: &Forest, item: ItemId) -> Vec<ItemId> {
    let singles = |n| forest.child(n).filter(|&r| forest.items(r).len() == 1);
    g.parent_nodes(item).filter_map(singles).map(|r| forest.items(r)[0]).collect()
}

/// Finds mergers of a partition of one contour with its child, and with its grandchild.
fn merges(g: &Graph, forest: &Forest, item: ItemId, found: &mut GainfulMoves) {
    for child in single_children(g, forest, item) {
        merge(g, forest, &[item, child], found);
        for grandchild in single_children(g, forest, child) {
            merge(g, forest, &[item, child, grandchild], found);
        }
    }
}

/// Finds the best merger of these contours, each the only one of a child of the one before.
fn merge(g: &Graph, forest: &Forest, items: &[ItemId], found: &mut GainfulMoves) {
    let route = forest.route_of(items[0]);
    let now: f64 = items.iter().map(|&i| forest.route_seconds(g, forest.route_of(i))).sum();
    // Nodes to which they are attached become free.
    let freed = |n: NodeId| items[1..].iter().any(|&i| forest.at(forest.route_of(i)) == Some(n));
    let layer = |i: ItemId| -> Vec<NodeId> {
        // A group that keeps other partitions keeps its path; otherwise all of its paths are possible again.
        let merged =
            items[1..].iter().filter(|&&c| forest.at(forest.route_of(c)).is_some_and(|n| g.item(n) == i));
        if g.is_group(i) && forest.children(i) as usize != merged.count() {
            return vec![forest.entry(i)];
        }
        g.nodes(i).filter(|&n| forest.child(n).is_none() || freed(n)).collect()
    };
    let orders: Vec<Vec<Vec<NodeId>>> =
        orders(items.len()).iter().map(|o| o.iter().map(|&k| layer(items[k])).collect()).collect();
    let mut places: Vec<NodeId> = items
        .iter()
        .flat_map(|&i| g.nodes(i))
        .flat_map(|n| g.near(n).iter().take(g.at_most(NEAR)).copied())
        .filter(|&to| forest.is_free(g, to) && !forest.hangs_from(g, g.item(to), route, &(0..1)))
        .chain(forest.at(route))
        .collect();
    crate::order::sort_by(&mut places, |&n| [n.into(), 0, 0]);
    places.dedup();
    let mut best: Option<(f64, Vec<NodeId>, NodeId)> = None;
    for to in places {
        for layers in &orders {
            found.priced += layers.windows(2).map(|w| (w[0].len() * w[1].len()) as u64).sum::<u64>();
            let hook = forest.hook(g, to);
            let (cost, nodes) = cheapest(g, layers, (hook.out, Some(hook.back)), |n| g.extra(n));
            let gain = now - cost - hook.seconds;
            if gain > best.as_ref().map_or(EPSILON, |b| b.0) {
                best = Some((gain, nodes, to));
            }
        }
    }
    if let Some((gain, nodes, node)) = best {
        found.moves.push((gain, TreeMove::Merge { route, nodes, node }));
    }
}
