//! The two kinds of element that every stage after the reader handles: a straight line and a circular arc.
//!
//! Both store their end points exactly as given, so neighbours in a chain share them bit for bit. An arc also stores
//! its centre and its signed sweep; a full circle is an arc whose ends coincide and whose sweep is +-2 pi. Lengths are
//! in mm, angles in rad, counter-clockwise positive. A position on a segment is a fraction of its length.

use super::aabb::Aabb;
use super::math;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// A straight line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// First end, mm.
    pub start: DVec2,
    /// Second end, mm.
    pub end: DVec2,
}

/// A circular arc. Build it with [`Arc::new`], [`Arc::from_angles`], [`Arc::from_bulge`] or [`Arc::circle`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// First end, mm.
    pub start: DVec2,
    /// Second end, mm.
    pub end: DVec2,
    /// Centre, mm.
    pub center: DVec2,
    /// Signed angle from start to end, rad, in [-2 pi, 2 pi], positive counter-clockwise, never 0.
    pub sweep: f64,
}

/// One element of a contour. As data it is a list of numbers: start and end, and for an arc its centre and sweep.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(into = "Vec<f64>", try_from = "Vec<f64>")]
pub enum Segment {
    /// A straight line.
    Line(Line),
    /// A circular arc.
    Arc(Arc),
}

impl From<Segment> for Vec<f64> {
    fn from(segment: Segment) -> Self {
        let (start, end) = (segment.start(), segment.end());
        let ends = [start.x, start.y, end.x, end.y];
        match segment {
            Segment::Line(_) => ends.to_vec(),
            Segment::Arc(Arc { center, sweep, .. }) => [&ends[..], &[center.x, center.y, sweep]].concat(),
        }
    }
}

impl TryFrom<Vec<f64>> for Segment {
    type Error = &'static str;

    fn try_from(numbers: Vec<f64>) -> Result<Self, &'static str> {
        let at = DVec2::new;
        match *numbers {
            [x0, y0, x1, y1] => Ok(Self::Line(Line { start: at(x0, y0), end: at(x1, y1) })),
            [x0, y0, x1, y1, x, y, sweep] => {
                Ok(Self::Arc(Arc { start: at(x0, y0), end: at(x1, y1), center: at(x, y), sweep }))
            }
            _ => Err("an element has 4 or 7 numbers"),
        }
    }
}

impl Arc {
    /// The arc from `start` to `end` around `center`, in the given direction. Coincident ends make a full circle.
    pub fn new(start: DVec2, end: DVec2, center: DVec2, ccw: bool) -> Self {
        let turn = math::turn(start - center, end - center);
        let sweep = if start == end {
            if ccw { TAU } else { -TAU }
        } else if ccw {
            if turn <= 0.0 { turn + TAU } else { turn }
        } else if turn >= 0.0 {
            turn - TAU
        } else {
            turn
        };
        Self { start, end, center, sweep }
    }

    /// The arc around `center` from angle `from` over the signed angle `sweep` (rad).
    pub fn from_angles(center: DVec2, radius: f64, from: f64, sweep: f64) -> Self {
        let sweep = sweep.clamp(-TAU, TAU);
        let start = center + radius * math::unit(from);
        let full = sweep.abs() >= TAU;
        let end = if full { start } else { center + radius * math::unit(from + sweep) };
        Self { start, end, center, sweep }
    }

    /// A full circle, counter-clockwise, starting at angle 0.
    pub fn circle(center: DVec2, radius: f64) -> Self {
        Self::from_angles(center, radius, 0.0, TAU)
    }

    /// The arc between two points with DXF bulge `b` = tan(sweep / 4); `None` when straight or degenerate.
    pub fn from_bulge(start: DVec2, end: DVec2, b: f64) -> Option<Self> {
        let center = Self::bulge_center(start, end, b)?;
        Some(Self { start, end, center, sweep: 4.0 * math::atan(b) })
    }

    /// The centre of that arc.
    pub(super) fn bulge_center(start: DVec2, end: DVec2, b: f64) -> Option<DVec2> {
        let chord = end - start;
        let finite = b.is_finite() && chord.length_squared() > 0.0;
        // Below 1e-9 the sagitta of a 1 m chord is half a picometre, so the arc is a line.
        if !finite || b.abs() < 1e-9 {
            return None;
        }
        // The centre is the middle of the chord, moved along its left normal by c/2 * (1 - b^2) / (2 b). In this form a
        // huge bulge does not overflow.
        Some((start + end) * 0.5 + chord.perp() * ((1.0 / b - b) * 0.25))
    }

    /// Radius in mm.
    pub fn radius(&self) -> f64 {
        (self.start - self.center).length()
    }

    /// Angle of the start as seen from the centre, rad.
    pub fn start_angle(&self) -> f64 {
        math::angle_of(self.start - self.center)
    }

    /// Whether the arc runs counter-clockwise.
    pub fn ccw(&self) -> bool {
        self.sweep > 0.0
    }

    /// Whether the arc is a full circle.
    pub fn is_circle(&self) -> bool {
        self.sweep.abs() >= TAU
    }

    /// Fraction of the sweep, in [0, 1], at which the arc meets direction `v` from the centre; `None` when `v` lies
    /// outside the arc. A direction that misses an end only by rounding counts as that end.
    pub fn fraction_of(&self, v: DVec2) -> Option<f64> {
        /// Directions closer than this (rad) are the same: 1e-6 mm at the largest radius of 1e6 mm.
        const SAME: f64 = 1e-12;
        let turn = math::turn(self.start - self.center, v);
        let along = math::wrap_tau(if self.ccw() { turn } else { -turn });
        let sweep = self.sweep.abs();
        if along <= sweep {
            Some(along / sweep)
        } else if along - sweep <= SAME {
            Some(1.0)
        } else if TAU - along <= SAME {
            Some(0.0)
        } else {
            None
        }
    }
}

impl Segment {
    /// A line from `start` to `end`.
    pub fn line(start: DVec2, end: DVec2) -> Self {
        Self::Line(Line { start, end })
    }

    /// First end, mm.
    pub fn start(&self) -> DVec2 {
        match self {
            Self::Line(l) => l.start,
            Self::Arc(a) => a.start,
        }
    }

    /// Second end, mm.
    pub fn end(&self) -> DVec2 {
        match self {
            Self::Line(l) => l.end,
            Self::Arc(a) => a.end,
        }
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        match self {
            Self::Line(l) => (l.end - l.start).length(),
            Self::Arc(a) => a.radius() * a.sweep.abs(),
        }
    }

    /// The same element in the opposite direction.
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line(l) => Self::line(l.end, l.start),
            Self::Arc(a) => Self::Arc(Arc { start: a.end, end: a.start, center: a.center, sweep: -a.sweep }),
        }
    }

    /// The point at fraction `f` of the length. Fractions 0 and 1 give the stored ends exactly.
    pub fn at(&self, f: f64) -> DVec2 {
        if f <= 0.0 {
            return self.start();
        }
        if f >= 1.0 {
            return self.end();
        }
        match self {
            Self::Line(l) => l.start + (l.end - l.start) * f,
            Self::Arc(a) => a.center + math::rotate(a.start - a.center, a.sweep * f),
        }
    }

    /// Unit direction of travel at fraction `f` of the length (zero for a zero-length line).
    pub fn tangent(&self, f: f64) -> DVec2 {
        match self {
            Self::Line(l) => (l.end - l.start).normalize_or_zero(),
            Self::Arc(a) => {
                let r = math::rotate(a.start - a.center, a.sweep * f.clamp(0.0, 1.0)).normalize_or_zero();
                if a.ccw() { r.perp() } else { -r.perp() }
            }
        }
    }

    /// The piece between fractions `from` < `to` of the length.
    pub fn piece(&self, from: f64, to: f64) -> Self {
        let (from, to) = (from.clamp(0.0, 1.0), to.clamp(0.0, 1.0));
        match *self {
            Self::Line(_) => Self::line(self.at(from), self.at(to)),
            Self::Arc(a) => Self::Arc(Arc {
                start: self.at(from),
                end: self.at(to),
                center: a.center,
                sweep: a.sweep * (to - from),
            }),
        }
    }

    /// The smallest box around the element, exact for arcs.
    pub fn bounds(&self) -> Aabb {
        let mut b = Aabb::of(self.start()).with(self.end());
        if let Self::Arc(a) = self {
            let r = a.radius();
            let [from, to] =
                if a.sweep < 0.0 { [a.end, a.start] } else { [a.start, a.end] }.map(|p| p - a.center);
            // The test uses the sides of both radii and needs no angles, which would take most of the time of reading a
            // drawing.
            let passes = |v: DVec2| {
                let (after, before) = (from.perp_dot(v) >= 0.0, v.perp_dot(to) >= 0.0);
                match a.sweep.abs() {
                    whole if whole >= TAU => true,
                    half if half > PI => after || before,
                    small => after && before && (small > 1.0 || from.dot(v) >= 0.0),
                }
            };
            for v in [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y] {
                if passes(v) {
                    b = b.with(a.center + v * r);
                }
            }
        }
        b
    }

    /// The nearest place to `p`: its fraction of the length, and the squared distance in mm2.
    pub fn nearest(&self, p: DVec2) -> (f64, f64) {
        let f = match self {
            Self::Line(l) => {
                let d = l.end - l.start;
                let len2 = d.length_squared();
                if len2 > 0.0 { ((p - l.start).dot(d) / len2).clamp(0.0, 1.0) } else { 0.0 }
            }
            Self::Arc(a) => match a.fraction_of(p - a.center) {
                Some(f) if p != a.center => f,
                _ => {
                    let to_start = p.distance_squared(a.start);
                    if to_start <= p.distance_squared(a.end) { 0.0 } else { 1.0 }
                }
            },
        };
        (f, p.distance_squared(self.at(f)))
    }

    /// Twice the signed area swept from the origin along the element: the cross product of the ends, plus twice the
    /// circular segment for an arc. The sum over a closed contour is twice its signed area.
    pub fn doubled_area(&self) -> f64 {
        let chord = self.start().perp_dot(self.end());
        match self {
            Self::Line(_) => chord,
            Self::Arc(a) => {
                let r2 = (a.start - a.center).length_squared();
                let sin = if a.is_circle() { 0.0 } else { math::sin(a.sweep) };
                chord + r2 * (a.sweep - sin)
            }
        }
    }
}
