//! The second set of repartitioning moves. A sub-sequence of a partition becomes a partition of its own, or moves to
//! another partition or to another gap of its own (figure 7). As in the paper it is never reversed. A single contour may be
//! entered elsewhere, unless that is switched off ([`Reattach::AsItIs`]).

use super::forest::{Forest, ROOT};
use super::graph::Graph;
use super::moves::{GainfulMoves, Reattach, TreeMove};
use crate::problem::{ItemId, NodeId};
use crate::solve::epsilon::EPSILON;
use glam::DVec2;
use std::ops::Range;

/// Largest number of contours in a sub-sequence. Longer ones save next to nothing on large sheets, and the work grows with
/// their length.
const LONGEST: usize = 50;

/// Contours of a route that may move, and the seconds saved by removing them.
struct Piece {
    route: u32,
    places: Range<usize>,
    /// The nodes where the first and the last contour are entered.
    ends: [NodeId; 2],
    /// The new entry of a single contour, if it changes.
    enter: Option<NodeId>,
    saved: f64,
}

/// Finds moves of the sub-sequences that begin or end with a contour.
pub(super) fn look(g: &Graph, forest: &Forest, item: ItemId, found: &mut GainfulMoves) {
    let (route, pos) = (forest.route_of(item), forest.pos(item));
    let count = forest.items(route).len();
    let longest = g.at_most(LONGEST);
    for end in pos + 1..=count.min(pos.saturating_add(longest)) {
        offer(g, forest, &piece(g, forest, route, pos..end), forest.entry(item), found);
    }
    for first in (pos + 1).saturating_sub(longest)..pos {
        offer(g, forest, &piece(g, forest, route, first..pos + 1), forest.entry(item), found);
    }
    if found.reattach == Reattach::AsItIs {
        return;
    }
    let entered = forest.entry(item);
    let here = piece(g, forest, route, pos..pos + 1);
    for enter in g.nodes(item).filter(|&n| n != entered && forest.may_enter(g, n)) {
        let saved = here.saved + g.extra(entered) - forest.extra(g, enter);
        let turned =
            Piece { places: here.places.clone(), ends: [enter; 2], enter: Some(enter), saved, ..here };
        offer(g, forest, &turned, enter, found);
    }
}

fn piece(g: &Graph, forest: &Forest, route: u32, places: Range<usize>) -> Piece {
    let node = |k: usize| forest.entry(forest.items(route)[k]);
    let ends = [node(places.start), node(places.end - 1)];
    let (from, to) = (forest.before(g, route, places.start), forest.after(g, route, places.end));
    let whole = places.len() == forest.items(route).len();
    // An empty partition is gone: no air move takes its place.
    let left = |to: DVec2| if whole { 0.0 } else { g.air(from, to) };
    let on = to.map_or(0.0, |to| g.air(g.exit(ends[1]), to) - left(to));
    let mut saved = g.air(from, g.entry(ends[0])) + on;
    if whole {
        saved += forest.leaving(g, route);
    }
    Piece { route, places, ends, enter: None, saved }
}

/// Finds moves of a sub-sequence to the near nodes of one of its ends.
fn offer(g: &Graph, forest: &Forest, piece: &Piece, end: NodeId, found: &mut GainfulMoves) {
    let [first, last] = piece.ends;
    let whole = piece.places.len() == forest.items(piece.route).len();
    for &near in g.near(end) {
        let t = g.item(near);
        let hangs = || forest.hangs_from(g, t, piece.route, &piece.places);
        // As a partition of its own. Whole partitions are moved by the first set.
        found.priced += 1;
        let cost = forest.hook(g, near).around(g, first, last);
        if piece.saved - cost > EPSILON && !whole && forest.is_free(g, near) && !hangs() {
            let (route, places, enter) = (piece.route, piece.places.clone(), piece.enter);
            found.moves.push((piece.saved - cost, TreeMove::Own { route, places, node: near, enter }));
        }
        let (to, at) = (forest.route_of(t), forest.pos(t));
        for pos in [at, at + 1] {
            let own = to == piece.route && (piece.places.start..=piece.places.end).contains(&pos);
            if own {
                // In its own gap only the entry of a contour could change, and the entries of a route are chosen together.
                continue;
            }
            found.priced += 1;
            let (from, next) = (forest.before(g, to, pos), forest.after(g, to, pos));
            let on = next.map_or(0.0, |next| g.air(g.exit(last), next) - g.air(from, next));
            let gain = piece.saved - g.air(from, g.entry(first)) - on;
            if gain > EPSILON && !(whole && piece.route == ROOT) && !hangs() {
                let (route, places, enter) = (piece.route, piece.places.clone(), piece.enter);
                found.moves.push((gain, TreeMove::Into { route, places, to, pos, enter }));
            }
        }
    }
}
