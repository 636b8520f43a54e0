//! One kick: a random change, then local search around it, then the decision whether the result stays.

use super::super::config::CONFIG;
use super::super::exchange::{draw_stretches, exchange};
use super::super::improve::improve;
use super::super::long_legs::{draw_between_long_legs, heat};
use super::super::ruin_recreate::ruin_recreate;
use super::Annealing;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Draw;

impl Annealing<'_> {
    /// One kick of the current part.
    pub(super) fn kick(&mut self) {
        // Drawing a kick counts as a move, also when precedence forbids the kick.
        self.tour.priced += 1;
        self.kicks += 1;
        let mut temperature = {
            let left = 1.0 - self.kicks as f64 / self.kicks_wanted as f64;
            self.temperature * left * left
        };
        let mean_leg = self.mean_leg.unwrap_or(0.0);
        let cuts_long_legs = self.long_legs_percent > 0 && self.rng.below(100) < self.long_legs_percent;
        let Self { tour, near, queue, rng, .. } = self;
        let change = if self.ruin_percent > 0 && rng.below(100) < self.ruin_percent {
            ruin_recreate(tour, near, queue, rng)
        } else if cuts_long_legs {
            draw_between_long_legs(tour, rng).and_then(|stretches| {
                temperature *= heat(tour, stretches, mean_leg);
                exchange(tour, queue, rng, stretches)
            })
        } else {
            draw_stretches(tour, rng, CONFIG.kick.longest).and_then(|s| exchange(tour, queue, rng, s))
        };
        let Some(mut change) = change else {
            while queue.pop().is_some() {}
            tour.undo();
            return;
        };
        while let Some(item) = self.queue.pop() {
            change -= improve(&mut self.tour, &self.near, &mut self.queue, item);
        }
        let most = self.part_best.cost + CONFIG.small.reassign_margin * mean_leg;
        if self.is_small && change.abs() > EPSILON && self.cost + change < most {
            change -= self.settle_again(self.cost + change);
        }
        if !self.rng.accepts(change, temperature) {
            self.tour.undo();
            return;
        }
        // This holds for a change that costs nothing too: which of two equal tours is the best must not depend on how
        // the work is sliced.
        if self.part_best.unsaved && self.cost + change >= self.part_best.cost - EPSILON {
            self.part_best.snapshot = self.tour.before_journal();
            self.part_best.unsaved = false;
        }
        self.cost += change;
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "a move broke precedence");
        self.tour.commit();
        if self.cost < self.part_best.cost - EPSILON {
            self.part_best.cost = self.cost;
            self.part_best.unsaved = true;
        }
    }
}
