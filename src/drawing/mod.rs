//! What every reader makes of a file: a [`Drawing`] in millimetres. It is the same for all formats.

mod model;
mod other_format;
mod reading;
mod turned;
mod unit;

pub use model::{Drawing, EntityKindCount, Layer, Shape};
pub(crate) use other_format::other_format;
pub use reading::{Limits, ReadError, ReadOptions, TextDecoder};
pub use unit::{CSS_DPI, Unit, Units, UnitsSource};
