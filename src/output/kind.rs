//! The kinds of output.

use crate::fields::FieldError;
use std::str::FromStr;

/// The kinds of output. Pictures are made from the plan document by the PNG renderer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputKind {
    /// G-code for the machine.
    Gcode,
    /// A picture of the path.
    Svg,
    /// A drawing of the contours in cutting order, each starting at its entry.
    Dxf,
    /// The plan document, `kerfway.plan/1`.
    Json,
    /// A LightBurn project.
    Lbrn2,
    /// A Ruida file; experimental.
    Rd,
    /// A drawing of what is left of the sheet, for the next job.
    Remainder,
}

impl OutputKind {
    /// Whether a machine runs it, so that it has to stay on the bed.
    pub fn is_program(self) -> bool {
        matches!(self, Self::Gcode | Self::Lbrn2 | Self::Rd)
    }
}

impl FromStr for OutputKind {
    type Err = FieldError;

    fn from_str(name: &str) -> Result<Self, FieldError> {
        match name {
            "gcode" => Ok(Self::Gcode),
            "svg" => Ok(Self::Svg),
            "dxf" => Ok(Self::Dxf),
            "json" => Ok(Self::Json),
            "lbrn2" => Ok(Self::Lbrn2),
            "rd" => Ok(Self::Rd),
            "remainder" => Ok(Self::Remainder),
            _ => Err(FieldError::no_such(
                "output",
                name,
                &["gcode", "svg", "dxf", "json", "lbrn2", "rd", "remainder"],
            )),
        }
    }
}
