//! Where on a contour a joint has room: away from corners, and from the cuts of other contours.

use super::stretches::Joint;
use crate::geometry::{Aabb, BoxIndex, Path, Segment, distance, math};
use crate::sheet::{Contour, Operation};

/// A corner turns by more than this, rad: ten degrees, as elements of flattened curves turn by less.
const CORNER: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// All cuts, as joints see them.
pub(super) struct Cuts {
    /// The elements of all cuts with their contours, and where they begin along them, mm.
    elements: Vec<(u32, Segment, f64)>,
    index: BoxIndex,
}

impl Cuts {
    pub(super) fn new(contours: &[Contour]) -> Self {
        let cut =
            (0..).zip(contours).filter(|(_, c)| c.operation == Operation::Cut && c.pass == 0 && !c.skeleton);
        // The outline of an open rest runs along the sides that another contour cuts for it.
        let of = |(id, c): (u32, &Contour)| {
            let begin = |at: &mut f64, s: &Segment| Some((id, *s, std::mem::replace(at, *at + s.length())));
            c.boundary().unwrap_or(&c.path).segments.iter().scan(0.0, begin).collect::<Vec<_>>()
        };
        let elements: Vec<(u32, Segment, f64)> = cut.flat_map(of).collect();
        let index = BoxIndex::new(elements.iter().map(|e| e.1.bounds()));
        Self { elements, index }
    }

    /// Whether another contour is cut nearer than `least` mm to a stretch of a contour.
    fn is_near(&self, contour: u32, stretch: &[Segment], least: f64) -> bool {
        let bounds = stretch.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds())).grown(least);
        let mut near = false;
        self.index.visit(bounds, |k| {
            if let Some((_, other, _)) = self.elements.get(k).filter(|e| e.0 != contour) {
                near = stretch.iter().any(|s| distance(s, other).0 < least);
            }
            !near
        });
        near
    }
}

/// Points along a joint at which its distance from the other sides of its own contour is measured.
const POINTS: u32 = 4;

/// The room for joints on one contour.
pub(super) struct Room<'a> {
    pub(super) cuts: &'a Cuts,
    pub(super) contour: u32,
    pub(super) path: &'a Path,
    /// Length of the contour, mm.
    pub(super) whole: f64,
    /// Length that a joint leaves uncut, mm.
    pub(super) gap: f64,
    /// Least distance of a joint from corners, mm.
    pub(super) clearance: f64,
    /// Arc lengths of the corners, mm, in order.
    pub(super) corners: Vec<f64>,
}

impl Room<'_> {
    /// The joint with its middle at `at` mm.
    pub(super) fn joint(&self, at: f64) -> Joint {
        let from = (at - 0.5 * self.gap).rem_euclid(self.whole);
        Joint { from, to: (at + 0.5 * self.gap).rem_euclid(self.whole), length: self.gap }
    }

    /// Distance of two places along the contour, mm, the shorter way round.
    pub(super) fn apart(&self, a: f64, b: f64) -> f64 {
        let ahead = (a - b).rem_euclid(self.whole);
        ahead.min(self.whole - ahead)
    }

    /// Whether a joint with its middle at `at` mm is far enough from corners.
    pub(super) fn is_off_corners(&self, at: f64) -> bool {
        let least = self.clearance + 0.5 * self.gap;
        // Corners are in order, so only those on both sides can be nearest.
        let next = self.corners.partition_point(|&c| c < at);
        let count = self.corners.len();
        count == 0
            || [self.corners.get(next % count), self.corners.get((next + count - 1) % count)]
                .into_iter()
                .flatten()
                .all(|&c| self.apart(c, at) >= least)
    }

    /// Whether a joint with its middle at `at` mm is in no cut that contours share. It holds to a web that is at least half
    /// as wide as itself.
    pub(super) fn is_off_others(&self, at: f64) -> bool {
        let Joint { from, to, .. } = self.joint(at);
        let stretch = self.path.between(from, to);
        !self.cuts.is_near(self.contour, &stretch, 0.5 * self.gap) && !self.is_near_itself(at, &stretch)
    }

    /// Whether another side of the contour itself is as near to a joint as another cut may not be, as in a narrow slot.
    fn is_near_itself(&self, at: f64, stretch: &[Segment]) -> bool {
        let least = 0.5 * self.gap;
        let bounds = stretch.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds())).grown(least);
        let mut near = false;
        self.cuts.index.visit(bounds, |k| {
            let Some((_, side, begin)) = self.cuts.elements.get(k).filter(|e| e.0 == self.contour) else {
                return true;
            };
            near = stretch.iter().any(|s| {
                (0..=POINTS).any(|i| {
                    let (f, d2) = side.nearest(s.at(f64::from(i) / f64::from(POINTS)));
                    // What is next to the joint along the contour is no other side.
                    d2 < least * least && self.apart(begin + f * side.length(), at) > 1.5 * self.gap
                })
            });
            !near
        });
        near
    }
}

/// The arc lengths at which a closed path has corners, in order.
pub(super) fn corners(path: &Path) -> Vec<f64> {
    let elements: Vec<&Segment> = path.segments.iter().filter(|s| s.length() > 0.0).collect();
    let Some(mut before) = elements.last().copied() else { return Vec::new() };
    let (mut at, mut corners) = (0.0, Vec::new());
    for element in elements {
        let (arrives, leaves) = (before.tangent(1.0), element.tangent(0.0));
        if math::atan2(arrives.perp_dot(leaves), arrives.dot(leaves)).abs() > CORNER {
            corners.push(at);
        }
        at += element.length();
        before = element;
    }
    corners
}
