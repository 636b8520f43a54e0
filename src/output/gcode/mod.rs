//! Writes a plan as G-code, in the dialect of the machine (`machine::dialect`).
//!
//! The moves are the same for every dialect (`program.rs`); `beam.rs` has what differs between controllers.
//!
//! **Beam off on air moves.** The power is set to 0 before or on the line of every rapid, on every controller, also where
//! the controller itself keeps the beam off on G0: two independent mechanisms. GRBL's M4 is selected once, at the head of
//! the program, because switching M5 and M4 around every contour would empty the planner's buffer and add nothing.
//!
//! **Piercing on GRBL.** Under M4 the power follows the speed, so at standstill the beam is off and a dwell pierces
//! nothing. A pierce at the entry is therefore `G1 M3 S.. F..` (constant power; G1 is on the same line because in the
//! motion mode G0, left by the rapid, GRBL would keep the beam off), `G4 P..` with the beam on, and `M4` back to dynamic
//! power. The settling time of the beam before a cut is part of that dwell; the one after a cut is a dwell with the beam
//! off. On a controller whose beam fires only during motions, the head *creeps*: it cuts a short length at the beginning
//! so slowly that this takes the piercing time.
//!
//! **Moving starts** have no dwell: the beam goes on with the first motion of the cut.
//!
//! **Partial cuts.** A contour is resumed from its pre-cut without a pierce, so a cut without a pierce before it has no
//! dwell. A pre-cut with a length is cut in advance, and the head returns with the beam off.
//!
//! **Micro-joints** with a stop are a rapid over the joint and another piercing. Over flying joints the head runs on with the
//! power at 0, on controllers that set the power with the motion.
//!
//! **Sharp corners** are a dwell with the beam off in the corner; then the cut goes on.
//!
//! What a dialect cannot do is refused in a sentence that names it, and nothing is written.
//!
//! Sources: GRBL 1.1, gcode.c (steps 4 and 7 of the block), spindle_control.c, protocol.c, wiki "Grbl v1.1 Laser Mode";
//! LinuxCNC, "G-codes" and "M-codes"; Marlin, M3, M5, M106, G4; Smoothieware, "Laser".

mod beam;
mod check;
mod checksum;
mod error;
mod facts;
mod grbl_arc;
mod pen;
mod program;
mod refuse;
mod text;

use super::sheet_facts::SheetFacts;
use crate::geometry::{Aabb, DVec2};
use crate::machine::{Profile, Start, far_out};
use crate::plan::Plan;
pub use check::{Check, CheckCode, CheckProblem, check, check_against};
pub use error::OutputError;
use facts::Facts;
pub use facts::JobFacts;
use program::Writer;

/// The program of a plan for a machine; `job` says what the comments at its head name. With
/// [`Start::Absolute`] coordinates are the work coordinates active on the machine. The head may be anywhere at the start,
/// because the program first moves it to the plan's home. With [`Start::Current`] every motion is given as seen from the
/// one before (G91), so the job lies where the head stands when the program begins.
///
/// # Errors
/// The controller's 32-bit numbers are too coarse for the job, or the dialect cannot do what the plan asks for.
pub fn gcode<'a>(
    plan: &Plan,
    sheet: &SheetFacts,
    profile: &Profile,
    job: impl Into<JobFacts<'a>>,
    start: Start,
) -> Result<String, OutputError> {
    let [x0, y0, x1, y1] = plan.summary.bounds;
    let bounds = Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) };
    if let Some(far) = far_out(&bounds.with(profile.home())) {
        return Err(OutputError::FarFromOrigin { x: far.at.x, y: far.at.y, spacing: far.spacing });
    }
    let dialect = profile.dialect.document().map_err(OutputError::Dialect)?;
    refuse::refuse(plan, sheet, profile, &dialect)?;
    let facts = Facts::of(plan, profile, &dialect, &job.into());
    let writer = Writer::new(profile, &dialect, plan, sheet, start);
    writer.program(plan, &facts).map(checksum::filled).map_err(|line| {
        OutputError::Dialect(format!(
            "A line of the program is longer than the {} characters of the dialect \"{}\": {line}",
            dialect.line_length, dialect.name
        ))
    })
}
