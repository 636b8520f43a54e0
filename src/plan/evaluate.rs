//! Adds up a list of moves on a machine, from the moves alone.
//!
//! Cuts that are joined by joints without a stop, or cut on the run, are one motion: its time is that of all its elements, and the beam settles
//! once.

use super::air::AirMoves;
use super::model::{Move, Summary, Way};
use crate::geometry::{Aabb, Segment};
use crate::machine::{AirTime, Profile, cut_time};
use crate::sheet::Sheet;
use std::borrow::Cow;

/// The sums over moves on a sheet that start at the machine's home. The moves do not contain the number of parts, that of
/// joints or a lower bound, so `parts` and `joints` are 0 and there is no gap.
///
/// Every cut and mark is charged the beam delays, but only the one after it if it begins moving, and every piercing the pierce
/// time; both are in `pierce_time`. A contour that is cut in several stretches or passes counts once.
pub fn evaluate(moves: &[Move], sheet: &Sheet, machine: &Profile) -> Summary {
    let (air, over_joint) = (AirMoves::new(machine), AirTime::head_down(machine));
    let mut sum = Summary::default();
    let mut bounds = Aabb::EMPTY;
    let (mut head, mut height) = (machine.home(), 0.0);
    let (mut moving, mut around) = (false, false);
    let mut worked = vec![false; sheet.contours.len()];
    // Seconds at the end of the last cut that is no skeleton cut.
    let mut parts_end = 0.0;
    // The elements of a motion that goes on over a joint or to the next cut.
    let mut motion: Vec<Segment> = Vec::new();
    for (index, step) in moves.iter().enumerate() {
        match step {
            Move::Air { to, way } => {
                sum.air_length += head.distance(*to);
                sum.air_time += air.seconds(head, *to, *way);
                sum.lifts += u32::from(air.is_lifted(head, *to, *way));
                sum.crossings += u32::from(*way == Way::Crosses);
                // A way around ends with the first move that is not to a way point.
                sum.detours += u32::from(*way == Way::Around && !around);
                around = *way == Way::Around;
                head = *to;
            }
            Move::Pierce => {
                sum.pierces += 1;
                sum.pierce_time += machine.pierce_time;
            }
            Move::MovingStart => {
                sum.moving_starts += 1;
                moving = true;
            }
            Move::PreCut { to, .. } => {
                sum.pre_cuts += 1;
                sum.pre_cut_time += machine.pre_cut_time.unwrap_or(0.0);
                head = *to;
            }
            Move::Height { z } => {
                sum.air_time += machine.height_seconds(z - height);
                height = *z;
            }
            Move::Macro { .. } => sum.macro_time += machine.macro_time(),
            Move::Joint { path, flying: true, .. } => {
                motion.extend(path);
                head = path.last().map_or(head, Segment::end);
            }
            Move::Fly { path } => {
                sum.fly_cuts += 1;
                motion.extend(path);
                head = path.last().map_or(head, Segment::end);
            }
            Move::Joint { path, .. } => {
                let to = path.last().map_or(head, Segment::end);
                let seconds = over_joint.seconds(head, to);
                sum.air_length += head.distance(to);
                sum.air_time += seconds;
                sum.joint_time += seconds + machine.pierce_time + machine.beam_delays();
                head = to;
            }
            Move::Cut { contour, with, path, leads, .. } => {
                let Some(last) = path.last() else { continue };
                let [lead_in, _, overcut, lead_out] = leads.divide(path);
                for contour in with.iter().chain([contour]).map(|&c| c as usize) {
                    if let Some(worked) = worked.get_mut(contour) {
                        *worked = true;
                    }
                }
                let process = sheet.process_by_id(*contour, machine);
                sum.cut_length += path.iter().map(Segment::length).sum::<f64>();
                sum.lead_length +=
                    [lead_in, overcut, lead_out].into_iter().flatten().map(Segment::length).sum::<f64>();
                if moves.get(index + 1).is_some_and(Move::runs_on) {
                    motion.extend(path);
                } else {
                    let whole = if motion.is_empty() {
                        Cow::Borrowed(path)
                    } else {
                        motion.extend(path);
                        Cow::Owned(std::mem::take(&mut motion))
                    };
                    sum.cut_time += cut_time(machine, &process, &whole);
                    sum.pierce_time += machine.delays_of_cut(std::mem::take(&mut moving));
                }
                bounds = path.iter().fold(bounds, |b, s| b.union(s.bounds()));
                head = last.end();
                if sheet.contours.get(*contour as usize).is_some_and(|c| c.skeleton) {
                    sum.skeleton_length += path.iter().map(Segment::length).sum::<f64>();
                    sum.skeleton_time = sum.seconds() - parts_end;
                } else {
                    parts_end = sum.seconds();
                }
            }
        }
    }
    // The earlier passes over a line are no contours of their own.
    for (contour, _) in
        sheet.contours.iter().zip(worked).filter(|(c, worked)| *worked && c.next_pass.is_none())
    {
        if contour.skeleton {
            sum.skeleton_cuts += 1;
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
