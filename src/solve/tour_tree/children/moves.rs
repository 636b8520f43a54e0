//! Local search over routes from a queue of touched touches, until no move of theirs gains.
//!
//! For a touch, in this order: a better place on its item where it stands (for an anchor: where the route hangs); a chain
//! of up to 3 stops that starts or ends with it, or its whole route, put elsewhere: in any gap at a near item, in its
//! route or in one that hangs from it, or as a new route that hangs from it; reversing a stretch so that it meets a near
//! touch (2-opt). A route whose last stop goes elsewhere is gone, with its charge. Every move is priced in constant time;
//! whether ranks, precedence and nesting allow it is looked up only when it gains.

use super::super::queue::Queue;
use super::super::space::Space;
use super::super::travel::Gap;
use super::allowed::{in_order, may_shift};
use super::flip::flip;
use super::shift::{Ground, Shift, Spot};
use super::tree::{Tree, leaving};
use super::turn::turn;
use crate::solve::epsilon::EPSILON;

/// Longest chain moved, except for whole routes; kicks move longer ones.
const CHAIN: usize = 3;

/// Improves the routes around one touch until no move of its gains; gives the seconds gained.
pub(super) fn improve(g: Ground, tree: &mut Tree, queue: &mut Queue, touch: u32) -> f64 {
    let mut total = 0.0;
    while tree.is_live(touch) {
        let gain = reenter(g, tree, queue, touch)
            .or_else(|| relocate(g, tree, queue, touch))
            .or_else(|| turn(g, tree, queue, touch));
        match gain {
            Some(g) => total += g,
            None => break,
        }
    }
    total
}

/// A better place on its item where a touch stands.
pub(super) fn reenter(g: Ground, tree: &mut Tree, queue: &mut Queue, touch: u32) -> Option<f64> {
    let (item, now) = (tree.item(touch), tree.at(touch));
    if g.space.places(item).len() == 1 {
        return None;
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
    if tree.kids(item).len() > 1 && !in_order(g, tree, item) {
        tree.undo(g.space, mark);
        return None;
    }
    for t in [touch, before, after] {
        queue.push(t);
    }
    Some(seconds - best.1)
}

/// A chain at `touch` put elsewhere, a single stop at its best place there: the best of all candidates.
fn relocate(g: Ground, tree: &mut Tree, queue: &mut Queue, touch: u32) -> Option<f64> {
    if tree.is_anchor(touch) {
        return None;
    }
    let (mut most, mut best) = (EPSILON, None);
    let (mut ahead, mut behind) = (touch, touch);
    for length in 1..=CHAIN {
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
        if is_left(g.space, touch) {
            consider(g, tree, touch, host, host, &mut most, &mut best);
        }
    }
    let shift = best?;
    perform(g, tree, shift, |t| queue.push(t));
    Some(most)
}

/// Looks for the best spot for a chain that starts or ends with `touch`, or is the item that its route hangs from.
fn consider(
    g: Ground,
    tree: &mut Tree,
    touch: u32,
    first: u32,
    last: u32,
    most: &mut f64,
    best: &mut Option<Shift>,
) {
    if tree.is_anchor(first) || tree.is_anchor(last) {
        return;
    }
    let flips = first != touch && last != touch;
    let enter = if flips { touch } else { first };
    // A stop that is entered elsewhere costs what it does there; one that changes parts leaves an anchor where it was.
    let mut charges = if first == last { tree.extra(g.space, first) } else { 0.0 };
    if flips {
        charges += leaving(g.space, first) - leaving(g.space, touch);
    }
    let (freed, head) = (freed(g.space, tree, first, last) + charges, tree.head(first));
    let before = tree.previous(first);
    let shift = |to: u32| Shift { first, last, turned: false, spot: Spot::Behind(to), at: None, enter };
    if flips {
        let after = tree.next(first);
        let given = tree.edge(g.space, before, first) + tree.edge(g.space, first, after) + charges;
        put_in(g, tree, shift(before), tree.gap(before, after), given, most, best);
    }
    for (k, &b) in g.near.of_item(touch).iter().enumerate() {
        if freed <= *most {
            return;
        }
        if tree.closing.holds(head, last, b) {
            continue;
        }
        for c in 0..=tree.kids(b).len() {
            let c = *tree.kids(b).get(c).unwrap_or(&b);
            for to in [c, tree.previous(c)] {
                if to == before || (!tree.is_anchor(to) && tree.closing.holds(head, last, to)) {
                    continue;
                }
                tree.priced += 1;
                let (gap, given) =
                    (tree.gap(to, tree.next(to)), freed + tree.edge(g.space, to, tree.next(to)));
                put_in(g, tree, shift(to), gap, given, most, best);
            }
        }
        if !is_left(g.space, b) {
            continue;
        }
        tree.priced += 1;
        let (at, place, seconds) = if first == last && !g.space.two_ends(enter) {
            let bridge = g.bridges.of(touch, k);
            (Some(bridge.from), bridge.to, bridge.seconds)
        } else {
            let around = Gap { from: tree.exit(last), to: Some(tree.entry(first)) };
            let (place, seconds) = g.space.best_entry(b, around, freed - leaving(g.space, b) - *most);
            (None, place, seconds)
        };
        let shift = Shift { spot: Spot::Child(b, place), at, ..shift(b) };
        let gain = freed - seconds - leaving(g.space, b);
        if gain > *most && may_shift(g, tree, shift) {
            *most = gain;
            *best = Some(shift);
        }
    }
}

/// Looks at a chain in a gap, either way round; a single stop at its best place.
fn put_in(
    g: Ground,
    tree: &mut Tree,
    shift: Shift,
    gap: Gap,
    given: f64,
    most: &mut f64,
    best: &mut Option<Shift>,
) {
    let Shift { first, last, enter, .. } = shift;
    if first == last {
        let on = gap.to.map_or(0.0, |q| g.space.at_least(q, enter, true));
        if given - g.space.at_least(gap.from, enter, false) - on <= *most {
            return;
        }
        let (at, seconds) = g.space.best_entry(enter, gap, given - *most);
        let shift = Shift { at: Some(at), ..shift };
        if given - seconds > *most && may_shift(g, tree, shift) {
            *most = given - seconds;
            *best = Some(shift);
        }
        return;
    }
    for turned in [false, true] {
        let ends = (tree.entry(first), tree.exit(last));
        let (enter, leave) = if turned { (ends.1, ends.0) } else { ends };
        let on = gap.to.map_or(0.0, |to| g.space.travel.seconds(leave, to));
        let over = if turned { tree.turning(g.space, first, last) } else { 0.0 };
        let gain = given - g.space.travel.seconds(gap.from, enter) - on - over;
        let shift = Shift { turned, ..shift };
        if gain > *most && may_shift(g, tree, shift) {
            *most = gain;
            *best = Some(shift);
        }
    }
}

/// Seconds won by taking a chain out; with a whole route its charge.
pub(super) fn freed(space: &Space, tree: &Tree, first: u32, last: u32) -> f64 {
    let (before, after) = (tree.previous(first), tree.next(last));
    let ways = tree.edge(space, before, first) + tree.edge(space, last, after);
    let left = if before == after { -tree.price(space, before) } else { tree.edge(space, before, after) };
    ways - left
}

/// Whether an item may be left unfinished.
pub(super) fn is_left(space: &Space, item: u32) -> bool {
    space.problem.items.get(item as usize).is_some_and(|i| i.leave.is_some())
}

/// Puts a chain elsewhere, and tells which touches that concerns.
pub(super) fn perform(g: Ground, tree: &mut Tree, shift: Shift, mut touched: impl FnMut(u32)) {
    let Shift { mut first, mut last, turned, spot, at, enter } = shift;
    touched(tree.previous(first));
    touched(tree.next(last));
    if enter != first {
        for t in [tree.previous(enter), tree.next(enter), first] {
            touched(t);
        }
        flip(g.space, tree, enter, at.unwrap_or(0));
        (first, last) = (enter, enter);
    }
    if turned {
        tree.turn(g.space, first, last);
        (first, last) = (last, first);
    }
    let to = match spot {
        Spot::Behind(to) => to,
        Spot::Child(host, place) => {
            touched(host);
            tree.open(g.space, host, place)
        }
    };
    for t in [first, last, to, tree.next(to)] {
        touched(t);
    }
    if to != tree.previous(first) {
        tree.shift(first, last, to);
    }
    if let Some(at) = at.filter(|_| enter == shift.first) {
        tree.place(g.space, first, at);
    }
}
