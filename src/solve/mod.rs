//! Solvers behind two traits, and the registry that names them.
//!
//! A [`Solver`] starts a [`Search`] on a problem. A search has a solution at once, and [`Search::step`] improves it by a given
//! amount of work. The same seed gives the same solutions, however the work is divided.
//!
//! - `tour_tree`: the default method. It prices moves by the ends of legs; where a price depends on what was cut before,
//!   `tipped` replays the path and improves it further.
//! - `greedy`: nearest neighbour, where the default method starts.
//! - [`exact()`]: the optimum of problems with few items, by dynamic programming. Tests compare with it.
//! - [`pierce_group`]: the ways through contours that share cuts, which become nodes of one item.
//! - `papers` (feature `research`): published methods, built as published.

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
    if let Some(ours) = method(name) {
        return Ok(Box::new(ours));
    }
    published(name, parameters).unwrap_or_else(|| {
        let names: Vec<_> = methods().iter().map(|m| m.info().name).chain(names_of_published()).collect();
        Err(FieldError::no_such("method", name, &names))
    })
}

#[cfg(feature = "research")]
fn published(name: &str, parameters: &str) -> Option<Result<Box<dyn Solver>, FieldError>> {
    papers::names().any(|known| known == name).then(|| papers::method(name, parameters))
}

#[cfg(feature = "research")]
fn names_of_published() -> impl Iterator<Item = &'static str> {
    papers::names()
}

#[cfg(not(feature = "research"))]
fn published(_name: &str, _parameters: &str) -> Option<Result<Box<dyn Solver>, FieldError>> {
    None
}

#[cfg(not(feature = "research"))]
fn names_of_published() -> [&'static str; 0] {
    []
}
