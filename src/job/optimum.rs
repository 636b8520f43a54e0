//! Proof that a path is optimal, for jobs of few contours. The lower bound needs a good path to compare with, so a search of its own
//! runs beside it. For more contours it only proves a bound, which is the stronger one up to some hundred contours.

use super::warm_path::{self, WarmPath};
use crate::plan::{LowerBound, WalkCertificate};
use crate::problem::Problem;
use crate::solve::{self, Running, Solution};

/// Work on the bound between two pieces of the search, and the moves of such a piece: about a third of the time, until the search has
/// made [`ENOUGH`] moves.
pub(super) const TURN: u32 = 1_000_000;
const MOVES: u64 = 10_000;
/// Where legs are priced by mixtures of the known path, the search goes first for so many moves, because the mixtures of a poor path are of little
/// use for better ones. Elsewhere this gains nothing.
const ALONE: u64 = 300_000;
/// Moves of each of these turns.
const MOVES_ALONE: u64 = 100_000;
/// A path is proven optimal when the bound is no more than this share of its travel below it: twice what a look at all orders leaves.
const PROVEN: f64 = 2e-7;
/// The search ends here: beyond, it hardly ever finds a better path over 128 contours.
const ENOUGH: u64 = 20_000_000;

/// A search and a lower bound that work until they meet.
pub(super) struct Optimum {
    running: Running,
    bound: LowerBound,
    moves: u64,
    /// Moves after which the bound begins.
    begins: u64,
    /// The cost of the path that the bound was told of last, s.
    told: f64,
    more: bool,
}

impl Optimum {
    /// `warm`: a path that is known. `None` for jobs of too many contours for walks. All orders are looked at up to 128.
    pub(super) fn new(problem: &Problem, warm: Option<&Solution>) -> Option<Self> {
        (problem.items.len() <= LowerBound::MOST_BY_WALKS).then(|| {
            let bound = LowerBound::new(problem);
            let begins = if bound.learns_of_paths() { ALONE } else { 0 };
            let running = Running::new(problem.clone(), |p| solve::methods()[0].start(p, 1, warm));
            Self { running, bound, moves: 0, begins, told: f64::INFINITY, more: true }
        })
    }

    /// A piece of the search, and [`TURN`] more numbers of the bound. Returns whether more work may help.
    pub(super) fn turn(&mut self) -> bool {
        if self.more {
            if self.moves < self.begins {
                self.search(MOVES_ALONE);
                return true;
            }
            if self.moves < ENOUGH {
                self.search(MOVES);
            }
            let best = self.running.borrow_dependent().best();
            if best.cost < self.told {
                self.told = best.cost;
                self.bound.knows(self.running.borrow_owner(), best);
            }
            self.more = self.bound.improve(TURN, best.cost);
            self.take_over();
        }
        self.more
    }

    fn search(&mut self, moves: u64) {
        self.moves += moves;
        self.running.with_dependent_mut(|_, search| search.step(moves));
    }

    /// Whether the best path is proven optimal: nothing is left to do.
    pub(super) fn is_proven(&self) -> bool {
        let travel = self.cost() + self.running.borrow_owner().most_saved();
        !self.more && self.value() >= travel * (1.0 - PROVEN)
    }

    /// Offers the search a better path that the bound has found, so that its own paths and that of the bound are compared in one place.
    fn take_over(&mut self) {
        self.running.with_dependent_mut(|problem, search| {
            let found = self.bound.better_than(search.best().cost, problem);
            let priced = found.map(|path| solve::priced(problem, path));
            if let Some(path) = priced.filter(|path| warm_path::is_feasible(&path.stops, problem)) {
                search.offer(&path);
            }
        });
    }

    /// The best path that the search or the bound has found. `None` if it cannot be told by contours and places.
    pub(super) fn path(&self) -> Option<WarmPath> {
        warm_path::of(self.running.borrow_dependent().best(), self.running.borrow_owner())
    }

    /// The cost of this path, s.
    pub(super) fn cost(&self) -> f64 {
        self.running.borrow_dependent().best().cost
    }

    /// The certificate of the bound by walks or by all orders, if it proves more than `above`, s.
    pub(super) fn certificate(&self, above: f64) -> Option<WalkCertificate> {
        self.bound.certificate(self.running.borrow_owner(), above)
    }

    /// No path has less travel, s.
    pub(super) fn value(&self) -> f64 {
        self.bound.value()
    }
}
