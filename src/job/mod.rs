//! One drawing through the whole flow, for the wasm bindings, native tests and benches.
//!
//! A [`Job`] owns the bytes of one file and everything made from them. It can be loaded again with other options without
//! sending the bytes again, planned several times, and written out. A search runs in slices of moves. The caller, who has a
//! clock and a user to listen to, decides how many moves each slice has. Slices of any size give the same bytes.

mod begin;
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
mod sheet_of;
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
use crate::geometry::{Path, Segment};
use crate::machine::PLANS_ALL_LEVERS;
use crate::sheet::{Contour, Sheet, SheetOptions};
use sheet_of::sheet_of;

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
        let sheet = sheet_of(&drawing, &sheet_options)?;
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
            self.sheet = sheet_of(&self.drawing, &sheet_options)?;
        } else {
            let drawing = read::read(&self.bytes, &read_options)?.turned(read_options.quarter_turns);
            self.sheet = sheet_of(&drawing, &sheet_options)?;
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
        conflicts::check(&self.sheet, &placed.profile)?;
        self.drop_run();
        let run = self.begin(placed, options).inspect_err(|_| self.drop_run())?;
        Ok(self.run.insert(run))
    }

    fn drop_run(&mut self) {
        self.run = None;
        self.beam_sheet = None;
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
