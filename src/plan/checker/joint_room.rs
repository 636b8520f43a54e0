//! What surrounds a micro-joint: corners, other cuts, and other sides of its own contour.
//!
//! Where joints are missing or too far apart, places along the whole contour are tried: if one more joint fits well, the
//! plan is at fault.

use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, math};
use crate::machine::{JointKind, JointRule};
use crate::sheet::{Contour, Operation, Sheet};

/// Largest error of the length of a joint, mm.
pub(super) const LENGTH: f64 = 1e-3;
/// What turns by more than the first, degrees, surely is a corner for the planner, and what turns by more than the second may
/// be one: its limit is between them.
pub(super) const CORNER: [f64; 2] = [10.1, 9.9];
/// Points along a joint at which its distance from other cuts is measured.
const POINTS: u32 = 8;
/// A missing joint counts as one if it would have this much more room on all sides, in lengths of a joint.
const MORE_ROOM: f64 = 0.6;
/// Places along a contour at which a missing joint is tried, at most, in the length of a joint and on the contour.
const FINE: f64 = 4.0;
const MOST_PLACES: f64 = 4000.0;

/// A joint as it was made.
pub(super) struct Made {
    pub(super) step: usize,
    pub(super) path: Vec<Segment>,
    pub(super) flying: Option<bool>,
}

/// A contour with joints.
pub(super) struct On<'a> {
    pub(super) id: u32,
    pub(super) contour: &'a Contour,
    pub(super) others: &'a Others,
    pub(super) gap: f64,
    pub(super) clearance: f64,
    /// Arc lengths of what surely is a corner, and of what may be one, mm.
    pub(super) corners: [Vec<f64>; 2],
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
    pub(super) fn fault(&self, joint: &Made, kind: JointKind) -> Option<(&'static str, DVec2)> {
        let at = joint.path.first()?.start();
        let length = length_of(&joint.path);
        if (length - self.gap).abs() > LENGTH {
            return Some(("has the wrong length", at));
        }
        if joint.flying.is_some_and(|f| f != (kind == JointKind::Flying)) {
            return Some(("is of the wrong kind", at));
        }
        let middle = self.middle(&joint.path)?;
        if self.corners[0].iter().any(|&c| self.apart(c, middle) < 0.5 * length + self.clearance - LENGTH) {
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
    pub(super) fn missing(&self, rule: &JointRule, joints: &[Made]) -> Option<(&'static str, DVec2)> {
        let path = &self.contour.path;
        let whole = path.length();
        let middles: Vec<f64> = joints.iter().filter_map(|j| self.middle(&j.path)).collect();
        let few = (middles.len() as f64) < f64::from(rule.count.max(1));
        let step = (self.gap / FINE).max(whole / MOST_PLACES);
        let room = MORE_ROOM * self.gap + whole / 4096.0;
        // A joint is at most a third of its contour.
        if whole < 3.0 * self.gap + room {
            return None;
        }
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
                || self.corners[1]
                    .iter()
                    .any(|&c| self.apart(c, at) < 0.5 * self.gap + self.clearance + room);
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

/// Arc lengths of the places where a closed path turns by more than `least` degrees, mm.
pub(super) fn corners(path: &Path, least: f64) -> Vec<f64> {
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
    elements.iter().zip(next).zip(ends).filter(|((a, b), _)| turn(a, b) > least).map(|(_, at)| at).collect()
}

/// All cuts with their contours.
pub(super) struct Others {
    elements: Vec<(u32, Segment)>,
    index: BoxIndex,
}

impl Others {
    pub(super) fn new(sheet: &Sheet) -> Self {
        let mut elements = Vec::new();
        for (id, c) in (0..)
            .zip(&sheet.contours)
            .filter(|(_, c)| c.operation == Operation::Cut && c.pass == 0 && !c.skeleton)
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

/// Length of a path, mm.
pub(super) fn length_of(path: &[Segment]) -> f64 {
    path.iter().map(Segment::length).sum()
}
