//! Writes a plan as G-code, in the dialect of the machine (`machine::dialect`).
//!
//! The moves are the same for every dialect; `beam.rs` has what differs between controllers.
//!
//! **Beam off on air moves.** The power is set to 0 before or on the line of every rapid, on every controller, also where
//! the controller itself keeps the beam off on G0: two independent mechanisms. GRBL's M4 is selected once, at the head of
//! the program, because switching M5 and M4 around every contour would empty the planner's buffer and add nothing.
//!
//! **Piercing on GRBL.** Under M4 the power follows the speed, so at standstill the beam is off and a dwell pierces
//! nothing. A pierce at the entry is therefore `G1 M3 S.. F..` (constant power; G1 is on the same line because in the
//! motion mode G0, left by the rapid, GRBL would keep the beam off), `G4 P..` with the beam on, and `M4` back to dynamic
//! power. The settling time of the beam before a cut is part of that dwell; the one after a cut is a dwell with the beam
//! off. On a controller whose beam fires only during motions, the head *creeps*: it cuts a short length at the beginning
//! so slowly that this takes the piercing time.
//!
//! **Moving starts** have no dwell: the beam goes on with the first motion of the cut.
//!
//! **Partial cuts.** A contour is resumed from its pre-cut without a pierce, so a cut without a pierce before it has no
//! dwell. A pre-cut with a length is cut in advance, and the head returns with the beam off.
//!
//! **Micro-joints** with a stop are a rapid over the joint and another piercing. Over flying joints the head runs on with the
//! power at 0, on controllers that set the power with the motion.
//!
//! **Sharp corners** are a dwell with the beam off in the corner; then the cut goes on.
//!
//! What a dialect cannot do is refused in a sentence that names it, and nothing is written.
//!
//! Sources: GRBL 1.1, gcode.c (steps 4 and 7 of the block), spindle_control.c, protocol.c, wiki "Grbl v1.1 Laser Mode";
//! LinuxCNC, "G-codes" and "M-codes"; Marlin, M3, M5, M106, G4; Smoothieware, "Laser".

mod beam;
mod check;
mod checksum;
mod facts;
mod grbl_arc;
mod pen;
mod refuse;
mod text;

use super::cuts::cuts;
use super::process::CutProcess;
use super::sheet_facts::SheetFacts;
use crate::geometry::{Aabb, DVec2, Path, Segment};
use crate::machine::dialect::{Dialect, Pierce, PierceBy};
use crate::machine::{Profile, Start, far_out};
use crate::plan::{Move, Plan, Way};
use beam::Beam;
pub use check::{Check, CheckCode, CheckProblem, check, check_against};
use facts::Facts;
pub use facts::JobFacts;
use pen::Pen;
use std::mem;

/// Shortest way back along a cut that is a motion for the controller, mm: some steps of the coarsest grid.
const LEAST_MOTION: f64 = 0.1;

/// Why a plan cannot be written as a program, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The job reaches a place where the controller's numbers are too coarse.
    #[error(
        "The program would reach x {x:.0}, y {y:.0} mm, where the controller's 32-bit numbers are {spacing:.3} mm apart: \
         move the drawing and the machine's home near the origin, or correct the drawing's unit."
    )]
    FarFromOrigin {
        /// x of that place, mm.
        x: f64,
        /// y of that place, mm.
        y: f64,
        /// Distance between neighbouring numbers there, mm.
        spacing: f64,
    },
    /// The dialect cannot do what the plan asks for.
    #[error("{0}")]
    Dialect(String),
    /// The program does not pass the check that reads it back.
    #[error("The program does not pass its own check, so it was not written: {0}")]
    Preflight(String),
    /// The format has too few places for this plan.
    #[error("{0}")]
    Format(String),
}

/// The program of a plan for a machine; `job` says what the comments at its head name. With
/// [`Start::Absolute`] coordinates are the work coordinates active on the machine. The head may be anywhere at the start,
/// because the program first moves it to the plan's home. With [`Start::Current`] every motion is given as seen from the
/// one before (G91), so the job lies where the head stands when the program begins.
///
/// # Errors
/// The controller's 32-bit numbers are too coarse for the job, or the dialect cannot do what the plan asks for.
pub fn gcode<'a>(
    plan: &Plan,
    sheet: &SheetFacts,
    profile: &Profile,
    job: impl Into<JobFacts<'a>>,
    start: Start,
) -> Result<String, OutputError> {
    let [x0, y0, x1, y1] = plan.summary.bounds;
    let bounds = Aabb { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) };
    if let Some(far) = far_out(&bounds.with(profile.home())) {
        return Err(OutputError::FarFromOrigin { x: far.at.x, y: far.at.y, spacing: far.spacing });
    }
    let dialect = profile.dialect.document().map_err(OutputError::Dialect)?;
    let writer = Writer::new(profile, &dialect, start);
    writer.refuse(plan, sheet)?;
    let facts = Facts::of(plan, profile, &dialect, &job.into());
    writer.program(plan, sheet, &facts).map(checksum::filled).map_err(|line| {
        OutputError::Dialect(format!(
            "A line of the program is longer than the {} characters of the dialect \"{}\": {line}",
            dialect.line_length, dialect.name
        ))
    })
}

/// Writes one plan.
struct Writer<'d> {
    profile: &'d Profile,
    dialect: &'d Dialect,
    pen: Pen<'d>,
}

impl<'d> Writer<'d> {
    fn new(profile: &'d Profile, dialect: &'d Dialect, start: Start) -> Self {
        let rapid = profile.rapid.speed[0].max(profile.rapid.speed[1]);
        Self { profile, dialect, pen: Pen::new(dialect, profile, rapid, start) }
    }

    fn pierce_time(&self) -> f64 {
        self.profile.pierce_time + self.profile.beam_on_delay
    }

    fn program(mut self, plan: &Plan, sheet: &SheetFacts, facts: &Facts) -> Result<String, String> {
        self.pen.header(facts);
        self.pen.find_start();

        // The move home is run with the laser switched off.
        let (work, way_home) = match plan.moves.split_last() {
            Some((Move::Air { to, way }, work)) => (work, Some((*to, *way))),
            _ => (plan.moves.as_slice(), None),
        };
        let all = cuts(plan).len();
        let (mut order, mut pierce, mut goes_on, mut moving) = (0, 0.0, false, false);
        let (mut height, mut flying) = (0.0, false);
        let mut head = self.profile.home();
        for (index, step) in work.iter().enumerate() {
            let stays_on = |m: &Move| m.runs_on() || matches!(m, Move::Chain { .. });
            let ends = !work.get(index + 1).is_some_and(stays_on);
            match step {
                Move::Air { to, way } => self.air(head, *to, *way),
                Move::Pierce => pierce += self.profile.pierce_time,
                Move::MovingStart => moving = true,
                // A pre-cut without length is only a charge of time, so nothing is cut.
                Move::PreCut { contour, to, ahead } if !ahead.is_empty() => {
                    self.pen.lines.comment_naming(&format!("pre-cut into contour {contour}"), "");
                    let process = CutProcess::new(&sheet.process(*contour, self.profile), height);
                    self.contour(&process, ahead, mem::take(&mut pierce) + self.profile.beam_on_delay, true);
                    self.pen.rapid(*to);
                }
                Move::PreCut { .. } => {}
                Move::Macro { .. } => self.pen.settle_dark(self.profile.macro_time()),
                Move::Wait { seconds } => {
                    self.pen.lines.comment_naming(&format!("waits {seconds:.3} s until it has cooled"), "");
                    self.pen.wait(*seconds);
                }
                Move::Joint { contour, path, flying: true } => {
                    let length = path.iter().map(Segment::length).sum::<f64>();
                    let words = format!("flying joint of contour {contour}: beam off for {length:.3} mm");
                    self.pen.lines.comment_naming(&words, "");
                    self.pen.run_dark(path);
                }
                Move::Fly { path } => {
                    let length = path.iter().map(Segment::length).sum::<f64>();
                    self.pen.lines.comment_naming(&format!("on the run: beam off for {length:.3} mm"), "");
                    self.pen.run_dark(path);
                }
                Move::Chain { path } => {
                    let length = path.iter().map(Segment::length).sum::<f64>();
                    let Some(Move::Cut { contour, .. }) = work.get(index + 1) else { continue };
                    let after_cut = index > 0 && matches!(work.get(index - 1), Some(Move::Cut { .. }));
                    if !after_cut {
                        order += 1;
                        let words = format!("{order} of {all}: cut contour {contour}, layer ");
                        self.pen.lines.comment_naming(&words, sheet.layer_name(*contour));
                    }
                    let verb =
                        if after_cut { "through waste" } else { "from a kerf or an edge through waste" };
                    let words = format!("{verb} for {length:.3} mm to contour {contour}");
                    self.pen.lines.comment_naming(&words, "");
                    let process = CutProcess::new(&sheet.process(*contour, self.profile), height);
                    let on = if after_cut { 0.0 } else { self.profile.beam_on_delay };
                    self.contour(&process, path, on, false);
                }
                Move::Joint { path, .. } => path.last().iter().for_each(|s| self.pen.rapid(s.end())),
                Move::Height { z } => {
                    height = *z;
                    self.pen.lower_to(height);
                }
                Move::Cut { contour, path, mark, .. } => {
                    if !goes_on {
                        order += 1;
                        let layer = sheet.layer_name(*contour);
                        let verb = if *mark { "mark" } else { "cut" };
                        let called = sheet.called(*contour);
                        let words = format!("{order} of {all}: {verb} contour {called}, layer ");
                        self.pen.lines.comment_naming(&words, layer);
                    }
                    let process = CutProcess::new(&sheet.process(*contour, self.profile), height);
                    // Over a flying joint, on the run and after a chain the beam needs no time to settle.
                    let on = if mem::take(&mut moving) || flying { 0.0 } else { self.profile.beam_on_delay };
                    self.contour(&process, path, mem::take(&mut pierce) + on, ends);
                }
            }
            goes_on = matches!(step, Move::Macro { .. } | Move::Chain { .. });
            flying = stays_on(step);
            head = step.end().unwrap_or(head);
        }

        self.pen.off();
        let last = head;
        if let Some((home, way)) = way_home {
            self.air(last, home, way);
            head = home;
        }
        if head.distance(last) < LEAST_MOTION && !Beam::new(self.dialect).goes_off_at_rest() {
            self.back_and_forth(work, head);
        }
        self.pen.take_power_back();
        self.pen.footer(facts);
        self.pen.lines.into_program()
    }

    /// Moves back along the last cut and forth again, with the beam off: a beam that goes off with the next motion only needs one.
    fn back_and_forth(&mut self, work: &[Move], head: DVec2) {
        let cut =
            work.iter().rev().find_map(|m| if let Move::Cut { path, .. } = m { Some(path) } else { None });
        let places = cut.into_iter().flatten().rev().map(|s| s.at(0.5));
        for place in places.filter(|p| p.distance(head) > LEAST_MOTION).take(1).chain([head]) {
            self.pen.rapid(place);
        }
    }

    /// Writes a move with the beam off, with the head lifted where the machine lifts it.
    fn air(&mut self, from: DVec2, to: DVec2, way: Way) {
        let levers = &self.profile.levers;
        let by_length = levers.lift_by_length().filter(|lift| lift.is_for(from.distance(to)));
        match levers.lift.filter(|_| way == Way::Lifted).or(by_length) {
            Some(lift) => self.pen.lifted(to, &lift),
            None => self.pen.rapid(to),
        }
    }

    /// Writes one contour: `seconds` of waiting with the beam on, the path, and the dwell after it if the head rests there.
    fn contour(&mut self, process: &CutProcess, path: &[Segment], seconds: f64, rests: bool) {
        self.pen.set_process(process);
        let mut rest = None;
        match self.dialect.pierce.as_ref() {
            Some(Pierce { by: PierceBy::Creep, length: Some(length), .. }) if seconds > 0.0 => {
                rest = Some(self.creep(process, path, *length, seconds));
            }
            Some(how) => self.pen.pierce(how, seconds),
            None => {}
        }
        self.pen.cut(rest.as_deref().unwrap_or(path));
        if rests {
            self.pen.settle_dark(self.profile.beam_off_delay);
        }
    }

    /// Cuts the beginning of a path in `seconds`, and returns its rest. A path that is cut in less time than that is
    /// pierced no faster than it is cut.
    fn creep(&mut self, process: &CutProcess, path: &[Segment], length: f64, seconds: f64) -> Vec<Segment> {
        let path = Path::new(path.to_vec(), false);
        let whole = path.length();
        let length = length.min(whole * 0.5).min(process.speed * seconds);
        self.pen.set_speed(length / seconds);
        self.pen.cut(&path.between(0.0, length));
        self.pen.set_speed(process.speed);
        path.between(length, whole)
    }
}
