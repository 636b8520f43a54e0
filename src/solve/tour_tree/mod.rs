//! `tour-tree`, the default method: order, entry and direction searched together, good at any moment.
//!
//! 1. At once: nearest next (`greedy`), the first feasible path.
//! 2. Neighbour lists by gate (`neighbours.rs`), then local search over the whole tour (`improve.rs`).
//! 3. Cycles of annealed kicks, each twice as long as the one before (`anneal.rs`): first free of the nesting, then
//!    repaired (`repair.rs`) and within it.
//! 4. Entries slide to the exact minimum at the end of every cycle (`polish.rs`).
//!
//! So far one route, the root: children (leaving a contour unfinished) come with the charges that they need.
//! Sources: neighbour lists and queue instead of don't-look bits: Bentley, ORSA J. Computing 4 (1992); Or-opt: Or,
//! PhD thesis, Northwestern (1976); gain criterion: Lin & Kernighan, Operations Research 21 (1973); segment
//! double-bridge kicks: Martin, Otto & Felten, Complex Systems 5 (1991), local as in Applegate, Cook & Rohe, INFORMS
//! J. Computing 15 (2003); precedence by exchange of neighbouring stretches: Gambardella & Dorigo, INFORMS J.
//! Computing 12 (2000).

mod anneal;
mod dice;
mod entries;
mod exchange;
mod improve;
mod neighbours;
mod polish;
mod rebuild;
mod repair;
mod ring;
mod space;
#[cfg(test)]
mod tests;
mod tour;
mod travel;

use super::greedy::greedy;
use super::traits::{Search, Solution, Solver, SolverInfo, Status, Step, Telemetry};
use crate::problem::Problem;
use anneal::Annealing;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use space::Space;
use tour::Tour;

/// The method.
pub(super) struct TourTree;

impl Solver for TourTree {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "tour-tree",
            title: "Kerfway",
            about: "Order, entry and direction searched together: local search with annealed kicks, better every \
                    moment.",
            source: None,
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let first = warm.cloned().unwrap_or_else(|| greedy(problem));
        let space = Space::new(problem);
        let kept = space.kept(&first);
        let tour = Tour::new(space, kept);
        let rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        Box::new(TourTreeSearch { annealing: Annealing::new(tour, rng), granted: 0, best: first, best_at: 0 })
    }
}

struct TourTreeSearch<'p> {
    annealing: Annealing<'p>,
    /// Work handed out so far: what one slice did too much, the next does less.
    granted: u64,
    best: Solution,
    best_at: u64,
}

impl TourTreeSearch<'_> {
    /// Takes a solution over, if it is better.
    fn take(&mut self, found: Solution) {
        if found.cost < self.best.cost {
            self.best = found;
            self.best_at = self.annealing.priced();
        }
    }
}

impl Search for TourTreeSearch<'_> {
    fn step(&mut self, work: u64) -> Step {
        let cost = self.best.cost;
        self.granted = self.granted.saturating_add(work);
        while !self.annealing.is_finished() && self.annealing.priced() < self.granted {
            if self.annealing.advance() {
                self.take(polish::polished(self.annealing.tour(), self.annealing.best().1));
            }
        }
        self.annealing.save();
        let (seconds, kept) = self.annealing.best();
        if seconds < self.best.cost {
            self.take(polish::unpolished(self.annealing.tour(), kept));
        }
        let (status, done) =
            if self.annealing.is_finished() { (Status::Exhausted, 0) } else { (Status::Running, work) };
        Step { status, done, improved: self.best.cost < cost }
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.annealing.priced(), best_at: self.best_at, best: self.best.cost }
    }

    fn offer(&mut self, other: &Solution) {
        if other.cost < self.best.cost {
            let kept = self.annealing.tour().space.kept(other);
            self.annealing.offer(other.cost, kept);
            self.take(other.clone());
        }
    }
}
