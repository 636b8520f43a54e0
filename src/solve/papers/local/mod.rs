//! Local search for the methods of papers: 2-opt and Or-opt over the items near to each other, then the best entries
//! for the order that stands. It knows no precedence: what it comes to is repaired like every other order.

mod choose;
mod near;
mod polish;

pub(super) use choose::Choose;
pub(super) use polish::{Ground, Polish};
