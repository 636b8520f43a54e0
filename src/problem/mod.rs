//! What a solver sees: items, the nodes where each may be entered, the cost of travel, and what must come before
//! what. Solvers know nothing else.

mod model;

pub use model::{Item, ItemId, Node, NodeId, Problem};
