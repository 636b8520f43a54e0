//! Child routes that hang from pierce groups.
//!
//! The path through a group is fixed while routes hang from it, except that [`other_path`] changes the path and the places
//! of all its routes together. A route hangs from a place of the current path (`leave_places.rs`). What lies in an area of
//! the group may hang only from places at which this area still holds.

use super::super::config::CONFIG;
use super::super::queue::Queue;
use super::super::space::Space;
use super::super::travel::Gap;
use super::allowed::keeps_order;
use super::chain_move::Context;
use super::tree::Tree;
use crate::problem::SubPath;
use crate::solve::epsilon::EPSILON;

/// Places of a group that are priced in the time of one move.
const PRICED_AT_ONCE: u64 = 16;

impl Tree {
    /// The path by which a pierce group is cut.
    fn path<'p>(&self, space: &Space<'p>, group: u32) -> Option<&'p SubPath> {
        space.problem.items.get(group as usize)?.paths.get(self.at(group) as usize)
    }

    /// Whether an item may be cut while a group is left at a place: it lies elsewhere, or in an area that still holds.
    fn holds_still(&self, space: &Space, group: u32, along: f64, item: u32) -> bool {
        let item = &space.problem.items[item as usize];
        item.before != Some(group) || self.path(space, group).is_some_and(|path| along < path.due(item.area))
    }

    /// Whether everything from `first` to `last`, with all that hangs from it, may go where `to` is: for each group above
    /// that place, what lies inside the group still holds.
    pub(super) fn areas_hold(&self, space: &Space, first: u32, last: u32, to: u32) -> bool {
        if !space.leave_places.any() {
            return true;
        }
        let mut anchor = self.route(to);
        while anchor != self.home {
            let group = self.item(anchor);
            if let Some(place) = self.leave_place(space, anchor)
                && !self
                    .finish_order
                    .stretch(self.head(first), last)
                    .all(|i| self.holds_still(space, group, place.along, i))
            {
                return false;
            }
            anchor = self.route(group);
        }
        true
    }

    /// Whether the areas of a group still hold for all routes that hang from it.
    fn routes_hold(&self, space: &Space, group: u32) -> bool {
        let filled = |k: &&u32| self.next(**k) != **k;
        self.anchors(group).iter().filter(filled).all(|&k| {
            let (head, last) = (self.head(self.next(k)), self.previous(k));
            let along = self.leave_place(space, k).map_or(f64::INFINITY, |p| p.along);
            self.finish_order.stretch(head, last).all(|i| self.holds_still(space, group, along, i))
        })
    }

    /// Whether all routes hang from places of their groups' paths, in time. For debug assertions.
    pub(super) fn groups_are_sound(&self, space: &Space) -> bool {
        (0..self.home).filter(|&i| self.keeps_path(space, i)).all(|i| {
            let places = space.leave_places.on_path(i, self.at(i));
            self.anchors(i).iter().all(|&k| places.contains(&self.at(k))) && self.routes_hold(space, i)
        })
    }

    /// The cheapest place of a path for a route whose ends are at `around`: its seconds contain both legs.
    fn cheapest_place(&mut self, space: &Space, group: u32, path: u32, around: Gap) -> Option<(u32, f64)> {
        let places = space.leave_places.on_path(group, path);
        self.priced += (places.len() as u64).div_ceil(PRICED_AT_ONCE);
        let mut best: Option<(u32, f64)> = None;
        for at in places {
            let Some(place) = space.leave_places.place(group, at) else { continue };
            let [exit, entry] = place.ends;
            // The gap is the rest of the ring: from the last stop to the group, and from there to the first.
            let back = space.travel.air(around.from.point, entry);
            let out = around.to.map_or(0.0, |first| space.travel.air(exit, first.point));
            let seconds = back + out + place.seconds;
            if best.is_none_or(|b| seconds < b.1) {
                best = Some((at, seconds));
            }
        }
        best
    }

    /// The cheapest way to hang a chain from a group: the place, the place where a single stop is entered, and the seconds
    /// of both legs, of leaving, and of that entry. A stop with a ring and its place on the group are chosen in turns.
    pub(super) fn hang_on(
        &mut self,
        space: &Space,
        group: u32,
        (first, last, enter): (u32, u32, u32),
    ) -> Option<(u32, Option<u32>, f64)> {
        let path = self.at(group);
        if first != last || space.two_ends(enter) {
            let around = Gap { from: self.exit(last), to: Some(self.entry(first)) };
            return self.cheapest_place(space, group, path, around).map(|(at, seconds)| (at, None, seconds));
        }
        let mut here = self.entry(enter);
        let mut best: Option<(u32, Option<u32>, f64)> = None;
        for _ in 0..CONFIG.children.bridge_turns {
            let (at, _) = self.cheapest_place(space, group, path, Gap { from: here, to: Some(here) })?;
            let place = space.leave_places.place(group, at)?;
            let [exit, entry] = place.ends;
            let gap = Gap { from: exit.into(), to: Some(entry.into()) };
            let (entered, seconds) = space.best_entry(enter, gap, f64::INFINITY);
            let seconds = seconds + place.seconds;
            if best.is_some_and(|b| seconds >= b.2 - EPSILON) {
                break;
            }
            best = Some((at, Some(entered), seconds));
            here = space.places(enter).at(entered);
        }
        best
    }
}

/// Moves a route along the path of its group to the best place that still holds; returns the seconds gained.
pub(super) fn better_place(g: Context, tree: &mut Tree, queue: &mut Queue, anchor: u32) -> Option<f64> {
    let group = tree.item(anchor);
    let (first, last) = (tree.next(anchor), tree.previous(anchor));
    let around = Gap { from: tree.exit(last), to: Some(tree.entry(first)) };
    let now =
        tree.edge(g.space, anchor, first) + tree.edge(g.space, last, anchor) + tree.price(g.space, anchor);
    let (at, seconds) = tree.cheapest_place(g.space, group, tree.at(group), around)?;
    if seconds >= now - EPSILON {
        return None;
    }
    let mark = tree.changes();
    tree.place(g.space, anchor, at);
    if !fits(g, tree, group) {
        tree.undo(g.space, mark);
        return None;
    }
    for t in [anchor, first, last] {
        queue.push(t);
    }
    Some(now - seconds)
}

/// Cuts a group from which routes hang by another path, with all its routes at their cheapest places; returns the seconds
/// gained.
pub(super) fn other_path(g: Context, tree: &mut Tree, queue: &mut Queue, group: u32) -> Option<f64> {
    let space = g.space;
    let gap = tree.gap(tree.previous(group), tree.next(group));
    let anchors = tree.anchors(group).to_vec();
    let around =
        |tree: &Tree, k: u32| Gap { from: tree.exit(tree.previous(k)), to: Some(tree.entry(tree.next(k))) };
    let legs = |tree: &Tree, k: u32| {
        tree.edge(space, k, tree.next(k)) + tree.edge(space, tree.previous(k), k) + tree.price(space, k)
    };
    let now = space.through(group, tree.at(group), gap) + anchors.iter().map(|&k| legs(tree, k)).sum::<f64>();
    let mut best: Option<(f64, u32, Vec<u32>)> = None;
    let current = tree.at(group);
    for path in (0..).take(space.places(group).len()).filter(|&p| p != current) {
        let mut seconds = space.through(group, path, gap);
        let mut places = Vec::with_capacity(anchors.len());
        for &k in &anchors {
            let around = around(tree, k);
            let (at, own) = tree.cheapest_place(space, group, path, around).unwrap_or((0, f64::INFINITY));
            seconds += own;
            places.push(at);
        }
        if seconds < best.as_ref().map_or(now - EPSILON, |b| b.0) {
            best = Some((seconds, path, places));
        }
    }
    let (seconds, path, places) = best?;
    let mark = tree.changes();
    tree.place(space, group, path);
    for (&k, &at) in anchors.iter().zip(&places) {
        tree.place(space, k, at);
    }
    if !fits(g, tree, group) {
        tree.undo(space, mark);
        return None;
    }
    for t in anchors.into_iter().chain([group, tree.previous(group), tree.next(group)]) {
        queue.push(t);
    }
    Some(now - seconds)
}

/// Whether the routes of a group hang in an order that precedence allows, while their areas hold.
fn fits(g: Context, tree: &Tree, group: u32) -> bool {
    tree.routes_hold(g.space, group) && (tree.anchors(group).len() < 2 || keeps_order(g, tree, group))
}
