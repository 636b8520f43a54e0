//! Why a job cannot go on.

use super::code::ErrorCode;
use crate::drawing::ReadError;
use crate::fields::{Fault, FieldError};
use crate::machine::ProfileError;
use crate::output::OutputError;
use crate::sheet::plural;
use serde::Serialize;
use std::collections::BTreeMap;

/// Why a job cannot continue, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum JobError {
    /// The file cannot be used.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// An option is wrong.
    #[error(transparent)]
    Options(#[from] FieldError),
    /// A contour that an option names is not in the drawing.
    #[error(
        "Contour {contour} is listed in the options, but there {}, counted from 0.", only(*count)
    )]
    UnknownContour {
        /// Its id.
        contour: u32,
        /// Number of contours in the drawing.
        count: usize,
    },
    /// Options exclude each other.
    #[error("{sentence}")]
    Conflict {
        /// The option.
        field: &'static str,
        /// What excludes what.
        sentence: &'static str,
    },
    /// The path to start from does not fit.
    #[error("The path to start from does not fit this drawing and these options. Start without it.")]
    UnfitPath,
    /// Nothing on the sheet is cut or marked.
    #[error("There is nothing to cut: {0}")]
    NothingToCut(&'static str),
    /// A plan was requested before one was started.
    #[error("There is no plan yet. Start one first.")]
    NoPlan,
    /// The plan cannot be written in the requested format.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The job does not lie on the machine's bed.
    #[error("{0} Nothing was written: a program that leaves the bed has to be allowed.")]
    OffBed(String),
    /// The plan did not pass the independent checker. This is a fault of this program.
    #[error(
        "The plan does not pass its own check, nothing was written: {0}. Please report this with the drawing."
    )]
    Unsound(String),
}

fn only(contours: usize) -> String {
    let verb = if contours == 1 { "is" } else { "are" };
    format!("{verb} only {}", plural(contours, "contour", "contours"))
}

impl From<ProfileError> for JobError {
    fn from(error: ProfileError) -> Self {
        Self::Options(error.into())
    }
}

/// A value that a sentence names, for programs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Param {
    /// A text.
    Text(String),
    /// A number.
    Number(f64),
    /// A list of texts.
    List(Vec<String>),
}

/// An error as programs get it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ErrorReport {
    /// What went wrong.
    pub code: ErrorCode,
    /// One sentence for people, in English: what, where, what to do.
    pub message: String,
    /// What the sentence names, by name: `field`, `value`, `least`, `most`, ....
    #[cfg_attr(test, ts(type = "Record<string, string | number | string[]>"))]
    pub params: BTreeMap<&'static str, Param>,
    /// Whether the same call may succeed later, without a change by the caller.
    pub retryable: bool,
}

impl JobError {
    /// The kind of the error.
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Read(ReadError::NotADrawing(_)) => ErrorCode::NotADrawing,
            Self::Read(ReadError::Empty(_)) => ErrorCode::EmptyDrawing,
            Self::Read(ReadError::Limit(_)) => ErrorCode::TooLarge,
            Self::Options(error) => match error.fault {
                Fault::Unknown => ErrorCode::UnknownField,
                Fault::Missing => ErrorCode::MissingField,
                Fault::WrongType => ErrorCode::WrongType,
                Fault::OutOfRange(_) => ErrorCode::OutOfRange,
                Fault::Contradiction => ErrorCode::OptionsConflict,
                Fault::NotAChoice(_) => ErrorCode::NotAChoice,
                Fault::Parameter => ErrorCode::InvalidParameter,
                Fault::NotJson => ErrorCode::NotJson,
            },
            Self::UnknownContour { .. } => ErrorCode::UnknownContour,
            Self::Conflict { .. } => ErrorCode::OptionsConflict,
            Self::UnfitPath => ErrorCode::UnfitPath,
            Self::OffBed(_) => ErrorCode::OffBed,
            Self::NothingToCut(_) => ErrorCode::NothingToCut,
            Self::NoPlan => ErrorCode::NoPlan,
            Self::Output(error) => code_of(error),
            Self::Unsound(_) => ErrorCode::UnsoundPlan,
        }
    }

    /// The error as programs get it.
    pub fn report(&self) -> ErrorReport {
        ErrorReport::new(self.code(), self.to_string(), self.params())
    }

    fn params(&self) -> BTreeMap<&'static str, Param> {
        let mut params = BTreeMap::new();
        match self {
            Self::Options(error) => {
                if !error.field.is_empty() {
                    params.insert("field", Param::Text(error.field.clone()));
                }
                if let Some(value) = &error.value {
                    params.insert("value", Param::Text(value.clone()));
                }
                if let Some(near) = &error.near {
                    params.insert("near", Param::Text(near.clone()));
                }
                match &error.fault {
                    Fault::OutOfRange(range) => {
                        params.insert("least", Param::Number(range.least));
                        params.insert("most", Param::Number(range.most));
                        params.insert("unit", Param::Text(range.unit.to_owned()));
                    }
                    Fault::NotAChoice(choices) => {
                        params.insert("choices", Param::List(choices.clone()));
                    }
                    _ => {}
                }
            }
            Self::UnknownContour { contour, count } => {
                params.insert("contour", Param::Number((*contour).into()));
                params.insert("count", Param::Number(*count as f64));
            }
            Self::Conflict { field, .. } => {
                params.insert("field", Param::Text((*field).to_owned()));
            }
            Self::Output(error) => return params_of(error),
            _ => {}
        }
        params
    }
}

impl ErrorReport {
    fn new(code: ErrorCode, message: String, params: BTreeMap<&'static str, Param>) -> Self {
        Self { code, message, params, retryable: code.is_retryable() }
    }
}

// The wasm file with the writers reports these alone, without the texts of all other errors.
impl From<OutputError> for ErrorReport {
    fn from(error: OutputError) -> Self {
        Self::new(code_of(&error), error.to_string(), params_of(&error))
    }
}

fn code_of(error: &OutputError) -> ErrorCode {
    match error {
        OutputError::FarFromOrigin { .. } => ErrorCode::FarFromOrigin,
        _ => ErrorCode::Unwritable,
    }
}

fn params_of(error: &OutputError) -> BTreeMap<&'static str, Param> {
    match error {
        OutputError::FarFromOrigin { x, y, spacing } => {
            [("x", *x), ("y", *y), ("spacing", *spacing)].map(|(name, n)| (name, Param::Number(n))).into()
        }
        _ => BTreeMap::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::Range;

    #[test]
    fn codes_and_params_name_the_field_and_the_limits() {
        let range = Range::new(0.0, 5.0, "mm", "it is a test");
        let report =
            JobError::from(FieldError::out_of_range("The option", "joinTolerance", 7.0, &range)).report();
        assert_eq!((report.code, report.retryable), (ErrorCode::OutOfRange, false));
        assert_eq!(report.params["field"], Param::Text("joinTolerance".into()));
        assert_eq!(report.params["value"], Param::Text("7".into()));
        assert_eq!(report.params["most"], Param::Number(5.0));
        let report =
            JobError::from(FieldError::no_such("machine", "co2-10w", &["co2-100w", "length"])).report();
        assert_eq!(report.code, ErrorCode::NotAChoice);
        assert_eq!(report.params["near"], Param::Text("co2-100w".into()));
        let report = JobError::UnknownContour { contour: 9, count: 4 }.report();
        assert_eq!(
            serde_json::to_string(&report).unwrap(),
            r#"{"code":"unknown-contour","message":"Contour 9 is listed in the options, but there are only 4 contours, counted from 0.","params":{"contour":9.0,"count":4.0},"retryable":false}"#
        );
        assert_eq!(
            JobError::UnknownContour { contour: 1, count: 1 }.to_string(),
            "Contour 1 is listed in the options, but there is only 1 contour, counted from 0."
        );
    }

    #[test]
    fn the_list_of_codes_is_complete_and_in_order() {
        assert!(ErrorCode::ALL.windows(2).all(|w| w[0] < w[1]));
        // The last variant's place is the number of the others.
        assert_eq!(ErrorCode::Internal as usize + 1, ErrorCode::ALL.len());
    }
}
