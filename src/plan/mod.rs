//! The plan: moves with times, evaluated and checked.

mod evaluate;
mod from_solution;
mod model;

pub use evaluate::evaluate;
pub use from_solution::from_solution;
pub use model::{Move, Plan, Summary};
