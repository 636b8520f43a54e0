//! Replays when each cut begins and ends, and looks for cuts that follow one near them too soon.
//!
//! A cut through waste belongs to the cut that follows it: that one begins where the beam does.
//!
//! It shares no formula with `src/heat` and `plan/cooled.rs`: seconds are added up with the formulas of `textbook.rs`, and the distance of two
//! lines is that of places along one from the elements of the other, halved until it is clear.

use super::textbook::{air_time, is_lifted, trapezoid};
use super::violation::Violation;
use crate::geometry::{Aabb, DVec2, Path, Segment};
use crate::machine::{Heat, PLANS_ALL_LEVERS, Profile, cut_time};
use crate::plan::model::{Move, Plan};
use crate::sheet::{Operation, Sheet};

/// Times, s, and distances, mm, that differ by less may be taken for the same: what sums of thousands of numbers are off, ten times over.
const SAME: f64 = 1e-5;
/// Most places along a line that are tried: lines that run beside each other at just the distance are too close to call.
const MOST: u32 = 20_000;

/// A cut that heats what is near it.
struct Heated<'s> {
    contour: u32,
    line: &'s Path,
    bounds: Aabb,
    /// When it ended, s; as long as it has not, when it began.
    at: f64,
}

/// Whether two lines are near each other, if that is not too close to call.
#[derive(Clone, Copy, PartialEq)]
enum Near {
    No,
    Perhaps,
    Surely,
}

pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    // Builds without it refuse machines that mind heat.
    if !PLANS_ALL_LEVERS {
        return;
    }
    let heat = machine.levers.heat.filter(|h| h.distance > 0.0 && h.seconds > 0.0);
    let waits = heat.is_some_and(|h| h.charge.is_none());
    let mut clock = Clock::new(sheet, machine);
    let mut cuts = Cuts { heat, waits, heated: Vec::new(), surely: 0, perhaps: 0 };
    // When the head arrived where it is, or had waited there, and the move that waited.
    let (mut begins, mut waited) = (0.0, None);
    for (step, m) in plan.moves.iter().enumerate() {
        if let Move::Cut { contour, .. } = m
            && cuts.heated.last().is_none_or(|e| e.contour != *contour)
            && let Some(line) = hot_line(sheet, *contour)
        {
            let bounds = line.bounds();
            let cut = Heated { contour: *contour, line, bounds, at: begins };
            let may_begin = cuts.may_begin(step, &cut, found);
            if let Some(wait) = waited.take()
                && (!waits || begins > may_begin + SAME)
            {
                found.push(Violation::NeedlessWait { step: wait });
            }
            cuts.heated.push(cut);
        }
        clock.add(m, plan.moves.get(step + 1).is_some_and(Move::runs_on));
        match m {
            Move::Cut { contour, .. } => {
                if let Some(last) = cuts.heated.last_mut().filter(|e| e.contour == *contour) {
                    last.at = clock.seconds;
                }
                begins = clock.seconds;
            }
            Move::Air { .. } | Move::Wait { .. } => begins = clock.seconds,
            _ => continue,
        }
        // A wait that no cut follows is for nothing.
        if let Some(wait) = waited.take() {
            found.push(Violation::NeedlessWait { step: wait });
        }
        waited = matches!(m, Move::Wait { .. }).then_some(step);
    }
    found.extend(waited.map(|step| Violation::NeedlessWait { step }));
    let says = plan.summary.hot_pairs;
    let most = if waits { 0 } else { cuts.perhaps };
    if !(cuts.surely.min(most)..=most).contains(&says) {
        let (what, says, found_pairs) = ("the number of hot pairs", f64::from(says), f64::from(cuts.surely));
        found.push(Violation::Sum { what, says, found: found_pairs });
    }
}

/// The cuts so far, and how many pairs of them are too hot.
struct Cuts<'c> {
    heat: Option<Heat>,
    /// Whether the head waits, so that there are no hot pairs.
    waits: bool,
    heated: Vec<Heated<'c>>,
    /// Pairs that are too hot in any case, and those that are too close to call as well.
    surely: u32,
    perhaps: u32,
}

impl Cuts<'_> {
    /// When a cut may begin, s, that begins at its time: once those near it have cooled. Counts those that have not.
    fn may_begin(&mut self, step: usize, cut: &Heated, found: &mut Vec<Violation>) -> f64 {
        let mut may_begin = 0.0_f64;
        let Some(heat) = self.heat else { return may_begin };
        for before in self.heated.iter().rev() {
            let apart = cut.at - before.at;
            if apart >= heat.seconds + SAME {
                break;
            }
            let near = near((cut.line, &cut.bounds), (before.line, &before.bounds), heat.distance);
            if near != Near::No {
                may_begin = may_begin.max(before.at + heat.seconds);
            }
            if apart < heat.seconds - SAME && near == Near::Surely {
                self.surely += 1;
                if self.waits {
                    let (contour, hot) = (cut.contour, before.contour);
                    found.push(Violation::Hot { step, contour, hot, seconds: apart });
                }
            }
            self.perhaps += u32::from(near != Near::No);
        }
        may_begin
    }
}

/// The line of a contour that heats what is near it.
fn hot_line(sheet: &Sheet, contour: u32) -> Option<&Path> {
    let known = sheet.contours.get(contour as usize)?;
    (known.operation == Operation::Cut && !known.skeleton).then_some(&known.path)
}

/// Whether two lines, each with the box around it, are nearer to each other than `distance` mm.
fn near((a, x): (&Path, &Aabb), (b, y): (&Path, &Aabb), distance: f64) -> Near {
    let gap = |low: f64, high: f64| (low - high).max(0.0);
    let wide = gap(x.min.x, y.max.x).max(gap(y.min.x, x.max.x));
    let high = gap(x.min.y, y.max.y).max(gap(y.min.y, x.max.y));
    if (wide * wide + high * high).sqrt() >= distance + SAME {
        return Near::No;
    }
    // Distances of places along a line differ by no more than the places: what lies between two of them is no nearer than this allows.
    let length = a.length();
    let far = |along: f64| {
        let place = a.at(along.min(length)).unwrap_or(DVec2::NAN);
        b.segments.iter().map(|s: &Segment| s.nearest(place).1).fold(f64::INFINITY, f64::min).sqrt()
    };
    let mut rest = vec![[0.0, far(0.0), length, far(length)]];
    let mut tried = 0;
    while let Some([from, at_from, to, at_to]) = rest.pop() {
        if at_from.min(at_to) < distance - SAME {
            return Near::Surely;
        }
        let half = 0.5 * (to - from);
        if 0.5 * (at_from + at_to) - half >= distance + SAME {
            continue;
        }
        if half < SAME || tried == MOST {
            return Near::Perhaps;
        }
        tried += 1;
        let at_half = far(from + half);
        rest.push([from, at_from, from + half, at_half]);
        rest.push([from + half, at_half, to, at_to]);
    }
    Near::No
}

/// Seconds from the beginning of the job.
struct Clock<'a> {
    sheet: &'a Sheet,
    machine: &'a Profile,
    seconds: f64,
    head: DVec2,
    height: f64,
    moving: bool,
    motion: Vec<Segment>,
    /// Length of the cut through waste that leads to the next cut, mm, and whether the beam was on before it.
    chain: f64,
    lit: bool,
    after_cut: bool,
}

impl<'a> Clock<'a> {
    fn new(sheet: &'a Sheet, machine: &'a Profile) -> Self {
        let (head, motion) = (machine.home(), Vec::new());
        let (chain, lit, after_cut) = (0.0, false, false);
        Self { sheet, machine, seconds: 0.0, head, height: 0.0, moving: false, motion, chain, lit, after_cut }
    }

    fn add(&mut self, m: &Move, goes_on: bool) {
        let machine = self.machine;
        self.seconds += match m {
            Move::Air { to, way } => {
                let by = *to - self.head;
                air_time(machine, by, is_lifted(machine, by, *way))
            }
            Move::Pierce => machine.pierce_time,
            Move::PreCut { .. } => machine.pre_cut_time.unwrap_or(0.0),
            Move::Macro { .. } => machine.macro_time(),
            Move::Wait { seconds } => *seconds,
            Move::Height { z } => {
                let by = (z - self.height).abs();
                self.height = *z;
                machine.z_speed.map_or(0.0, |speed| by / speed)
            }
            Move::Joint { path, flying: false, .. } => {
                path.last().map_or(0.0, |s| air_time(machine, s.end() - self.head, false))
            }
            Move::Joint { path, .. } | Move::Fly { path } => {
                self.motion.extend(path);
                0.0
            }
            // At the speed of the cut that follows. Right after a cut, the beam is on.
            Move::Chain { path } => {
                self.chain = path.iter().map(|s| s.end().distance(s.start())).sum();
                self.lit = self.after_cut;
                0.0
            }
            Move::MovingStart => {
                self.moving = true;
                0.0
            }
            Move::Cut { contour, path, .. } => {
                self.motion.extend(path);
                if goes_on {
                    0.0
                } else {
                    let on = if std::mem::take(&mut self.moving) { 0.0 } else { machine.beam_on_delay };
                    let delays = on + machine.beam_off_delay;
                    let process = self.sheet.process_by_id(*contour, machine);
                    let accel = process.accel.unwrap_or(f64::INFINITY);
                    let chain = trapezoid(std::mem::take(&mut self.chain), process.speed, accel);
                    let along = cut_time(machine, &process, &std::mem::take(&mut self.motion));
                    chain + along + if std::mem::take(&mut self.lit) { 0.0 } else { delays }
                }
            }
        };
        self.after_cut = matches!(m, Move::Cut { .. });
        self.head = m.end().unwrap_or(self.head);
    }
}
