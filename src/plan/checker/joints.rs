//! Checks micro-joints from the moves, the sheet and the machine's rules.
//!
//! That the cuts and the joints of a contour cover it exactly once is followed in `visits.rs`, where the elements of joints
//! count as the contour's. Here every joint is checked for its length, its distance from corners and other cuts, and for
//! overcuts that run over it. Where joints are missing or too far apart, places along the whole contour are tried: if one
//! more joint fits well, the plan is at fault.

use super::groups::Groups;
use super::tolerance::SAME;
use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, math};
use crate::machine::{JointKind, JointRule, LeadSide, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{Contour, Operation, Sheet};
use std::borrow::Cow;

/// Largest error of the length of a joint, mm.
const LENGTH: f64 = 1e-3;
/// A corner turns by more than this, degrees: slightly more than where the planner sees one.
const CORNER: f64 = 10.1;
/// Points along a joint at which its distance from other cuts is measured.
const POINTS: u32 = 8;
/// A missing joint counts as one if it would have this much more room on all sides, in lengths of a joint.
const MORE_ROOM: f64 = 0.6;
/// Places along a contour at which a missing joint is tried, at most, in the length of a joint and on the contour.
const FINE: f64 = 4.0;
const MOST_PLACES: f64 = 4000.0;

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
    match (rule, by_hand) {
        (rule, true) => Some((rule.or_else(first).copied().unwrap_or_default(), true)),
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

/// A joint as it was made.
struct Made {
    step: usize,
    path: Vec<Segment>,
    flying: Option<bool>,
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

pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    groups: &Groups,
    found: &mut Vec<Violation>,
) {
    let any = plan.moves.iter().any(|m| matches!(m, Move::Joint { .. }));
    if machine.joints.is_none() && sheet.joints.is_empty() && !any {
        return;
    }
    let mut work: Vec<Work> = sheet.contours.iter().map(|_| Work::default()).collect();
    for (step, m) in plan.moves.iter().enumerate() {
        match m {
            Move::Joint { contour, path, flying } => {
                let Some(work) = work.get_mut(*contour as usize) else { continue };
                work.joints.push(Made { step, path: path.clone(), flying: Some(*flying) });
            }
            Move::Cut { contour, path, leads, mark: false, .. } => {
                let Some(work) = work.get_mut(*contour as usize) else { continue };
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
    let others = Others::new(sheet);
    let mut count = 0_u32;
    for (id, (contour, mut work)) in (0..).zip(sheet.contours.iter().zip(work)) {
        let Some((step, _)) = work.first else { continue };
        let asked = asked(sheet, machine, id).filter(|_| !groups.holds(id));
        let Some((rule, by_hand)) = asked else {
            if let Some(joint) = work.joints.first() {
                let at = joint.path.first().map(Segment::start).unwrap_or_default();
                found.push(Violation::Joint {
                    step: joint.step,
                    contour: id,
                    what: "is one that nothing asks for",
                    at,
                });
            }
            continue;
        };
        let gap = rule.width + machine.kerf_width;
        let on = On {
            id,
            contour,
            others: &others,
            gap,
            clearance: rule.corner_clearance,
            corners: corners(&contour.path),
        };
        let uncut =
            contour.path.length() - work.cut - work.joints.iter().map(|j| length_of(&j.path)).sum::<f64>();
        if let (Some((_, start)), Some(end)) = (work.first, work.last)
            && (uncut - gap).abs() <= LENGTH
        {
            // The contour begins at a joint, which no move leaves.
            let along = |p| contour.path.nearest(p).map_or(0.0, |n| n.0);
            let path = contour.path.between(along(end), along(start));
            work.joints.push(Made { step, path, flying: None });
        }
        count = count.saturating_add(u32::try_from(work.joints.len()).unwrap_or(u32::MAX));
        for joint in &work.joints {
            if let Some((what, at)) = on.fault(joint, rule.kind) {
                found.push(Violation::Joint { step: joint.step, contour: id, what, at });
            }
        }
        if work.overcut > work.begins + SAME {
            let at = work.joints.first().and_then(|j| j.path.first()).map(Segment::start).unwrap_or_default();
            found.push(Violation::Joint { step, contour: id, what: "is cut by an overcut", at });
        }
        let missing =
            if by_hand { strays(sheet, &on, &work.joints) } else { on.missing(&rule, &work.joints) };
        if let Some((what, at)) = missing {
            found.push(Violation::Joint { step, contour: id, what, at });
        }
    }
    if count != plan.summary.joints {
        let (says, found_count) = (f64::from(plan.summary.joints), f64::from(count));
        found.push(Violation::Sum { what: "the number of joints", says, found: found_count });
    }
}

fn length_of(path: &[Segment]) -> f64 {
    path.iter().map(Segment::length).sum()
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

/// A contour with joints.
struct On<'a> {
    id: u32,
    contour: &'a Contour,
    others: &'a Others,
    gap: f64,
    clearance: f64,
    corners: Vec<f64>,
}

impl On<'_> {
    /// The arc length of the middle of a joint, mm. Where sides of the contour touch, the joint is on the side along which it
    /// runs.
    fn middle(&self, joint: &[Segment]) -> Option<f64> {
        let path = &self.contour.path;
        let (start, half) = (joint.first()?.start(), 0.5 * length_of(joint));
        let middle = Path::new(joint.to_vec(), false).at(half)?;
        let (mut at, mut best) = (0.0, (f64::INFINITY, 0.0));
        for s in &path.segments {
            let (f, d2) = s.nearest(start);
            let place = (at + f * s.length() + half) % path.length();
            let off = d2.sqrt() + path.at(place)?.distance(middle);
            if off < best.0 {
                best = (off, place);
            }
            at += s.length();
        }
        Some(best.1)
    }

    /// Whether another side of the contour itself is nearer than `least` to a joint with its middle at `at` mm.
    fn is_near_itself(&self, joint: &[Segment], at: f64, least: f64) -> bool {
        let bounds = joint.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds())).grown(least.max(0.0));
        let points: Vec<DVec2> = joint.iter().flat_map(|s| [0.0, 0.5, 1.0].map(|f| s.at(f))).collect();
        let mut begin = 0.0;
        self.contour.path.segments.iter().any(|side| {
            let from = begin;
            begin += side.length();
            let touches = side.bounds().overlaps(&bounds);
            touches
                && points.iter().any(|p| {
                    let (f, d2) = side.nearest(*p);
                    d2.sqrt() < least && self.apart(from + f * side.length(), at) > 1.6 * self.gap
                })
        })
    }

    fn apart(&self, a: f64, b: f64) -> f64 {
        let whole = self.contour.path.length();
        let d = (a - b).abs() % whole;
        d.min(whole - d)
    }

    /// What is wrong with a joint, and where.
    fn fault(&self, joint: &Made, kind: JointKind) -> Option<(&'static str, DVec2)> {
        let at = joint.path.first()?.start();
        let length = length_of(&joint.path);
        if (length - self.gap).abs() > LENGTH {
            return Some(("has the wrong length", at));
        }
        if joint.flying.is_some_and(|f| f != (kind == JointKind::Flying)) {
            return Some(("is of the wrong kind", at));
        }
        let middle = self.middle(&joint.path)?;
        if self.corners.iter().any(|&c| self.apart(c, middle) < 0.5 * length + self.clearance - LENGTH) {
            return Some(("is too near to a corner", at));
        }
        let least = 0.5 * self.gap - LENGTH;
        (self.is_near_others(&joint.path, least) || self.is_near_itself(&joint.path, middle, least))
            .then_some(("is too near to another cut", at))
    }

    fn is_near_others(&self, path: &[Segment], least: f64) -> bool {
        let each = (0..=POINTS).map(|k| f64::from(k) / f64::from(POINTS));
        path.iter().any(|s| each.clone().any(|f| self.others.is_near(self.id, s.at(f), least)))
    }

    /// Where joints are missing although one more fits well.
    fn missing(&self, rule: &JointRule, joints: &[Made]) -> Option<(&'static str, DVec2)> {
        let path = &self.contour.path;
        let whole = path.length();
        let middles: Vec<f64> = joints.iter().filter_map(|j| self.middle(&j.path)).collect();
        let few = (middles.len() as f64) < f64::from(rule.count.max(1));
        let step = (self.gap / FINE).max(whole / MOST_PLACES);
        let room = MORE_ROOM * self.gap + whole / 4096.0;
        let mut at = 0.0;
        while at < whole {
            // How far a joint here is from its neighbours, ahead and behind.
            let ahead = middles.iter().map(|m| (m - at).rem_euclid(whole)).fold(whole, f64::min);
            let behind = middles.iter().map(|m| (at - m).rem_euclid(whole)).fold(whole, f64::min);
            let too_long = rule.spacing.is_some_and(|most| {
                let stretch = if middles.is_empty() { whole } else { ahead + behind };
                stretch - self.gap > most + LENGTH
            });
            let near = middles.iter().any(|&m| self.apart(m, at) < 3.0 * self.gap + room)
                || self.corners.iter().any(|&c| self.apart(c, at) < 0.5 * self.gap + self.clearance + room);
            if (few || too_long) && !near {
                let joint = path.between(
                    (at - 0.5 * self.gap).rem_euclid(whole),
                    (at + 0.5 * self.gap).rem_euclid(whole),
                );
                let least = 0.5 * self.gap + room;
                if !self.is_near_others(&joint, least) && !self.is_near_itself(&joint, at, least) {
                    return Some(("is missing, although there is room for it", path.at(at)?));
                }
            }
            at += step;
        }
        None
    }
}

/// Arc lengths of the corners of a closed path, mm.
fn corners(path: &Path) -> Vec<f64> {
    let elements: Vec<&Segment> = path.segments.iter().filter(|s| s.length() > 0.0).collect();
    let ends = elements.iter().scan(0.0, |at, s| {
        *at += s.length();
        Some(*at)
    });
    let next = elements.iter().cycle().skip(1);
    let turn = |a: &Segment, b: &Segment| {
        let (u, v) = (a.tangent(1.0), b.tangent(0.0));
        math::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y).to_degrees().abs()
    };
    elements.iter().zip(next).zip(ends).filter(|((a, b), _)| turn(a, b) > CORNER).map(|(_, at)| at).collect()
}

/// All cuts with their contours.
struct Others {
    elements: Vec<(u32, Segment)>,
    index: BoxIndex,
}

impl Others {
    fn new(sheet: &Sheet) -> Self {
        let mut elements = Vec::new();
        for (id, c) in
            (0..).zip(&sheet.contours).filter(|(_, c)| c.operation == Operation::Cut && c.pass == 0)
        {
            elements.extend(c.boundary().unwrap_or(&c.path).segments.iter().map(|s| (id, *s)));
        }
        let index = BoxIndex::new(elements.iter().map(|e| e.1.bounds()));
        Self { elements, index }
    }

    fn is_near(&self, contour: u32, p: DVec2, least: f64) -> bool {
        let mut near = false;
        self.index.visit(Aabb::of(p).grown(least.max(0.0)), |k| {
            let other = self.elements.get(k).filter(|e| e.0 != contour);
            near = other.is_some_and(|(_, s)| s.nearest(p).1.sqrt() < least);
            !near
        });
        near
    }
}
