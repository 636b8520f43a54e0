//! Why a job cannot go on.

use crate::drawing::ReadError;
use crate::machine::ProfileError;
use crate::output::OutputError;

/// Why a job cannot continue, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum JobError {
    /// The file cannot be used.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// An option is wrong.
    #[error("{0}")]
    Options(String),
    /// Nothing on the sheet is cut or marked.
    #[error("There is nothing to cut: {0}")]
    NothingToCut(&'static str),
    /// A plan was requested before one was started.
    #[error("There is no plan yet. Start one first.")]
    NoPlan,
    /// The machine profile is wrong.
    #[error(transparent)]
    Machine(#[from] ProfileError),
    /// The plan cannot be written in the requested format.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The job does not lie on the machine's bed.
    #[error("{0} Nothing was written; `--allow-off-bed` (option `allowOffBed`) writes it anyway.")]
    OffBed(String),
    /// The plan did not pass the independent checker. This is a fault of this program.
    #[error(
        "The plan does not pass its own check, nothing was written: {0}. Please report this with the drawing."
    )]
    Unsound(String),
}
