//! When each stop of the best path cuts.

use crate::geometry::{DVec2, Segment};
use crate::machine::{AirTime, Profile, cut_time};
use crate::plan::{AirMoves, Move, Plan};
use crate::sheet::Sheet;
use std::mem;

/// The contour of a cut.
pub(super) fn contour_of(step: &Move) -> Option<u32> {
    if let Move::Cut { contour, .. } = step { Some(*contour) } else { None }
}

/// Start and end of cutting for each stop, in seconds from the start of the job. In a run through a pierce group, and on the run,
/// the seconds are divided among the stretches and the ways between them by their length. These are the partial sums of [`crate::plan::evaluate`].
pub(super) fn cutting_times(
    plan: &Plan,
    machine: &Profile,
    sheet: &Sheet,
    parts: &[Vec<[f64; 2]>],
) -> Vec<f64> {
    let mut clock = Clock::new(plan, machine, sheet, parts.len());
    for (index, step) in plan.moves.iter().enumerate() {
        clock.add(index, step);
    }
    let mut times = Vec::with_capacity(2 * clock.runs.len());
    for ([begin, end], lengths) in clock.runs.into_iter().zip(parts) {
        let (all, mut gone) = (lengths.iter().flatten().sum::<f64>(), 0.0);
        for [way, length] in lengths {
            gone += way;
            let from = begin + (end - begin) * (gone / all);
            gone += length;
            times.extend([from, begin + (end - begin) * (gone / all)]);
        }
    }
    times
}

/// The time, and what the next move needs to know.
struct Clock<'p> {
    moves: &'p [Move],
    machine: &'p Profile,
    sheet: &'p Sheet,
    air: AirMoves,
    over_joint: AirTime,
    /// Start and end of each run, including pauses in sharp corners.
    runs: Vec<[f64; 2]>,
    now: f64,
    head: DVec2,
    height: f64,
    /// Whether the next cut begins moving, or after a chain: the beam needs no time to settle.
    moving: bool,
    chained: bool,
    /// The contour whose passes go on until the next air move.
    repeated: Option<u32>,
    /// The elements of a motion that goes on over a joint or to the next cut.
    motion: Vec<Segment>,
    /// Whether the next cut is of the same run: after a joint with a stop, or after a pause in a corner.
    after_joint: bool,
    goes_on: bool,
}

impl<'p> Clock<'p> {
    fn new(plan: &'p Plan, machine: &'p Profile, sheet: &'p Sheet, runs: usize) -> Self {
        Self {
            moves: &plan.moves,
            machine,
            sheet,
            air: AirMoves::new(machine),
            over_joint: AirTime::head_down(machine),
            runs: Vec::with_capacity(runs),
            now: 0.0,
            head: machine.home(),
            height: 0.0,
            moving: false,
            chained: false,
            repeated: None,
            motion: Vec::new(),
            after_joint: false,
            goes_on: false,
        }
    }

    /// Adds a move.
    fn add(&mut self, index: usize, step: &Move) {
        let machine = self.machine;
        let flies_on = self.moves.get(index + 1).is_some_and(Move::runs_on);
        match step {
            Move::Joint { path, flying, .. } => {
                if *flying {
                    self.motion.extend_from_slice(path);
                } else {
                    let to = path.last().map_or(self.head, Segment::end);
                    self.now += self.over_joint.seconds(self.head, to);
                }
                self.after_joint = !flying;
            }
            Move::Fly { path } => self.motion.extend_from_slice(path),
            Move::Chain { path } => {
                // On a kerf, the beam goes on after it went off.
                let after_cut = index > 0 && matches!(self.moves.get(index - 1), Some(Move::Cut { .. }));
                self.now += if after_cut { 0.0 } else { machine.beam_on_delay };
                let next = self.moves.get(index + 1).and_then(contour_of);
                let process = next.map_or(machine.cut, |c| self.sheet.process_by_id(c, machine));
                self.now += cut_time(machine, &process, path);
                self.chained = true;
            }
            Move::Cut { path, .. } if flies_on => self.motion.extend_from_slice(path),
            Move::Cut { contour, path, .. } => self.cut(index, *contour, path),
            Move::Air { to, way } => {
                self.repeated = None;
                self.now += self.air.seconds(self.head, *to, *way);
            }
            Move::Pierce => self.now += machine.pierce_time,
            Move::MovingStart => self.moving = true,
            Move::PreCut { .. } => self.now += machine.pre_cut_time.unwrap_or(0.0),
            Move::Macro { .. } => self.now += machine.macro_time(),
            Move::Wait { seconds } => self.now += seconds,
            Move::Height { z } => {
                self.now += machine.height_seconds(z - self.height);
                self.height = *z;
            }
        }
        self.head = step.end().unwrap_or(self.head);
        let in_motion = flies_on || step.runs_on();
        self.goes_on = matches!(step, Move::Macro { .. }) || (self.goes_on && in_motion);
    }

    /// Adds a cut after which the beam goes off or the head stops.
    fn cut(&mut self, index: usize, contour: u32, path: &[Segment]) {
        let (sheet, machine) = (self.sheet, self.machine);
        let is_on = mem::take(&mut self.moving) || mem::take(&mut self.chained);
        let begin = self.now + if is_on { 0.0 } else { machine.beam_on_delay };
        self.motion.extend_from_slice(path);
        let end = begin + cut_time(machine, &sheet.process_by_id(contour, machine), &self.motion);
        self.motion.clear();
        let passes = sheet.contours.get(contour as usize).map_or(1, |c| sheet.passes_at_once(c, machine));
        let again = self.repeated == Some(contour);
        self.repeated = (passes > 1).then_some(contour);
        let after_joint = mem::take(&mut self.after_joint);
        match self.runs.last_mut().filter(|_| self.goes_on || again || after_joint) {
            Some(run) => run[1] = end,
            None => self.runs.push([begin, end]),
        }
        let stays_on = matches!(self.moves.get(index + 1), Some(Move::Chain { .. }));
        self.now = end + if stays_on { 0.0 } else { machine.beam_off_delay };
    }
}
