//! The problem that a solver sees: items, the nodes where each may be entered, the cost of travel, and precedence. Solvers
//! know neither drawings nor machine programs.
//!
//! [`from_sheet`] makes the problem of a sheet on a machine; its documentation lists what becomes of everything on the sheet.
//! Most contours are items of their own (`single.rs`). Contours that share cuts (`pierce_groups.rs`) and those that are cut on
//! the run (`fly`) are one item, whose nodes are the ways through all of them. Some costs depend on more than one leg: chains
//! are [`Links`] between nodes, cuts that begin on kerfs are [`Starts`], pieces that may tip are zones (`tipping.rs`), and near
//! cuts have to cool (`heat.rs`). [`instance()`] reads benchmark instances as problems.

mod beside;
mod between_parts;
mod bridge_cuts;
mod chains;
mod cut_apart;
mod entries;
mod fly;
mod from_sheet;
mod group_problem;
mod groups;
mod heat;
mod ids;
mod instance;
mod kerf_starts;
mod leads;
mod links;
mod model;
mod pierce_groups;
mod seconds;
mod single;
mod skeleton_starts;
mod starts;
mod sub_path;
mod table;
mod tipping;

pub use beside::Beside;
pub(crate) use bridge_cuts::begins_on_kerf;
pub use from_sheet::from_sheet;
pub use group_problem::{Element, GroupMethod, GroupProblem, GroupProblems, group_problems};
pub use groups::Groups;
pub use ids::{ItemId, NodeId};
pub use instance::{Fault, Instance, InstanceError, check, instance};
pub use leads::ItemLeads;
pub use links::{Link, Links};
pub use model::{Item, Node, Problem};
pub use starts::{Start, Starts};
pub use sub_path::{LeavePoint, Span, Stroke, SubPath};
pub use table::Table;
