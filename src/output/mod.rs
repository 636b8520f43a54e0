//! Output formats: a plan for a machine, for another program, or for a person.
//!
//! Each format turns a plan into text and depends on neither solver nor clock: [`gcode()`] for the machine, [`lbrn2()`]
//! for LightBurn, [`rd()`] for Ruida controllers, [`dxf()`] for other cutting software, [`svg()`] for viewing and printing.
//! They write from a [`WorkOrder`], because in WebAssembly they are a file of their own, which gets the plan from the
//! planner's. [`json_text()`] is for programs and writes a [plan document](crate::plan::document). [`png`] (feature `png`)
//! draws the picture of such a document. Lengths are in mm.

mod cuts;
mod dxf;
mod gcode;
mod json;
mod kind;
mod labels;
mod lbrn2;
#[cfg(feature = "png")]
pub mod png;
mod process;
mod rd;
mod sheet_facts;
mod svg;
mod work_order;

pub use dxf::{dxf, remainder};
pub use gcode::{Check, CheckCode, CheckProblem, JobFacts, OutputError, check, check_against, gcode};
pub use json::{json_text, sha256};
pub use kind::OutputKind;
pub use lbrn2::lbrn2;
pub use rd::rd;
pub use sheet_facts::{ContourFacts, LayerFacts, SheetFacts};
pub use svg::svg;
pub use work_order::{WorkOrder, Written};
