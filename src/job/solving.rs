//! A benchmark instance under way: the instance, the search that works on it, and the check of its tour.

use crate::plan::LowerBound;
use crate::problem::{self, Fault, Instance, InstanceError};
use crate::solve::{self, Search, Status};

type Searching<'p> = Box<dyn Search + 'p>;

// The search borrows the instance; both live as long as the run.
self_cell::self_cell!(
    struct Running {
        owner: Instance,
        #[covariant]
        dependent: Searching,
    }
);

/// Moves between two turns of the lower bound, and its work in each: about a fifth of the time. Counted in moves, so
/// that a budget in moves gives the same bound however it is sliced.
const BOUND_EVERY: u64 = 200_000;
/// See [`BOUND_EVERY`].
const BOUND_WORK: u32 = 1_000_000;

/// The default method on an instance, and the lower bound beside it.
pub struct Solving {
    running: Running,
    bound: LowerBound,
    bound_at: u64,
    moves: u64,
}

impl Solving {
    /// Reads an instance and starts the search.
    ///
    /// # Errors
    /// What the file lacks or contradicts.
    pub fn start(bytes: &[u8], seed: u64) -> Result<Self, InstanceError> {
        let instance = problem::instance(bytes)?;
        // The registry lists the default method first.
        let running = Running::new(instance, |i| solve::methods()[0].start(&i.problem, seed, None));
        let bound = LowerBound::new(&running.borrow_owner().problem);
        Ok(Self { running, bound, bound_at: BOUND_EVERY, moves: 0 })
    }

    /// What the file calls the instance.
    pub fn name(&self) -> &str {
        &self.running.borrow_owner().name
    }

    /// Works for at most `work` moves; false when nothing more can be gained: the tour is proven the shortest, or the
    /// method is at its end.
    pub fn step(&mut self, work: u64) -> bool {
        let work = work.min(self.bound_at - self.moves);
        let step = self.running.with_dependent_mut(|_, search| search.step(work));
        self.moves += step.done;
        let cost = self.running.borrow_dependent().telemetry().best;
        if self.moves >= self.bound_at {
            self.bound_at += BOUND_EVERY;
            self.bound.improve(BOUND_WORK, cost);
        }
        step.status == Status::Running && self.lower_bound().is_none_or(|bound| bound < cost)
    }

    /// What no tour is shorter than; where all costs are whole numbers, so is it. `None` where edges are fixed: what
    /// these earn in the table makes the bound of the table's problem no bound of a length.
    pub fn lower_bound(&self) -> Option<f64> {
        let instance = self.running.borrow_owner();
        let bound = self.bound.value();
        // A hair less, so that rounding does not lift a bound over a whole number.
        let whole = |bound: f64| if instance.is_whole() { (bound - 1e-6).ceil().max(0.0) } else { bound };
        (!instance.has_fixed_edges()).then(|| whole(bound))
    }

    /// Moves done so far.
    pub fn moves(&self) -> u64 {
        self.moves
    }

    /// The best tour so far, by the numbers of the file.
    pub fn tour(&self) -> Vec<u32> {
        let stops = &self.running.borrow_dependent().best().stops;
        self.running.borrow_owner().tour(stops.iter().map(|s| s.node))
    }

    /// Its length, added up anew.
    ///
    /// # Errors
    /// What is wrong with the tour: a fault of this program.
    pub fn length(&self) -> Result<f64, Fault> {
        problem::check(self.running.borrow_owner(), &self.tour())
    }
}
