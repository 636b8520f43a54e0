//! The plan: the moves of the head with their times, and how good it is.
//!
//! 1. [`from_solution`] converts the path that a solver found to moves (`model`). [`evaluate`] adds up their lengths and times.
//! 2. [`check`] makes sure that a plan does what its sheet requires. It shares no code with the solvers or the conversion, so
//!    that a fault of these does not hide itself.
//! 3. [`LowerBound`] computes what no plan can fall short of, while the search runs.
//! 4. [`document`] is the plan as other programs read it.

mod air;
mod checker;
mod cooled;
pub mod document;
mod evaluate;
mod from_solution;
mod lower_bound;
mod model;
mod past_tipped;

pub(crate) use air::AirMoves;
pub use checker::{Violation, check};
pub use evaluate::evaluate;
pub use from_solution::from_solution;
pub use lower_bound::LowerBound;
#[cfg(feature = "research")]
pub use lower_bound::{
    Certificate, CertificateFault, Certified, CutPart, FlowBound, FlowCertificate, MixedLegs, Part,
    PricedCut, PricedParts, ShareBound, SharedLegs, StopBound, StopCertificate, WalkCertificate, with_paid,
};
pub use model::{Leads, Move, Plan, Summary, Turn, Way};
