//! Checks leads and overcuts from the moves, the sheet and the machine's rules, with formulas of its own.
//!
//! Only closed cuts have them, and only by a rule. The joints of arcs are tangent, computed from their radii. An overcut
//! follows the contour from its beginning for the length of the rule, and a gap is left where the rule says so. That leads
//! lie in scrap is checked at points along them (`lead_room.rs`).

use super::groups::Groups;
use super::joints;
use super::lead_room::Room;
use super::lead_rules::{asked_of_outline, rule};
use super::macros::joined;
use super::tolerance::SAME;
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment, math};
use crate::machine::{LeadKind, PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{Contour, Sheet};
use std::f64::consts::PI;

/// Largest angle between a tangent arc and what it joins, rad.
const TANGENT: f64 = 0.1 * PI / 180.0;
/// Largest error of an overcut, mm.
const OVERCUT: f64 = 1e-3;

/// The overcut of a contour by the machine's rules, mm; negative for a gap.
pub(super) fn overcut(sheet: &Sheet, machine: &Profile, id: u32, contour: &Contour) -> f64 {
    wanted(sheet, machine, id, contour).unwrap_or(0.0)
}

/// The same; `None` if nothing asks for leads or an overcut. What is pierced at speed is cut again, unless it has a gap; a
/// contour with joints is pierced at rest.
fn wanted(sheet: &Sheet, machine: &Profile, id: u32, contour: &Contour) -> Option<f64> {
    let half = 0.5 * contour.path.length();
    let moving = machine.levers.moving_pierce.filter(|_| joints::asked(sheet, machine, id).is_none());
    let again = moving.map_or(0.0, |p| p.overcut);
    let asked = match rule(sheet, machine, id, contour)? {
        Some(rule) if rule.overcut < 0.0 => rule.overcut,
        Some(rule) => rule.overcut.max(again),
        None if again > 0.0 => again,
        None => return None,
    };
    Some(asked.clamp(-half, half))
}

pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    is_flown: impl Fn(u32) -> bool,
    found: &mut Vec<Violation>,
) {
    let any = plan.moves.iter().any(|m| matches!(m, Move::Cut { leads, .. } if !leads.is_empty()));
    if machine.leads.is_none() && sheet.choices.is_empty() && !any {
        return;
    }
    let groups = Groups::new(sheet, machine, plan);
    let room = Room::new(sheet, machine);
    // Faults of pauses are reported elsewhere.
    for (step, m) in joints::whole(joined(&plan.moves, machine, &groups, &mut Vec::new())) {
        let Move::Cut { contour, path, leads, .. } = m.as_ref() else { continue };
        let Some(known) = sheet.contours.get(*contour as usize).filter(|_| !is_flown(*contour)) else {
            continue;
        };
        let mut fault = |what, at| found.push(Violation::Lead { step, contour: *contour, what, at });
        let start = path.first().map_or(DVec2::ZERO, Segment::start);
        let [lead_in, on, again, lead_out] = leads.divide(path);
        if PLANS_ALL_LEVERS && groups.holds(*contour) && !leads.is_empty() && !machine.makes_pre_cuts() {
            let straight = matches!(lead_in, [Segment::Line(_)]) && again.is_empty() && lead_out.is_empty();
            let pierced = step > 0 && plan.moves.get(step - 1) == Some(&Move::Pierce);
            if !straight || !pierced || !asked_of_outline(sheet, machine, *contour, known) {
                fault("is one that no rule asks for", start);
            } else if let Some((what, at)) = room.fault_to_node(known, lead_in) {
                fault(what, at);
            }
            continue;
        }
        let Some(wanted) = wanted(sheet, machine, *contour, known).filter(|_| !groups.holds(*contour)) else {
            if !leads.is_empty() {
                fault("is one that no rule asks for", start);
            }
            continue;
        };
        let bare = sheet.chosen_lead(*contour) == Some(LeadKind::None);
        if bare && !(lead_in.is_empty() && lead_out.is_empty()) {
            fault("is one that a person does not want", start);
        }
        let length = |path: &[Segment]| path.iter().map(Segment::length).sum::<f64>();
        let joint = joints::length(sheet, machine, *contour);
        // A cut that begins at a joint ends where the joint begins, whatever the overcut.
        let at_joint = joint > 0.0 && (known.path.length() - length(on) - joint).abs() <= OVERCUT;
        let has_leads = (!leads.is_empty() || wanted < 0.0) && !(at_joint && again.is_empty());
        if has_leads && (length(again) - wanted.max(0.0)).abs() > OVERCUT {
            fault("has the wrong length", again.first().map_or(start, Segment::start));
        }
        if let Some(at) = strays(on, again) {
            fault("does not repeat the beginning of the contour", at);
        }
        let last = again.last().or(on.last());
        if let Some(at) = bent(None, lead_in, on.first()).or_else(|| bent(last, lead_out, None)) {
            fault("has an arc that is not tangent", at);
        }
        for lead in [lead_in, lead_out] {
            if let Some((what, at)) = room.fault(*contour, lead) {
                fault(what, at);
            }
        }
    }
}

/// Where an overcut is not on the beginning of the contour.
pub(super) fn strays(on: &[Segment], again: &[Segment]) -> Option<DVec2> {
    let (first, second) = (Path::new(on.to_vec(), false), Path::new(again.to_vec(), false));
    let length = second.length();
    (0..=8).filter(|_| length > 0.0).find_map(|k| {
        let at = length * f64::from(k) / 8.0;
        let (a, b) = (first.at(at)?, second.at(at)?);
        (a.distance(b) > SAME + 1e-6).then_some(b)
    })
}

/// Where an arc of a lead is not tangent to its neighbour; `before` and `after` are those of the whole lead.
fn bent(before: Option<&Segment>, lead: &[Segment], after: Option<&Segment>) -> Option<DVec2> {
    let chain: Vec<&Segment> = before.into_iter().chain(lead).chain(after).collect();
    let first = usize::from(before.is_some());
    let of_lead = first..first + lead.len();
    chain.windows(2).enumerate().find_map(|(k, pair)| {
        let is_arc = |i: usize| of_lead.contains(&i) && matches!(chain[i], Segment::Arc(_));
        let (a, b) = (direction(pair[0], true), direction(pair[1], false));
        let turn = math::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        ((is_arc(k) || is_arc(k + 1)) && turn.abs() > TANGENT).then(|| pair[1].start())
    })
}

/// The direction of travel at an end of an element: across its radius, or along its line.
fn direction(s: &Segment, at_end: bool) -> DVec2 {
    match s {
        Segment::Line(l) => l.end - l.start,
        Segment::Arc(a) => {
            let out = if at_end { a.end - a.center } else { a.start - a.center };
            let ahead = DVec2::new(-out.y, out.x);
            if a.sweep > 0.0 { ahead } else { -ahead }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    #[test]
    fn an_arc_that_meets_at_an_angle_is_found() {
        let p = DVec2::new;
        let arc = Segment::Arc(Arc::new(p(0.0, -2.0), p(2.0, 0.0), p(2.0, -2.0), false));
        let contour = |degrees: f64| {
            let (y, x) = (math::sin(degrees.to_radians()), math::cos(degrees.to_radians()));
            Segment::line(p(2.0, 0.0), p(2.0 + x, y))
        };
        assert_eq!(bent(None, &[arc], Some(&contour(0.09))), None);
        assert_eq!(bent(None, &[arc], Some(&contour(0.11))), Some(p(2.0, 0.0)));
        // A line may meet the contour at any angle.
        assert_eq!(bent(None, &[Segment::line(p(2.0, -3.0), p(2.0, 0.0))], Some(&contour(0.0))), None);
        let line = Segment::line(p(0.5, -4.0), p(0.0, -2.0));
        assert_eq!(bent(None, &[line, arc], Some(&contour(0.0))), Some(p(0.0, -2.0)));
    }
}
