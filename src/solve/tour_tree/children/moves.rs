//! Local search over routes with a work queue: a move puts the touches it changed back on the queue.
//!
//! For a touch these moves are tried in this order: a better place on its item (for an anchor: where the route hangs); a
//! chain of up to three stops that starts or ends with it, or its whole route, put elsewhere, that is in a gap at a near
//! item, in that item's route or in one that hangs from it, or as a new route that hangs from it; a stretch reversed so that
//! it meets a near touch (2-opt). A route that loses its last stop is closed, and its charge is saved. A move is priced in
//! constant time; whether ranks, precedence and nesting allow it is looked up only if it gains.

use super::super::config::CONFIG;
use super::super::queue::Queue;
use super::super::space::Space;
use super::super::travel::Gap;
use super::allowed::{keeps_order, may_move};
use super::chain_move::{ChainMove, Context, Target};
use super::groups::{better_place, other_path};
use super::swap_with_host::swap_with_host;
use super::tree::{Tree, leaving};
use super::two_opt::two_opt;
use crate::solve::epsilon::EPSILON;

/// Improves the routes around one touch until no move of the touch gains. Returns the seconds gained.
pub(super) fn improve(g: Context, tree: &mut Tree, queue: &mut Queue, touch: u32) -> f64 {
    let mut total = 0.0;
    while tree.is_live(touch) {
        let before = cfg!(debug_assertions).then(|| tree.cost(g.space));
        let gain = improve_entry(g, tree, queue, touch)
            .or_else(|| relocate(g, tree, queue, touch))
            .or_else(|| two_opt(g, tree, queue, touch));
        let Some(gain) = gain else { break };
        debug_assert!(
            before.is_some_and(|before| (before - tree.cost(g.space) - gain).abs() <= EPSILON * before.max(1.0)),
            "a move of touch {touch} does not gain {gain}"
        );
        total += gain;
    }
    total
}

/// Moves a touch to its best place between its neighbours; returns the seconds gained.
pub(super) fn improve_entry(g: Context, tree: &mut Tree, queue: &mut Queue, touch: u32) -> Option<f64> {
    let (item, now) = (tree.item(touch), tree.at(touch));
    if g.space.places(item).len() == 1 {
        return None;
    }
    if tree.keeps_path(g.space, item) {
        return if tree.is_anchor(touch) {
            better_place(g, tree, queue, touch)
        } else {
            other_path(g, tree, queue, touch)
        };
    }
    let (before, after) = (tree.previous(touch), tree.next(touch));
    let gap = tree.gap(before, after);
    tree.priced += 1;
    let seconds = g.space.through(item, now, gap);
    let near = g.space.better_near(item, (now, seconds), gap);
    let best = g.space.best_entry(item, gap, near.1);
    let best = if best.1 < near.1 { best } else { near };
    if best.1 >= seconds - EPSILON {
        return None;
    }
    let mark = tree.changes();
    tree.place(g.space, touch, best.0);
    if tree.anchors(item).len() > 1 && !keeps_order(g, tree, item) {
        tree.undo(g.space, mark);
        return None;
    }
    for t in [touch, before, after] {
        queue.push(t);
    }
    Some(seconds - best.1)
}

/// Puts a chain at `touch` elsewhere, the best of all candidates; a single stop gets its best entry there.
fn relocate(g: Context, tree: &mut Tree, queue: &mut Queue, touch: u32) -> Option<f64> {
    if tree.is_anchor(touch) {
        return None;
    }
    let (mut most, mut best) = (EPSILON, None);
    let (mut ahead, mut behind) = (touch, touch);
    for length in 1..=CONFIG.children.longest_chain {
        consider(g, tree, touch, touch, ahead, &mut most, &mut best);
        if length > 1 {
            consider(g, tree, touch, behind, touch, &mut most, &mut best);
        }
        ahead = if tree.is_anchor(ahead) { ahead } else { tree.next(ahead) };
        behind = if tree.is_anchor(behind) { behind } else { tree.previous(behind) };
    }
    let route = tree.route(touch);
    let (first, last) = (tree.next(route), tree.previous(route));
    let long = !tree.is_anchor(ahead) || !tree.is_anchor(behind);
    if route != g.space.home {
        if long && (first == touch || last == touch) {
            consider(g, tree, touch, first, last, &mut most, &mut best);
        }
        let host = tree.item(route);
        let swap = |i: u32| may_be_left(g.space, i) && !g.space.leave_places.is_group(i);
        if swap(touch) && swap(host) {
            consider(g, tree, touch, host, host, &mut most, &mut best);
        }
    }
    let best = best?;
    apply(g, tree, best, |t| queue.push(t));
    Some(most)
}

/// Looks for the best target of a chain that starts or ends with `touch`, or of the host of its route.
fn consider(
    g: Context,
    tree: &mut Tree,
    touch: u32,
    first: u32,
    last: u32,
    most: &mut f64,
    best: &mut Option<ChainMove>,
) {
    if tree.is_anchor(first) || tree.is_anchor(last) {
        return;
    }
    let swaps = first != touch && last != touch;
    let enter = if swaps { touch } else { first };
    // A single stop saves its extra seconds, because it is priced at its new entry. A stop that changes places with its
    // host leaves an anchor where it was.
    let single = first == last && !tree.keeps_path(g.space, first);
    let mut charges = if single { tree.extra(g.space, first) } else { 0.0 };
    if swaps {
        charges += leaving(g.space, first) - leaving(g.space, touch);
    }
    let (freed, head) = (freed(g.space, tree, first, last) + charges, tree.head(first));
    let before = tree.previous(first);
    let move_after =
        |to: u32| ChainMove { first, last, reversed: false, target: Target::After(to), at: None, enter };
    if swaps {
        let after = tree.next(first);
        let given = tree.edge(g.space, before, first) + tree.edge(g.space, first, after) + charges;
        consider_gap(g, tree, move_after(before), tree.gap(before, after), given, most, best);
    }
    for (k, &b) in g.near.of_item(touch).iter().enumerate() {
        if freed <= *most {
            return;
        }
        if tree.finish_order.holds(head, last, b) {
            continue;
        }
        for c in 0..=tree.anchors(b).len() {
            let c = *tree.anchors(b).get(c).unwrap_or(&b);
            for to in [c, tree.previous(c)] {
                if to == before || (!tree.is_anchor(to) && tree.finish_order.holds(head, last, to)) {
                    continue;
                }
                tree.priced += 1;
                let (gap, given) =
                    (tree.gap(to, tree.next(to)), freed + tree.edge(g.space, to, tree.next(to)));
                consider_gap(g, tree, move_after(to), gap, given, most, best);
            }
        }
        if !may_be_left(g.space, b) {
            continue;
        }
        tree.priced += 1;
        let (at, place, seconds) = if g.space.leave_places.is_group(b) {
            let Some((place, at, seconds)) = tree.hang_on(g.space, b, (first, last, enter)) else { continue };
            (at, place, seconds)
        } else if first == last && !g.space.leaves_elsewhere(enter) {
            let bridge = g.bridges.of(touch, k);
            (Some(bridge.from), bridge.to, bridge.seconds)
        } else {
            let around = Gap { from: tree.exit(last), to: Some(tree.entry(first)) };
            let (place, seconds) = g.space.best_entry(b, around, freed - leaving(g.space, b) - *most);
            (None, place, seconds)
        };
        // A single stop that is left elsewhere than it is entered keeps its place.
        let kept = if single && at.is_none() { tree.extra(g.space, first) } else { 0.0 };
        let m = ChainMove { target: Target::Child(b, place), at, ..move_after(b) };
        let gain = freed - seconds - kept - leaving(g.space, b);
        if gain > *most && may_move(g, tree, m) {
            *most = gain;
            *best = Some(m);
        }
    }
}

/// Prices a chain in a gap in both directions; a single stop gets its best entry.
fn consider_gap(
    g: Context,
    tree: &mut Tree,
    m: ChainMove,
    gap: Gap,
    given: f64,
    most: &mut f64,
    best: &mut Option<ChainMove>,
) {
    let ChainMove { first, last, enter, .. } = m;
    if first == last && !tree.keeps_path(g.space, first) {
        let on = gap.to.map_or(0.0, |q| g.space.at_least(q, enter, true));
        if given - g.space.at_least(gap.from, enter, false) - on <= *most {
            return;
        }
        let (at, seconds) = g.space.best_entry(enter, gap, given - *most);
        let m = ChainMove { at: Some(at), ..m };
        if given - seconds > *most && may_move(g, tree, m) {
            *most = given - seconds;
            *best = Some(m);
        }
        return;
    }
    for reversed in [false, true] {
        let (enter, leave) = tree.ends(g.space, (first, last), reversed);
        let on = gap.to.map_or(0.0, |to| g.space.travel.seconds(leave, to));
        let over = if reversed { tree.reversal_cost(g.space, first, last) } else { 0.0 };
        let gain = given - g.space.travel.seconds(gap.from, enter) - on - over;
        let m = ChainMove { reversed, ..m };
        if gain > *most && may_move(g, tree, m) {
            *most = gain;
            *best = Some(m);
        }
    }
}

/// Seconds saved by taking a chain out; for a whole route its charge too.
pub(super) fn freed(space: &Space, tree: &Tree, first: u32, last: u32) -> f64 {
    let (before, after) = (tree.previous(first), tree.next(last));
    let ways = tree.edge(space, before, first) + tree.edge(space, last, after);
    let left = if before == after { -tree.price(space, before) } else { tree.edge(space, before, after) };
    ways - left
}

/// Whether an item may be left unfinished.
pub(super) fn may_be_left(space: &Space, item: u32) -> bool {
    space.problem.items.get(item as usize).is_some_and(|i| i.leave.is_some())
        || space.leave_places.may_leave(item)
}

/// Makes a chain move and calls `touched` with each touch around which the routes have changed.
pub(super) fn apply(g: Context, tree: &mut Tree, m: ChainMove, mut touched: impl FnMut(u32)) {
    let ChainMove { mut first, mut last, reversed, target, at, enter } = m;
    touched(tree.previous(first));
    touched(tree.next(last));
    if enter != first {
        for t in [tree.previous(enter), tree.next(enter), first] {
            touched(t);
        }
        swap_with_host(g.space, tree, enter, at.unwrap_or(0));
        (first, last) = (enter, enter);
    }
    if reversed {
        tree.reverse_stretch(g.space, first, last);
        (first, last) = (last, first);
    }
    let to = match target {
        Target::After(to) => to,
        Target::Child(host, place) => {
            touched(host);
            tree.open(g.space, host, place)
        }
    };
    for t in [first, last, to, tree.next(to)] {
        touched(t);
    }
    if to != tree.previous(first) {
        tree.move_chain(first, last, to);
    }
    if let Some(at) = at.filter(|_| enter == m.first) {
        tree.place(g.space, first, at);
    }
}
