//! Lead-ins and lead-outs: how the beam gets through scrap to a contour, and away from it.
//!
//! The machine's rules ([`crate::machine::Leads`]) say which lead a contour should have. For each place where the contour
//! may be entered, this stage builds it (`shape.rs`), always on the scrap side: inside holes, outside parts. It then tests
//! that the lead keeps its distance from everything that is not scrap (`scrap.rs`). Only places where the lead fits remain
//! entries of the contour, and the search chooses among them with the seconds of their leads.
//!
//! If the wanted lead fits nowhere, the *ladder* (`ladder.rs`) tries, in this order: the lead turned, at another position
//! along the contour, shortened, replaced by a line, and none. Every step down is reported with its place (`findings.rs`).
//!
//! A lead that touches no contour stays in one piece of scrap. That piece is still there when the lead is cut: scrap
//! around parts is never cut free, and a hole falls out after its own contour only. Marks are not avoided.

mod chain;
mod findings;
mod inscribed;
mod ladder;
mod loops;
mod moving;
mod planner;
mod run;
mod scrap;
mod shape;
mod to_node;

pub use findings::findings;
pub use ladder::{Fit, Outcome};
pub use moving::starts_moving;
pub use planner::{ContourLeads, Entry, Planner};
pub use run::{Lead, Run};
pub(crate) use scrap::Scrap;
