//! The tree of routes: rings of touches, and a journal that takes changes back.
//!
//! A touch is a place where the head meets an item. Each item has one *stop*, where it is entered and finished, and for each
//! child route one *anchor*, where it is left and resumed. A route is a ring of touches: its anchor (home for the root
//! route), then its stops in order. Every leg goes from one touch of a ring to the next, so that all moves are priced alike.
//! A stop has the number of its item, and anchors have the numbers after home. This file describes the routes; `change.rs`
//! changes them, and `visits.rs` converts them from and to solutions.

use super::super::index::index;
use super::super::space::Space;
use super::super::travel::Gap;
use super::super::travel::Place;
use super::finish_order::FinishOrder;
use crate::problem::{Item, LeavePoint};

/// The route of an anchor that is not in use.
pub(super) const NONE: u32 = u32::MAX;

/// One change, to be taken back.
#[derive(Clone, Copy)]
pub(super) enum Change {
    /// A touch moved along its item: the touch, and its place before.
    Placed(u32, u32),
    /// A chain moved: its first and last touch, and the touch before it.
    Moved(u32, u32, u32),
    /// A stretch was reversed: its first and last touch now.
    Reversed(u32, u32),
    /// A route was opened: its anchor.
    Opened(u32),
    /// A route was closed: its anchor, host and place.
    Closed(u32, u32, u32),
}

/// The routes.
#[derive(Clone)]
pub(super) struct Tree {
    pub(super) home: u32,
    pub(super) closed: bool,
    // By touch: item, place, where the head arrives and leaves, neighbours in the ring, anchor of the route.
    pub(super) item: Vec<u32>,
    pub(super) at: Vec<u32>,
    pub(super) entry: Vec<Place>,
    pub(super) exit: Vec<Place>,
    pub(super) next: Vec<u32>,
    pub(super) previous: Vec<u32>,
    pub(super) route: Vec<u32>,
    /// By item: its anchors in the order along it from its entry.
    pub(super) anchors: Vec<Vec<u32>>,
    /// Anchors that are not in use.
    pub(super) spare: Vec<u32>,
    pub(super) finish_order: FinishOrder,
    pub(super) journal: Vec<Change>,
    /// Moves priced so far.
    pub(super) priced: u64,
}

impl Tree {
    pub(super) fn is_anchor(&self, touch: u32) -> bool {
        touch >= self.home
    }

    /// Whether a touch is in use.
    pub(super) fn is_live(&self, touch: u32) -> bool {
        self.route[touch as usize] != NONE
    }

    pub(super) fn item(&self, touch: u32) -> u32 {
        self.item[touch as usize]
    }

    pub(super) fn at(&self, touch: u32) -> u32 {
        self.at[touch as usize]
    }

    pub(super) fn next(&self, touch: u32) -> u32 {
        self.next[touch as usize]
    }

    pub(super) fn previous(&self, touch: u32) -> u32 {
        self.previous[touch as usize]
    }

    pub(super) fn route(&self, touch: u32) -> u32 {
        self.route[touch as usize]
    }

    pub(super) fn entry(&self, touch: u32) -> Place {
        self.entry[touch as usize]
    }

    pub(super) fn exit(&self, touch: u32) -> Place {
        self.exit[touch as usize]
    }

    /// Where the head would enter a stop in a reversed stretch: a contour with leads is entered at its lead-in all the same.
    pub(super) fn entry_reversed(&self, space: &Space, stop: u32) -> Place {
        if space.is_directed(stop) { self.entry(stop) } else { self.exit(stop) }
    }

    /// Where the head would leave a stop in a reversed stretch.
    pub(super) fn exit_reversed(&self, space: &Space, stop: u32) -> Place {
        if space.is_directed(stop) { self.exit(stop) } else { self.entry(stop) }
    }

    /// Where the head enters and leaves a stretch as it is, or reversed.
    pub(super) fn ends(&self, space: &Space, (first, last): (u32, u32), reversed: bool) -> (Place, Place) {
        if reversed {
            (self.entry_reversed(space, last), self.exit_reversed(space, first))
        } else {
            (self.entry(first), self.exit(last))
        }
    }

    pub(super) fn anchors(&self, item: u32) -> &[u32] {
        &self.anchors[item as usize]
    }

    /// Seconds from `p` to touch `to` at `q`; coming home costs nothing when the path does not return.
    pub(super) fn leg_seconds(&self, space: &Space, p: Place, to: u32, q: Place) -> f64 {
        if to == self.home && !self.closed { 0.0 } else { space.travel.seconds(p, q) }
    }

    /// Seconds from one touch to another.
    pub(super) fn edge(&self, space: &Space, from: u32, to: u32) -> f64 {
        self.leg_seconds(space, self.exit(from), to, self.entry(to))
    }

    /// The gap between two touches.
    pub(super) fn gap(&self, from: u32, to: u32) -> Gap {
        let ends = to == self.home && !self.closed;
        Gap { from: self.exit(from), to: (!ends).then(|| self.entry(to)) }
    }

    /// Cost of all legs, extra seconds and charges, s.
    pub(super) fn cost(&self, space: &Space) -> f64 {
        let live = (0..index(self.next.len())).filter(|&t| self.is_live(t));
        live.map(|t| self.edge(space, t, self.next(t)) + self.price(space, t)).sum()
    }

    /// Whether two routes hang from one place, or one from the entry of its item: as visits they cost less.
    pub(super) fn is_doubled(&self, space: &Space) -> bool {
        let same = |a: u32, b: u32| self.at(a) == self.at(b);
        (0..self.home).any(|i| {
            let anchors = self.anchors(i);
            let first = anchors.first().filter(|_| !space.leave_places.is_group(i));
            first.is_some_and(|&k| same(k, i)) || anchors.windows(2).any(|k| same(k[0], k[1]))
        })
    }

    /// The place where a route hangs from a pierce group; `None` for other touches.
    pub(super) fn leave_place<'p>(&self, space: &Space<'p>, touch: u32) -> Option<&'p LeavePoint> {
        if touch <= self.home {
            return None;
        }
        space.leave_places.place(self.item(touch), self.at(touch))
    }

    /// Whether an item is a pierce group from which routes hang: they belong to the path by which it is cut.
    pub(super) fn keeps_path(&self, space: &Space, item: u32) -> bool {
        space.leave_places.is_group(item) && !self.anchors(item).is_empty()
    }

    /// Extra seconds of a touch by its place: a run along a contour may take longer if it starts or stops there.
    pub(super) fn extra(&self, space: &Space, touch: u32) -> f64 {
        let place = self.leave_place(space, touch);
        place.map_or_else(|| space.extra(self.item(touch), self.at(touch)), |p| p.seconds)
    }

    /// Cost of a touch without its legs, s: its extra seconds and, for an anchor, the charge for leaving the item.
    pub(super) fn price(&self, space: &Space, touch: u32) -> f64 {
        let leaves = if touch > self.home { leaving(space, self.item(touch)) } else { 0.0 };
        leaves + self.extra(space, touch)
    }

    /// Of a stop and everything that hangs from it, the item that is finished first.
    pub(super) fn head(&self, stop: u32) -> u32 {
        let mut item = stop;
        while let Some(&kid) = self.anchors(item).iter().find(|&&k| self.next(k) != k) {
            item = self.next(kid);
        }
        item
    }

    /// The item after which a stop is finished that is put after a touch.
    pub(super) fn finished_before(&self, touch: u32) -> u32 {
        if !self.is_anchor(touch) {
            return touch;
        }
        if self.next(touch) != touch {
            return self.finish_order.previous(self.head(self.next(touch)));
        }
        let (host, filled) = (self.item(touch), |k: &&u32| self.next(**k) != **k);
        let anchors = self.anchors(host);
        let here = anchors.iter().position(|&k| k == touch).unwrap_or(0);
        if let Some(&before) = anchors[..here].iter().rev().find(filled) {
            return self.previous(before);
        }
        let after = anchors[here..].iter().find(filled).map_or(host, |&k| self.head(self.next(k)));
        self.finish_order.previous(after)
    }

    /// Accepts all changes: empties the journal.
    pub(super) fn commit(&mut self) {
        self.journal.clear();
    }

    /// Number of changes in the journal.
    pub(super) fn changes(&self) -> usize {
        self.journal.len()
    }
}

/// Seconds of leaving an item and resuming it, without the extra seconds of the place.
pub(super) fn leaving(space: &Space, item: u32) -> f64 {
    space.problem.items.get(item as usize).map_or(0.0, Item::resume)
}
