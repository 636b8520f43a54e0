//! Chooses the best node of every contour of a route for a fixed order, by dynamic programming.

use super::forest::Forest;
use super::graph::Graph;
use super::visits::keeps_precedence;
use crate::problem::{ItemId, NodeId};
use crate::solve::epsilon::EPSILON;
use glam::DVec2;

/// Largest number of contours that are tried in every order.
pub(super) const MOST_ORDERED: usize = 3;

/// Every order of up to [`MOST_ORDERED`] contours; none for more.
pub(super) fn orders(contours: usize) -> &'static [&'static [usize]] {
    match contours {
        1 => &[&[0]],
        2 => &[&[0, 1], &[1, 0]],
        3 => &[&[0, 1, 2], &[0, 2, 1], &[1, 0, 2], &[1, 2, 0], &[2, 0, 1], &[2, 1, 0]],
        _ => &[],
    }
}

/// The cheapest nodes for layers that are visited in order between two points, and their cost. `extra` gives the seconds of
/// each node besides air moves.
pub(super) fn cheapest(
    g: &Graph,
    layers: &[Vec<NodeId>],
    (from, to): (DVec2, Option<DVec2>),
    extra: impl Fn(NodeId) -> f64,
) -> (f64, Vec<NodeId>) {
    // Least seconds to each node of the last layer, and the node of the layer before.
    let mut costs: Vec<f64> = Vec::new();
    let mut came: Vec<Vec<usize>> = Vec::with_capacity(layers.len());
    for (k, layer) in layers.iter().enumerate() {
        let mut next = Vec::with_capacity(layer.len());
        let mut back = Vec::with_capacity(layer.len());
        for &node in layer {
            let best = match k.checked_sub(1).map(|k| &layers[k]) {
                None => (g.air(from, g.entry(node)), 0),
                Some(before) => before
                    .iter()
                    .zip(&costs)
                    .map(|(&b, c)| c + g.leg(b, node))
                    .zip(0..)
                    .fold((f64::INFINITY, 0), |best, this| if this.0 < best.0 { this } else { best }),
            };
            next.push(best.0 + extra(node));
            back.push(best.1);
        }
        costs = next;
        came.push(back);
    }
    let Some(last) = layers.last() else { return (to.map_or(0.0, |to| g.air(from, to)), Vec::new()) };
    let ends = last.iter().zip(&costs).map(|(&n, c)| c + to.map_or(0.0, |to| g.air(g.exit(n), to)));
    let (cost, mut at) =
        ends.zip(0..).fold((f64::INFINITY, 0), |best, this| if this.0 < best.0 { this } else { best });
    let mut nodes = Vec::with_capacity(layers.len());
    for (layer, back) in layers.iter().zip(&came).rev() {
        nodes.push(layer[at]);
        at = back[at];
    }
    nodes.reverse();
    (cost, nodes)
}

/// Chooses the entries of a route, or those of the contours in `only`. If `keep` is set, only precedence-keeping ones: where several partitions are attached to
/// a contour, another entry changes the order in which they are cut. Returns whether seconds were saved, and the work in
/// moves.
pub(super) fn improve(
    g: &Graph,
    forest: &mut Forest,
    route: u32,
    keep: bool,
    only: Option<&[ItemId]>,
) -> (bool, u64) {
    let stays = |item: ItemId| only.is_some_and(|only| !only.contains(&item));
    let mut work = 1;
    // First all entries may change; if that violates precedence, contours with several partitions keep theirs.
    for frozen in [false, true].into_iter().take(1 + usize::from(keep)) {
        let layers: Vec<Vec<NodeId>> = forest
            .items(route)
            .iter()
            .map(|&i| match stays(i) || frozen && forest.children(i) > 1 {
                true => vec![forest.entry(i)],
                false => g.nodes(i).filter(|&n| forest.may_enter(g, n)).collect(),
            })
            .collect();
        work += layers.windows(2).map(|w| (w[0].len() * w[1].len()) as u64).sum::<u64>();
        let (cost, nodes) = cheapest(g, &layers, forest.ends(g, route), |n| forest.extra(g, n));
        let now = forest.route_seconds(g, route) - forest.leaving(g, route);
        if cost >= now - EPSILON {
            return (false, work);
        }
        let items = forest.items(route).to_vec();
        let old: Vec<NodeId> = items.iter().map(|&i| forest.entry(i)).collect();
        items.iter().zip(&nodes).for_each(|(&i, &n)| forest.enter(i, n));
        if !keep || keeps_precedence(g, forest) {
            return (true, work);
        }
        items.iter().zip(&old).for_each(|(&i, &n)| forest.enter(i, n));
    }
    (false, work)
}
