//! What a solver sees: items, the nodes where each may be entered, the cost of travel, and what must come before
//! what. Solvers know nothing else.

mod buckets;
mod entries;
mod from_sheet;
mod groups;
mod instance;
mod model;
mod packed;
mod table;

pub use buckets::Buckets;
pub use from_sheet::from_sheet;
pub use groups::Groups;
pub use instance::{Fault, Instance, InstanceError, check, instance};
pub(crate) use model::TABLES;
pub use model::{Item, ItemId, Node, NodeId, Problem};
pub use table::Table;
