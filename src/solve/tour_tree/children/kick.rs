//! Kicks: a chain of stops taken somewhere else, further along its route or to something near, the local search after
//! it, and the decision whether that stays.

use super::super::index::index;
use super::super::neighbours::Neighbours;
use super::super::space::Space;
use super::super::travel::Gap;
use super::allowed::{in_order, may_shift};
use super::moves::{freed, improve, is_left, perform, reenter};
use super::shift::Ground;
use super::shift::Shift;
use super::shift::Spot;
use super::tree::leaving;
use super::{Children, Tree};
use crate::solve::rng::{Draw, Rng};

/// Longest chain taken, and farthest it goes along its route: most are short, as in `exchange.rs`.
const LONGEST: usize = 50;
/// One kick in this many joins routes.
const JOIN: usize = 8;
/// Most routes joined on the way up from a stop.
const DEEPEST: usize = 4;
/// One kick in this many also draws a place for a stop.
const DRAW_PLACE: usize = 4;

impl Children {
    /// One kick; journal and queue are empty before and after.
    pub(super) fn kick(&mut self, space: &Space, near: &Neighbours, heat: f64) {
        // Drawing a kick costs too, also one that is not allowed.
        self.tree.priced += 1;
        let g = Ground { space, near, bridges: &self.bridges };
        let mut touched = Vec::with_capacity(16);
        let first = index(self.rng.below(space.home as usize));
        // Not of the tour: it is cut with its pierce group.
        if !self.tree.is_live(first) {
            return;
        }
        let mut change = 0.0;
        if self.rng.below(JOIN) == 0 {
            let list = near.of_item(first);
            let other = *list.get(self.rng.below(list.len().max(1))).unwrap_or(&first);
            for stop in [first, other] {
                change -= join(g, &mut self.tree, stop, &mut touched);
            }
        } else {
            let Some(shift) = draw(&mut self.rng, &self.tree, g, first) else { return };
            if !may_shift(g, &mut self.tree, shift) {
                return;
            }
            change -= gain(space, &self.tree, shift);
            perform(g, &mut self.tree, shift, |t| touched.push(t));
        }
        if self.rng.below(DRAW_PLACE) == 0 {
            let place = index(self.rng.below(space.places(first).len()));
            change += place_at(g, &mut self.tree, first, place).unwrap_or(0.0);
        }
        // Places first, as in `exchange.rs`; the first of the chain last.
        for &t in touched.iter().filter(|&&t| t != first).chain([&first]) {
            if self.tree.is_live(t) {
                change -= reenter(g, &mut self.tree, &mut self.queue, t).unwrap_or(0.0);
            }
            self.queue.push(t);
        }
        while let Some(touch) = self.queue.pop() {
            change -= improve(g, &mut self.tree, &mut self.queue, touch);
        }
        if !self.rng.accepts(change, heat) {
            self.tree.undo(space, 0);
            return;
        }
        if change > 0.0 {
            self.save_before(space);
        }
        self.cost += change;
        self.tree.commit();
        self.check(space);
        self.keep_least(space);
    }
}

/// Takes the routes that lead to a stop, one after the other, into those they hang from, behind what they hang from; gives
/// the seconds gained. Rings come of that where two such paths meet, which no single chain finds: every step on the way
/// costs more than it gains.
fn join(g: Ground, tree: &mut Tree, stop: u32, touched: &mut Vec<u32>) -> f64 {
    let mut gained = 0.0;
    for _ in 0..DEEPEST {
        let anchor = tree.route(stop);
        if anchor == g.space.home || stop == g.space.home {
            break;
        }
        let (first, last) = (tree.next(anchor), tree.previous(anchor));
        let spot = Spot::Behind(tree.item(anchor));
        let shift = Shift { first, last, turned: false, spot, at: None, enter: first };
        if !may_shift(g, tree, shift) {
            break;
        }
        gained += gain(g.space, tree, shift);
        perform(g, tree, shift, |t| touched.push(t));
    }
    gained
}

/// A chain and somewhere to put it.
fn draw(rng: &mut Rng, tree: &Tree, g: Ground, first: u32) -> Option<Shift> {
    let space = g.space;
    let ahead = |from: u32, steps: usize, stop: u32| {
        let on = |&t: &u32| Some(tree.next(t)).filter(|&n| n != stop);
        std::iter::successors(Some(from), on).take(steps + 1).last().unwrap_or(from)
    };
    let last = ahead(first, rng.log_uniform(LONGEST) - 1, tree.route(first));
    let turned = rng.below(2) == 0;
    let shift = |spot| Some(Shift { first, last, turned, spot, at: None, enter: first });
    let way = rng.below(4);
    if way < 2 {
        let to = ahead(last, rng.log_uniform(LONGEST), tree.previous(first));
        return if to == last { None } else { shift(Spot::Behind(to)) };
    }
    let list = g.near.of_item(first);
    let other = *list.get(rng.below(list.len().max(1)))?;
    if other != space.home && tree.closing.holds(tree.head(first), last, other) {
        return None;
    }
    if way == 2 {
        let anchors = tree.kids(other);
        let touch = *anchors.get(rng.below(anchors.len() + 1)).unwrap_or(&other);
        let to = if rng.below(2) == 0 { touch } else { tree.previous(touch) };
        let outside = tree.is_anchor(to) || !tree.closing.holds(tree.head(first), last, to);
        return if outside && to != tree.previous(first) { shift(Spot::Behind(to)) } else { None };
    }
    if !is_left(space, other) {
        return None;
    }
    let place =
        space.best_entry(other, Gap { from: tree.exit(last), to: Some(tree.entry(first)) }, f64::INFINITY).0;
    shift(Spot::Child(other, place))
}

/// Seconds a shift gains.
fn gain(space: &Space, tree: &Tree, shift: Shift) -> f64 {
    let Shift { first, last, turned, spot, .. } = shift;
    let (mut enter, mut leave) = (tree.entry(first), tree.exit(last));
    if turned {
        (enter, leave) = (leave, enter);
    }
    let over = if turned { tree.turning(space, first, last) } else { 0.0 };
    let given = freed(space, tree, first, last) - over;
    match spot {
        Spot::Behind(to) => {
            let next = tree.next(to);
            given + tree.edge(space, to, next)
                - space.travel.seconds(tree.exit(to), enter)
                - tree.way(space, leave, next, tree.entry(next))
        }
        Spot::Child(host, at) => {
            let place = space.places(host).at(at);
            given
                - leaving(space, host)
                - space.extra(host, at)
                - space.travel.seconds(place, enter)
                - space.travel.seconds(leave, place)
        }
    }
}

/// Enters a stop elsewhere, if that is allowed; gives the seconds it costs.
fn place_at(g: Ground, tree: &mut Tree, stop: u32, at: u32) -> Option<f64> {
    let ways = |tree: &Tree| {
        let (before, after) = (tree.previous(stop), tree.next(stop));
        tree.edge(g.space, before, stop) + tree.edge(g.space, stop, after) + tree.extra(g.space, stop)
    };
    let (mark, before) = (tree.changes(), ways(tree));
    tree.place(g.space, stop, at);
    if tree.kids(stop).len() > 1 && !in_order(g, tree, stop) {
        tree.undo(g.space, mark);
        return None;
    }
    Some(ways(tree) - before)
}
