//! When each stop of the best path cuts.

use crate::geometry::Segment;
use crate::machine::{AirTime, Profile, cut_time};
use crate::plan::{AirMoves, Move, Plan};
use crate::sheet::Sheet;

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
    let (air, over_joint) = (AirMoves::new(machine), AirTime::head_down(machine));
    // Start and end of each run, including pauses in sharp corners.
    let mut runs: Vec<[f64; 2]> = Vec::with_capacity(parts.len());
    let mut goes_on = false;
    let (mut now, mut head, mut height) = (0.0, machine.home(), 0.0);
    let (mut moving, mut chained) = (false, false);
    // The contour whose passes go on until the next air move.
    let mut repeated = None;
    // Since a joint was left: the elements of a motion that goes on, and whether the contour does.
    let (mut motion, mut after_joint) = (Vec::new(), false);
    for (index, step) in plan.moves.iter().enumerate() {
        let flies_on = plan.moves.get(index + 1).is_some_and(Move::runs_on);
        match step {
            Move::Joint { path, flying, .. } => {
                let to = path.last().map_or(head, Segment::end);
                if *flying {
                    motion.extend_from_slice(path);
                } else {
                    now += over_joint.seconds(head, to);
                }
                (head, after_joint) = (to, !flying);
            }
            Move::Fly { path } => {
                motion.extend_from_slice(path);
                head = path.last().map_or(head, Segment::end);
            }
            Move::Chain { path } => {
                // On a kerf, the beam goes on after it went off.
                let after_cut = index > 0 && matches!(plan.moves.get(index - 1), Some(Move::Cut { .. }));
                now += if after_cut { 0.0 } else { machine.beam_on_delay };
                let next = plan.moves.get(index + 1);
                let process =
                    next.and_then(contour_of).map_or(machine.cut, |c| sheet.process_by_id(c, machine));
                now += cut_time(machine, &process, path);
                head = path.last().map_or(head, Segment::end);
                chained = true;
            }
            Move::Cut { path, .. } if flies_on => {
                motion.extend_from_slice(path);
                head = path.last().map_or(head, Segment::end);
            }
            Move::Air { to, way } => {
                repeated = None;
                now += air.seconds(head, *to, *way);
                head = *to;
            }
            Move::Pierce => now += machine.pierce_time,
            Move::MovingStart => moving = true,
            Move::PreCut { to, .. } => {
                now += machine.pre_cut_time.unwrap_or(0.0);
                head = *to;
            }
            Move::Macro { .. } => now += machine.macro_time(),
            Move::Wait { seconds } => now += seconds,
            Move::Height { z } => {
                now += machine.height_seconds(z - height);
                height = *z;
            }
            Move::Cut { contour, path, .. } => {
                let at_once = std::mem::take(&mut moving) || std::mem::take(&mut chained);
                let begin = now + if at_once { 0.0 } else { machine.beam_on_delay };
                motion.extend_from_slice(path);
                let process = sheet.process_by_id(*contour, machine);
                let end = begin + cut_time(machine, &process, &motion);
                motion.clear();
                let passes =
                    sheet.contours.get(*contour as usize).map_or(1, |c| sheet.passes_at_once(c, machine));
                let again = repeated == Some(*contour);
                repeated = (passes > 1).then_some(*contour);
                match runs.last_mut().filter(|_| goes_on || again || after_joint) {
                    Some(run) => run[1] = end,
                    None => runs.push([begin, end]),
                }
                after_joint = false;
                let stays_on = matches!(plan.moves.get(index + 1), Some(Move::Chain { .. }));
                now = end + if stays_on { 0.0 } else { machine.beam_off_delay };
                head = path.last().map_or(head, Segment::end);
            }
        }
        let in_motion = flies_on || step.runs_on();
        goes_on = matches!(step, Move::Macro { .. }) || (goes_on && in_motion);
    }
    let mut times = Vec::with_capacity(2 * runs.len());
    for ([begin, end], lengths) in runs.into_iter().zip(parts) {
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
