//! The codes of errors: the contract with programs.
//!
//! A code says what went wrong and never changes its meaning; the sentence beside it is for people and may be reworded. The
//! codes of all places are in this one list, so that a program that knows it understands the package, its elements, the
//! command line and the service.

use serde::Serialize;

/// The kind of an error. Written in kebab case (`out-of-range`). Later versions may add codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ErrorCode {
    // Options, machine profiles, materials and other values of callers. `params.field` names the field.
    /// There is no such option or field. `near` is the name that was probably meant.
    UnknownField,
    /// A field that must be given is absent.
    MissingField,
    /// A value has another type.
    WrongType,
    /// A number is out of its range: `value`, `least`, `most`, `unit`.
    OutOfRange,
    /// A value is not one of `choices`. `near` is the one that was probably meant.
    NotAChoice,
    /// A parameter of a method from a paper cannot be used.
    InvalidParameter,
    /// A text is not JSON.
    NotJson,
    /// Two options exclude each other.
    OptionsConflict,
    /// A contour's id is not in the drawing: `contour`, `count`.
    UnknownContour,
    /// The path to start from does not fit the drawing.
    UnfitPath,
    /// The drawing is not given as bytes.
    NotBytes,

    // The drawing.
    /// The file is not a drawing of a kind that can be read.
    NotADrawing,
    /// The file has nothing that can be cut.
    EmptyDrawing,
    /// The file, or something in it, is larger than can be read.
    TooLarge,
    /// Nothing on the sheet is cut or marked.
    NothingToCut,
    /// The bytes are not those of the drawing that was planned.
    OtherDrawing,
    /// The program would reach a place where the controller's numbers are too coarse: `x`, `y`, `spacing`.
    FarFromOrigin,
    /// The job does not lie on the machine's bed.
    OffBed,
    /// The plan cannot be written in this format.
    Unwritable,
    /// The report of a quote cannot be read, or is not one.
    NotAQuote,
    /// The response that should hold the drawing is an error: `status`.
    DownloadFailed,

    // The planner.
    /// No drawing is loaded.
    NoDrawing,
    /// No plan was started.
    NoPlan,
    /// The plan does not pass its own check. This is a fault of the planner.
    UnsoundPlan,
    /// The planner broke down or its worker died. Trying again may help.
    PlannerDied,
    /// The planner could not be started, or its files could not be loaded.
    NotStarted,
    /// The work took longer than its deadline.
    Deadline,
    /// The planner, pool or frame was closed.
    Closed,
    /// This build or entry of the package cannot do it.
    NotInThisBuild,

    // The command line.
    /// The arguments cannot be understood.
    WrongUsage,
    /// A file cannot be read.
    UnreadableFile,
    /// An output cannot be written.
    UnwritableOutput,

    // The service.
    /// Too many requests wait. `retryAfter` seconds later there may be room.
    Busy,
    /// The service is about to stop.
    Stopping,
    /// The key is missing or unknown.
    Unauthorized,
    /// There is nothing at this address.
    NotFound,
    /// The address does not answer this method.
    MethodNotAllowed,
    /// The body is neither a drawing nor a form with one.
    UnsupportedMediaType,
    /// The form cannot be read.
    MalformedForm,
    /// The upload did not arrive in time.
    SlowUpload,
    /// The queue does not answer.
    QueueUnavailable,
    /// A fault of the service. Details are in its log.
    Internal,
}

impl ErrorCode {
    /// Every code, in the order of the list.
    pub const ALL: &[Self] = &[
        Self::UnknownField,
        Self::MissingField,
        Self::WrongType,
        Self::OutOfRange,
        Self::NotAChoice,
        Self::InvalidParameter,
        Self::NotJson,
        Self::OptionsConflict,
        Self::UnknownContour,
        Self::UnfitPath,
        Self::NotBytes,
        Self::NotADrawing,
        Self::EmptyDrawing,
        Self::TooLarge,
        Self::NothingToCut,
        Self::OtherDrawing,
        Self::FarFromOrigin,
        Self::OffBed,
        Self::Unwritable,
        Self::NotAQuote,
        Self::DownloadFailed,
        Self::NoDrawing,
        Self::NoPlan,
        Self::UnsoundPlan,
        Self::PlannerDied,
        Self::NotStarted,
        Self::Deadline,
        Self::Closed,
        Self::NotInThisBuild,
        Self::WrongUsage,
        Self::UnreadableFile,
        Self::UnwritableOutput,
        Self::Busy,
        Self::Stopping,
        Self::Unauthorized,
        Self::NotFound,
        Self::MethodNotAllowed,
        Self::UnsupportedMediaType,
        Self::MalformedForm,
        Self::SlowUpload,
        Self::QueueUnavailable,
        Self::Internal,
    ];

    /// Whether the same call may succeed later, without a change by the caller.
    pub fn is_retryable(self) -> bool {
        matches!(
            self,
            Self::PlannerDied
                | Self::NotStarted
                | Self::Deadline
                | Self::Busy
                | Self::Stopping
                | Self::SlowUpload
                | Self::QueueUnavailable
                | Self::Internal
        )
    }
}
