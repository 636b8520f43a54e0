//! Proof that a path is optimal, for jobs of few contours. The lower bound needs a good path to compare with, so a search of its own
//! runs beside it. For more contours it only proves a bound, which is the stronger one up to some hundred contours.

use crate::plan::{LowerBound, WalkCertificate};
use crate::problem::Problem;
use crate::solve::{self, Running};

/// Most contours: with more, the bound is not by walks. All orders are looked at up to 128.
const MOST: usize = 220;
/// Work on the bound between two pieces of the search, and the moves of such a piece: about a third of the time, until the search has
/// made [`ENOUGH`] moves.
const TURN: u32 = 1_000_000;
const MOVES: u64 = 10_000;
/// The search ends here: beyond, it hardly ever finds a better path over 128 contours.
const ENOUGH: u64 = 20_000_000;

/// A search and a lower bound that work until they meet.
pub(super) struct Optimum {
    running: Running,
    bound: LowerBound,
    moves: u64,
    /// Work that is granted and not yet done: less than a turn.
    left: u64,
    more: bool,
}

impl Optimum {
    /// `None` for jobs of too many contours.
    pub(super) fn new(problem: &Problem) -> Option<Self> {
        (problem.items.len() <= MOST).then(|| Self {
            bound: LowerBound::new(problem),
            running: Running::new(problem.clone(), |p| solve::methods()[0].start(p, 1, None)),
            moves: 0,
            left: 0,
            more: true,
        })
    }

    /// Looks at about `work` more numbers, in turns of the same size however it is sliced. Returns whether more work may help.
    pub(super) fn improve(&mut self, work: u32) -> bool {
        self.left += u64::from(work);
        while self.more && self.left >= u64::from(TURN) {
            self.left -= u64::from(TURN);
            if self.moves < ENOUGH {
                self.moves += MOVES;
                self.running.with_dependent_mut(|_, search| search.step(MOVES));
            }
            let upper = self.running.borrow_dependent().best().cost;
            self.more = self.bound.improve(TURN, upper);
        }
        self.more
    }

    /// The certificate of the bound by walks, if it proves more than `above`, s. It does not show that a path is optimal.
    pub(super) fn certificate(&self, above: f64) -> Option<WalkCertificate> {
        self.bound.certificate(self.running.borrow_owner(), above)
    }

    /// No path has less travel, s.
    pub(super) fn value(&self) -> f64 {
        self.bound.value()
    }
}
