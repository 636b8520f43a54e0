//! Biarcs: two arcs joined with one direction, from a point and direction to another.
//!
//! K. M. Bolton, "Biarc curves", Computer-Aided Design 7 (1975), doi:10.1016/0010-4485(75)90086-X; the error of a
//! biarc of length `h` on a curve whose curvature changes at rate `k` is `k h^3 / 324` (D. S. Meek, D. J. Walton,
//! "Approximating smooth planar curves by arc splines", J. Comput. Appl. Math. 59 (1995),
//! doi:10.1016/0377-0427(94)00029-Z). Of the one-parameter family we take the member whose two control legs have the
//! same length: it has no inner turn of its own, and its joint lies near the curve.

use super::math;
use super::sample::Sample;
use super::segment::{Arc, Segment};
use glam::DVec2;

/// An arc known by its start, the unit direction there, and its end. No angles yet: cheap to build and to measure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bow {
    start: DVec2,
    tangent: DVec2,
    end: DVec2,
    /// Centre and radius; `None` when straight.
    circle: Option<(DVec2, f64)>,
}

/// A bow whose middle lies nearer than this part of its chord to the chord is a line: below 1e-9 the centre is
/// lost in rounding.
const FLAT: f64 = 1e-9;

/// Sine of the angle a line may miss a direction by: 0.06 degrees, no joint to see or to slow down for.
const STRAIGHT: f64 = 1e-3;

/// Largest angle between a sample's direction and the fitted one: cosine of 37 degrees. Keeps the measure honest
/// (curve and fit run side by side, so near points match in order) and rejects loops smaller than the tolerance.
const ALONG: f64 = 0.8;

impl Bow {
    /// The arc that leaves `start` along the unit direction `tangent` and ends in `end`; `None` when it would turn by
    /// more than half a circle or has no length.
    pub(super) fn new(start: DVec2, tangent: DVec2, end: DVec2) -> Option<Self> {
        let chord = end - start;
        let (along, across) = (tangent.dot(chord), tangent.perp_dot(chord));
        if along <= 0.0 || !along.is_finite() {
            return None;
        }
        let length2 = chord.length_squared();
        // The middle of the bow rises by about a quarter of `across` over the chord.
        let circle = (across.abs() > 4.0 * FLAT * length2.sqrt()).then(|| {
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
        // The direction at the start, mirrored at the chord's middle normal.
        let chord = (self.end - self.start).normalize_or_zero();
        (chord * (2.0 * chord.dot(self.tangent)) - self.tangent).normalize_or_zero()
    }

    /// Distance from a sample to the bow's circle or line; `None` when it runs another way.
    pub(super) fn distance(&self, s: &Sample) -> Option<f64> {
        match self.circle {
            None => {
                let d = (self.end - self.start).normalize_or_zero();
                (d.dot(s.tangent) > ALONG).then(|| d.perp_dot(s.point - self.start).abs())
            }
            Some((center, radius)) => {
                let v = s.point - center;
                let distance = v.length();
                let ccw = self.tangent.perp_dot(center - self.start) > 0.0;
                let direction = if ccw { v.perp() } else { -v.perp() };
                (direction.dot(s.tangent) > ALONG * distance).then(|| (distance - radius).abs())
            }
        }
    }

    /// The element; a bow that rises by less than `flat` mm over its chord and turns by less than [`STRAIGHT`] is a line.
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

/// Two bows joined with one direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Biarc {
    pub(super) first: Bow,
    pub(super) second: Bow,
}

impl Biarc {
    /// The biarc with equal control legs between two places and directions; `None` where no biarc exists whose
    /// arcs both turn by less than half a circle.
    pub(super) fn new(from: Sample, to: Sample) -> Option<Self> {
        Self::through(from, to, joint(from, to, equal_leg(from, to))?)
    }

    /// The biarc whose joint lies on the curve given by the samples between the two places: where the curvature
    /// changes unevenly it is up to twice as near as the one with equal legs.
    pub(super) fn along(from: Sample, to: Sample, between: &[Sample]) -> Option<Self> {
        /// Step of the leg to see which way the joint moves.
        const STEP: f64 = 0.1;
        let leg = equal_leg(from, to);
        let equal = joint(from, to, leg)?;
        let better = joint(from, to, leg * (1.0 - STEP)).and_then(|other| {
            // One step of the secant rule: joints move nearly in proportion to the leg.
            let (here, there) = (side(equal, from, between, to), side(other, from, between, to));
            let factor = 1.0 - STEP * here / (here - there);
            (0.5..=2.0).contains(&factor).then(|| joint(from, to, leg * factor)).flatten()
        });
        better.and_then(|j| Self::through(from, to, j)).or_else(|| Self::through(from, to, equal))
    }

    fn through(from: Sample, to: Sample, joint: DVec2) -> Option<Self> {
        /// Way over the joint against the chord: 1.4 for a half circle, 2.6 for three quarters. Where a curve turns
        /// back on itself within a hair, two half circles of any size would lead from before to behind the turn.
        const DETOUR: f64 = 3.0;
        let way = from.point.distance(joint) + joint.distance(to.point);
        if way > DETOUR * from.point.distance(to.point) {
            return None;
        }
        let first = Bow::new(from.point, from.tangent, joint)?;
        let second = Bow::new(joint, first.end_tangent(), to.point)?;
        Some(Self { first, second })
    }

    /// The place where the two arcs join.
    pub(super) fn joint(&self) -> Sample {
        Sample { point: self.second.start, tangent: self.second.tangent }
    }

    /// Whether samples in order of travel lie within `limit` mm of the biarc and run its way.
    pub(super) fn within(&self, samples: &[Sample], limit: f64) -> bool {
        let (joint, across) = (self.second.start, self.second.tangent);
        samples.iter().all(|s| {
            let bow = if (s.point - joint).dot(across) < 0.0 { &self.first } else { &self.second };
            bow.distance(s).is_some_and(|d| d <= limit)
        })
    }
}

/// Of the biarc with equal legs: the change of curvature (1/mm) from the first arc to the second, and the mean length
/// of their chords (mm).
pub(super) fn bend(from: Sample, to: Sample) -> Option<(f64, f64)> {
    let joint = joint(from, to, equal_leg(from, to))?;
    let (a, b) = (joint - from.point, to.point - joint);
    // The angle between an arc's direction at an end and its chord is half its turn.
    let first = 2.0 * from.tangent.perp_dot(a) / a.length_squared();
    let second = 2.0 * b.perp_dot(to.tangent) / b.length_squared();
    Some((second - first, (a.length() + b.length()) * 0.5))
}

/// Where the arcs of the biarc join whose first control leg has length `d`.
fn joint(from: Sample, to: Sample, d: f64) -> Option<DVec2> {
    if !(d.is_finite() && d > 0.0) {
        return None;
    }
    // The inner control points are as far from each other as the legs are long together:
    // |p1 - e t1 - p0 - d t0| = d + e.
    let v = to.point - from.point;
    let bent = (1.0 - from.tangent.dot(to.tangent)).max(0.0);
    let e = (0.5 * v.length_squared() - d * v.dot(from.tangent)) / (v.dot(to.tangent) + d * bent);
    Some(((from.point + from.tangent * d) * e + (to.point - to.tangent * e) * d) / (d + e))
}

/// The leg d of `d^2 * 2 (1 - t0.t1) + 2 d (v.(t0 + t1)) - v.v = 0`, in the form that survives t0 = t1; not a positive
/// number where there is none.
fn equal_leg(from: Sample, to: Sample) -> f64 {
    let v = to.point - from.point;
    let b = v.dot(from.tangent + to.tangent);
    let bent = 2.0 * (1.0 - from.tangent.dot(to.tangent)).max(0.0);
    v.length_squared() / (b + (b * b + bent * v.length_squared()).sqrt())
}

/// Signed distance of `p` from the curve through samples, left of it positive.
fn side(p: DVec2, from: Sample, between: &[Sample], to: Sample) -> f64 {
    // The last sample that `p` lies ahead of.
    let k = between.partition_point(|s| (p - s.point).dot(s.tangent) > 0.0);
    let last = if k == 0 { from } else { between[k - 1] };
    let next = between.get(k).copied().unwrap_or(to);
    match Bow::new(last.point, last.tangent, next.point) {
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
