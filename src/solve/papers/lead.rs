//! The best of a method that works in pieces, and the method as a search.

use super::insight::Insight;
use super::pace::{Pieces, work_on};
use crate::solve::{Search, Solution, Step, Telemetry};

/// The best so far by the measure of a method.
pub(super) struct Lead {
    pub(super) solution: Solution,
    /// By the method's measure.
    pub(super) length: f64,
    /// Moves before the piece that found it.
    at: u64,
    changed: bool,
}

impl Lead {
    /// The first one.
    pub(super) fn new(solution: Solution, length: f64) -> Self {
        Self { solution, length, at: 0, changed: false }
    }

    /// Takes a shorter one, found after so many moves.
    pub(super) fn take(&mut self, length: f64, at: u64, solution: impl FnOnce() -> Solution) {
        if length < self.length {
            let solution = solution();
            // Codes may differ in length and stand for one path.
            let changed = self.changed || solution != self.solution;
            *self = Self { solution, length, at, changed };
        }
    }
}

/// A method of pieces with a best.
pub(super) trait Led: Pieces {
    /// Its best.
    fn lead(&self) -> &Lead;
    /// Its best, to be changed.
    fn lead_mut(&mut self) -> &mut Lead;
    /// Moves done.
    fn done(&self) -> u64;
    /// For charts.
    fn insight(&self) -> Insight;
}

/// Such a method as a search.
pub(super) struct Running<M>(pub(super) M);

impl<M: Led> Search for Running<M> {
    fn step(&mut self, work: u64) -> Step {
        let (done, status) = work_on(&mut self.0, work);
        let improved = std::mem::take(&mut self.0.lead_mut().changed);
        Step { status, done, improved }
    }

    fn best(&self) -> &Solution {
        &self.0.lead().solution
    }

    fn telemetry(&self) -> Telemetry {
        let lead = self.0.lead();
        Telemetry { moves: self.0.done(), best_at: lead.at, best: lead.solution.cost }
    }

    fn insight(&self) -> Insight {
        self.0.insight()
    }
}
