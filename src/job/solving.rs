//! A benchmark instance under way: the instance, the search that works on it, and the check of its tour.

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

/// The default method on an instance.
pub struct Solving {
    running: Running,
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
        Ok(Self { running, moves: 0 })
    }

    /// What the file calls the instance.
    pub fn name(&self) -> &str {
        &self.running.borrow_owner().name
    }

    /// Works for at most `work` moves; false when nothing more can be gained.
    pub fn step(&mut self, work: u64) -> bool {
        let step = self.running.with_dependent_mut(|_, search| search.step(work));
        self.moves += step.done;
        step.status == Status::Running
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
