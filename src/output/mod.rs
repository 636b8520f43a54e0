//! Output formats: a plan for a machine, for another program, or for a person.
//!
//! Each format turns a plan into text and depends on neither solver nor clock: [`gcode()`] for the machine, [`lbrn2()`]
//! for LightBurn, [`rd()`] for Ruida controllers, [`dxf()`] for other cutting software, [`svg()`] for viewing and printing, [`json_text()`] for programs, which writes a [plan
//! document](crate::plan::document). [`png`] (feature `png`) draws the picture of such a document. Lengths are in mm.

mod cuts;
mod dxf;
mod gcode;
mod json;
mod lbrn2;
mod number;
#[cfg(feature = "png")]
pub mod png;
mod process;
mod rd;
mod svg;

pub use dxf::dxf;
pub use gcode::{
    Check, CheckCode, CheckProblem, JobFacts, OutputError, check, check_against, fits_bed, gcode,
};
pub use json::json_text;
pub use lbrn2::lbrn2;
pub use rd::rd;
pub use svg::svg;
