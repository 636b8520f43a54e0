//! Work in slices. A method is a row of pieces, each with its cost in moves, and goes on with the next piece only when
//! the last one is paid for: so it comes to the same however its work is sliced, and a piece larger than a slice is
//! paid for by the slices after it. What it has done, what it owes and what it has found are kept in one place.

use crate::problem::{NodeId, Problem};
use crate::solve::Insight;
use crate::solve::{Search, Solution, Status, Step, Stop, Telemetry};

/// The best so far by the measure of a method, and the moves done.
pub(super) struct Lead {
    solution: Solution,
    /// By the method's measure.
    pub(super) length: f64,
    /// Moves before the piece that found it.
    at: u64,
    changed: bool,
    /// Moves done, those owed too: a number that does not depend on slices while a piece is worked.
    spent: u64,
    owed: u64,
}

impl Lead {
    /// The first one.
    pub(super) fn new(solution: Solution, length: f64) -> Self {
        Self { solution, length, at: 0, changed: false, spent: 0, owed: 0 }
    }

    /// The best so far.
    pub(super) fn solution(&self) -> &Solution {
        &self.solution
    }

    /// Takes a shorter one, found by the piece in work.
    pub(super) fn take(&mut self, length: f64, solution: impl FnOnce() -> Solution) {
        if length < self.length {
            let solution = solution();
            // Codes may differ in length and stand for one path.
            self.changed |= solution != self.solution;
            (self.solution, self.length, self.at) = (solution, length, self.spent);
        }
    }
}

/// A tour as a solution.
pub(super) fn solution(problem: &Problem, tour: &[NodeId]) -> Solution {
    Solution::new(problem, tour.iter().map(|&n| Stop::at(problem, n)).collect())
}

/// A method made of pieces. None may take more than a few milliseconds, however large the problem.
pub(super) trait Pieces {
    /// Its best.
    fn lead(&self) -> &Lead;
    /// Its best, to be changed.
    fn lead_mut(&mut self) -> &mut Lead;
    /// Works the next piece; its cost in moves, or nothing at the end.
    fn piece(&mut self) -> Option<u64>;
    /// For charts.
    fn insight(&self) -> Insight;
}

/// Such a method as a search.
pub(super) struct Running<M>(pub(super) M);

impl<M: Pieces> Running<M> {
    /// At most `work` moves; how many were done, and whether it goes on.
    fn work(&mut self, work: u64) -> (u64, Status) {
        let mut left = work;
        loop {
            let lead = self.0.lead_mut();
            let paid = left.min(lead.owed);
            lead.owed -= paid;
            left -= paid;
            if left == 0 {
                return (work, Status::Running);
            }
            let Some(cost) = self.0.piece() else { return (work - left, Status::Exhausted) };
            let lead = self.0.lead_mut();
            lead.owed = cost.max(1);
            lead.spent += cost.max(1);
        }
    }
}

impl<M: Pieces> Search for Running<M> {
    fn step(&mut self, work: u64) -> Step {
        let (done, status) = self.work(work);
        let improved = std::mem::take(&mut self.0.lead_mut().changed);
        Step { status, done, improved }
    }

    fn best(&self) -> &Solution {
        &self.0.lead().solution
    }

    fn telemetry(&self) -> Telemetry {
        let lead = self.0.lead();
        Telemetry { moves: lead.spent - lead.owed, best_at: lead.at, best: lead.solution.cost }
    }

    fn insight(&self) -> Option<Insight> {
        Some(self.0.insight())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of 1, 2, 3 ... 9 moves; the sum of their numbers.
    struct Count(Lead, u64);

    impl Pieces for Count {
        fn lead(&self) -> &Lead {
            &self.0
        }

        fn lead_mut(&mut self) -> &mut Lead {
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
        let begun = || Running(Count(Lead::new(Solution::default(), 0.0), 0));
        for total in 1..50 {
            let mut whole = begun();
            let (done, status) = whole.work(total);
            let mut sliced = begun();
            let more: u64 = (0..total).map(|_| sliced.work(1).0).sum();
            assert_eq!((done, whole.telemetry().moves), (more, more), "{total}");
            assert_eq!(status == Status::Exhausted, total > 45, "all pieces cost 45");
            // A piece is worked as soon as the ones before it are paid for.
            let begun = (1..10).take_while(|n| n * (n - 1) / 2 < total).count() as u64;
            assert_eq!(whole.0.1.min(9), begun);
        }
    }
}
