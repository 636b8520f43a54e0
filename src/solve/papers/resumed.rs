//! A published method that goes on from a path found earlier.
//!
//! The methods start as published, from nothing. When a worker had to be replaced, the path it had found is given back
//! as the best until the method's new search finds its first improvement.

use crate::problem::Problem;
use crate::solve::{Insight, Search, Solution, Solver, Step, Telemetry};

/// Starts a method; `earlier` is its best path until it finds an improvement of its own.
pub(crate) fn start<'p>(
    method: &dyn Solver,
    problem: &'p Problem,
    seed: u64,
    earlier: Option<Solution>,
) -> Box<dyn Search + 'p> {
    let search = method.start(problem, seed, None);
    match earlier {
        None => search,
        Some(_) => Box::new(Resumed { search, earlier }),
    }
}

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
