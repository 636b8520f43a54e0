//! One drawing through the whole flow, for the wasm bindings, native tests and benches.
//!
//! A [`Job`] owns the bytes of one file and everything made from them. It can be loaded again with other options without
//! sending the bytes again, planned several times, and written out. A search runs in slices of moves. The caller, who has a
//! clock and a user to listen to, decides how many moves each slice has. Slices of any size give the same bytes.

mod best_path;
mod bridges;
mod code;
mod conflicts;
mod cutting_times;
mod error;
mod findings;
mod halves;
#[cfg(feature = "research")]
mod optimum;
mod option_fields;
mod options;
mod outputs;
mod placement;
mod plan_options;
mod problem_of;
#[cfg(feature = "research")]
mod proof;
mod ranges;
mod read;
mod report;
mod run;
mod sample;
mod shift;
#[cfg(feature = "research")]
mod solving;
mod warm_path;

pub use crate::output::OutputKind;
use crate::output::sha256;
pub use best_path::BestPath;
pub use code::ErrorCode;
pub use error::{ErrorReport, JobError, Param};
pub use options::{GroupChoice, LayerChoice, LoadOptions};
pub use placement::{Place, Placed};
pub use plan_options::{Budget, MachineChoice, PlanOptions};
pub use problem_of::problem_of;
#[cfg(feature = "research")]
pub use proof::{CERTIFICATE_SCHEMA, Proof, Verified, verify};
pub use read::is_svg;
pub use report::{Baselines, ContourInfo, Geometry, Loaded};
pub use run::{Run, Slice, SliceEnd};
pub use sample::sample_order;
#[cfg(feature = "research")]
pub use solving::Solving;
pub use warm_path::WarmPath;

use crate::drawing::{Drawing, ReadOptions};
use crate::fields::{Fault, FieldError};
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{Path, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Process, Profile};
use crate::order::sort_by;
use crate::sheet::{self, CommonCuts, Contour, Sheet, SheetOptions};

/// One drawing through the whole flow.
pub struct Job {
    name: String,
    bytes: Vec<u8>,
    sha256: String,
    read_options: ReadOptions,
    sheet_options: SheetOptions,
    drawing: Drawing,
    sheet: Sheet,
    /// The sheet with the paths of the beam, if the machine of the run has a kerf width, or passes are run sheet by sheet.
    beam_sheet: Option<Sheet>,
    run: Option<Run>,
}

impl Job {
    /// Reads a DXF or SVG file and arranges its contours.
    pub fn load(bytes: Vec<u8>, name: &str, options: &LoadOptions) -> Result<Self, JobError> {
        let read_options = options.read_options()?;
        let sheet_options = options.sheet_options()?;
        let drawing = read::read(&bytes, &read_options)?.turned(read_options.quarter_turns);
        let sheet = build_sheet(&drawing, &sheet_options)?;
        Ok(Self {
            name: name.to_owned(),
            sha256: sha256(&bytes),
            bytes,
            read_options,
            sheet_options,
            drawing,
            sheet,
            beam_sheet: None,
            run: None,
        })
    }

    /// Applies other options to the same file. The file is read again only if they concern its reading. The current plan is
    /// dropped. After an error nothing has changed.
    pub fn reload(&mut self, options: &LoadOptions) -> Result<(), JobError> {
        let read_options = options.read_options()?;
        let sheet_options = options.sheet_options()?;
        if read_options == self.read_options {
            self.sheet = build_sheet(&self.drawing, &sheet_options)?;
        } else {
            let drawing = read::read(&self.bytes, &read_options)?.turned(read_options.quarter_turns);
            self.sheet = build_sheet(&drawing, &sheet_options)?;
            self.drawing = drawing;
            self.read_options = read_options;
        }
        self.sheet_options = sheet_options;
        self.drop_run();
        Ok(())
    }

    /// The bytes of the file.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// A report on the content of the drawing.
    pub fn report(&self) -> Loaded<'_> {
        report::loaded(&self.name, &self.sha256, &self.drawing, &self.sheet)
    }

    /// The geometry of the contours, by id.
    pub fn geometry(&self) -> Geometry {
        Geometry::of(self.sheet.contours.iter().map(|c| &c.path))
    }

    /// The geometry of what is shown but not cut.
    pub fn ignored(&self) -> Geometry {
        Geometry::of(self.sheet.ignored.iter().map(|i| &i.path))
    }

    /// The drawing as read.
    pub fn drawing(&self) -> &Drawing {
        &self.drawing
    }

    /// The sheet as drawn.
    pub fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// The sheet as it is cut: as drawn, or with the paths of the beam, offset by half the kerf, if the machine has a kerf
    /// width.
    pub fn beam_sheet(&self) -> &Sheet {
        self.beam_sheet.as_ref().unwrap_or(&self.sheet)
    }

    /// The paths of the beam if they differ from the drawing: contours by id, and their geometry. Outlines that are cut with another contour,
    /// because bridges connect their parts, have none of their own.
    pub fn beam_paths(&self) -> Option<(Vec<ContourInfo<'_>>, Geometry)> {
        let sheet = self.beam_sheet.as_ref()?;
        let none = Path::default();
        let paths = (0..).zip(&sheet.contours).map(|(id, c)| {
            let elsewhere = PLANS_ALL_LEVERS && c.path.closed && c.bridged.is_some_and(|root| root != id);
            if elsewhere { &none } else { &c.path }
        });
        Some((report::contours(sheet), Geometry::of(paths)))
    }

    /// What two parts share: the stretches of pierce groups that are cut once for both, and the sides of bridges.
    pub fn common_cuts(&self) -> Geometry {
        let groups = self.beam_sheet().pierce_groups();
        let mut paths: Vec<_> = groups.iter().flat_map(|g| g.between_parts().map(|e| g.path(e))).collect();
        if PLANS_ALL_LEVERS {
            let strips = self.beam_sheet().bridged.iter().flat_map(|b| &b.strips);
            let sides = strips.flat_map(|s| s.sides).map(|[from, to]| Segment::line(from, to));
            paths.extend(sides.map(|side| Path::new(vec![side], false)));
        }
        Geometry::of(paths.iter())
    }

    /// Starts a plan. The current one is dropped.
    pub fn start(&mut self, options: &PlanOptions) -> Result<&Run, JobError> {
        if !self.sheet.contours.iter().any(Contour::is_processed) {
            return Err(JobError::NothingToCut(self.why_empty()));
        }
        options.check()?;
        let placed = Placed::new(options.profile()?, options.place, options.start, &self.sheet.bounds)?
            .allow_off_bed(options.allow_off_bed);
        let profile = &placed.profile;
        if let Some(layer) = self.sheet.lowers_head(profile).filter(|_| profile.z_speed.is_none()) {
            let message = format!(
                "The passes on layer {layer} lower the head, but the machine {} has no \"z_speed\". Set it, or set the z step to 0.",
                profile.name
            );
            return Err(FieldError::new(Fault::Missing, "machine.z_speed", message).into());
        }
        if let Some((lever, does)) = profile.levers.not_in_this_build() {
            let message = format!(
                "The machine {} {does}, which this build of Kerfway does not plan. Leave out \"levers.{lever}\", or load the whole package.",
                profile.name
            );
            return Err(FieldError::new(Fault::Contradiction, "machine.levers", message).into());
        }
        if !PLANS_ALL_LEVERS && self.sheet.common_cuts == CommonCuts::Insertion {
            let sentence = "This build of Kerfway has no insertion heuristic. Leave out \"commonCuts\", or load the whole package.";
            return Err(JobError::Conflict { field: "commonCuts", sentence });
        }
        conflicts::corners(&self.sheet, profile)?;
        conflicts::bridges(&self.sheet, profile)?;
        self.drop_run();
        let run = self.begin(placed, options).inspect_err(|_| self.drop_run())?;
        Ok(self.run.insert(run))
    }

    /// Makes the sheet of the beam, and the first plan on it.
    fn begin(&mut self, placed: Placed, options: &PlanOptions) -> Result<Run, JobError> {
        let mut findings = self.compensate(&placed.profile);
        if PLANS_ALL_LEVERS {
            let divided = self.beam_sheet().with_bridge_cuts(&placed.profile);
            self.beam_sheet = divided.or(self.beam_sheet.take());
        }
        let skeleton = self.beam_sheet().with_skeleton(&placed.seen_from_drawing()).map_err(|fault| {
            let message = format!("Skeleton cuts are not possible: {fault}.");
            FieldError::new(Fault::Contradiction, "machine.skeleton", message)
        })?;
        self.beam_sheet = skeleton.or(self.beam_sheet.take());
        self.beam_sheet = self.beam_sheet().sheet_by_sheet(&placed.profile).or(self.beam_sheet.take());
        findings.extend(placed.finding(&self.beam_sheet().bounds));
        findings.extend(self.too_fast(&placed.profile));
        let least = self.sheet.layer_with(&placed.profile, |process| process.min_power.is_some());
        findings.extend(least.map(|layer| {
            Finding::new(Code::LeastPowerLeftOut, Severity::Info, format!(
                "Layer {layer} has a least power, for which G-code has no word: only LightBurn projects and Ruida files carry it."
            ))
        }));
        let mut run = Run::start(self.beam_sheet(), placed, options)?;
        findings.append(&mut run.findings);
        run.findings = findings;
        Ok(run)
    }

    fn drop_run(&mut self) {
        self.run = None;
        self.beam_sheet = None;
    }

    /// Moves parts and connects them by bridges if the machine says so, offsets the cuts by half the kerf, and returns the findings.
    fn compensate(&mut self, machine: &Profile) -> Vec<Finding> {
        let kerf = machine.kerf_width;
        let (moved, mut findings) = shift::shifted(&self.sheet, &self.sheet_options, machine);
        let bridged = bridges::bridged(moved.as_ref().unwrap_or(&self.sheet), machine, &mut findings);
        if kerf <= 0.0 {
            self.beam_sheet = bridged;
            return findings;
        }
        let drawn = bridged.as_ref().or(moved.as_ref()).unwrap_or(&self.sheet);
        let (sheet, found) = sheet::compensated(&self.drawing, drawn, &self.sheet_options, kerf);
        self.beam_sheet = Some(sheet);
        findings.extend(found);
        findings
    }

    /// A layer that is worked faster than the machine moves.
    fn too_fast(&self, machine: &Profile) -> Option<Finding> {
        let most = machine.top_speed();
        let is_too_fast = |process: &Process| process.speed > most;
        let contour = self.sheet.contour_with(machine, is_too_fast)?;
        let message = format!(
            "Layer {} is worked at {} mm/s, but the machine moves with at most {most} mm/s: it takes longer than planned, and is not written as G-code. Lower the speed of the layer, or raise the rapids of the machine.",
            self.sheet.layer_name(contour),
            self.sheet.process_by_id(contour, machine).speed
        );
        Some(Finding::new(Code::LayerTooFast, Severity::Warning, message))
    }

    /// The current plan.
    pub fn run(&self) -> Result<&Run, JobError> {
        self.run.as_ref().ok_or(JobError::NoPlan)
    }

    /// The current plan, for continuing its search.
    pub fn run_mut(&mut self) -> Result<&mut Run, JobError> {
        self.run.as_mut().ok_or(JobError::NoPlan)
    }

    fn why_empty(&self) -> &'static str {
        if self.sheet.ignored.is_empty() {
            "the drawing holds no outlines."
        } else {
            "everything in the drawing is skipped. Set a layer to cut or mark, or include a contour."
        }
    }
}

fn build_sheet(drawing: &Drawing, options: &SheetOptions) -> Result<Sheet, JobError> {
    let sheet = sheet::build(drawing, options);
    let count = sheet.contours.len();
    let lists = [&options.first, &options.last, &options.exclude, &options.mark];
    let joints = options.joints.iter().map(|j| j.contour);
    let choices = options.contours.iter().map(|c| c.contour);
    if let Some(contour) = lists
        .into_iter()
        .chain(&options.sequences)
        .chain(&options.together)
        .flatten()
        .copied()
        .chain(joints)
        .chain(choices)
        .find(|&id| id as usize >= count)
    {
        return Err(JobError::UnknownContour { contour, count });
    }
    let refused =
        |option: &str, sentence: String| Err(FieldError::new(Fault::Contradiction, option, sentence).into());
    for (option, lists) in [("sequences", &options.sequences), ("together", &options.together)] {
        let mut named: Vec<u32> = lists.iter().flatten().copied().collect();
        sort_by(&mut named, |&id| [id.into(), 0, 0]);
        if let Some(twice) = named.array_windows().find(|[a, b]| a == b) {
            let sentence =
                format!("The option \"{option}\" names contour {} twice. Name each contour once.", twice[0]);
            return refused(option, sentence);
        }
    }
    if let Some(why) = sheet.torn_group() {
        return refused("together", format!("The option \"together\" is not possible: {why}."));
    }
    match sheet.contradiction() {
        None => Ok(sheet),
        Some(contour) => {
            let parts = if sheet.part_by_part { ", and a part is cut without others in between" } else { "" };
            let sentence = format!(
                "The option \"sequences\" asks for an order that is not possible: contour {contour} would have to be cut \
             before itself. What lies inside a contour is cut before it{parts}."
            );
            refused("sequences", sentence)
        }
    }
}
