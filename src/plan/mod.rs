//! The plan: moves with their times, and the checker.

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
