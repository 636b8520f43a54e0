//! Searches that do their work in pieces, so that they can be run in slices of any size.
//!
//! A method divides its work into pieces and states the cost of each in moves. The next piece starts only when slices have
//! paid for the last one. So the result does not depend on how the work is sliced, and a piece larger than a slice is paid
//! for by the slices after it. [`Progress`] keeps the best solution, the moves done and the moves still owed.

use crate::problem::{NodeId, Problem};
use crate::solve::Insight;
use crate::solve::{Search, Solution, Status, Step, Stop, Telemetry};

/// The best solution by the measure of the method, and the moves done.
pub(super) struct Progress {
    solution: Solution,
    /// Length of the best solution, by the method's measure.
    pub(super) length: f64,
    /// Moves done before the piece that found the best solution.
    at: u64,
    changed: bool,
    /// Moves of all pieces so far, including those still owed. During a piece this number does not depend on slices.
    spent: u64,
    owed: u64,
}

impl Progress {
    /// Starts with a first solution and its length.
    pub(super) fn new(solution: Solution, length: f64) -> Self {
        Self { solution, length, at: 0, changed: false, spent: 0, owed: 0 }
    }

    /// The best solution.
    pub(super) fn solution(&self) -> &Solution {
        &self.solution
    }

    /// Replaces the best solution by a shorter one, which the current piece found.
    pub(super) fn take(&mut self, length: f64, solution: impl FnOnce() -> Solution) {
        if length < self.length {
            let solution = solution();
            // Two codes may differ in length and still represent the same path.
            self.changed |= solution != self.solution;
            (self.solution, self.length, self.at) = (solution, length, self.spent);
        }
    }
}

/// Converts a tour to a solution.
pub(super) fn solution(problem: &Problem, tour: &[NodeId]) -> Solution {
    Solution::new(problem, tour.iter().map(|&n| Stop::at(problem, n)).collect())
}

/// A method that works in pieces. No piece may take more than a few milliseconds, however large the problem is.
pub(super) trait Piecewise {
    /// The progress so far.
    fn progress(&self) -> &Progress;
    /// The progress so far, for changing it.
    fn progress_mut(&mut self) -> &mut Progress;
    /// Does the next piece of work and returns its cost in moves, or `None` when the method has finished.
    fn piece(&mut self) -> Option<u64>;
    /// Values for charts.
    fn insight(&self) -> Insight;
}

/// Runs a method that works in pieces as a [`Search`].
pub(super) struct PiecewiseSearch<M>(pub(super) M);

impl<M: Piecewise> PiecewiseSearch<M> {
    /// Does at most `work` moves. Returns how many were done, and whether the search continues.
    fn work(&mut self, work: u64) -> (u64, Status) {
        let mut left = work;
        loop {
            let progress = self.0.progress_mut();
            let paid = left.min(progress.owed);
            progress.owed -= paid;
            left -= paid;
            if left == 0 {
                return (work, Status::Running);
            }
            let Some(cost) = self.0.piece() else { return (work - left, Status::Exhausted) };
            let progress = self.0.progress_mut();
            progress.owed = cost.max(1);
            progress.spent += cost.max(1);
        }
    }
}

impl<M: Piecewise> Search for PiecewiseSearch<M> {
    fn step(&mut self, work: u64) -> Step {
        let (done, status) = self.work(work);
        let improved = std::mem::take(&mut self.0.progress_mut().changed);
        Step { status, done, improved }
    }

    fn best(&self) -> &Solution {
        &self.0.progress().solution
    }

    fn telemetry(&self) -> Telemetry {
        let progress = self.0.progress();
        Telemetry {
            moves: progress.spent - progress.owed,
            best_at: progress.at,
            best: progress.solution.cost,
        }
    }

    fn insight(&self) -> Option<Insight> {
        Some(self.0.insight())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces that cost 1, 2, 3 ... 9 moves.
    struct Count(Progress, u64);

    impl Piecewise for Count {
        fn progress(&self) -> &Progress {
            &self.0
        }

        fn progress_mut(&mut self) -> &mut Progress {
            &mut self.0
        }

        fn piece(&mut self) -> Option<u64> {
            self.1 += 1;
            Some(self.1).filter(|&n| n < 10)
        }

        fn insight(&self) -> Insight {
            Insight::default()
        }
    }

    #[test]
    fn slices_of_any_size_do_the_same_pieces() {
        let begun = || PiecewiseSearch(Count(Progress::new(Solution::default(), 0.0), 0));
        for total in 1..50 {
            let mut whole = begun();
            let (done, status) = whole.work(total);
            let mut sliced = begun();
            let more: u64 = (0..total).map(|_| sliced.work(1).0).sum();
            assert_eq!((done, whole.telemetry().moves), (more, more), "{total}");
            assert_eq!(status == Status::Exhausted, total > 45, "all pieces cost 45");
            // A piece runs as soon as all pieces before it are paid for.
            let begun = (1..10).take_while(|n| n * (n - 1) / 2 < total).count() as u64;
            assert_eq!(whole.0.1.min(9), begun);
        }
    }
}
