//! Checks micro-joints from the moves, the sheet and the machine's rules.
//!
//! That the cuts and the joints of a contour cover it exactly once is followed in `visits.rs`, where the elements of joints
//! count as the contour's. Here every joint is checked for its length, its distance from corners and other cuts, and for
//! overcuts that run over it (`joint_room.rs`).

use super::joint_room::{CORNER, LENGTH, Made, On, Others, corners, length_of};
use super::lead_rules::rule as lead_rule;
use super::tolerance::SAME;
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{JointRule, LeadSide, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{Operation, Sheet};
use std::borrow::Cow;

/// The rule for the joints of a contour, and whether a person placed them; `None` if nothing asks for joints.
pub(super) fn asked(sheet: &Sheet, machine: &Profile, id: u32) -> Option<(JointRule, bool)> {
    let contour = sheet.contours.get(id as usize)?;
    let once = sheet.process_of(contour, machine).passes == 1 && contour.next_pass.is_none();
    if !once || !contour.path.closed || contour.operation != Operation::Cut || contour.self_crossing {
        return None;
    }
    let size = contour.path.bounds().size();
    let side = if contour.depth % 2 == 1 { LeadSide::Hole } else { LeadSide::Outer };
    let rule = machine.joints.as_ref().and_then(|j| j.rule(side, [size.x, size.y]));
    let by_hand = sheet.joints.iter().any(|j| j.contour == id);
    let first = || machine.joints.as_ref().and_then(|j| j.rules.first());
    let own = || rule.or_else(first).copied().unwrap_or_default();
    if let (Some(count), false) = (sheet.chosen_joints(id), by_hand) {
        return (count > 0).then(|| (JointRule { count, spacing: None, ..own() }, false));
    }
    match (rule, by_hand) {
        (_, true) => Some((own(), true)),
        (Some(rule), false) if rule.count > 0 || rule.spacing.is_some() => Some((*rule, false)),
        _ => None,
    }
}

/// Length that each joint of a contour leaves uncut, mm; 0 if it has none.
pub(super) fn length(sheet: &Sheet, machine: &Profile, id: u32) -> f64 {
    asked(sheet, machine, id).map_or(0.0, |(rule, _)| rule.width + machine.kerf_width)
}

/// The moves with the stretches of a contour that has joints as one cut, its joints included.
pub(super) fn whole(moves: Vec<(usize, Cow<'_, Move>)>) -> Vec<(usize, Cow<'_, Move>)> {
    let mut out: Vec<(usize, Cow<Move>)> = Vec::with_capacity(moves.len());
    // The cut before a joint, which goes on after the next piercing.
    let mut goes_on = None;
    for (step, m) in moves {
        let before = goes_on.and_then(|k: usize| out.get_mut(k));
        match (m.as_ref(), before) {
            (Move::Joint { path: joint, .. }, _) => {
                goes_on = out.len().checked_sub(1);
                if let Some(Move::Cut { path, .. }) = out.last_mut().map(|o| o.1.to_mut()) {
                    path.extend(joint);
                }
                continue;
            }
            (Move::Pierce, Some(_)) => continue,
            (Move::Cut { path: more, leads: next, contour: c, .. }, Some((_, before))) => {
                if let Move::Cut { path, leads, contour, .. } = before.to_mut()
                    && contour == c
                {
                    *leads = leads.and(*next);
                    path.extend(more);
                    continue;
                }
            }
            _ => {}
        }
        goes_on = None;
        out.push((step, m));
    }
    out
}

/// What was made of one contour.
#[derive(Default)]
struct Work {
    joints: Vec<Made>,
    first: Option<(usize, DVec2)>,
    last: Option<DVec2>,
    /// Length cut of the contour itself, mm.
    cut: f64,
    /// Length of the overcut and of the contour in the first stretch, mm.
    overcut: f64,
    begins: f64,
}

pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    let any = plan.moves.iter().any(|m| matches!(m, Move::Joint { .. }));
    if machine.joints.is_none() && sheet.joints.is_empty() && sheet.choices.is_empty() && !any {
        return;
    }
    let others = Others::new(sheet);
    // Contours that may be cut as one with others have no joints, whether the plan cuts them as one or one by one.
    let grouped = sheet.may_be_cut_as_one(machine.cuts_as_one());
    // Number of joints, and of those among them that may be gaps of overcuts instead.
    let (mut count, mut either) = (0_u32, 0_u32);
    for (id, (contour, mut work)) in (0..).zip(sheet.contours.iter().zip(work(sheet, plan))) {
        let Some((step, _)) = work.first else { continue };
        let asked = asked(sheet, machine, id).filter(|_| grouped.get(id as usize) != Some(&true));
        let Some((rule, by_hand)) = asked else {
            if let Some(joint) = work.joints.first() {
                let (step, at) = (joint.step, start_of(joint));
                let what = "is one that nothing asks for";
                found.push(Violation::Joint { step, contour: id, what, at });
            }
            continue;
        };
        let on = On {
            id,
            contour,
            others: &others,
            gap: rule.width + machine.kerf_width,
            clearance: rule.corner_clearance,
            corners: CORNER.map(|least| corners(&contour.path, least)),
        };
        if let Some(joint) = at_beginning(&on, &work) {
            // An overcut may leave a gap of the same length, also where no joint fits.
            let overcut = lead_rule(sheet, machine, id, contour).flatten().map_or(0.0, |rule| rule.overcut);
            let is_either = (overcut + on.gap).abs() <= LENGTH;
            let fits =
                || on.fault(&joint, rule.kind).is_none() && !(by_hand && all_made(sheet, id, &work.joints));
            if !is_either || fits() {
                either = either.saturating_add(u32::from(is_either));
                work.joints.push(joint);
            }
        }
        count = count.saturating_add(u32::try_from(work.joints.len()).unwrap_or(u32::MAX));
        for joint in &work.joints {
            if let Some((what, at)) = on.fault(joint, rule.kind) {
                found.push(Violation::Joint { step: joint.step, contour: id, what, at });
            }
        }
        if work.overcut > work.begins + SAME {
            let at = work.joints.first().map(start_of).unwrap_or_default();
            found.push(Violation::Joint { step, contour: id, what: "is cut by an overcut", at });
        }
        let missing =
            if by_hand { strays(sheet, &on, &work.joints) } else { on.missing(&rule, &work.joints) };
        if let Some((what, at)) = missing {
            found.push(Violation::Joint { step, contour: id, what, at });
        }
    }
    let least = count.saturating_sub(either);
    if !(least..=count).contains(&plan.summary.joints) {
        let (says, found_count) = (f64::from(plan.summary.joints), f64::from(least));
        found.push(Violation::Sum { what: "the number of joints", says, found: found_count });
    }
}

/// What the plan makes of each contour.
fn work(sheet: &Sheet, plan: &Plan) -> Vec<Work> {
    let mut all: Vec<Work> = sheet.contours.iter().map(|_| Work::default()).collect();
    for (step, m) in plan.moves.iter().enumerate() {
        match m {
            Move::Joint { contour, path, flying } => {
                let Some(work) = all.get_mut(*contour as usize) else { continue };
                work.joints.push(Made { step, path: path.clone(), flying: Some(*flying) });
            }
            Move::Cut { contour, path, leads, mark: false, .. } => {
                let Some(work) = all.get_mut(*contour as usize) else { continue };
                let [_, on, overcut, _] = leads.divide(path);
                work.first = work.first.or(on.first().map(|s| (step, s.start())));
                work.last = on.last().map(Segment::end).or(work.last);
                work.cut += length_of(on);
                work.overcut += length_of(overcut);
                if work.joints.is_empty() {
                    work.begins += length_of(on);
                }
            }
            _ => {}
        }
    }
    all
}

/// The joint at which a contour begins, which no move leaves: what is uncut besides the other joints is as long as a joint.
fn at_beginning(on: &On, work: &Work) -> Option<Made> {
    let (step, start) = work.first?;
    let end = work.last?;
    let left = work.joints.iter().map(|j| length_of(&j.path)).sum::<f64>();
    let uncut = on.contour.path.length() - work.cut - left;
    ((uncut - on.gap).abs() <= LENGTH).then(|| {
        let along = |p| on.contour.path.nearest(p).map_or(0.0, |n| n.0);
        Made { step, path: on.contour.path.between(along(end), along(start)), flying: None }
    })
}

fn start_of(joint: &Made) -> DVec2 {
    joint.path.first().map(Segment::start).unwrap_or_default()
}

/// Whether these are as many joints as a person placed on a contour.
fn all_made(sheet: &Sheet, contour: u32, joints: &[Made]) -> bool {
    sheet.joints.iter().filter(|j| j.contour == contour).count() <= joints.len()
}

/// A joint by hand that is farther from where the person placed it than moving it out of a corner explains.
fn strays(sheet: &Sheet, on: &On, joints: &[Made]) -> Option<(&'static str, DVec2)> {
    let drawn = on.contour.drawn.as_ref().unwrap_or(&on.contour.path);
    let wished: Vec<DVec2> = sheet
        .joints
        .iter()
        .filter(|j| j.contour == on.id)
        .filter_map(|j| drawn.at(j.at * drawn.length()))
        .collect();
    // From the drawn line to the line of the beam it is half a kerf, and at most a few more in a sharp corner.
    let most = on.clearance + 4.0 * on.gap;
    let middle = |j: &Made| Path::new(j.path.clone(), false).at(0.5 * length_of(&j.path));
    if joints.len() > wished.len() {
        return Some(("is one that nobody placed", middle(joints.first()?)?));
    }
    let astray = |at: &DVec2| wished.iter().all(|w| w.distance(*at) > most);
    joints.iter().filter_map(middle).find(astray).map(|at| ("is not where it was placed", at))
}
