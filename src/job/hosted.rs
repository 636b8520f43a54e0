//! A method of a paper as the planner sees it: its own search is elsewhere, what it finds is handed over here.
//!
//! In the browser and in Node that is a wasm file of its own, which has the problem as numbers and hands paths over;
//! natively the search is in the same program, and its paths take the same way, so that they are the same bytes.

#[cfg(feature = "papers")]
use super::{JobError, Warm, warm};
use crate::problem::Problem;
#[cfg(not(feature = "papers"))]
use crate::solve::Status;
use crate::solve::{Search, Solution, Step, Telemetry};

/// Its own search, and the problem it is of.
#[cfg(feature = "papers")]
type Method<'p> = (&'p Problem, Box<dyn Search + 'p>);
#[cfg(not(feature = "papers"))]
type Method<'p> = std::marker::PhantomData<&'p Problem>;

/// What a method of a paper has found.
pub(super) struct Hosted<'p> {
    method: Method<'p>,
    best: Solution,
    moves: u64,
}

impl<'p> Hosted<'p> {
    /// Until something is handed over, `first` is its best.
    #[cfg(not(feature = "papers"))]
    pub(super) fn new(_: &'p Problem, first: Solution) -> Self {
        Self { method: Method::default(), best: first, moves: 0 }
    }

    /// With the search of a method; `warm` is its best until it finds another.
    #[cfg(feature = "papers")]
    pub(super) fn new(
        problem: &'p Problem,
        method: Box<dyn Search + 'p>,
        warm: Option<Solution>,
    ) -> Result<Self, JobError> {
        let best = match warm {
            Some(warm) => warm,
            None => warm::solution(&Warm::of(problem, method.best()), problem)?,
        };
        Ok(Self { method: (problem, method), best, moves: 0 })
    }
}

impl Search for Hosted<'_> {
    #[cfg(not(feature = "papers"))]
    fn step(&mut self, work: u64) -> Step {
        self.moves += work;
        Step { status: Status::Running, done: work, improved: false }
    }

    #[cfg(feature = "papers")]
    fn step(&mut self, work: u64) -> Step {
        let (problem, method) = &mut self.method;
        let step = method.step(work);
        self.moves += step.done;
        if step.improved
            && let Ok(found) = warm::solution(&Warm::of(problem, method.best()), problem)
        {
            self.best = found;
        }
        step
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    /// The best is as old as what was handed over last; who asks is told that it is new.
    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.moves, best_at: self.moves, best: self.best.cost }
    }

    #[cfg(feature = "papers")]
    fn insight(&self) -> crate::solve::papers::Insight {
        self.method.1.insight()
    }

    /// Takes it over, better or not: what is best is the method's to say.
    fn offer(&mut self, other: &Solution) {
        self.best = other.clone();
    }
}
