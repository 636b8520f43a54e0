//! Routes that hang from contours: rings of touches, a journal that takes changes back.
//!
//! A touch is a place where the head meets an item: its **stop**, where it is entered and finished, and for each child
//! route an **anchor**, where it is left and resumed. A route is a ring of touches: its anchor (home for the root), then
//! its stops in order. Every way goes from one touch of a ring to the next, so all moves price alike. Stops have the
//! number of their item; anchors follow home. Here is what the routes are; `change.rs` changes them, `visits.rs` makes them
//! from solutions and solutions from them.

use super::super::index::index;
use super::super::space::Space;
use super::super::travel::Gap;
use super::super::travel::Place;
use super::closing::Closing;
use crate::problem::Item;

/// No route: an anchor that is not in use.
pub(super) const NONE: u32 = u32::MAX;

/// One change, to be taken back.
#[derive(Clone, Copy)]
pub(super) enum Change {
    /// Touch, and its place before.
    Placed(u32, u32),
    /// First and last of a chain, and the touch it stood behind.
    Shifted(u32, u32, u32),
    /// First and last of a stretch as it is now.
    Turned(u32, u32),
    /// An anchor put to use.
    Opened(u32),
    /// An anchor no longer in use, with its host and place.
    Closed(u32, u32, u32),
}

/// The routes.
#[derive(Clone)]
pub(super) struct Tree {
    pub(super) home: u32,
    pub(super) closed: bool,
    /// By touch: item, place, where the head comes and goes, neighbours, anchor of the route.
    pub(super) item: Vec<u32>,
    pub(super) at: Vec<u32>,
    pub(super) entry: Vec<Place>,
    pub(super) exit: Vec<Place>,
    pub(super) next: Vec<u32>,
    pub(super) previous: Vec<u32>,
    pub(super) route: Vec<u32>,
    /// Anchors at an item, in the order of a round from its entry.
    pub(super) kids: Vec<Vec<u32>>,
    pub(super) spare: Vec<u32>,
    pub(super) closing: Closing,
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

    pub(super) fn kids(&self, item: u32) -> &[u32] {
        &self.kids[item as usize]
    }

    /// Seconds from `p` to touch `to` at point `q`; home costs nothing when the path does not return.
    pub(super) fn way(&self, space: &Space, p: Place, to: u32, q: Place) -> f64 {
        if to == self.home && !self.closed { 0.0 } else { space.travel.seconds(p, q) }
    }

    /// Seconds from one touch to another.
    pub(super) fn edge(&self, space: &Space, from: u32, to: u32) -> f64 {
        self.way(space, self.exit(from), to, self.entry(to))
    }

    /// The gap between two touches.
    pub(super) fn gap(&self, from: u32, to: u32) -> Gap {
        let ends = to == self.home && !self.closed;
        Gap { from: self.exit(from), to: (!ends).then(|| self.entry(to)) }
    }

    /// Seconds of all ways and charges.
    pub(super) fn cost(&self, space: &Space) -> f64 {
        let live = (0..index(self.next.len())).filter(|&t| self.is_live(t));
        live.map(|t| self.edge(space, t, self.next(t)) + self.price(space, t)).sum()
    }

    /// Whether routes hang from one place, or from where their item is entered: as visits they take less.
    pub(super) fn is_doubled(&self) -> bool {
        let same = |a: u32, b: u32| self.at(a) == self.at(b);
        (0..self.home).any(|i| {
            let kids = self.kids(i);
            kids.first().is_some_and(|&k| same(k, i)) || kids.windows(2).any(|k| same(k[0], k[1]))
        })
    }

    /// Seconds for the place of a touch, besides the ways: a run along a contour may take longer when it is begun or
    /// broken off there.
    pub(super) fn extra(&self, space: &Space, touch: u32) -> f64 {
        space.extra(self.item(touch), self.at(touch))
    }

    /// All that a touch costs but for the ways: of an anchor, leaving for its route, too.
    pub(super) fn price(&self, space: &Space, touch: u32) -> f64 {
        let leaves = if touch > self.home { leaving(space, self.item(touch)) } else { 0.0 };
        leaves + self.extra(space, touch)
    }

    /// The item of a stop and all that hangs from it: the first to be finished.
    pub(super) fn head(&self, stop: u32) -> u32 {
        let mut item = stop;
        while let Some(&kid) = self.kids(item).iter().find(|&&k| self.next(k) != k) {
            item = self.next(kid);
        }
        item
    }

    /// The item behind which whatever is put behind a touch is finished.
    pub(super) fn finished_before(&self, touch: u32) -> u32 {
        if !self.is_anchor(touch) {
            return touch;
        }
        if self.next(touch) != touch {
            return self.closing.previous(self.head(self.next(touch)));
        }
        let (host, filled) = (self.item(touch), |k: &&u32| self.next(**k) != **k);
        let kids = self.kids(host);
        let here = kids.iter().position(|&k| k == touch).unwrap_or(0);
        if let Some(&before) = kids[..here].iter().rev().find(filled) {
            return self.previous(before);
        }
        let after = kids[here..].iter().find(filled).map_or(host, |&k| self.head(self.next(k)));
        self.closing.previous(after)
    }

    /// Forgets how to go back.
    pub(super) fn commit(&mut self) {
        self.journal.clear();
    }

    /// How many changes there are to take back.
    pub(super) fn changes(&self) -> usize {
        self.journal.len()
    }
}

/// What leaving an item and resuming it costs, but for the place.
pub(super) fn leaving(space: &Space, item: u32) -> f64 {
    space.problem.items.get(item as usize).map_or(0.0, Item::resume)
}
