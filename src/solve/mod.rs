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
mod tipped;
mod tour_tree;
mod traits;

pub use as_drawn::in_order;
pub use exact::{TooLarge, exact};
pub use greedy::greedy;
pub use insight::{Curve, Grid, Insight, Parent, Partitions};
pub(crate) use running::Running;
pub use tipped::{Begun, begun, priced, start};
pub use traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};

use crate::fields::FieldError;

/// Every method of ours, the default first.
pub fn methods() -> &'static [&'static dyn Solver] {
    &[&tour_tree::TourTree, &greedy::Greedy]
}

/// The method of that name among ours.
pub fn method(name: &str) -> Option<&'static dyn Solver> {
    methods().iter().copied().find(|m| m.info().name == name)
}

/// The method of that name: one of ours or, with the feature `research`, of a published paper. `parameters` is a JSON object
/// with the parameters of a published method that differ from its defaults, or empty; ours have none.
///
/// # Errors
/// There is no such method, or a parameter is wrong.
pub fn named(name: &str, parameters: &str) -> Result<Box<dyn Solver>, FieldError> {
    match method(name) {
        Some(ours) => Ok(Box::new(ours)),
        None => published(name, parameters),
    }
}

#[cfg(feature = "research")]
fn published(name: &str, parameters: &str) -> Result<Box<dyn Solver>, FieldError> {
    papers::method(name, parameters)
}

#[cfg(not(feature = "research"))]
fn published(name: &str, _parameters: &str) -> Result<Box<dyn Solver>, FieldError> {
    let names: Vec<&str> = methods().iter().map(|m| m.info().name).collect();
    Err(FieldError::no_such("method", name, &names))
}
