//! Why a value of a caller cannot be used.

use super::nearest::{nearest, no_such};
use super::rule::out_of_range;
use super::table::Range;
use super::value::Value;
use std::fmt;

/// What is wrong with a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// There is no such field.
    Unknown,
    /// A field that must be given is absent.
    Missing,
    /// The value has another type.
    WrongType,
    /// A number is out of its range.
    OutOfRange(Box<Range>),
    /// Values are valid each, but contradict each other.
    Contradiction,
    /// The value is not one of these.
    NotAChoice(Vec<String>),
    /// A parameter of a method cannot be used.
    Parameter,
    /// The text is not JSON.
    NotJson,
}

/// Why a value of a caller cannot be used: what is wrong with which field, and one sentence for people.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldError {
    /// What is wrong.
    pub fault: Fault,
    /// Path of the field, for example `cut.speed`; empty if the value as a whole is wrong.
    pub field: String,
    /// The value as the sentence shows it; `None` if there is none.
    pub value: Option<String>,
    /// The known name that was probably meant.
    pub near: Option<String>,
    /// One sentence for people.
    pub message: String,
}

impl FieldError {
    /// An error with its sentence.
    pub fn new(fault: Fault, field: impl Into<String>, message: impl Into<String>) -> Self {
        Self { fault, field: field.into(), value: None, near: None, message: message.into() }
    }

    /// A number out of its range. `what` begins the sentence, for example `The machine's field`.
    pub fn out_of_range(what: &str, field: &str, n: f64, range: &Range) -> Self {
        let message = out_of_range(what, field, n, range);
        Self::new(Fault::OutOfRange(Box::new(*range)), field, message).of(&Value::Number(n))
    }

    /// A name that is not among the known ones. `what` is the kind of thing and the name of the field: `machine`.
    pub fn no_such(what: &str, name: &str, known: &[&str]) -> Self {
        let choices = known.iter().map(|&k| k.to_owned()).collect();
        let error = Self::new(Fault::NotAChoice(choices), what, no_such(what, name, known));
        Self { near: nearest(name, known.iter().copied()).map(str::to_owned), ..error }
            .of(&Value::Text(name.to_owned()))
    }

    pub(super) fn of(self, value: &Value) -> Self {
        let shown = match value {
            Value::Text(text) => super::value::shown(text),
            other => other.to_string(),
        };
        Self { value: Some(shown), ..self }
    }
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for FieldError {}
