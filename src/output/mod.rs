//! Output formats: a plan for a machine, for another program, or for a person.
//!
//! Each format turns a plan into text and depends on neither solver nor clock: [`gcode()`] for the machine, [`dxf()`]
//! for other cutting software, [`svg()`] for viewing and printing, [`json_text()`] for programs, which writes a [plan
//! document](crate::plan::document). [`png`] (feature `png`) draws the picture of such a document. Lengths are in mm.

mod cuts;
mod dxf;
mod gcode;
mod json;
mod number;
#[cfg(feature = "png")]
pub mod png;
mod svg;

pub use dxf::dxf;
pub use gcode::{OutputError, gcode};
pub use json::json_text;
pub use svg::svg;
