//! Writes the best plan of a job. A plan that does not pass the independent checker is never written.

use super::{Job, JobError};
use crate::output::{self, Budget, Document, Input};
use crate::plan::{self, Plan};
use std::str::FromStr;

/// The kinds of output. Pictures are made from the JSON by the PNG renderer.
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
}

impl FromStr for OutputKind {
    type Err = JobError;

    fn from_str(name: &str) -> Result<Self, JobError> {
        match name {
            "gcode" => Ok(Self::Gcode),
            "svg" => Ok(Self::Svg),
            "dxf" => Ok(Self::Dxf),
            "json" => Ok(Self::Json),
            _ => Err(JobError::Options(format!(
                "There is no output named {name}. Choose one of: gcode, svg, dxf, json."
            ))),
        }
    }
}

impl Job {
    /// The best plan so far, after it passed the checker.
    pub fn plan(&self) -> Result<Plan, JobError> {
        let run = self.run()?;
        let plan = run.plan(self.beam_sheet());
        match plan::check(self.beam_sheet(), &run.machine, &plan) {
            Ok(()) => Ok(plan),
            Err(violations) => {
                let first = violations.first().map(ToString::to_string).unwrap_or_default();
                Err(JobError::Unsound(first))
            }
        }
    }

    /// The best plan so far, checked and written in a format.
    pub fn output(&self, kind: OutputKind) -> Result<String, JobError> {
        let plan = self.plan()?;
        let run = self.run()?;
        Ok(match kind {
            OutputKind::Gcode => output::gcode(&plan, self.beam_sheet(), &run.machine, &self.name)?,
            OutputKind::Svg => output::svg(&plan, self.beam_sheet(), &run.machine),
            OutputKind::Dxf => output::dxf(&plan, self.beam_sheet()),
            OutputKind::Json => output::json(&Document {
                input: Input { name: &self.name, sha256: &self.sha256 },
                drawing: &self.drawing,
                sheet: self.beam_sheet(),
                read: &self.read_options,
                arrange: &self.sheet_options,
                machine: &run.machine,
                method: &run.method,
                parameters: run.parameters.as_deref().filter(|p| *p != "{}"),
                seed: run.seed,
                budget: Budget {
                    moves: run.budget.moves,
                    seconds: run.budget.seconds,
                    done: run.moves,
                    workers: (run.workers > 1).then_some(run.workers),
                },
                more: &run.findings,
                plan: &plan,
            }),
        })
    }
}
