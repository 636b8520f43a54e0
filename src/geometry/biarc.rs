//! Biarcs: two arcs with a common tangent at their joint, from one point and direction to another.
//!
//! K. M. Bolton, "Biarc curves", Computer-Aided Design 7 (1975), doi:10.1016/0010-4485(75)90086-X. The error of a biarc
//! of length `h` on a curve whose curvature changes at rate `k` is `k h^3 / 324` (D. S. Meek, D. J. Walton,
//! "Approximating smooth planar curves by arc splines", J. Comput. Appl. Math. 59 (1995),
//! doi:10.1016/0377-0427(94)00029-Z). Of the one-parameter family this module uses the member whose two control legs
//! have the same length: it adds no inflection of its own, and its joint lies near the curve.

use super::math;
use super::sample::Sample;
use super::segment::{Arc, Segment};
use glam::DVec2;

/// An arc defined by its start, its unit direction there, and its end. It stores no angles, so it is cheap to build and
/// to measure.
#[derive(Clone, Copy, Debug)]
pub(super) struct TangentArc {
    start: DVec2,
    tangent: DVec2,
    end: DVec2,
    /// Centre and radius, mm; `None` for a straight line.
    circle: Option<(DVec2, f64)>,
}

/// An arc whose sagitta is below this fraction of its chord is a line. Below 1e-9 the centre is lost in rounding.
const FLATNESS: f64 = 1e-9;

/// Sine of the largest angle (0.06 degrees) by which a line may miss a direction. Such a joint is neither visible nor
/// slows the head down.
const STRAIGHT: f64 = 1e-3;

/// Cosine of the largest angle (37 degrees) between the direction of a sample and that of the fit. It ensures that
/// curve and fit run in the same direction, so that near points match in order, and it rejects loops smaller than the
/// tolerance.
const MIN_COSINE: f64 = 0.8;

impl TangentArc {
    /// The arc that leaves `start` in the unit direction `tangent` and ends at `end`; `None` when it would turn by more
    /// than half a circle or has no length.
    pub(super) fn new(start: DVec2, tangent: DVec2, end: DVec2) -> Option<Self> {
        let chord = end - start;
        let (along, across) = (tangent.dot(chord), tangent.perp_dot(chord));
        if along <= 0.0 || !along.is_finite() {
            return None;
        }
        let length2 = chord.length_squared();
        // The sagitta is about a quarter of `across` divided by the chord.
        let circle = (across.abs() > 4.0 * FLATNESS * length2.sqrt()).then(|| {
            let to_center = tangent.perp() * (length2 / (2.0 * across));
            (start + to_center, to_center.length())
        });
        Some(Self { start, tangent, end, circle })
    }

    /// The unit direction at the start.
    pub(super) fn start_tangent(&self) -> DVec2 {
        self.tangent
    }

    /// The unit direction at the end.
    pub(super) fn end_tangent(&self) -> DVec2 {
        // The direction at the start, mirrored in the perpendicular bisector of the chord.
        let chord = (self.end - self.start).normalize_or_zero();
        (chord * (2.0 * chord.dot(self.tangent)) - self.tangent).normalize_or_zero()
    }

    /// Distance from a sample to the arc's circle or line; `None` when the directions disagree.
    pub(super) fn distance(&self, s: &Sample) -> Option<f64> {
        match self.circle {
            None => {
                let d = (self.end - self.start).normalize_or_zero();
                (d.dot(s.tangent) > MIN_COSINE).then(|| d.perp_dot(s.point - self.start).abs())
            }
            Some((center, radius)) => {
                let v = s.point - center;
                let distance = v.length();
                let ccw = self.tangent.perp_dot(center - self.start) > 0.0;
                let direction = if ccw { v.perp() } else { -v.perp() };
                (direction.dot(s.tangent) > MIN_COSINE * distance).then(|| (distance - radius).abs())
            }
        }
    }

    /// The element. An arc whose sagitta is less than `flat` mm and that turns by less than [`STRAIGHT`] becomes a
    /// line.
    pub(super) fn segment(&self, flat: f64) -> Segment {
        let chord = self.end - self.start;
        let across = self.tangent.perp_dot(chord).abs();
        let straight = across <= 4.0 * flat && across <= STRAIGHT * chord.length();
        match self.circle {
            Some((center, _)) if !straight => {
                let half = math::turn(self.tangent, chord);
                Segment::Arc(Arc { start: self.start, end: self.end, center, sweep: 2.0 * half })
            }
            _ => Segment::line(self.start, self.end),
        }
    }
}

/// Two arcs with a common tangent at their joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Biarc {
    pub(super) first: TangentArc,
    pub(super) second: TangentArc,
}

impl Biarc {
    /// The biarc with equal control legs between two places and directions; `None` when no biarc exists whose arcs both
    /// turn by less than half a circle.
    pub(super) fn new(from: Sample, to: Sample) -> Option<Self> {
        Self::through(from, to, joint(from, to, equal_leg(from, to))?)
    }

    /// The biarc whose joint lies on the curve given by the samples between the two places. Where the curvature changes
    /// unevenly, it is up to twice as near to the curve as the one with equal legs.
    pub(super) fn along(from: Sample, to: Sample, between: &[Sample]) -> Option<Self> {
        /// Relative change of the leg used to estimate how the joint moves.
        const STEP: f64 = 0.1;
        let leg = equal_leg(from, to);
        let equal = joint(from, to, leg)?;
        let better = joint(from, to, leg * (1.0 - STEP)).and_then(|other| {
            // One step of the secant method is enough, because the joint moves nearly in proportion to the leg.
            let (here, there) = (side(equal, from, between, to), side(other, from, between, to));
            let factor = 1.0 - STEP * here / (here - there);
            (0.5..=2.0).contains(&factor).then(|| joint(from, to, leg * factor)).flatten()
        });
        better.and_then(|j| Self::through(from, to, j)).or_else(|| Self::through(from, to, equal))
    }

    fn through(from: Sample, to: Sample, joint: DVec2) -> Option<Self> {
        /// Largest ratio of the way over the joint to the chord: it is 1.4 for half a circle and 2.6 for three
        /// quarters. Where a curve turns back on itself sharply, two half circles of any size would fit the ends.
        const MAX_DETOUR: f64 = 3.0;
        let way = from.point.distance(joint) + joint.distance(to.point);
        if way > MAX_DETOUR * from.point.distance(to.point) {
            return None;
        }
        let first = TangentArc::new(from.point, from.tangent, joint)?;
        let second = TangentArc::new(joint, first.end_tangent(), to.point)?;
        Some(Self { first, second })
    }

    /// The place and direction where the two arcs join.
    pub(super) fn joint(&self) -> Sample {
        Sample { point: self.second.start, tangent: self.second.tangent }
    }

    /// Whether the samples, in order of travel, lie within `limit` mm of the biarc and agree with its direction.
    pub(super) fn within(&self, samples: &[Sample], limit: f64) -> bool {
        let (joint, across) = (self.second.start, self.second.tangent);
        samples.iter().all(|s| {
            let bow = if (s.point - joint).dot(across) < 0.0 { &self.first } else { &self.second };
            bow.distance(s).is_some_and(|d| d <= limit)
        })
    }
}

/// For the biarc with equal legs: the change of curvature (1/mm) from the first arc to the second, and the mean length
/// of their chords (mm).
pub(super) fn bend(from: Sample, to: Sample) -> Option<(f64, f64)> {
    let joint = joint(from, to, equal_leg(from, to))?;
    let (a, b) = (joint - from.point, to.point - joint);
    // The angle between an arc's direction at an end and its chord is half its turn.
    let first = 2.0 * from.tangent.perp_dot(a) / a.length_squared();
    let second = 2.0 * b.perp_dot(to.tangent) / b.length_squared();
    Some((second - first, (a.length() + b.length()) * 0.5))
}

/// The joint of the biarc whose first control leg has length `d` mm.
fn joint(from: Sample, to: Sample, d: f64) -> Option<DVec2> {
    if !(d.is_finite() && d > 0.0) {
        return None;
    }
    // The distance between the inner control points is the sum of the legs: |p1 - e t1 - p0 - d t0| = d + e.
    let v = to.point - from.point;
    let bent = (1.0 - from.tangent.dot(to.tangent)).max(0.0);
    let e = (0.5 * v.length_squared() - d * v.dot(from.tangent)) / (v.dot(to.tangent) + d * bent);
    Some(((from.point + from.tangent * d) * e + (to.point - to.tangent * e) * d) / (d + e))
}

/// The leg d of `d^2 * 2 (1 - t0.t1) + 2 d (v.(t0 + t1)) - v.v = 0`, in the form that remains stable when t0 = t1. The
/// result is not a positive number when there is no such leg.
fn equal_leg(from: Sample, to: Sample) -> f64 {
    let v = to.point - from.point;
    let b = v.dot(from.tangent + to.tangent);
    let bent = 2.0 * (1.0 - from.tangent.dot(to.tangent)).max(0.0);
    v.length_squared() / (b + (b * b + bent * v.length_squared()).sqrt())
}

/// Signed distance of `p` from the curve through the samples, positive to its left.
fn side(p: DVec2, from: Sample, between: &[Sample], to: Sample) -> f64 {
    // The last sample behind `p`.
    let k = between.partition_point(|s| (p - s.point).dot(s.tangent) > 0.0);
    let last = if k == 0 { from } else { between[k - 1] };
    let next = between.get(k).copied().unwrap_or(to);
    match TangentArc::new(last.point, last.tangent, next.point) {
        Some(bow) => match bow.circle {
            Some((center, radius)) => {
                let left = bow.tangent.perp_dot(center - bow.start) > 0.0;
                let inward = radius - p.distance(center);
                if left { inward } else { -inward }
            }
            None => last.tangent.perp_dot(p - last.point),
        },
        None => last.tangent.perp_dot(p - last.point),
    }
}
