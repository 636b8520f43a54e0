//! The cycles of annealing: how long each is, how hot it starts, and what is done with its result.
//!
//! A cycle has two parts. The first part ignores nesting, because the large structure of a good tour is found only where
//! outer contours do not pin it. Its result is repaired (`repair.rs`), and the second part keeps every precedence.
//! Problems without nesting have one part. Each cycle starts from the best tour so far and is half as long again as the
//! one before, so that the search is good at any moment and needs no budget in advance. Small problems have cycles of
//! other lengths and temperatures (`small_instances.rs`).

use super::super::config::CONFIG;
use super::super::improve::improve;
use super::super::recombine::recombine;
use super::super::repair::repaired;
use super::super::small_instances::{CyclePlan, ShortTour};
use super::{Annealing, Stage};
use crate::solve::epsilon::EPSILON;

impl Annealing<'_> {
    /// Restores the best tour and begins the first part of the next cycle.
    pub(super) fn begin_cycle(&mut self) {
        self.tour.restore(self.best.1.clone());
        self.start_part();
        self.tour.ignores_nesting = self.tour.space.precedence.nested_only && !self.is_small;
        self.begin_part(if self.tour.ignores_nesting { CONFIG.cycle.free_percent } else { 100 });
    }

    /// Begins the part of a cycle that keeps every precedence.
    pub(super) fn begin_second_part(&mut self) {
        self.begin_part(100 - CONFIG.cycle.free_percent);
    }

    /// Begins a part that takes a percentage of the cycle.
    fn begin_part(&mut self, percent: u64) {
        let config = CONFIG.cycle;
        let items = self.tour.last() as u64;
        let first_kicks = |per_item: u64| (per_item * items * percent / 100).max(1);
        let plan = if self.is_small {
            CyclePlan::of_small(self.cycle, self.tour.space.problem, first_kicks(config.first_kicks))
        } else {
            let short = ShortTour::of(self.tour.space.problem, items);
            // No machine gets past the 70th cycle; the limit keeps the number of kicks within its type.
            let kicks = (0..self.cycle.min(70)).fold(first_kicks(short.first_kicks), |kicks, _| {
                kicks + kicks.div_ceil(config.growth_divisor)
            });
            let temperature = match self.cycle {
                0 => 1.0,
                _ if self.tour.ignores_nesting || !self.tour.space.precedence.any => config.reheat_free,
                _ => config.reheat,
            };
            CyclePlan { temperature, ruin_percent: short.ruin_percent, kicks }
        };
        self.kicks_wanted = plan.kicks;
        self.kicks = 0;
        self.temperature = config.temperature * self.mean_leg.unwrap_or(0.0) * plan.temperature;
        self.ruin_percent = plan.ruin_percent;
        self.stage = Stage::Kicking;
    }

    /// Goes on after the last kick of a part: repairs the tour after the first one, recombines it after the second.
    pub(super) fn part_ended(&mut self) {
        if self.part_best.unsaved {
            self.save_part();
        }
        if self.tour.ignores_nesting {
            self.tour.ignores_nesting = false;
            let mut least = f64::INFINITY;
            // A repair may tear apart what a person keeps together. Then the best tour goes on.
            let mut goes_on = self.best.1.clone();
            for tour in repaired(&self.tour.space, &self.part_best.snapshot) {
                self.tour.restore(tour.clone());
                let cost = self.tour.cost();
                if cost < least && self.tour.keeps_all_groups() {
                    (least, goes_on) = (cost, tour);
                }
            }
            self.tour.restore(goes_on);
            self.start_part();
            self.settle();
            return;
        }
        self.save();
        self.tour.restore(self.part_best.snapshot.clone());
        self.cost = self.tour.cost();
        // Recombination does not respect groups: with them, no partner has this number.
        let number = if self.tour.space.problem.groups.is_empty() { 0 } else { usize::MAX };
        self.stage = Stage::Recombining(number, self.cost);
    }

    /// Recombines the result of a cycle with one of the elites or with the best tour, by the partner's number; true when
    /// the cycle ends. `before`: the cost before the first partner. All partners are tried again until a round gains
    /// nothing.
    pub(super) fn recombine(&mut self, number: usize, before: f64) -> bool {
        let Self { tour, queue, elites, best, .. } = self;
        if let Some(other) = elites.partner(number, &best.1) {
            let gain = recombine(tour, queue, other);
            // A recombination is never taken back.
            tour.commit();
            self.cost -= gain;
            // The same partner is tried again until it has no better stretch.
            self.stage = Stage::Recombining(number + usize::from(gain <= 0.0), before);
            return false;
        }
        self.cost -= self.settle_again(self.cost);
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "recombination broke precedence");
        if self.cost < before - EPSILON {
            self.stage = Stage::Recombining(0, self.cost);
            return false;
        }
        self.offer(self.cost, self.tour.current().clone());
        self.elites.add(self.part_best.snapshot.clone());
        self.cycle += 1;
        self.begin_cycle();
        true
    }

    /// Local search after a change to a tour of this cost; in small problems all entries are chosen together first.
    /// Returns the seconds gained.
    pub(super) fn settle_again(&mut self, cost: f64) -> f64 {
        let Self { tour, near, queue, layers, .. } = self;
        let mut gain = if self.is_small { layers.enter_best(tour, cost, |i| queue.push(i)) } else { 0.0 };
        while let Some(item) = queue.pop() {
            gain += improve(tour, near, queue, item);
        }
        gain
    }
}
