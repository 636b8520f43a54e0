//! Writes the best plan of a job. A plan that does not pass the independent checker is never written.

use super::{Job, JobError, Placed};
use crate::drawing::Unit;
use crate::fields::{Fault, FieldError};
use crate::finding::Severity;
use crate::geometry::{Aabb, DVec2};
use crate::machine::Profile;
use crate::output::{self, Check, JobFacts, OutputError};
use crate::plan::document::{self, Budget, Document, Input, Move, Options, Placement};
use crate::plan::{self, Plan};
use crate::quote::{self, Quote, Terms};
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
    /// A LightBurn project.
    Lbrn2,
    /// A Ruida file; experimental.
    Rd,
}

impl OutputKind {
    /// Whether a machine runs it, so that it has to stay on the bed.
    pub fn is_program(self) -> bool {
        matches!(self, Self::Gcode | Self::Lbrn2 | Self::Rd)
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
            "lbrn2" => Ok(Self::Lbrn2),
            "rd" => Ok(Self::Rd),
            _ => {
                let known = ["gcode", "svg", "dxf", "json", "lbrn2", "rd"];
                Err(FieldError::no_such("output", name, &known).into())
            }
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

    /// The best plan so far, checked and written in a format of text. A G-code program is also read back and checked; one
    /// that fails is not returned.
    pub fn output(&self, kind: OutputKind) -> Result<String, JobError> {
        let plan = self.plan_for(kind)?;
        let (sheet, profile) = (self.beam_sheet(), &self.run()?.placed.profile);
        Ok(match kind {
            OutputKind::Gcode => self.program(&plan)?,
            OutputKind::Svg => output::svg(&plan, sheet, profile),
            OutputKind::Dxf => output::dxf(&plan, sheet),
            OutputKind::Json => output::json_text(&self.document_of(&plan)?),
            OutputKind::Lbrn2 => output::lbrn2(&plan, sheet, profile)?,
            OutputKind::Rd => {
                return Err(JobError::Conflict {
                    field: "output",
                    sentence: "A Ruida file is no text: ask for its bytes.",
                });
            }
        })
    }

    /// The best plan so far, checked and written in any format.
    pub fn output_bytes(&self, kind: OutputKind) -> Result<Vec<u8>, JobError> {
        match kind {
            OutputKind::Rd => {
                Ok(output::rd(&self.plan_for(kind)?, self.beam_sheet(), &self.run()?.placed.profile)?)
            }
            _ => Ok(self.output(kind)?.into_bytes()),
        }
    }

    /// What the check says of the G-code of the best plan so far: the preflight. A program that fails is refused by
    /// [`Job::output`] with the first of its problems.
    pub fn preflight(&self) -> Result<Check, JobError> {
        self.written(&self.plan_for(OutputKind::Gcode)?).map(|(_, check)| check)
    }

    /// The plan for an output. Programs have to stay on the bed.
    fn plan_for(&self, kind: OutputKind) -> Result<Plan, JobError> {
        if kind.is_program() {
            self.check_bed()?;
        }
        self.placed_plan()
    }

    /// The program of a plan, which has passed the check.
    fn program(&self, plan: &Plan) -> Result<String, JobError> {
        let (text, check) = self.written(plan)?;
        match check.problems.iter().find(|p| p.severity == Severity::Error) {
            Some(problem) => Err(OutputError::Preflight(problem.message.clone()).into()),
            None => Ok(text),
        }
    }

    fn written(&self, plan: &Plan) -> Result<(String, Check), JobError> {
        let run = self.run()?;
        let Placed { profile, start, .. } = &run.placed;
        let facts =
            JobFacts { name: &self.name, hash: Some(&self.sha256), material: run.material.as_deref() };
        let text = output::gcode(plan, self.beam_sheet(), profile, facts, *start)?;
        // Whether the job is allowed on this bed has been decided before, with the options of its placement.
        let machine = Profile { bed: None, ..profile.clone() };
        let mut check = output::check_against(&text, &machine, plan)
            .map_err(|sentence| FieldError::new(Fault::Contradiction, "dialect", sentence))?;
        check.fits_bed = output::fits_bed(&check, profile).filter(|_| start.is_absolute());
        Ok((text, check))
    }

    /// The best plan so far, checked, in the coordinates of the machine.
    pub fn placed_plan(&self) -> Result<Plan, JobError> {
        let Placed { profile, shift, .. } = &self.run()?.placed;
        let plan = self.plan()?.moved(*shift);
        // Moving a plan must not change its time.
        let (says, adds_up) =
            (plan.summary.total_time, plan::evaluate(&plan.moves, self.beam_sheet(), profile).total_time);
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

    /// What a price needs of the best plan so far, which is checked first. A material that the machine has no setting for, or
    /// that was not planned for, is refused instead of priced with the speed of another.
    pub fn quote(&self, terms: &Terms) -> Result<Quote, JobError> {
        let run = self.run()?;
        let named = terms.material.name.as_deref();
        if let Some(name) = named.filter(|_| !run.placed.profile.materials.is_empty()) {
            let profile = &run.placed.profile;
            let Some(known) = profile.material(name) else {
                return Err(profile.lacks(name).into());
            };
            let planned = run.material.as_deref();
            if planned.and_then(|planned| profile.material(planned)) != Some(known) {
                let planned = planned.map_or("the machine's own setting".to_owned(), |p| format!("\"{p}\""));
                let message = format!(
                    "The quote names the material \"{name}\", but the job was planned for {planned}. Plan it for that material."
                );
                return Err(FieldError::new(Fault::Contradiction, "material", message).into());
            }
        }
        Ok(quote::quote(&self.document()?, terms)?)
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
                dpi: self.drawing.units.dpi,
                units_doubt: self.drawing.units.doubt(),
            },
            // The library is not part of the plan.
            machine: Profile { materials: Vec::new(), ..profile.clone() },
            options: Options::of(&self.read_options, &self.sheet_options),
            material: run.material.clone(),
            placement: (!run.placed.is_as_drawn())
                .then(|| Placement { shift: shift.to_array(), start: *start }),
            summary: plan.summary.clone(),
            contours: document::contours(self.beam_sheet(), profile, *shift),
            moves: plan.moves.iter().map(Move::from).collect(),
            findings: findings.map(|f| f.clone().moved(*shift)).collect(),
        })
    }
}
