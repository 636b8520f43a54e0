//! Writes the best plan of a job. A plan that does not pass the independent checker is never written.

use super::{Job, JobError, Placed, findings};
use crate::drawing::Unit;
use crate::fields::{Fault, FieldError};
use crate::geometry::{Aabb, Affine, DVec2, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::output::{Check, OutputKind, SheetFacts, WorkOrder, Written, json_text};
use crate::plan::document::{self, Budget, Document, Input, Move, Options, Placement};
use crate::plan::{self, Plan};
use crate::quote::{self, Quote, Terms};

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
        match self.written(kind)? {
            Written::Text(text) => Ok(text),
            Written::Bytes(_) => Err(JobError::Conflict {
                field: "output",
                sentence: "A Ruida file is no text: ask for its bytes.",
            }),
        }
    }

    /// The best plan so far, checked and written in any format.
    pub fn output_bytes(&self, kind: OutputKind) -> Result<Vec<u8>, JobError> {
        self.written(kind).map(|written| match written {
            Written::Text(text) => text.into_bytes(),
            Written::Bytes(bytes) => bytes,
        })
    }

    fn written(&self, kind: OutputKind) -> Result<Written, JobError> {
        Ok(match kind {
            OutputKind::Json => Written::Text(json_text(&self.document()?)),
            kind => self.work_order(kind)?.write(kind)?,
        })
    }

    /// What the check says of the G-code of the best plan so far: the preflight. A program that fails is refused by
    /// [`Job::output`] with the first of its problems.
    pub fn preflight(&self) -> Result<Check, JobError> {
        Ok(self.work_order(OutputKind::Gcode)?.preflight()?)
    }

    /// The best plan so far, checked, with everything that writing it in a format takes. A plan for a program has to stay on
    /// the bed.
    pub fn work_order(&self, kind: OutputKind) -> Result<WorkOrder, JobError> {
        if kind.is_program() {
            self.check_bed()?;
        }
        let run = self.run()?;
        let Placed { profile, start, .. } = &run.placed;
        let remainder = if kind == OutputKind::Remainder { self.remainder()? } else { Vec::new() };
        Ok(WorkOrder {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            name: self.name.clone(),
            sha256: self.sha256.clone(),
            material: run.material.clone(),
            start: *start,
            machine: Profile { materials: Vec::new(), ..profile.clone() },
            plan: self.placed_plan()?,
            sheet: SheetFacts::of(self.beam_sheet()),
            remainder,
        })
    }

    /// The outlines of what is left of the sheet, in the coordinates of the machine.
    fn remainder(&self) -> Result<Vec<Vec<Segment>>, JobError> {
        let Placed { shift, .. } = self.run()?.placed;
        let left = self.beam_sheet().remainder(&self.run()?.machine).map_err(|fault| {
            let message = format!("The remainder of the sheet cannot be written: {fault}.");
            FieldError::new(Fault::Contradiction, "output", message)
        })?;
        let moved = Affine::translation(shift);
        Ok(left.iter().map(|path| moved.path(path, 0.0).segments).collect())
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

    /// Refuses programs that would leave the bed, on a cut or between cuts. A home beyond the bed has a sentence of its own.
    fn check_bed(&self) -> Result<(), JobError> {
        let run = self.run()?;
        let plan = run.plan(self.beam_sheet());
        let [x0, y0, x1, y1] = plan.summary.bounds;
        let cuts = Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) };
        let ends = plan.moves.iter().filter_map(plan::Move::end).filter(|end| *end != run.machine.home());
        run.placed.check(&ends.fold(cuts, Aabb::with))
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
                from_path: run.from_path,
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
            contours: document::contours(self.beam_sheet(), profile, &plan.moves, *shift),
            bridges: if PLANS_ALL_LEVERS { plan.bridges.clone() } else { Vec::new() },
            moves: plan.moves.iter().map(Move::from).collect(),
            findings: findings
                .map(|f| f.clone().moved(*shift))
                .chain(findings::of_plan(plan, profile))
                .collect(),
        })
    }
}
