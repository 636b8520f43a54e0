//! A method of a paper at work on a problem that a planner handed over as numbers: see `hosted.rs`.

use super::{JobError, Warm};
use crate::problem::Problem;
use crate::solve::papers::{self, Insight};
use crate::solve::{Running, Step};

/// A method at work.
pub struct Guest(Running);

impl Guest {
    /// Starts a method with parameters (a JSON object with those that differ from the defaults, or nothing) on the
    /// numbers of [`Problem::packed`].
    ///
    /// # Errors
    /// No such method or parameter; numbers that are no problem.
    pub fn start(numbers: &[f64], name: &str, parameters: &str, seed: u64) -> Result<Self, JobError> {
        let method = papers::method(name, parameters).map_err(JobError::Options)?;
        let problem = Problem::unpacked(numbers);
        let problem = problem.ok_or_else(|| JobError::Options("These numbers are no problem.".into()))?;
        Ok(Self(Running::new(problem, |p| method.start(p, seed, None))))
    }

    /// Works for at most `work` moves.
    pub fn step(&mut self, work: u64) -> Step {
        self.0.with_dependent_mut(|_, search| search.step(work))
    }

    /// The method's best path.
    pub fn best(&self) -> Warm {
        Warm::of(self.0.borrow_owner(), self.0.borrow_dependent().best())
    }

    /// What makes it special, as it stands now.
    pub fn insight(&self) -> Insight {
        self.0.borrow_dependent().insight()
    }
}
