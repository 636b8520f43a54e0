//! Lower bound (prototype).
mod cheap;
mod minorant;
mod net;
mod order;
mod pairs;
mod rounds;
mod space;
mod tree;
mod walks;

use crate::problem::Problem;
use cheap::Cheap;
use rounds::Strong;

/// So many items get the strong bound: beyond, a look at all walks takes longer than people wait.
const STRONG: usize = 220;

/// Bound under way.
#[derive(Debug)]
pub struct LowerBound {
    work: Work,
}

#[derive(Debug)]
enum Work {
    Cheap(Cheap),
    Strong(Strong),
    Done(f64),
}

impl LowerBound {
    /// x
    pub fn new(problem: &Problem) -> Self {
        let resumes = std::env::var("RESUMES").is_ok();
        let work = if problem.items.is_empty() {
            Work::Done(0.0)
        } else if problem.items.len() > STRONG || resumes {
            Work::Cheap(Cheap::new(problem, resumes))
        } else {
            Work::Strong(Strong::new(problem))
        };
        Self { work }
    }

    /// x
    pub fn improve(&mut self, work: u64, upper: f64) -> bool {
        let mut left = work;
        while left > 0 {
            let done = match &mut self.work {
                Work::Cheap(c) => c.once(),
                Work::Strong(s) => s.once(upper),
                Work::Done(_) => 0,
            };
            if done == 0 {
                self.work = Work::Done(self.value());
                return false;
            }
            left = left.saturating_sub(done);
        }
        true
    }

    /// x
    pub fn value(&self) -> f64 {
        match &self.work {
            Work::Cheap(c) => c.value(),
            Work::Strong(s) => s.value(),
            Work::Done(value) => *value,
        }
    }
    /// x
    pub fn state(&self) -> String {
        match &self.work { Work::Strong(s) => s.state(), _ => String::new() }
    }
}
