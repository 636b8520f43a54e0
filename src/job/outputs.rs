//! Writes the best plan of a job. A plan that does not pass the independent checker is never written.

use super::{Job, JobError};
use crate::drawing::Unit;
use crate::output;
use crate::plan::document::{self, Budget, Document, Input, Move, Options};
use crate::plan::{self, Plan};
use crate::quote::{self, Material, Quote};
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
            OutputKind::Json => output::json_text(&self.document_of(&plan)?),
        })
    }

    /// What a price needs of the best plan so far, which is checked first.
    pub fn quote(&self, material: &Material) -> Result<Quote, JobError> {
        quote::quote(&self.document()?, material).map_err(JobError::Options)
    }

    /// The best plan so far, checked, with everything it came from.
    pub fn document(&self) -> Result<Document, JobError> {
        self.document_of(&self.plan()?)
    }

    fn document_of(&self, plan: &Plan) -> Result<Document, JobError> {
        let run = self.run()?;
        let findings = self.drawing.findings.iter().chain(&self.beam_sheet().findings).chain(&run.findings);
        Ok(Document {
            schema: document::SCHEMA.to_owned(),
            units: Unit::Mm,
            method: run.method.clone(),
            parameters: run.parameters.clone().filter(|p| p != "{}"),
            seed: run.seed,
            budget: Budget {
                moves: run.budget.moves,
                seconds: run.budget.seconds,
                done: run.moves,
                workers: (run.workers > 1).then_some(run.workers),
            },
            input: Input {
                sha256: self.sha256.clone(),
                name: self.name.clone(),
                units: self.drawing.units.unit,
                units_source: self.drawing.units.source,
            },
            machine: run.machine.clone(),
            options: Options::of(&self.read_options, &self.sheet_options),
            summary: plan.summary.clone(),
            contours: document::contours(self.beam_sheet(), &run.machine),
            moves: plan.moves.iter().map(Move::from).collect(),
            findings: findings.cloned().collect(),
        })
    }
}
