//! A work order: a finished plan with everything that writing it takes.
//!
//! In WebAssembly, planner and writers are two files. The planner checks and places a plan, and writes a work order as
//! [JSON](super::json_text); the file with the writers reads it. Every number crosses bit for bit, so the output has the same
//! bytes as natively, where the order does not leave memory.

use super::gcode::{self, Check, JobFacts, OutputError};
use super::{OutputKind, SheetFacts, dxf, lbrn2, rd, remainder, svg};
use crate::fields::through_value;
use crate::finding::Severity;
use crate::geometry::Segment;
use crate::machine::{Profile, Start};
use crate::plan::Plan;
use serde::{Deserialize, Serialize};

/// A plan that has passed its check, in the coordinates of the machine, with everything that writing it takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkOrder {
    /// The version of the planner.
    pub version: String,
    /// Name of the job, such as the file of the drawing.
    pub name: String,
    /// SHA-256 of the drawing, in hexadecimal.
    pub sha256: String,
    /// Name of the material.
    pub material: Option<String>,
    /// What the coordinates of a program mean.
    pub start: Start,
    /// The machine, without its library of materials.
    #[serde(deserialize_with = "through_value")]
    pub machine: Profile,
    /// The plan.
    pub plan: Plan,
    /// What is cut.
    pub sheet: SheetFacts,
    /// Outlines of what is left of the sheet, if they are asked for: the outer one, and holes in it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remainder: Vec<Vec<Segment>>,
}

/// An output.
#[derive(Clone, Debug, PartialEq)]
pub enum Written {
    /// Most formats are text.
    Text(String),
    /// Ruida files are not.
    Bytes(Vec<u8>),
}

impl WorkOrder {
    /// Reads a work order from JSON.
    ///
    /// # Errors
    /// One sentence: the text is no work order, or comes from a planner of another version.
    pub fn read(text: &str) -> Result<Self, String> {
        let order: Self = serde_json::from_str(text).map_err(|e| {
            format!(
                "The plan did not reach the writer of outputs whole: line {}, column {}.",
                e.line(),
                e.column()
            )
        })?;
        if order.version == env!("CARGO_PKG_VERSION") {
            Ok(order)
        } else {
            Err(format!(
                "The planner is of version {}, and the writer of outputs of version {}: use the files of one version.",
                order.version,
                env!("CARGO_PKG_VERSION")
            ))
        }
    }

    /// Writes the plan in a format. A G-code program is also read back and checked; one that fails is not returned.
    ///
    /// # Errors
    /// The format cannot hold the plan, or the program does not pass its check.
    pub fn write(&self, kind: OutputKind) -> Result<Written, OutputError> {
        let Self { plan, sheet, machine, .. } = self;
        Ok(match kind {
            OutputKind::Gcode => Written::Text(self.program()?),
            OutputKind::Svg => Written::Text(svg(plan, sheet, machine)),
            OutputKind::Dxf => Written::Text(dxf(plan, sheet)),
            OutputKind::Lbrn2 => Written::Text(lbrn2(plan, sheet, machine)?),
            OutputKind::Rd => Written::Bytes(rd(plan, sheet, machine)?),
            OutputKind::Remainder => Written::Text(remainder(&self.remainder)),
            OutputKind::Json => {
                let sentence = "The plan document is written by the planner, not from a work order.";
                return Err(OutputError::Format(sentence.to_owned()));
            }
        })
    }

    /// What the check says of the G-code of the plan: the preflight. A program that fails is refused by [`Self::write`] with
    /// the first of its problems.
    ///
    /// # Errors
    /// The plan cannot be written as G-code.
    pub fn preflight(&self) -> Result<Check, OutputError> {
        self.program_and_check().map(|(_, check)| check)
    }

    fn program(&self) -> Result<String, OutputError> {
        let (text, check) = self.program_and_check()?;
        match check.problems.iter().find(|p| p.severity == Severity::Error) {
            Some(problem) => Err(OutputError::Preflight(problem.message.clone())),
            None => Ok(text),
        }
    }

    fn program_and_check(&self) -> Result<(String, Check), OutputError> {
        let Self { plan, sheet, machine, start, .. } = self;
        let facts =
            JobFacts { name: &self.name, hash: Some(&self.sha256), material: self.material.as_deref() };
        let text = gcode::gcode(plan, sheet, machine, facts, *start)?;
        // Where the head stands on the bed is known to the person only.
        let placed = Profile { bed: machine.bed.filter(|_| start.is_absolute()), ..machine.clone() };
        let check = gcode::check_against(&text, &placed, plan).map_err(OutputError::Dialect)?;
        Ok((text, check))
    }
}
