//! Named values from callers: what fields an object may have, of which kind and in which range.
//!
//! Options, machine profiles and materials arrive from JavaScript, JSON files and forms. Each has a table of its fields (a
//! [`Shape`]); [`read`] checks a value against the table before it becomes a typed struct. A misspelt name, a wrong type or
//! a number out of its range is refused with one sentence that names the field, its value and what is right. The same
//! tables are written out for TypeScript (`www/sdk/fields.ts`), which checks options before a worker sees them.

mod check;
mod nearest;
mod table;
mod value;

pub use check::out_of_range;
pub use nearest::{nearest, no_such};
pub use table::{Field, Kind, Range, Shape};
pub use value::Value;

use serde::de::DeserializeOwned;

/// A struct that callers fill.
pub trait Shaped: DeserializeOwned {
    /// Its fields.
    const SHAPE: Shape;
}

/// The struct that a value describes.
///
/// # Errors
/// One sentence that names the field, its value and what is right.
pub fn read<T: Shaped>(value: Value) -> Result<T, String> {
    T::SHAPE.check(&value)?;
    T::deserialize(value).map_err(|e| format!("{} cannot be read: {e}.", T::SHAPE.owner))
}

/// The struct that a JSON text describes.
///
/// # Errors
/// The text is no JSON; otherwise as [`read`].
pub fn from_json<T: Shaped>(text: &str) -> Result<T, String> {
    let value = serde_json::from_str(text).map_err(|e| format!("{} is not JSON: {e}.", T::SHAPE.owner))?;
    read(value)
}
