//! The plan: moves with times, evaluated and checked.

mod checker;
mod evaluate;
mod from_solution;
mod model;

pub use checker::{Violation, check};
pub use evaluate::evaluate;
pub use from_solution::from_solution;
pub use model::{Move, Plan, Summary};
