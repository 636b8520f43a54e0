//! Why a job cannot go on.

use crate::dxf::ReadError;
use crate::machine::ProfileError;
use crate::output::OutputError;

/// Why a job cannot go on: one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum JobError {
    /// The file is unusable.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// An option is.
    #[error("{0}")]
    Options(String),
    /// Nothing on the sheet is to be cut or marked.
    #[error("There is nothing to cut: {0}")]
    NothingToCut(&'static str),
    /// Asked for a plan before there was one.
    #[error("There is no plan yet. Start one first.")]
    NoPlan,
    /// The machine is.
    #[error(transparent)]
    Machine(#[from] ProfileError),
    /// The plan cannot be written in the format asked for.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A plan did not pass the independent checker: a fault of this program.
    #[error(
        "The plan does not pass its own check, nothing was written: {0}. Please report this with the drawing."
    )]
    Unsound(String),
}
