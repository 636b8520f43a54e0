//! Outputs: what a plan looks like to a machine, to another program and to a person.
//!
//! Each format is one file that turns a plan into text, knowing no solver and no clock: [`gcode()`] for the machine,
//! [`dxf()`] for other cutting software, [`svg()`] for looking and printing, [`json()`] for programs, and [`png`]
//! (feature `png`) draws the picture of such a JSON document. Lengths in mm.

mod arcs;
mod dxf;
mod gcode;
mod json;
mod number;
pub(crate) mod picture;
#[cfg(feature = "png")]
pub mod png;
mod svg;
mod walk;

pub use dxf::dxf;
pub use gcode::{OutputError, gcode};
pub use json::{Budget, Document, Input, json, json_text};
pub use svg::svg;
