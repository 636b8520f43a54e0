//! Routes that hang from contours: rings of touches, a journal that takes changes back.
//!
//! A touch is a place where the head meets an item: its **stop**, where it is entered and finished, and for each child
//! route an **anchor**, where it is left and resumed. A route is a ring of touches: its anchor (home for the root), then
//! its stops in order. Every way goes from one touch of a ring to the next, so all moves price alike. Stops have the
//! number of their item; anchors follow home.

use super::super::space::{Gap, Space, index};
use super::super::travel::Place;
use super::closing::Closing;
use super::moves::leaving;
use crate::solve::{Solution, Stop};

/// No route: an anchor that is not in use.
const NONE: u32 = u32::MAX;

/// One change, to be taken back.
#[derive(Clone, Copy)]
enum Change {
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
    home: u32,
    closed: bool,
    /// By touch: item, place, where the head comes and goes, neighbours, anchor of the route.
    item: Vec<u32>,
    at: Vec<u32>,
    entry: Vec<Place>,
    exit: Vec<Place>,
    next: Vec<u32>,
    previous: Vec<u32>,
    route: Vec<u32>,
    /// Anchors at an item, in the order of a round from its entry.
    kids: Vec<Vec<u32>>,
    spare: Vec<u32>,
    pub(super) closing: Closing,
    journal: Vec<Change>,
    /// Moves priced so far.
    pub(super) priced: u64,
}

impl Tree {
    /// The routes of a solution that visits every item of the space, entered and left at the nearest places.
    pub(super) fn new(space: &Space, solution: &Solution) -> Self {
        let home = space.home;
        let touches = 2 * home as usize + 1;
        let mut tree = Self {
            home,
            closed: space.problem.closed,
            item: (0..=home).chain(std::iter::repeat_n(home, home as usize)).collect(),
            at: vec![0; touches],
            entry: vec![space.problem.home; touches],
            exit: vec![space.problem.home; touches],
            next: (0..index(touches)).collect(),
            previous: (0..index(touches)).collect(),
            route: vec![NONE; touches],
            kids: vec![Vec::new(); home as usize + 1],
            spare: (home + 1..index(touches)).rev().collect(),
            closing: Closing::new(home),
            journal: Vec::new(),
            priced: 0,
        };
        tree.route[home as usize] = home;
        tree.fill(space, solution);
        tree
    }

    fn fill(&mut self, space: &Space, solution: &Solution) {
        // Where the next stop goes, and the items left unfinished with their first place.
        let mut tail = self.home;
        let mut open: Vec<(u32, f64)> = Vec::new();
        for stop in &solution.stops {
            let item = space.problem.nodes[stop.node as usize].item;
            let resumed = open.pop_if(|o| o.0 == item);
            if resumed.is_some() {
                let anchor = self.route[tail as usize];
                if anchor == tail {
                    self.close(anchor);
                }
            } else {
                self.at[item as usize] = space.entered_at(stop);
                self.locate(space, item);
                self.link(item, item, tail);
            }
            let start = resumed.map_or(stop.along, |o| o.1);
            tail = item;
            #[expect(clippy::float_cmp, reason = "the last visit ends where the first began, bit for bit")]
            let finished = stop.until == start;
            if finished {
                self.closing.append(item);
            } else {
                open.push((item, start));
                let mut at = space.left_at(stop);
                if at == self.at[item as usize] {
                    // Rounded to the entry: one place on or back, so that it stays on its side.
                    let count = index(space.places(item).len());
                    let round = space.round(item);
                    let ahead = (stop.until - start).rem_euclid(round) < 0.5 * round;
                    at = (at + if ahead { 1 } else { count - 1 }) % count;
                }
                tail = self.open(space, item, at);
            }
        }
        self.journal.clear();
    }

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

    /// Moves a touch along its item.
    pub(super) fn place(&mut self, space: &Space, touch: u32, at: u32) {
        self.journal.push(Change::Placed(touch, self.at(touch)));
        self.set(space, touch, at);
    }

    fn set(&mut self, space: &Space, touch: u32, at: u32) {
        self.at[touch as usize] = at;
        self.locate(space, touch);
        let host = self.item(touch);
        if self.kids(host).len() > 1 && self.sort(space, host) {
            self.restack(host);
        }
    }

    fn locate(&mut self, space: &Space, touch: u32) {
        let (item, at) = (self.item(touch), self.at(touch));
        self.entry[touch as usize] = space.places(item)[at as usize];
        self.exit[touch as usize] = space.exit(item, at);
    }

    /// Brings the anchors of an item in the order of a round from its entry; whether that changed anything.
    fn sort(&mut self, space: &Space, host: u32) -> bool {
        let (count, start) = (index(space.places(host).len()), self.at(host));
        let Self { kids, at, .. } = self;
        // Routes from one place follow each other by number, so that a change taken back leaves no trace.
        let along = |k: u32| ((at[k as usize] + count - start) % count, k);
        let kids = &mut kids[host as usize];
        let mut changed = false;
        for i in 1..kids.len() {
            let mut j = i;
            while j > 0 && along(kids[j - 1]) > along(kids[j]) {
                kids.swap(j - 1, j);
                changed = true;
                j -= 1;
            }
        }
        changed
    }

    /// Brings the order of finishing in line with that of an item's anchors.
    fn restack(&mut self, host: u32) {
        let blocks: Vec<(u32, u32)> = self
            .kids(host)
            .iter()
            .filter(|&&k| self.next(k) != k)
            .map(|&k| (self.head(self.next(k)), self.previous(k)))
            .collect();
        // Behind everything else, one after the other, ends in the right order right before the host.
        for (first, last) in blocks {
            let behind = self.closing.previous(host);
            if behind != last {
                self.closing.carry(first, last, behind);
            }
        }
    }

    /// A new, empty route that hangs from `host` at a place.
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
        self.kids[host as usize].push(anchor);
        self.sort(space, host);
    }

    /// Takes an empty route away.
    fn close(&mut self, anchor: u32) {
        self.journal.push(Change::Closed(anchor, self.item(anchor), self.at(anchor)));
        self.take_down(anchor);
    }

    fn take_down(&mut self, anchor: u32) {
        self.kids[self.item[anchor as usize] as usize].retain(|&k| k != anchor);
        self.route[anchor as usize] = NONE;
        self.spare.push(anchor);
    }

    /// Moves the chain from `first` to `last`, and all that hangs from it, behind `to`; a route left empty is taken
    /// away.
    pub(super) fn shift(&mut self, first: u32, last: u32, to: u32) {
        let from = self.previous(first);
        self.journal.push(Change::Shifted(first, last, from));
        self.carry(first, last, to);
        if from > self.home && self.next(from) == from {
            self.close(from);
        }
    }

    fn carry(&mut self, first: u32, last: u32, to: u32) {
        let (before, after) = (self.previous(first), self.next(last));
        self.next[before as usize] = after;
        self.previous[after as usize] = before;
        let head = self.head(first);
        let mut behind = self.finished_before(to);
        if self.closing.holds(head, last, behind) {
            behind = self.closing.previous(head);
        }
        self.link(first, last, to);
        self.closing.carry(head, last, behind);
    }

    /// Puts a chain into a ring.
    fn link(&mut self, first: u32, last: u32, to: u32) {
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

    /// Runs the stretch from `first` to `last` the other way round; what hangs from its items stays as it is.
    pub(super) fn turn(&mut self, space: &Space, first: u32, last: u32) {
        self.journal.push(Change::Turned(last, first));
        self.reverse(space, first, last);
    }

    fn reverse(&mut self, space: &Space, first: u32, last: u32) {
        let (before, after) = (self.previous(first), self.next(last));
        let mut behind = self.closing.previous(self.head(first));
        let mut stops = vec![last];
        while stops[stops.len() - 1] != first {
            stops.push(self.previous(stops[stops.len() - 1]));
        }
        let mut previous = before;
        for stop in stops {
            let head = self.head(stop);
            self.closing.carry(head, stop, behind);
            behind = stop;
            if space.two_ends(stop) {
                self.at[stop as usize] = 1 - self.at(stop);
                self.locate(space, stop);
            }
            self.next[previous as usize] = stop;
            self.previous[stop as usize] = previous;
            previous = stop;
        }
        self.next[previous as usize] = after;
        self.previous[after as usize] = previous;
    }

    /// Forgets how to go back.
    pub(super) fn commit(&mut self) {
        self.journal.clear();
    }

    /// How many changes there are to take back.
    pub(super) fn changes(&self) -> usize {
        self.journal.len()
    }

    /// Takes changes back until so many are left.
    pub(super) fn undo(&mut self, space: &Space, left: usize) {
        while self.journal.len() > left {
            match self.journal.pop() {
                Some(Change::Placed(touch, at)) => self.set(space, touch, at),
                Some(Change::Shifted(first, last, from)) => self.carry(first, last, from),
                Some(Change::Turned(first, last)) => self.reverse(space, first, last),
                Some(Change::Opened(anchor)) => self.take_down(anchor),
                Some(Change::Closed(anchor, host, at)) => {
                    self.spare.pop();
                    self.hang(space, anchor, host, at);
                }
                None => return,
            }
        }
    }

    /// Whether links, order of finishing, ranks and precedence hold: for debug assertions.
    pub(super) fn is_sound(&self, space: &Space) -> bool {
        let label = |i: u32| self.closing.label(i);
        let linked = (0..index(self.next.len())).filter(|&t| self.is_live(t)).all(|t| {
            let next = self.next(t);
            let kids = self.kids(self.item(t));
            let hung = t <= self.home || (kids.contains(&t) && next != t);
            self.previous(next) == t && self.route(next) == self.route(t) && hung
        });
        let inside = |stop: u32| {
            let route = self.route(stop);
            let previous = self.previous(stop);
            let after = self.is_anchor(previous) || label(previous) < label(self.head(stop));
            after && (route == self.home || label(stop) < label(self.item(route)))
        };
        let mut before = 0;
        let ranked =
            self.closing.stretch(self.closing.next(self.home), self.closing.previous(self.home)).all(|i| {
                let rank = space.rank[i as usize];
                let of_host =
                    self.route(i) == self.home || space.rank[self.item(self.route(i)) as usize] == rank;
                std::mem::replace(&mut before, rank) <= rank && of_host
            });
        let waits = |i: u32| space.precedence.waits(i, |o| label(o) < label(i));
        linked && (0..self.home).all(|i| inside(i) && !waits(i)) && ranked
    }

    /// The visits, with each touch at the place along its item that `along` says.
    pub(super) fn stops(&self, space: &Space, along: impl Fn(u32) -> f64) -> Vec<Stop> {
        let mut out = Vec::with_capacity(self.home as usize);
        let visit = |from: u32, to: u32| Stop {
            until: along(to),
            along: along(from),
            ..space.stop(self.item(from), self.at(from))
        };
        // Items left unfinished: how many of their routes are done, and the touch they were left at.
        let mut open: Vec<(u32, usize, u32)> = Vec::new();
        let mut touch = self.next(self.home);
        loop {
            if !self.is_anchor(touch) {
                if self.kids(touch).is_empty() {
                    out.push(visit(touch, touch));
                    touch = self.next(touch);
                    continue;
                }
                open.push((touch, 0, touch));
            }
            // Begun, or at the end of a route that hangs from it: on with the item.
            let Some((host, done, from)) = open.pop() else { return out };
            let Some(&kid) = self.kids(host).get(done) else {
                out.push(visit(from, host));
                touch = self.next(host);
                continue;
            };
            // Routes from one place follow each other without going back to it, and those from the entry come before the
            // item: both cost no more, and leave it less often.
            #[expect(clippy::float_cmp, reason = "the same place is the same number")]
            let same = along(kid) == along(from);
            if !same {
                out.push(visit(from, kid));
            }
            open.push((host, done + 1, if same { from } else { kid }));
            touch = self.next(kid);
        }
    }
}
