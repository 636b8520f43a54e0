//! The best path so far. If the search over the root route found it, it is kept as a tour and converted to a solution only
//! when a caller asks: on 10,000 contours the conversion takes as long as a slice of work, and callers seldom ask.

use super::polish::unpolished;
use super::snapshot::TourSnapshot;
use super::tour::Tour;
use crate::solve::Solution;
use std::cell::OnceCell;

/// The best solution, converted on demand.
pub(super) struct Best {
    /// Cost, s; equal to the cost of the solution up to the rounding of sums.
    cost: f64,
    /// The tour to be converted, unless the best was a solution from the start.
    snapshot: Option<TourSnapshot>,
    solution: OnceCell<Solution>,
    /// Number of moves when it was found.
    pub(super) at: u64,
}

impl Best {
    pub(super) fn new(solution: Solution, at: u64) -> Self {
        Self { cost: solution.cost, snapshot: None, solution: OnceCell::from(solution), at }
    }

    pub(super) fn cost(&self) -> f64 {
        self.cost
    }

    pub(super) fn solution(&self, tour: &Tour) -> &Solution {
        self.solution.get_or_init(|| {
            self.snapshot.as_ref().map_or_else(Solution::default, |snapshot| unpolished(tour, snapshot))
        })
    }

    /// Takes over a solution if it costs less.
    pub(super) fn take(&mut self, found: Solution, at: u64) {
        if found.cost < self.cost {
            *self = Self::new(found, at);
        }
    }

    /// Takes over a tour of this cost if it costs less.
    pub(super) fn take_tour(&mut self, cost: f64, snapshot: &TourSnapshot, at: u64) {
        if cost < self.cost {
            *self = Self { cost, snapshot: Some(snapshot.clone()), solution: OnceCell::new(), at };
        }
    }
}
