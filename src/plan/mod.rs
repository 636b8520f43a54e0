//! The plan: moves with times, evaluated and checked.

mod model;

pub use model::{Move, Plan, Summary};
