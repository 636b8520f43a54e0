//! A published method that may continue from a path found earlier.
//!
//! The methods start as published, from nothing. When a worker had to be replaced, the path it had found is reported as the
//! best until the method's new search finds its first improvement.

use crate::problem::Problem;
use crate::solve::{Insight, Search, Solution, Solver, SolverInfo, Step, Telemetry};

/// A method that starts as published, whatever path it is given.
pub(super) struct Published(pub(super) Box<dyn Solver>);

impl Solver for Published {
    fn info(&self) -> SolverInfo {
        self.0.info()
    }

    fn is_published(&self) -> bool {
        true
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let search = self.0.start(problem, seed, None);
        match warm {
            None => search,
            Some(earlier) => Box::new(Resumed { search, earlier: Some(earlier.clone()) }),
        }
    }
}

/// A search whose best path is an earlier one until it finds its first improvement.
struct Resumed<'p> {
    search: Box<dyn Search + 'p>,
    earlier: Option<Solution>,
}

impl Search for Resumed<'_> {
    fn step(&mut self, work: u64) -> Step {
        let step = self.search.step(work);
        if step.improved {
            self.earlier = None;
        }
        step
    }

    fn best(&self) -> &Solution {
        self.earlier.as_ref().unwrap_or_else(|| self.search.best())
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { best: self.best().cost, ..self.search.telemetry() }
    }

    fn insight(&self) -> Option<Insight> {
        self.search.insight()
    }
}
