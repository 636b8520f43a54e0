//! A kick: a local change, mended by local search, and kept or taken back.

use super::super::exchange::exchange;
use super::super::few::ENTER_ANEW;
use super::super::improve::improve;
use super::super::rebuild::rebuild;
use super::Annealing;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Draw;

impl Annealing<'_> {
    pub(super) fn kick(&mut self) {
        // Drawing a kick costs too, also one that precedence forbids.
        self.tour.priced += 1;
        self.kicks += 1;
        let heat = {
            let left = 1.0 - self.kicks as f64 / self.kicks_wanted as f64;
            self.temperature * left * left
        };
        let Self { tour, near, queue, rng, .. } = self;
        let change = if self.rebuilds > 0 && rng.below(100) < self.rebuilds {
            rebuild(tour, near, queue, rng)
        } else {
            exchange(tour, queue, rng)
        };
        let Some(mut change) = change else {
            while queue.pop().is_some() {}
            tour.undo();
            return;
        };
        while let Some(item) = self.queue.pop() {
            change -= improve(&mut self.tour, &self.near, &mut self.queue, item);
        }
        let most = self.top.cost + ENTER_ANEW * self.mean.unwrap_or(0.0);
        if self.few && change.abs() > EPSILON && self.cost + change < most {
            change -= self.settled_anew(self.cost + change);
        }
        if !self.rng.accepts(change, heat) {
            self.tour.undo();
            return;
        }
        // Also before a change that costs nothing: which of two equal tours is kept must not depend on slices.
        if self.top.unsaved && self.cost + change >= self.top.cost - EPSILON {
            self.top.kept = self.tour.before();
            self.top.unsaved = false;
        }
        self.cost += change;
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "a move broke precedence");
        self.tour.commit();
        if self.cost < self.top.cost - EPSILON {
            self.top.cost = self.cost;
            self.top.unsaved = true;
        }
    }
}
