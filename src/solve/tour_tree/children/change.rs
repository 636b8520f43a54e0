//! Changes to routes, each with its inverse: touches move along their items, chains move between routes, stretches are
//! reversed, routes are opened and closed. All keep the order of finishing in line with the routes.

use super::super::index::index;
use super::super::space::Space;
use super::tree::{Change, NONE, Tree};

impl Tree {
    /// Moves a touch along its item.
    pub(super) fn place(&mut self, space: &Space, touch: u32, at: u32) {
        self.journal.push(Change::Placed(touch, self.at(touch)));
        self.set(space, touch, at);
    }

    fn set(&mut self, space: &Space, touch: u32, at: u32) {
        self.at[touch as usize] = at;
        self.locate(space, touch);
        let host = self.item(touch);
        if self.anchors(host).len() > 1 && self.sort(space, host) {
            self.restack(host);
        }
    }

    /// Stores where the head enters and leaves a touch.
    pub(super) fn locate(&mut self, space: &Space, touch: u32) {
        let (item, at) = (self.item(touch), self.at(touch));
        if let Some(place) = self.leave_place(space, touch) {
            let [exit, entry] = place.ends;
            (self.entry[touch as usize], self.exit[touch as usize]) = (entry.into(), exit.into());
            return;
        }
        self.entry[touch as usize] = space.places(item).at(at);
        self.exit[touch as usize] = space.exit(item, at);
    }

    /// Sorts the anchors of an item in the order along it from its entry. Returns whether anything changed.
    fn sort(&mut self, space: &Space, host: u32) -> bool {
        let (count, start) = (index(space.places(host).len()), self.at(host));
        // The places of a pierce group are numbered along its path already.
        let numbered = space.leave_places.is_group(host);
        let Self { anchors, at, .. } = self;
        // Routes from one place are sorted by number, so that a change that is taken back leaves no trace.
        let along = |k: u32| {
            let at = at[k as usize];
            (if numbered { at } else { (at + count - start) % count }, k)
        };
        let anchors = &mut anchors[host as usize];
        let mut changed = false;
        for i in 1..anchors.len() {
            let mut j = i;
            while j > 0 && along(anchors[j - 1]) > along(anchors[j]) {
                anchors.swap(j - 1, j);
                changed = true;
                j -= 1;
            }
        }
        changed
    }

    /// Brings the order of finishing in line with the order of an item's anchors.
    fn restack(&mut self, host: u32) {
        let blocks: Vec<(u32, u32)> = self
            .anchors(host)
            .iter()
            .filter(|&&k| self.next(k) != k)
            .map(|&k| (self.head(self.next(k)), self.previous(k)))
            .collect();
        // Each block goes right before the host, so that the blocks end up in the order of the anchors.
        for (first, last) in blocks {
            let behind = self.finish_order.previous(host);
            if behind != last {
                self.finish_order.move_stretch(first, last, behind);
            }
        }
    }

    /// Opens an empty route that hangs from `host` at a place, and returns its anchor.
    pub(super) fn open(&mut self, space: &Space, host: u32, at: u32) -> u32 {
        // There are as many anchors as items, and no route is empty for long.
        let anchor = self.spare.pop().unwrap_or(self.home);
        self.journal.push(Change::Opened(anchor));
        self.hang(space, anchor, host, at);
        anchor
    }

    fn hang(&mut self, space: &Space, anchor: u32, host: u32, at: u32) {
        self.item[anchor as usize] = host;
        self.at[anchor as usize] = at;
        self.route[anchor as usize] = anchor;
        self.locate(space, anchor);
        self.anchors[host as usize].push(anchor);
        self.sort(space, host);
    }

    /// Closes an empty route.
    pub(super) fn close(&mut self, anchor: u32) {
        self.journal.push(Change::Closed(anchor, self.item(anchor), self.at(anchor)));
        self.take_down(anchor);
    }

    fn take_down(&mut self, anchor: u32) {
        self.anchors[self.item[anchor as usize] as usize].retain(|&k| k != anchor);
        self.route[anchor as usize] = NONE;
        self.spare.push(anchor);
    }

    /// Moves the chain from `first` to `last`, with all that hangs from it, after `to`; a route that becomes empty is closed.
    pub(super) fn move_chain(&mut self, first: u32, last: u32, to: u32) {
        let from = self.previous(first);
        self.journal.push(Change::Moved(first, last, from));
        self.relink(first, last, to);
        if from > self.home && self.next(from) == from {
            self.close(from);
        }
    }

    fn relink(&mut self, first: u32, last: u32, to: u32) {
        let (before, after) = (self.previous(first), self.next(last));
        self.next[before as usize] = after;
        self.previous[after as usize] = before;
        let head = self.head(first);
        let mut behind = self.finished_before(to);
        if self.finish_order.holds(head, last, behind) {
            behind = self.finish_order.previous(head);
        }
        self.link(first, last, to);
        self.finish_order.move_stretch(head, last, behind);
    }

    /// Puts a chain into a ring.
    pub(super) fn link(&mut self, first: u32, last: u32, to: u32) {
        let after = self.next(to);
        self.next[to as usize] = first;
        self.previous[first as usize] = to;
        self.next[last as usize] = after;
        self.previous[after as usize] = last;
        let route = self.route(to);
        let mut touch = first;
        loop {
            self.route[touch as usize] = route;
            if touch == last {
                return;
            }
            touch = self.next(touch);
        }
    }

    /// Extra cost of a stretch when it is reversed, s: paths forth and back through pierce groups differ, and so do legs that cost more one
    /// way than the other, as between contours with leads.
    pub(super) fn reversal_cost(&self, space: &Space, first: u32, last: u32) -> f64 {
        let mut sum = 0.0;
        let mut stop = first;
        while !space.direction_dependent.is_empty() || !space.travel.symmetric {
            if space.two_ends(stop) {
                sum += space.extra(stop, self.at(stop) ^ 1) - space.extra(stop, self.at(stop));
            }
            if stop == last {
                break;
            }
            let next = self.next(stop);
            if !space.travel.symmetric {
                let back = (self.exit_reversed(space, next), self.entry_reversed(space, stop));
                sum += space.travel.seconds(back.0, back.1) - self.edge(space, stop, next);
            }
            stop = next;
        }
        sum
    }

    /// Reverses the stretch from `first` to `last`; what hangs from its items stays as it is.
    pub(super) fn reverse_stretch(&mut self, space: &Space, first: u32, last: u32) {
        self.journal.push(Change::Reversed(last, first));
        self.reverse(space, first, last);
    }

    fn reverse(&mut self, space: &Space, first: u32, last: u32) {
        let (before, after) = (self.previous(first), self.next(last));
        let mut behind = self.finish_order.previous(self.head(first));
        let mut stops = vec![last];
        while stops[stops.len() - 1] != first {
            stops.push(self.previous(stops[stops.len() - 1]));
        }
        let mut previous = before;
        for stop in stops {
            let head = self.head(stop);
            self.finish_order.move_stretch(head, stop, behind);
            behind = stop;
            if space.two_ends(stop) {
                self.at[stop as usize] = self.at(stop) ^ 1;
                self.locate(space, stop);
            }
            self.next[previous as usize] = stop;
            self.previous[stop as usize] = previous;
            previous = stop;
        }
        self.next[previous as usize] = after;
        self.previous[after as usize] = previous;
    }

    /// Takes changes back until the journal has `left` changes.
    pub(super) fn undo(&mut self, space: &Space, left: usize) {
        while self.journal.len() > left {
            match self.journal.pop() {
                Some(Change::Placed(touch, at)) => self.set(space, touch, at),
                Some(Change::Moved(first, last, from)) => self.relink(first, last, from),
                Some(Change::Reversed(first, last)) => self.reverse(space, first, last),
                Some(Change::Opened(anchor)) => self.take_down(anchor),
                Some(Change::Closed(anchor, host, at)) => {
                    self.spare.pop();
                    self.hang(space, anchor, host, at);
                }
                None => return,
            }
        }
    }
}
