//! Solvers behind two traits, and the registry that names them.

mod as_drawn;
mod epsilon;
mod exact;
mod greedy;
mod insight;
#[cfg(feature = "research")]
pub mod papers;
pub mod pierce_group;
mod precedence;
mod rng;
mod running;
mod tour_tree;
mod traits;

pub use as_drawn::in_order;
pub use exact::{TooLarge, exact};
pub use greedy::greedy;
pub use insight::{Curve, Grid, Insight, Parent, Partitions};
pub(crate) use running::Running;
pub use traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};

/// Every method of ours, the default first.
pub fn methods() -> &'static [&'static dyn Solver] {
    &[&tour_tree::TourTree, &greedy::Greedy]
}

/// The method of that name.
pub fn method(name: &str) -> Option<&'static dyn Solver> {
    methods().iter().copied().find(|m| m.info().name == name)
}
