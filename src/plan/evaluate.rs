//! Adds up a list of moves on a machine, from the moves alone.
//!
//! Cuts that are joined by joints without a stop, or cut on the run, are one motion: its time is that of all its elements, and the beam settles
//! once. So it is with contours that are joined by chains, but the head stops at the ends of a chain.

use super::air::AirMoves;
use super::model::{Leads, Move, Summary, Turn, Way};
use crate::geometry::{Aabb, DVec2, Segment};
use crate::machine::{AirTime, CornerKind, PLANS_ALL_LEVERS, Profile, cut_time};
use crate::sheet::Sheet;
use std::borrow::Cow;

/// The sums over moves on a sheet that start at the machine's home. The moves do not contain the number of parts, that of
/// joints or of hot pairs, or a lower bound, so `parts`, `joints` and `hot_pairs` are 0 and there is no gap.
///
/// Every cut and mark is charged the beam delays, but only the one after it if it begins moving, and every piercing the pierce
/// time; both are in `pierce_time`. A contour that is cut in several stretches or passes counts once.
pub fn evaluate(moves: &[Move], sheet: &Sheet, machine: &Profile) -> Summary {
    let mut sums = Sums::new(sheet, machine);
    for (index, step) in moves.iter().enumerate() {
        sums.add(step, moves.get(index + 1).is_some_and(Move::runs_on));
    }
    sums.finish()
}

/// The sums so far.
pub(super) struct Sums<'a> {
    sheet: &'a Sheet,
    machine: &'a Profile,
    air: AirMoves,
    over_joint: AirTime,
    sum: Summary,
    bounds: Aabb,
    head: DVec2,
    height: f64,
    moving: bool,
    around: bool,
    /// Whether the beam is still on after a chain.
    chained: bool,
    /// The cut through waste that the next cut follows, at the speed of that one.
    to_cut: Vec<Segment>,
    /// Whether the last move was a cut.
    after_cut: bool,
    worked: Vec<bool>,
    /// Seconds at the end of the last cut that is no skeleton cut.
    parts_end: f64,
    /// The elements of a motion that goes on over a joint or to the next cut.
    motion: Vec<Segment>,
}

impl<'a> Sums<'a> {
    pub(super) fn new(sheet: &'a Sheet, machine: &'a Profile) -> Self {
        Self {
            sheet,
            machine,
            air: AirMoves::new(machine),
            over_joint: AirTime::head_down(machine),
            sum: Summary::default(),
            bounds: Aabb::EMPTY,
            head: machine.home(),
            height: 0.0,
            moving: false,
            around: false,
            chained: false,
            to_cut: Vec::new(),
            after_cut: false,
            worked: vec![false; sheet.contours.len()],
            parts_end: 0.0,
            motion: Vec::new(),
        }
    }

    /// Seconds so far. Within a motion that goes on, these are those before it.
    pub(super) fn seconds(&self) -> f64 {
        self.sum.seconds()
    }

    /// Adds a move. `goes_on`: whether the next move is part of the same motion.
    pub(super) fn add(&mut self, step: &Move, goes_on: bool) {
        let after_cut = std::mem::replace(&mut self.after_cut, matches!(step, Move::Cut { .. }));
        let (sum, machine) = (&mut self.sum, self.machine);
        match step {
            Move::Air { to, way } => self.add_air(*to, *way),
            Move::Pierce => {
                sum.pierces += 1;
                sum.pierce_time += machine.pierce_time;
            }
            Move::MovingStart => {
                sum.moving_starts += 1;
                self.moving = true;
            }
            Move::Wait { seconds } => {
                sum.waits += 1;
                sum.wait_time += seconds;
                sum.air_time += seconds;
            }
            Move::PreCut { .. } => {
                sum.pre_cuts += 1;
                sum.pre_cut_time += machine.pre_cut_time.unwrap_or(0.0);
            }
            Move::Height { z } => {
                sum.air_time += machine.height_seconds(z - self.height);
                self.height = *z;
            }
            Move::Macro { .. } => sum.macro_time += machine.macro_time(),
            Move::Joint { path, flying: true, .. } => self.motion.extend(path),
            Move::Joint { path, .. } => {
                let to = path.last().map_or(self.head, Segment::end);
                let seconds = self.over_joint.seconds(self.head, to);
                sum.air_length += self.head.distance(to);
                sum.air_time += seconds;
                sum.joint_time += seconds + machine.pierce_time + machine.beam_delays();
            }
            Move::Fly { path } => {
                sum.fly_cuts += 1;
                self.motion.extend(path);
            }
            Move::Chain { path } => self.add_chain(path, after_cut),
            Move::Cut { contour, with, path, leads, turns, .. } if !path.is_empty() => {
                if PLANS_ALL_LEVERS {
                    turns.iter().for_each(|turn| add_turn(sum, turn, path));
                }
                for contour in with.iter().chain([contour]).map(|&c| c as usize) {
                    if let Some(worked) = self.worked.get_mut(contour) {
                        *worked = true;
                    }
                }
                self.add_cut(*contour, path, *leads, goes_on);
            }
            Move::Cut { .. } => {}
        }
        self.head = step.end().unwrap_or(self.head);
    }

    fn add_air(&mut self, to: DVec2, way: Way) {
        let sum = &mut self.sum;
        sum.air_length += self.head.distance(to);
        sum.air_time += self.air.seconds(self.head, to, way);
        sum.lifts += u32::from(self.air.is_lifted(self.head, to, way));
        sum.crossings += u32::from(way == Way::Crosses);
        // A way around ends with the first move that is not to a way point.
        sum.detours += u32::from(way == Way::Around && !self.around);
        self.around = way == Way::Around;
    }

    fn add_chain(&mut self, path: &[Segment], after_cut: bool) {
        let length = path.iter().map(Segment::length).sum::<f64>();
        self.sum.chains += 1;
        self.sum.chain_length += length;
        self.sum.cut_length += length;
        self.to_cut = path.to_vec();
        self.bounds = path.iter().fold(self.bounds, |b, s| b.union(s.bounds()));
        // On a kerf, the beam goes on after it went off.
        self.sum.edge_starts += u32::from(!after_cut);
        self.chained = after_cut;
    }

    fn add_cut(&mut self, contour: u32, path: &[Segment], leads: Leads, goes_on: bool) {
        let (sum, machine) = (&mut self.sum, self.machine);
        let process = self.sheet.process_by_id(contour, machine);
        if !self.to_cut.is_empty() {
            sum.cut_time += cut_time(machine, &process, &std::mem::take(&mut self.to_cut));
        }
        let length = path.iter().map(Segment::length).sum::<f64>();
        sum.cut_length += length;
        let [lead_in, _, overcut, lead_out] = leads.divide(path);
        sum.lead_length +=
            [lead_in, overcut, lead_out].into_iter().flatten().map(Segment::length).sum::<f64>();
        if goes_on {
            self.motion.extend(path);
        } else {
            let whole = if self.motion.is_empty() {
                Cow::Borrowed(path)
            } else {
                self.motion.extend(path);
                Cow::Owned(std::mem::take(&mut self.motion))
            };
            sum.cut_time += cut_time(machine, &process, &whole);
            // With a chain before it, the beam is on already, and goes off once.
            if !std::mem::take(&mut self.chained) {
                sum.pierce_time += machine.delays_of_cut(std::mem::take(&mut self.moving));
            }
        }
        self.bounds = path.iter().fold(self.bounds, |b, s| b.union(s.bounds()));
        if self.sheet.contours.get(contour as usize).is_some_and(|c| c.skeleton) {
            sum.skeleton_length += length;
            sum.skeleton_time = sum.seconds() - self.parts_end;
        } else {
            self.parts_end = sum.seconds();
        }
    }

    /// The sums of all moves.
    pub(super) fn finish(self) -> Summary {
        let Self { mut sum, bounds, sheet, worked, .. } = self;
        // The earlier passes over a line are no contours of their own.
        for (contour, _) in
            sheet.contours.iter().zip(worked).filter(|(c, worked)| *worked && c.next_pass.is_none())
        {
            if contour.skeleton {
                sum.skeleton_cuts += 1;
            }
            if contour.is_added() {
                continue;
            }
            sum.contours += 1;
            sum.open_contours += u32::from(!contour.path.closed);
        }
        sum.total_time = sum.seconds();
        if !bounds.is_empty() {
            sum.bounds = [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y];
        }
        sum
    }
}

/// Adds a corner in which a cut does not stop.
fn add_turn(sum: &mut Summary, turn: &Turn, path: &[Segment]) {
    let elements = turn.of(path);
    if turn.kind == CornerKind::Loop {
        sum.loops += 1;
        sum.loop_length += elements.iter().map(Segment::length).sum::<f64>();
        return;
    }
    sum.rounded_corners += 1;
    let off = elements.iter().map(|s| s.nearest(turn.at).1).fold(f64::INFINITY, f64::min).sqrt();
    sum.corner_deviation = sum.corner_deviation.max(off);
}
