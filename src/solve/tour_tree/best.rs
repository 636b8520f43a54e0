//! The best path so far. Where the search over the root found it, it is a tour, made a solution only when somebody looks:
//! on 10,000 contours that takes as long as a slice of work, and slices follow one another faster than anybody looks.

use super::kept::Kept;
use super::polish::unpolished;
use super::tour::Tour;
use crate::solve::Solution;
use std::cell::OnceCell;

pub(super) struct Best {
    /// Seconds; those of the solution but for the rounding of sums.
    cost: f64,
    /// The tour the solution is made of, unless it was one from the start.
    kept: Option<Kept>,
    solution: OnceCell<Solution>,
    /// Moves at which it was found.
    pub(super) at: u64,
}

impl Best {
    pub(super) fn new(solution: Solution, at: u64) -> Self {
        Self { cost: solution.cost, kept: None, solution: OnceCell::from(solution), at }
    }

    pub(super) fn cost(&self) -> f64 {
        self.cost
    }

    pub(super) fn solution(&self, tour: &Tour) -> &Solution {
        self.solution
            .get_or_init(|| self.kept.as_ref().map_or_else(Solution::default, |kept| unpolished(tour, kept)))
    }

    /// Takes a solution over, if it is better.
    pub(super) fn take(&mut self, found: Solution, at: u64) {
        if found.cost < self.cost {
            *self = Self::new(found, at);
        }
    }

    /// Takes a tour over that takes `cost` seconds, if it is better.
    pub(super) fn take_tour(&mut self, cost: f64, kept: &Kept, at: u64) {
        if cost < self.cost {
            *self = Self { cost, kept: Some(kept.clone()), solution: OnceCell::new(), at };
        }
    }
}
