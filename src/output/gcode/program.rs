//! Writes the moves of a plan in order, with a comment at each cut.

use super::beam::Beam;
use super::facts::Facts;
use super::pen::Pen;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::dialect::{Dialect, Pierce, PierceBy};
use crate::machine::{Profile, Start};
use crate::output::SheetFacts;
use crate::output::cuts::cuts;
use crate::output::process::CutProcess;
use crate::plan::{Move, Plan, Way};
use std::mem;

/// Shortest way back along a cut that is a motion for the controller, mm: some steps of the coarsest grid.
const LEAST_MOTION: f64 = 0.1;

/// Writes one plan.
pub(super) struct Writer<'d> {
    profile: &'d Profile,
    dialect: &'d Dialect,
    pen: Pen<'d>,
    sheet: &'d SheetFacts,
    /// Number of cuts and marks in the plan, and of those that were begun.
    cuts: usize,
    order: usize,
    /// Where the head is, mm, and how deep it is lowered.
    head: DVec2,
    height: f64,
    /// Seconds of piercing for the next cut, and whether that begins moving.
    pierce: f64,
    moving: bool,
    /// Whether the next cut goes on with the one before it, so that it is not announced again.
    goes_on: bool,
    /// Whether the head runs on to the next cut or has cut through waste to it, so that the beam needs no time to settle.
    settled: bool,
}

impl<'d> Writer<'d> {
    pub(super) fn new(
        profile: &'d Profile,
        dialect: &'d Dialect,
        plan: &Plan,
        sheet: &'d SheetFacts,
        start: Start,
    ) -> Self {
        let rapid = profile.rapid.speed[0].max(profile.rapid.speed[1]);
        Self {
            profile,
            dialect,
            pen: Pen::new(dialect, profile, rapid, start),
            sheet,
            cuts: cuts(plan).len(),
            order: 0,
            head: profile.home(),
            height: 0.0,
            pierce: 0.0,
            moving: false,
            goes_on: false,
            settled: false,
        }
    }

    /// The whole program. The error is a line that is too long for the dialect.
    pub(super) fn program(mut self, plan: &Plan, facts: &Facts) -> Result<String, String> {
        self.pen.header(facts);
        self.pen.find_start();

        // The move home is run with the laser switched off.
        let (work, way_home) = match plan.moves.split_last() {
            Some((Move::Air { to, way }, work)) => (work, Some((*to, *way))),
            _ => (plan.moves.as_slice(), None),
        };
        for (index, step) in work.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|before| work.get(before));
            self.step(before, step, work.get(index + 1));
        }

        self.pen.off();
        let last = self.head;
        if let Some((home, way)) = way_home {
            self.air(home, way);
            self.head = home;
        }
        if self.head.distance(last) < LEAST_MOTION && !Beam::new(self.dialect).goes_off_at_rest() {
            self.back_and_forth(work);
        }
        self.pen.take_power_back();
        self.pen.footer(facts);
        self.pen.lines.into_program()
    }

    /// Writes a move; `before` and `next` are those around it.
    fn step(&mut self, before: Option<&Move>, step: &Move, next: Option<&Move>) {
        let stays_on = |m: &Move| m.runs_on() || matches!(m, Move::Chain { .. });
        match step {
            Move::Air { to, way } => self.air(*to, *way),
            Move::Pierce => self.pierce += self.profile.pierce_time,
            Move::MovingStart => self.moving = true,
            // A pre-cut without length is only a charge of time, so nothing is cut.
            Move::PreCut { contour, to, ahead } if !ahead.is_empty() => {
                self.pen.lines.comment_naming(&format!("pre-cut into contour {contour}"), "");
                let seconds = mem::take(&mut self.pierce) + self.profile.beam_on_delay;
                self.contour(*contour, ahead, seconds, true);
                self.pen.rapid(*to);
            }
            Move::PreCut { .. } => {}
            Move::Macro { .. } => self.pen.settle_dark(self.profile.macro_time()),
            Move::Wait { seconds } => {
                self.pen.lines.comment_naming(&format!("waits {seconds:.3} s until it has cooled"), "");
                self.pen.wait(*seconds);
            }
            Move::Joint { contour, path, flying: true } => {
                self.run_dark(&format!("flying joint of contour {contour}"), path);
            }
            Move::Joint { path, .. } => path.last().iter().for_each(|s| self.pen.rapid(s.end())),
            Move::Fly { path } => self.run_dark("on the run", path),
            Move::Chain { path } => {
                if let Some(Move::Cut { contour, .. }) = next {
                    self.chain(*contour, path, matches!(before, Some(Move::Cut { .. })));
                }
            }
            Move::Height { z } => {
                self.height = *z;
                self.pen.lower_to(self.height);
            }
            Move::Cut { contour, path, mark, .. } => {
                if !self.goes_on {
                    self.announce(if *mark { "mark" } else { "cut" }, *contour);
                }
                let on = if mem::take(&mut self.moving) || self.settled {
                    0.0
                } else {
                    self.profile.beam_on_delay
                };
                let seconds = mem::take(&mut self.pierce) + on;
                self.contour(*contour, path, seconds, !next.is_some_and(stays_on));
            }
        }
        self.goes_on = matches!(step, Move::Macro { .. } | Move::Chain { .. });
        self.settled = stays_on(step);
        self.head = step.end().unwrap_or(self.head);
    }

    /// The comment at the beginning of a cut or mark.
    fn announce(&mut self, verb: &str, contour: u32) {
        self.order += 1;
        let called = self.sheet.called(contour);
        let words = format!("{} of {}: {verb} contour {called}, layer ", self.order, self.cuts);
        self.pen.lines.comment_naming(&words, self.sheet.layer_name(contour));
    }

    /// Writes a motion with the beam off that does not stop.
    fn run_dark(&mut self, name: &str, path: &[Segment]) {
        let length = path.iter().map(Segment::length).sum::<f64>();
        self.pen.lines.comment_naming(&format!("{name}: beam off for {length:.3} mm"), "");
        self.pen.run_dark(path);
    }

    /// Writes a cut through waste to a contour.
    fn chain(&mut self, contour: u32, path: &[Segment], after_cut: bool) {
        if !after_cut {
            self.announce("cut", contour);
        }
        let length = path.iter().map(Segment::length).sum::<f64>();
        let verb = if after_cut { "through waste" } else { "from a kerf or an edge through waste" };
        self.pen.lines.comment_naming(&format!("{verb} for {length:.3} mm to contour {contour}"), "");
        let on = if after_cut { 0.0 } else { self.profile.beam_on_delay };
        self.contour(contour, path, on, false);
    }

    /// Moves back along the last cut and forth again, with the beam off: a beam that goes off with the next motion only needs one.
    fn back_and_forth(&mut self, work: &[Move]) {
        let head = self.head;
        let cut =
            work.iter().rev().find_map(|m| if let Move::Cut { path, .. } = m { Some(path) } else { None });
        let places = cut.into_iter().flatten().rev().map(|s| s.at(0.5));
        for place in places.filter(|p| p.distance(head) > LEAST_MOTION).take(1).chain([head]) {
            self.pen.rapid(place);
        }
    }

    /// Writes a move with the beam off, with the head lifted where the machine lifts it.
    fn air(&mut self, to: DVec2, way: Way) {
        let levers = &self.profile.levers;
        let by_length = levers.lift_by_length().filter(|lift| lift.is_for(self.head.distance(to)));
        match levers.lift.filter(|_| way == Way::Lifted).or(by_length) {
            Some(lift) => self.pen.lifted(to, &lift),
            None => self.pen.rapid(to),
        }
    }

    /// Writes a path with the process of a contour: `seconds` of waiting with the beam on, the path, and the dwell after it if the
    /// head rests there.
    fn contour(&mut self, contour: u32, path: &[Segment], seconds: f64, rests: bool) {
        let process = CutProcess::new(&self.sheet.process(contour, self.profile), self.height);
        self.pen.set_process(&process);
        let mut rest = None;
        match self.dialect.pierce.as_ref() {
            Some(Pierce { by: PierceBy::Creep, length: Some(length), .. }) if seconds > 0.0 => {
                rest = Some(self.creep(&process, path, *length, seconds));
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
