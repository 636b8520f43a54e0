//! Dialects of G-code, as data: what a controller does differently from others, in a JSON document without any script.
//!
//! A dialect says in which words a controller takes power, dwells, units and comments, and how it pierces. `output::gcode`
//! interprets it: the same moves become a program for GRBL, LinuxCNC, Marlin or a controller of one's own. The shipped
//! documents are the files of `shipped/`; the package contains them as `kerfway/dialects/NAME.json`, with a JSON schema.

mod choice;
mod fields;
mod model;
mod shipped;
mod validate;

pub use choice::DialectChoice;
pub use model::{
    Air, Comments, Decimals, Dialect, Dwell, DwellUnit, FileUnit, LineEnd, Pierce, PierceBy, Power, PowerBy,
};
pub use shipped::{dialect, dialects};
pub use validate::PLACEHOLDERS;
