//! What every reader makes of a file: a [`Drawing`] in millimetres. It is the same for all formats.

mod model;
mod reading;
mod turned;
mod unit;

pub use model::{Drawing, EntityKindCount, Layer, Shape};
pub use reading::{Limits, ReadError, ReadOptions, TextDecoder};
pub use unit::{Unit, Units, UnitsSource};
