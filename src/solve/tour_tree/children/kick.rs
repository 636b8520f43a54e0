//! One kick over routes: a chain of stops goes elsewhere, or routes are joined; then local search, and the decision whether
//! the result stays.

use super::super::config::CONFIG;
use super::super::index::index;
use super::super::neighbours::Neighbours;
use super::super::space::Space;
use super::super::travel::Gap;
use super::allowed::{keeps_order, may_move};
use super::chain_move::ChainMove;
use super::chain_move::Context;
use super::chain_move::Target;
use super::moves::{apply, freed, improve, improve_entry, may_be_left};
use super::tree::leaving;
use super::{ChildRoutes, Tree};
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::{Draw, Rng};

impl ChildRoutes {
    /// One kick. The journal and the queue are empty before and after it.
    pub(super) fn kick(&mut self, space: &Space, near: &Neighbours, temperature: f64) {
        // Drawing a kick counts as a move, also when the kick is not allowed.
        self.tree.priced += 1;
        let g = Context { space, near, bridges: &self.bridges };
        let mut touched = Vec::with_capacity(16);
        let first = index(self.rng.below(space.home as usize));
        // The item is not in the tour: it is cut with its pierce group.
        if !self.tree.is_live(first) {
            return;
        }
        let mut change = 0.0;
        if self.rng.below(CONFIG.children.join) == 0 {
            let list = near.of_item(first);
            let other = *list.get(self.rng.below(list.len().max(1))).unwrap_or(&first);
            for stop in [first, other] {
                change -= join(g, &mut self.tree, stop, &mut touched);
            }
        } else {
            let Some(m) = draw(&mut self.rng, &self.tree, g, first) else { return };
            if !may_move(g, &mut self.tree, m) {
                return;
            }
            change -= gain(space, &self.tree, m);
            apply(g, &mut self.tree, m, |t| touched.push(t));
        }
        if self.rng.below(CONFIG.children.draw_place) == 0 {
            let place = index(self.rng.below(space.places(first).len()));
            change += place_at(g, &mut self.tree, first, place).unwrap_or(0.0);
        }
        // Places are improved first, as in `exchange.rs`, and that of the first stop last.
        for &t in touched.iter().filter(|&&t| t != first).chain([&first]) {
            if self.tree.is_live(t) {
                change -= improve_entry(g, &mut self.tree, &mut self.queue, t).unwrap_or(0.0);
            }
            self.queue.push(t);
        }
        while let Some(touch) = self.queue.pop() {
            change -= improve(g, &mut self.tree, &mut self.queue, touch);
        }
        if !self.rng.accepts(change, temperature) {
            self.tree.undo(space, 0);
            return;
        }
        // A kick that changes the routes at the same cost must not take the place of the best: when that is saved depends on
        // the slices.
        if self.cost + change >= self.least - EPSILON {
            self.save_before(space);
        }
        self.cost += change;
        self.tree.commit();
        self.check(space);
        self.keep_least(space);
    }
}

/// Joins the routes on the way from a stop up to the root, each with the route it hangs from, after its host. Returns the
/// seconds gained. Where two such ways meet, they become one ring, which no single chain move finds, because every step of
/// the way costs more than it gains.
fn join(g: Context, tree: &mut Tree, stop: u32, touched: &mut Vec<u32>) -> f64 {
    let mut gained = 0.0;
    for _ in 0..CONFIG.children.deepest_join {
        let anchor = tree.route(stop);
        if anchor == g.space.home || stop == g.space.home {
            break;
        }
        let (first, last) = (tree.next(anchor), tree.previous(anchor));
        let target = Target::After(tree.item(anchor));
        let m = ChainMove { first, last, reversed: false, target, at: None, enter: first };
        if !may_move(g, tree, m) {
            break;
        }
        gained += gain(g.space, tree, m);
        apply(g, tree, m, |t| touched.push(t));
    }
    gained
}

/// Draws a chain and a target for it.
fn draw(rng: &mut Rng, tree: &Tree, g: Context, first: u32) -> Option<ChainMove> {
    let space = g.space;
    let ahead = |from: u32, steps: usize, stop: u32| {
        let on = |&t: &u32| Some(tree.next(t)).filter(|&n| n != stop);
        std::iter::successors(Some(from), on).take(steps + 1).last().unwrap_or(from)
    };
    let last = ahead(first, rng.log_uniform(CONFIG.children.longest_kick) - 1, tree.route(first));
    let reversed = rng.below(2) == 0;
    let to_target = |target| Some(ChainMove { first, last, reversed, target, at: None, enter: first });
    let kind = rng.below(4);
    if kind < 2 {
        let to = ahead(last, rng.log_uniform(CONFIG.children.longest_kick), tree.previous(first));
        return if to == last { None } else { to_target(Target::After(to)) };
    }
    let list = g.near.of_item(first);
    let other = *list.get(rng.below(list.len().max(1)))?;
    if other != space.home && tree.finish_order.holds(tree.head(first), last, other) {
        return None;
    }
    if kind == 2 {
        let anchors = tree.anchors(other);
        let touch = *anchors.get(rng.below(anchors.len() + 1)).unwrap_or(&other);
        let to = if rng.below(2) == 0 { touch } else { tree.previous(touch) };
        let outside = tree.is_anchor(to) || !tree.finish_order.holds(tree.head(first), last, to);
        return if outside && to != tree.previous(first) { to_target(Target::After(to)) } else { None };
    }
    if !may_be_left(space, other) {
        return None;
    }
    if space.leave_places.is_group(other) {
        let places = space.leave_places.on_path(other, tree.at(other));
        let drawn = rng.below(places.len().max(1));
        return places.clone().nth(drawn).and_then(|at| to_target(Target::Child(other, at)));
    }
    let place =
        space.best_entry(other, Gap { from: tree.exit(last), to: Some(tree.entry(first)) }, f64::INFINITY).0;
    to_target(Target::Child(other, place))
}

/// Seconds that a chain move gains.
fn gain(space: &Space, tree: &Tree, m: ChainMove) -> f64 {
    let ChainMove { first, last, reversed, target, .. } = m;
    let (enter, leave) = tree.ends(space, (first, last), reversed);
    let over = if reversed { tree.reversal_cost(space, first, last) } else { 0.0 };
    let given = freed(space, tree, first, last) - over;
    match target {
        Target::After(to) => {
            let next = tree.next(to);
            given + tree.edge(space, to, next)
                - space.travel.seconds(tree.exit(to), enter)
                - tree.leg_seconds(space, leave, next, tree.entry(next))
        }
        Target::Child(host, at) if let Some(place) = space.leave_places.place(host, at) => {
            let [out, back] = place.ends;
            given
                - place.seconds
                - space.travel.seconds(out.into(), enter)
                - space.travel.seconds(leave, back.into())
        }
        Target::Child(host, at) => {
            let place = space.places(host).at(at);
            given
                - leaving(space, host)
                - space.extra(host, at)
                - space.travel.seconds(place, enter)
                - space.travel.seconds(leave, place)
        }
    }
}

/// Enters a stop at another place, if precedence allows it, and returns the extra cost in seconds.
fn place_at(g: Context, tree: &mut Tree, stop: u32, at: u32) -> Option<f64> {
    if tree.keeps_path(g.space, stop) {
        return None;
    }
    let cost = |tree: &Tree| {
        let (before, after) = (tree.previous(stop), tree.next(stop));
        tree.edge(g.space, before, stop) + tree.edge(g.space, stop, after) + tree.extra(g.space, stop)
    };
    let (mark, before) = (tree.changes(), cost(tree));
    tree.place(g.space, stop, at);
    if tree.anchors(stop).len() > 1 && !keeps_order(g, tree, stop) {
        tree.undo(g.space, mark);
        return None;
    }
    Some(cost(tree) - before)
}
