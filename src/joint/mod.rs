//! Micro-joints: short lengths of a contour that stay uncut, so that its piece does not fall or tip.
//!
//! The machine's rules ([`crate::machine::Joints`]) say how many joints a contour has, how wide they are and how far apart;
//! a person may place them by hand instead ([`crate::sheet::HandJoint`]). This stage finds which contours have some (`planner.rs`), and their places (`grid.rs`):
//! evenly spread, away from corners (`room.rs`) and from cuts of other contours, so that no joint is in a cut that contours
//! share. What does not fit is a finding with its place (`findings.rs`).
//!
//! Places of joints do not depend on the order. The search then chooses where a contour is entered: anywhere that keeps
//! leads and overcuts away from joints, or at the end of a joint. A contour that begins at a joint is cut in as many
//! stretches as it has joints, otherwise in one more (`stretches.rs`), and each stretch costs a piercing.

mod findings;
mod grid;
mod outcome;
mod planner;
mod room;
mod stretches;

pub use findings::findings;
pub use outcome::{ContourJoints, Outcome, Refusal};
pub use planner::Planner;
pub use stretches::{Divided, Joint, Stretch, divided};
