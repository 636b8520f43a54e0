//! Solving a benchmark instance: the instance, its search, and the check of the tour.

use crate::plan::LowerBound;
use crate::problem::{self, Fault, Instance, InstanceError};
use crate::solve::{self, Search, Status};

type Searching<'p> = Box<dyn Search + 'p>;

// The search borrows the instance, so both are stored together.
self_cell::self_cell!(
    struct Running {
        owner: Instance,
        #[covariant]
        dependent: Searching,
    }
);

/// Number of moves between two turns of the lower bound, which take about a fifth of the time. It is counted in moves, so
/// that a budget in moves gives the same bound however it is sliced.
const BOUND_EVERY: u64 = 200_000;
/// Work on the lower bound in each turn.
const BOUND_WORK: u32 = 1_000_000;

/// The default method on an instance, with its lower bound.
pub struct Solving {
    running: Running,
    /// `None` for a large instance, see [`Instance::is_large`].
    bound: Option<LowerBound>,
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
        // The default method is the first in the list.
        let running = Running::new(instance, |i| solve::methods()[0].start(&i.problem, seed, None));
        let read = running.borrow_owner();
        let bound = (!read.is_large()).then(|| LowerBound::new(&read.problem));
        Ok(Self { running, bound, bound_at: BOUND_EVERY, moves: 0 })
    }

    /// The name of the instance, as given in the file.
    pub fn name(&self) -> &str {
        &self.running.borrow_owner().name
    }

    /// Does at most `work` moves. Returns false when nothing can be improved any more: the tour is proven optimal, or the
    /// method has ended.
    pub fn step(&mut self, work: u64) -> bool {
        let work = work.min(self.bound_at - self.moves);
        let step = self.running.with_dependent_mut(|_, search| search.step(work));
        self.moves += step.done;
        let cost = self.running.borrow_dependent().telemetry().best;
        if self.moves >= self.bound_at {
            self.bound_at += BOUND_EVERY;
            if let Some(bound) = &mut self.bound {
                bound.improve(BOUND_WORK, cost);
            }
        }
        step.status == Status::Running && self.lower_bound().is_none_or(|bound| bound < cost)
    }

    /// Lower bound of the length of every tour, rounded up where all costs are whole numbers. `None` for large
    /// instances, and if edges are fixed: the table rewards them, so the bound of its problem is no bound of a length.
    pub fn lower_bound(&self) -> Option<f64> {
        let instance = self.running.borrow_owner();
        let bound = self.bound.as_ref()?.value();
        // Slightly less, so that rounding does not lift the bound over a whole number.
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

    /// The length of the best tour, computed again from the file's data.
    ///
    /// # Errors
    /// What is wrong with the tour: a fault of this program.
    pub fn length(&self) -> Result<f64, Fault> {
        problem::check(self.running.borrow_owner(), &self.tour())
    }
}
