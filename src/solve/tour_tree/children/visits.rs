//! Conversion of a solution to a tree of routes and back.

use super::super::index::index;
use super::super::space::Space;
use super::finish_order::FinishOrder;
use super::tree::{NONE, Tree};
use crate::solve::{Solution, Stop};

impl Tree {
    /// The routes of a solution that visits every item, entered and left at the places nearest to its own.
    pub(super) fn new(space: &Space, solution: &Solution) -> Self {
        let home = space.home;
        let touches = 2 * home as usize + 1;
        let mut tree = Self {
            home,
            closed: space.problem.closed,
            item: (0..=home).chain(std::iter::repeat_n(home, home as usize)).collect(),
            at: vec![0; touches],
            entry: vec![space.problem.home.into(); touches],
            exit: vec![space.problem.home.into(); touches],
            next: (0..index(touches)).collect(),
            previous: (0..index(touches)).collect(),
            route: vec![NONE; touches],
            anchors: vec![Vec::new(); home as usize + 1],
            spare: (home + 1..index(touches)).rev().collect(),
            finish_order: FinishOrder::new(home),
            journal: Vec::new(),
            priced: 0,
        };
        tree.route[home as usize] = home;
        tree.fill(space, solution);
        tree
    }

    fn fill(&mut self, space: &Space, solution: &Solution) {
        // `tail`: the touch after which the next stop goes. `open`: unfinished items, with the place where each began.
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
                self.finish_order.append(item);
            } else {
                open.push((item, start));
                let mut at = space.left_at(stop);
                if at == self.at[item as usize] && !space.leave_places.is_group(item) {
                    // The nearest place is the entry: one place ahead or back keeps the anchor on its side of it.
                    let count = index(space.places(item).len());
                    let perimeter = space.perimeter(item);
                    let ahead = (stop.until - start).rem_euclid(perimeter) < 0.5 * perimeter;
                    at = (at + if ahead { 1 } else { count - 1 }) % count;
                }
                tail = self.open(space, item, at);
            }
        }
        self.journal.clear();
    }

    /// Whether links, order of finishing, ranks and precedence hold. For debug assertions.
    pub(super) fn is_sound(&self, space: &Space) -> bool {
        let label = |i: u32| self.finish_order.label(i);
        let linked = (0..index(self.next.len())).filter(|&t| self.is_live(t)).all(|t| {
            let next = self.next(t);
            let anchors = self.anchors(self.item(t));
            let hung = t <= self.home || (anchors.contains(&t) && next != t);
            self.previous(next) == t && self.route(next) == self.route(t) && hung
        });
        let inside = |stop: u32| {
            let route = self.route(stop);
            let previous = self.previous(stop);
            let after = self.is_anchor(previous) || label(previous) < label(self.head(stop));
            after && (route == self.home || label(stop) < label(self.item(route)))
        };
        let mut before = 0;
        let ranked = self
            .finish_order
            .stretch(self.finish_order.next(self.home), self.finish_order.previous(self.home))
            .all(|i| {
                let rank = space.rank[i as usize];
                let of_host =
                    self.route(i) == self.home || space.rank[self.item(self.route(i)) as usize] == rank;
                std::mem::replace(&mut before, rank) <= rank && of_host
            });
        let waits = |i: u32| space.precedence.waits(i, |o| label(o) < label(i));
        linked
            && self.groups_are_sound(space)
            && (0..self.home).all(|i| space.places(i).is_empty() || (inside(i) && !waits(i)))
            && ranked
    }

    /// The visits of the routes; `along` gives the arc length of each touch along its item, mm.
    pub(super) fn stops(&self, space: &Space, along: impl Fn(u32) -> f64) -> Vec<Stop> {
        let mut out = Vec::with_capacity(self.home as usize);
        let visit = |from: u32, to: u32| {
            // A visit of a pierce group has the node of its path.
            let item = self.item(from);
            let begun = if space.leave_places.is_group(item) { item } else { from };
            Stop { until: along(to), along: along(from), ..space.stop(item, self.at(begun)) }
        };
        // Unfinished items: the host, how many of its routes are done, and the touch where it was left.
        let mut open: Vec<(u32, usize, u32)> = Vec::new();
        let mut touch = self.next(self.home);
        loop {
            if !self.is_anchor(touch) {
                if self.anchors(touch).is_empty() {
                    out.push(visit(touch, touch));
                    touch = self.next(touch);
                    continue;
                }
                open.push((touch, 0, touch));
            }
            // The item has just begun, or a route that hangs from it has ended: the item goes on.
            let Some((host, done, from)) = open.pop() else { return out };
            let Some(&kid) = self.anchors(host).get(done) else {
                out.push(visit(from, host));
                touch = self.next(host);
                continue;
            };
            // Routes from one place follow each other without a return to it, and routes from the entry come before the
            // item: neither costs more, and the item is left less often.
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
