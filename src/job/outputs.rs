//! Writes the best plan of a job. A plan that does not pass the independent checker is never written.

use super::{Job, JobError, Placed};
use crate::drawing::Unit;
use crate::geometry::{Aabb, DVec2};
use crate::output;
use crate::plan::document::{self, Budget, Document, Input, Move, Options, Placement};
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

impl OutputKind {
    /// Whether a machine runs it, so that it has to stay on the bed.
    pub fn is_program(self) -> bool {
        self == Self::Gcode
    }
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

/// Relative difference within which times agree: sums of the same numbers at another place.
const SAME_TIME: f64 = 1e-9;

impl Job {
    /// The best plan so far, in the coordinates of the drawing, after it passed the checker.
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
        let Placed { profile, start, .. } = &self.run()?.placed;
        if kind.is_program() {
            self.check_bed()?;
        }
        let plan = self.placed_plan()?;
        Ok(match kind {
            OutputKind::Gcode => output::gcode(&plan, self.beam_sheet(), profile, &self.name, *start)?,
            OutputKind::Svg => output::svg(&plan, self.beam_sheet(), profile),
            OutputKind::Dxf => output::dxf(&plan, self.beam_sheet()),
            OutputKind::Json => output::json_text(&self.document_of(&plan)?),
        })
    }

    /// The best plan so far, checked, in the coordinates of the machine.
    pub fn placed_plan(&self) -> Result<Plan, JobError> {
        let Placed { profile, shift, .. } = &self.run()?.placed;
        let plan = self.plan()?.moved(*shift);
        // Moving a plan must not change its time.
        let (says, adds_up) = (plan.summary.total_time, plan::evaluate(&plan.moves, profile).total_time);
        if (says - adds_up).abs() <= SAME_TIME * (1.0 + adds_up) {
            Ok(plan)
        } else {
            Err(JobError::Unsound(format!("placed on the bed it takes {adds_up} s, not {says} s")))
        }
    }

    /// Refuses programs that would leave the bed.
    fn check_bed(&self) -> Result<(), JobError> {
        let run = self.run()?;
        let [x0, y0, x1, y1] = run.plan(self.beam_sheet()).summary.bounds;
        run.placed.check(&Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) })
    }

    /// What a price needs of the best plan so far, which is checked first.
    pub fn quote(&self, material: &Material) -> Result<Quote, JobError> {
        quote::quote(&self.document()?, material).map_err(JobError::Options)
    }

    /// The best plan so far, checked, with everything it came from.
    pub fn document(&self) -> Result<Document, JobError> {
        self.document_of(&self.placed_plan()?)
    }

    fn document_of(&self, plan: &Plan) -> Result<Document, JobError> {
        let run = self.run()?;
        let Placed { profile, shift, start, .. } = &run.placed;
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
            machine: profile.clone(),
            options: Options::of(&self.read_options, &self.sheet_options),
            placement: (!run.placed.is_as_drawn())
                .then(|| Placement { shift: shift.to_array(), start: *start }),
            summary: plan.summary.clone(),
            contours: document::contours(self.beam_sheet(), profile, *shift),
            moves: plan.moves.iter().map(Move::from).collect(),
            findings: findings.map(|f| f.clone().moved(*shift)).collect(),
        })
    }
}
