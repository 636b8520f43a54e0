//! Checks corners that a cut does not stop in: only where the machine or a person allows them, loops through waste alone, and
//! rounded corners within the greatest deviation.
//!
//! All other checks look at the plan as if the beam had turned in these corners ([`cut_through`]): so the whole contour is cut, and
//! its leads, joints and pauses are where they belong. Here a loop is followed in small steps, as chains are; it has to run
//! straight through its corner both times. The deviation of an arc is computed from its centre.

use super::fractions::fractions;
use super::groups::Groups;
use super::tolerance::SAME;
use super::violation::Violation;
use super::waste::{Near, Waste};
use crate::geometry::{DVec2, Segment, math};
use crate::machine::{CornerKind, Corners, PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan, Turn};
use crate::sheet::{Operation, Sheet};
use std::borrow::Cow;
use std::f64::consts::PI;

/// Distance of the places on a loop that are looked at, mm, and their greatest number on an element.
const STEP: f64 = 0.05;
const MOST: f64 = 5_000.0;
/// Largest angle between elements that should run on straight, rad.
const STRAIGHT: f64 = 0.1 * PI / 180.0;

/// The plan with every loop left out, and with the corner drawn in place of every arc.
pub(super) fn cut_through(plan: &Plan) -> Cow<'_, Plan> {
    let has_turns = |m: &Move| matches!(m, Move::Cut { turns, .. } if !turns.is_empty());
    if !PLANS_ALL_LEVERS || !plan.moves.iter().any(has_turns) {
        return Cow::Borrowed(plan);
    }
    let mut plan = plan.clone();
    for m in &mut plan.moves {
        if let Move::Cut { path, turns, .. } = m {
            *path = Turn::undone(path, turns);
        }
    }
    Cow::Owned(plan)
}

/// `is_flown`: the contours that are cut on the run.
pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    is_flown: impl Fn(u32) -> bool,
    found: &mut Vec<Violation>,
) {
    if !PLANS_ALL_LEVERS {
        return;
    }
    let (mut loops, mut loop_length, mut rounded, mut deviation) = (0.0, 0.0, 0.0, 0.0_f64);
    let mut room = None;
    for (step, m) in plan.moves.iter().enumerate() {
        let Move::Cut { contour, path, leads, turns, .. } = m else { continue };
        let mut done = leads.lead_in;
        let end = path.len().saturating_sub(leads.overcut + leads.lead_out);
        for turn in turns {
            let mut fault = |what, at| found.push(Violation::Corner { step, contour: *contour, what, at });
            let elements = turn.of(path);
            if turn.first <= done || elements.len() != turn.count || turn.first + turn.count >= end {
                fault("is not within the cut", turn.at);
                continue;
            }
            done = turn.first + turn.count;
            let room = room.get_or_insert_with(|| Room::new(sheet, machine, plan));
            if is_flown(*contour) || room.asked(*contour) != turn.kind {
                fault("is cut otherwise than the machine allows", turn.at);
            }
            // With the elements before and after it.
            let around = path.get(turn.first - 1..=done).unwrap_or_default();
            if let Some(at) = bend(around) {
                fault("is not run straight on", at);
            }
            if turn.kind == CornerKind::Loop {
                loops += 1.0;
                loop_length += elements.iter().map(|s| s.length()).sum::<f64>();
                if let Some((what, at)) = room.loop_fault(*contour, turn, elements) {
                    fault(what, at);
                }
            } else {
                rounded += 1.0;
                let [Segment::Arc(arc)] = elements else {
                    fault("is no arc", turn.at);
                    continue;
                };
                let (radius, off) = (arc.start.distance(arc.center), turn.at.distance(arc.center));
                deviation = deviation.max(off - radius);
                if off - radius > room.lever.deviation + SAME || radius > room.lever.round_radius + SAME {
                    fault("is rounded by more than the machine allows", turn.at);
                }
            }
        }
    }
    let s = &plan.summary;
    for (what, says, adds_up) in [
        ("the number of loops", f64::from(s.loops), loops),
        ("the length of loops", s.loop_length, loop_length),
        ("the number of rounded corners", f64::from(s.rounded_corners), rounded),
        ("the deviation of rounded corners", s.corner_deviation, deviation),
    ] {
        if (says - adds_up).abs() > SAME * (1.0 + adds_up) {
            found.push(Violation::Sum { what, says, found: adds_up });
        }
    }
}

/// Where elements do not run on straight from one to the next. A rounded corner has no other element in it, and a loop passes its
/// corner straight.
fn bend(path: &[Segment]) -> Option<DVec2> {
    path.windows(2).find_map(|pair| {
        let (a, b) = (pair[0].tangent(1.0), pair[1].tangent(0.0));
        let angle = math::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        let joined = pair[0].end().distance(pair[1].start()) <= SAME;
        (!joined || angle.abs() > STRAIGHT).then(|| pair[1].start())
    })
}

/// Where loops may be.
struct Room<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    lever: Corners,
    groups: Groups<'s>,
    waste: Waste<'s>,
}

impl<'s> Room<'s> {
    fn new(sheet: &'s Sheet, machine: &'s Profile, plan: &Plan) -> Self {
        let lever = machine.levers.corners.unwrap_or_default();
        let waste = Waste::new(sheet, machine, lever.clearance);
        Self { sheet, machine, lever, groups: Groups::new(sheet, machine, plan), waste }
    }

    /// What the machine or a person asks for at the corners of a contour.
    fn asked(&self, id: u32) -> CornerKind {
        let Some(contour) = self.sheet.contours.get(id as usize) else { return CornerKind::Stop };
        let once = self.sheet.process_of(contour, self.machine).passes == 1 && contour.pass == 0;
        let is_cut = contour.operation == Operation::Cut && contour.path.closed && !contour.self_crossing;
        if self.machine.levers.corners.is_none() || !once || !is_cut || self.groups.holds(id) {
            return CornerKind::Stop;
        }
        let rule = if contour.depth % 2 == 1 { self.lever.hole } else { self.lever.outer };
        self.sheet.chosen_corners(id).unwrap_or(rule)
    }

    /// What is wrong with a loop, and where.
    fn loop_fault(&self, id: u32, turn: &Turn, path: &[Segment]) -> Option<(&'static str, DVec2)> {
        let [Segment::Line(ahead), Segment::Arc(arc), Segment::Line(back)] = path else {
            return Some(("is no loop", turn.at));
        };
        if ahead.start.distance(turn.at) > SAME || back.end.distance(turn.at) > SAME {
            return Some(("is not where its loop begins and ends", turn.at));
        }
        if (arc.start.distance(arc.center) - self.lever.loop_radius).abs() > SAME {
            return Some(("has a loop of another radius", turn.at));
        }
        let reach = ahead.end.distance(turn.at);
        for s in path {
            for p in fractions(s.length(), STEP, [2.0, MOST]).map(|f| s.at(f)) {
                let gone = p.distance(turn.at).min(reach);
                match self.waste.too_near([(id, gone); 2], p) {
                    Near::None => {}
                    Near::Own => return Some(("has a loop along its own contour", p)),
                    Near::Other => return Some(("has a loop too near to another cut", p)),
                }
            }
        }
        let depth = self.sheet.contours.get(id as usize).map_or(0, |c| c.depth);
        let middle = path[1].at(0.5);
        (self.waste.depth(middle) != depth + depth % 2).then_some(("has a loop that is not in waste", middle))
    }
}
