//! Named values from callers: which fields an object may have, their types and their ranges.
//!
//! Options, machine profiles and materials come from JavaScript, JSON files and forms. Each has a table of its fields (a
//! [`Shape`]). [`read`] checks a value against the table before it becomes a typed struct. A misspelt name, a wrong type or
//! a number out of its range is refused with one sentence that names the field, its value and what is allowed. The same
//! tables are generated for TypeScript (`www/sdk/fields.ts`), which checks options before a worker receives them.

mod check;
mod error;
mod nearest;
mod rule;
mod table;
mod value;

pub use error::{Fault, FieldError};
pub use nearest::{nearest, no_such};
pub use rule::out_of_range;
pub use table::{Field, Kind, Range, Shape};
pub use value::{Value, shown};

use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer};

/// A struct that callers fill.
pub trait Shaped: DeserializeOwned {
    /// The table of its fields.
    const SHAPE: Shape;
}

/// Converts a value to a struct.
///
/// # Errors
/// What is wrong with which field.
pub fn read<T: Shaped>(value: Value) -> Result<T, FieldError> {
    T::SHAPE.check(&value)?;
    // The tables refuse everything that serde would refuse; a test draws values at random to keep that true.
    T::deserialize(value)
        .map_err(|_| FieldError::new(Fault::WrongType, "", format!("{} cannot be read.", T::SHAPE.owner)))
}

/// Converts a JSON text to a struct.
///
/// # Errors
/// The text is not JSON; otherwise as [`read`].
pub fn from_json<T: Shaped>(text: &str) -> Result<T, FieldError> {
    let value = serde_json::from_str(text).map_err(|e| {
        let (line, column) = (e.line(), e.column());
        let message = format!("{} is not JSON: see line {line}, column {column}.", T::SHAPE.owner);
        FieldError::new(Fault::NotJson, "", message)
    })?;
    read(value)
}

/// Whether a number is 0, for fields that JSON leaves out then.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
pub fn is_zero(number: &f64) -> bool {
    number.total_cmp(&0.0).is_eq()
}

/// Reads a JSON text that was checked before, such as one of our own, into a struct.
///
/// # Errors
/// The text is not JSON, or does not hold the struct.
pub fn from_checked_json<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    through_value(&mut serde_json::Deserializer::from_str(text)).map_err(|e| e.to_string())
}

/// Reads a struct by way of a [`Value`], as the options are read. Its code is then in the wasm file once, and not once more for
/// JSON: `#[serde(deserialize_with = "through_value")]`.
pub(crate) fn through_value<'de, T: DeserializeOwned, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    T::deserialize(Value::deserialize(deserializer)?).map_err(Error::custom)
}
