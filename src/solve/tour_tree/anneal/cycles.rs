//! What a cycle is made of, and what it ends in.
//!
//! A cycle has two parts. The first ignores nesting, because the large structure of a good tour is found only
//! where outer contours do not pin it; its result is repaired (`repair.rs`), and the second part goes on with every
//! precedence kept. Each cycle starts from the best path so far and is half as long again as the one before, so that
//! the search is good at any moment and needs no budget in advance. Without nesting there is one part. Problems with few
//! places have cycles that double every second time, or hardly grow (`few.rs`). What was measured for each constant is in
//! `docs/internals/tuning.md`.

use super::super::crossing::cross;
use super::super::few::{Small, Turn};
use super::super::improve::improve;
use super::super::repair::repaired;
use super::{Annealing, Stage};
use crate::solve::epsilon::EPSILON;

/// Kicks per item in the first cycle: more ends lower, but shows the first improvement later.
const FIRST_CYCLE: u64 = 2;
/// Percentage of a cycle that ignores nesting: enough to find the large structure of the tour, which nesting would pin.
const FREE_SHARE: u64 = 60;
/// Temperature at the start of the first cycle, in mean legs between neighbours: less stays in the first local optimum, more forgets it.
const HEAT: f64 = 0.3;
/// Temperature of later cycles that keep precedence, relative to the first: they refine the best path, and more spoils it.
const REHEAT: f64 = 0.3;
/// The same while nesting is ignored: hot enough for another route around the sheet; recombination restores the details.
const REHEAT_FREE: f64 = 2.5;

impl Annealing<'_> {
    pub(super) fn begin_cycle(&mut self) {
        self.tour.put(self.best.1.clone());
        self.start_top();
        self.tour.free = self.tour.space.precedence.nested_only && !self.few;
        self.begin_part(if self.tour.free { FREE_SHARE } else { 100 });
    }

    /// Within the nesting.
    pub(super) fn begin_second_part(&mut self) {
        self.begin_part(100 - FREE_SHARE);
    }

    fn begin_part(&mut self, share: u64) {
        let items = self.tour.last() as u64;
        let first = |per_item: u64| (per_item * items * share / 100).max(1);
        let turn = if self.few {
            Turn::of(self.cycle, self.tour.space.problem, first(FIRST_CYCLE))
        } else {
            let Small { first_cycle, rebuilds } = Small::of(self.tour.space.problem, items, FIRST_CYCLE);
            // Past so many cycles no machine arrives.
            let kicks =
                (0..self.cycle.min(70)).fold(first(first_cycle), |kicks, _| kicks + kicks.div_ceil(2));
            let heat = match self.cycle {
                0 => 1.0,
                _ if self.tour.free => REHEAT_FREE,
                _ => REHEAT,
            };
            Turn { heat, rebuilds, kicks }
        };
        self.kicks_wanted = turn.kicks;
        self.kicks = 0;
        self.temperature = HEAT * self.mean.unwrap_or(0.0) * turn.heat;
        self.rebuilds = turn.rebuilds;
        self.stage = Stage::Kicking;
    }

    pub(super) fn part_ended(&mut self) {
        if self.top.unsaved {
            self.save_top();
        }
        if self.tour.free {
            self.tour.free = false;
            let [ahead, back] = repaired(&self.tour.space, &self.top.kept);
            self.tour.put(ahead.clone());
            let cost = self.tour.cost();
            self.tour.put(back);
            if cost <= self.tour.cost() {
                self.tour.put(ahead);
            }
            self.start_top();
            self.settle();
            return;
        }
        self.save();
        self.tour.put(self.top.kept.clone());
        self.cost = self.tour.cost();
        // Stretches know no groups.
        let number = if self.tour.space.problem.groups.is_empty() { 0 } else { usize::MAX };
        self.stage = Stage::Crossing(number, self.cost);
    }

    /// Crosses the tour that a cycle ended in with what earlier cycles ended in and the best, one after the other,
    /// until that gains no more; true when the cycle ended with it.
    pub(super) fn cross(&mut self, number: usize, before: f64) -> bool {
        let Self { tour, queue, elites, best, .. } = self;
        if let Some(other) = elites.partner(number, &best.1) {
            let gain = cross(tour, queue, other);
            // It is never taken back.
            tour.commit();
            self.cost -= gain;
            // Again with the same one, until it has nothing better.
            self.stage = Stage::Crossing(number + usize::from(gain <= 0.0), before);
            return false;
        }
        self.cost -= self.settled_anew(self.cost);
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "crossing broke precedence");
        if self.cost < before - EPSILON {
            self.stage = Stage::Crossing(0, self.cost);
            return false;
        }
        self.offer(self.cost, self.tour.now().clone());
        self.elites.keep(self.top.kept.clone());
        self.cycle += 1;
        self.begin_cycle();
        true
    }

    /// All entries of a tour of this cost at once where items are few, and what the local search makes of it; gives
    /// the seconds gained.
    pub(super) fn settled_anew(&mut self, cost: f64) -> f64 {
        let Self { tour, near, queue, layers, .. } = self;
        let mut gain = if self.few { layers.enter_best(tour, cost, |i| queue.push(i)) } else { 0.0 };
        while let Some(item) = queue.pop() {
            gain += improve(tour, near, queue, item);
        }
        gain
    }
}
