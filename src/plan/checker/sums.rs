//! Adds up lengths, counts and times again.
//!
//! The trapezoidal motion of an air move is computed here a second time on purpose, in the plain form of textbooks: speed,
//! acceleration, distance. Otherwise an error in `machine/motion.rs` would not be noticed.

use super::groups::Groups;
use super::joints;
use super::tolerance::{SAME, rounding};
use super::violation::Violation;
use crate::geometry::{Aabb, DVec2, Path, Segment};
use crate::machine::{Profile, RiskyMoves, Travel, cut_time};
use crate::order::sort_by;
use crate::plan::model::{Move, Plan, Way};
use crate::sheet::Sheet;

/// Relative difference within which sums agree: thousands of additions in another order.
const RELATIVE: f64 = 1e-9;

pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    groups: &Groups,
    plan: &Plan,
    found: &mut Vec<Violation>,
) {
    let (mut head, mut height) = (machine.home(), 0.0_f64);
    let (mut cuts, mut pierces, mut pre_cuts, mut macros) = (0u32, 0u32, 0u32, 0u32);
    let (mut moving_starts, mut lifts, mut fly_cuts) = (0u32, 0u32, 0u32);
    let (mut detours, mut crossings) = (0u32, 0u32);
    let (mut chains, mut edge_starts, mut chain_length) = (0u32, 0u32, 0.0);
    let paths = paths(sheet, groups);
    let mut worked: Vec<u32> = Vec::new();
    let (mut air_length, mut air_seconds, mut cut_length, mut cut_seconds) = (0.0, 0.0, 0.0, 0.0);
    let mut lead_length = 0.0;
    let (mut bounds, mut slack) = (Aabb::EMPTY, 0.0_f64);
    let mut motion: Vec<Segment> = Vec::new();
    let (mut joint_seconds, mut stops) = (0.0, 0_u32);
    let (mut waits, mut wait_seconds) = (0_u32, 0.0);
    for (step, m) in plan.moves.iter().enumerate() {
        let flies_on = plan.moves.get(step + 1).is_some_and(Move::runs_on);
        match m {
            Move::Air { to, way } => {
                air_length += (*to - head).length();
                let lifted = is_lifted(machine, *to - head, *way);
                crossings += u32::from(*way == Way::Crosses);
                let goes_on = |m: &Move| matches!(m, Move::Air { way: Way::Around, .. });
                detours += u32::from(goes_on(m) && !(step > 0 && goes_on(&plan.moves[step - 1])));
                lifts += u32::from(lifted);
                air_seconds += air_time(machine, *to - head, lifted);
                head = *to;
            }
            Move::Pierce => pierces += 1,
            Move::MovingStart => moving_starts += 1,
            Move::PreCut { .. } => pre_cuts += 1,
            Move::Macro { .. } => macros += 1,
            Move::Wait { seconds } => {
                waits += 1;
                wait_seconds += seconds;
                air_seconds += seconds;
            }
            Move::Height { z } => {
                air_seconds += machine.z_speed.map_or(0.0, |speed| (z - height).abs() / speed);
                height = *z;
            }
            Move::Chain { path } => {
                let length = path.iter().map(|s| s.end().distance(s.start())).sum::<f64>();
                chains += 1;
                edge_starts += u32::from(step > 0 && !matches!(plan.moves[step - 1], Move::Cut { .. }));
                chain_length += length;
                cut_length += length;
                // From rest to rest, with the speed and acceleration of the cut that follows.
                let process = match plan.moves.get(step + 1) {
                    Some(Move::Cut { contour, .. }) => sheet.process_by_id(*contour, machine),
                    _ => machine.cut,
                };
                let (v, a) = (process.speed, process.accel.unwrap_or(f64::INFINITY));
                cut_seconds += path.iter().map(|s| trapezoid(s.end().distance(s.start()), v, a)).sum::<f64>();
                // It may begin at the edge of the sheet, beyond all contours.
                bounds = path.iter().fold(bounds, |b, s| b.union(s.bounds()));
                head = path.last().map_or(head, |s| s.end());
            }
            Move::Fly { path } => {
                fly_cuts += 1;
                motion.extend(path);
                head = path.last().map_or(head, |s| s.end());
            }
            Move::Joint { path, flying, .. } => {
                let to = path.last().map_or(head, |s| s.end());
                if *flying {
                    motion.extend(path);
                } else {
                    air_length += (to - head).length();
                    air_seconds += air_time(machine, to - head, false);
                    joint_seconds += air_time(machine, to - head, false);
                    stops += 1;
                }
                head = to;
            }
            Move::Cut { contour, with, path, leads, turns, .. } => {
                // After a chain the beam is on, unless that began on a kerf.
                let chained =
                    step > 1 && matches!(plan.moves[step - 2..step], [Move::Cut { .. }, Move::Chain { .. }]);
                cuts += u32::from(!flies_on && !chained);
                worked.push(*contour);
                worked.extend(with);
                if joints::asked(sheet, machine, *contour).is_some() || !turns.is_empty() {
                    // A joint may be where the contour reaches farthest, and a loop reaches beyond it.
                    bounds = path.iter().fold(bounds, |b, s| b.union(s.bounds()));
                } else {
                    for path in with.iter().chain([contour]).filter_map(|&c| paths.get(c as usize)) {
                        bounds = bounds.union(path.bounds());
                        slack = path.segments.iter().map(rounding).fold(slack, f64::max);
                    }
                }
                let [lead_in, _, overcut, lead_out] = leads.divide(path);
                for s in lead_in.iter().chain(lead_out) {
                    bounds = bounds.union(s.bounds());
                    lead_length += s.length();
                }
                lead_length += overcut.iter().map(|s| s.length()).sum::<f64>();
                cut_length += path.iter().map(|s| s.length()).sum::<f64>();
                motion.extend(path);
                if !flies_on {
                    cut_seconds += cut_time(machine, &sheet.process_by_id(*contour, machine), &motion);
                    motion.clear();
                }
                head = path.last().map_or(head, |s| s.end());
            }
        }
    }
    let at_rest = f64::from(cuts) - f64::from(moving_starts);
    let pierce_seconds = f64::from(pierces) * machine.pierce_time
        + at_rest * machine.beam_on_delay
        + f64::from(cuts) * machine.beam_off_delay;
    let pre_cut_seconds = f64::from(pre_cuts) * machine.pre_cut_time.unwrap_or(0.0);
    let macro_seconds = machine.macro_time() * f64::from(macros);
    // A contour that is cut in several stretches counts once.
    sort_by(&mut worked, |&c| [c.into(), 0, 0]);
    worked.dedup();
    // The earlier passes over a line are no contours of their own, nor are cuts that nobody drew.
    worked
        .retain(|&c| sheet.contours.get(c as usize).is_some_and(|c| c.next_pass.is_none() && !c.is_added()));
    let is_open = |c: &&u32| sheet.contours.get(**c as usize).is_some_and(|c| !c.path.closed);
    let (contours, open) = (worked.len() as f64, worked.iter().filter(is_open).count() as f64);
    let s = &plan.summary;
    let parts = u32::try_from(sheet.parts.len()).unwrap_or(u32::MAX);
    let total = air_seconds + cut_seconds + pierce_seconds + pre_cut_seconds + macro_seconds;
    let mut sums = vec![
        ("the number of contours", f64::from(s.contours), contours),
        ("the number of open contours", f64::from(s.open_contours), open),
        ("the number of parts", f64::from(s.parts), f64::from(parts)),
        ("the number of piercings", f64::from(s.pierces), f64::from(pierces)),
        ("the number of moving starts", f64::from(s.moving_starts), f64::from(moving_starts)),
        ("the number of cuts on the run", f64::from(s.fly_cuts), f64::from(fly_cuts)),
        ("the number of chains", f64::from(s.chains), f64::from(chains)),
        ("the number of edge starts", f64::from(s.edge_starts), f64::from(edge_starts)),
        ("the length of chains", s.chain_length, chain_length),
        ("the number of lifts", f64::from(s.lifts), f64::from(lifts)),
        ("the number of detours", f64::from(s.detours), f64::from(detours)),
        ("the number of crossings", f64::from(s.crossings), f64::from(crossings)),
        ("the number of waits", f64::from(s.waits), f64::from(waits)),
        ("the time of waits", s.wait_time, wait_seconds),
        ("the number of pre-cuts", f64::from(s.pre_cuts), f64::from(pre_cuts)),
        ("the length of air moves", s.air_length, air_length),
        ("the length of cuts", s.cut_length, cut_length),
        (
            "the time of joints",
            s.joint_time,
            joint_seconds
                + f64::from(stops) * (machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay),
        ),
        ("the length of leads", s.lead_length, lead_length),
        ("the time of air moves", s.air_time, air_seconds),
        ("the time of cuts", s.cut_time, cut_seconds),
        ("the time of piercing", s.pierce_time, pierce_seconds),
        ("the time of pre-cuts", s.pre_cut_time, pre_cut_seconds),
        ("the time of macros", s.macro_time, macro_seconds),
        ("the total time", s.total_time, total),
    ];
    if !bounds.is_empty() {
        let names = ["the least x", "the least y", "the greatest x", "the greatest y"];
        let all = [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y];
        for ((what, says), place) in names.into_iter().zip(s.bounds).zip(all) {
            // Coordinates are not sums. The bounding box of an arc that is entered in its middle, or cut backwards, is computed
            // from other ends.
            let agrees = (says - place).abs() <= SAME + slack;
            if !agrees {
                found.push(Violation::Sum { what, says, found: place });
            }
        }
    }
    if s.lower_bound > 0.0 {
        sums.push(("the lower bound", s.lower_bound, s.lower_bound.min(total)));
        sums.push(("the gap", s.gap.unwrap_or(f64::NAN), (total - s.lower_bound) / s.lower_bound));
    }
    for (what, says, adds_up) in sums {
        // Written so that NaN is a violation too.
        let agrees = (says - adds_up).abs() <= RELATIVE * (1.0 + adds_up.abs());
        if !agrees {
            found.push(Violation::Sum { what, says, found: adds_up });
        }
    }
}

/// The path of each contour; where the plan cuts a group as one, its path in the group.
fn paths<'s>(sheet: &'s Sheet, groups: &'s Groups) -> Vec<&'s Path> {
    let mut paths: Vec<&Path> = sheet.contours.iter().map(|c| &c.path).collect();
    for group in groups.each() {
        for (&contour, joined) in group.contours.iter().zip(&group.paths) {
            if let Some(path) = paths.get_mut(contour as usize) {
                *path = joined;
            }
        }
    }
    paths
}

/// Whether the head is lifted on its way, mm. Sums of coordinates may be off in their last digits.
pub(super) fn is_lifted(machine: &Profile, way: DVec2, past: Way) -> bool {
    let chosen = machine.levers.tips.is_some_and(|tips| tips.risky_moves == RiskyMoves::Avoid);
    if chosen || past == Way::Lifted {
        return past == Way::Lifted;
    }
    machine.levers.lift.is_some_and(|lift| way.length() - lift.stay_down > 1e-6)
}

/// Seconds of an air move along the vector `way`, mm, with the head lifted or down.
pub(super) fn air_time(machine: &Profile, way: DVec2, lifted: bool) -> f64 {
    let [vx, vy] = machine.rapid.speed;
    let [ax, ay] = machine.rapid.accel.unwrap_or([f64::INFINITY; 2]);
    let distance = way.length();
    if distance == 0.0 {
        return 0.0;
    }
    let (ux, uy) = (way.x.abs() / distance, way.y.abs() / distance);
    // Height to climb and to sink, and the speed of that.
    let (rise, vz) = match (machine.levers.lift, machine.z_speed) {
        (Some(lift), Some(vz)) if lifted => (2.0 * lift.height, vz),
        _ => (0.0, f64::INFINITY),
    };
    let at_rest = rise > 0.0 && machine.levers.lift.is_some_and(|lift| lift.at_rest);
    // The speed on the way with which the z axis keeps up.
    let slope = |length: f64| if rise > 0.0 && !at_rest { length / rise * vz } else { f64::INFINITY };
    let seconds = match machine.travel {
        Travel::Vector => trapezoid(distance, vx.min(vy).min(slope(distance)), ax.min(ay)),
        Travel::Straight => {
            trapezoid(distance, (vx / ux).min(vy / uy).min(slope(distance)), (ax / ux).min(ay / uy))
        }
        Travel::PerAxis => [(way.x.abs(), vx, ax), (way.y.abs(), vy, ay)]
            .into_iter()
            .filter(|axis| axis.0 > 0.0)
            .map(|(length, v, a)| trapezoid(length, v.min(slope(length)), a))
            .fold(0.0, f64::max),
    };
    if at_rest { seconds + rise / vz } else { seconds }
}

/// Seconds for `distance` from rest to rest with top speed `v` and acceleration `a`.
pub(super) fn trapezoid(distance: f64, v: f64, a: f64) -> f64 {
    let to_reach_speed = v * v / (2.0 * a);
    if distance < 2.0 * to_reach_speed {
        2.0 * (distance / a).sqrt()
    } else {
        2.0 * (v / a) + (distance - 2.0 * to_reach_speed) / v
    }
}
