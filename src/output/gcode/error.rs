//! Why a program is not written.

/// Why a plan cannot be written as a program, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The job reaches a place where the controller's numbers are too coarse.
    #[error(
        "The program would reach x {x:.0}, y {y:.0} mm, where the controller's 32-bit numbers are {spacing:.3} mm apart: \
         move the drawing and the machine's home near the origin, or correct the drawing's unit."
    )]
    FarFromOrigin {
        /// x of that place, mm.
        x: f64,
        /// y of that place, mm.
        y: f64,
        /// Distance between neighbouring numbers there, mm.
        spacing: f64,
    },
    /// The dialect cannot do what the plan asks for.
    #[error("{0}")]
    Dialect(String),
    /// The program does not pass the check that reads it back.
    #[error("The program does not pass its own check, so it was not written: {0}")]
    Preflight(String),
    /// The format has too few places for this plan.
    #[error("{0}")]
    Format(String),
}
