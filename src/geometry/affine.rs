//! Affine maps of the plane: the effect of an INSERT, an extrusion direction or a change of units on a shape.
//!
//! Lines stay lines under every map. Arcs stay arcs only under a similarity (rotation, reflection, uniform scale,
//! translation); under any other map they become elliptic, see [`Ellipse`](super::Ellipse).

use super::math;
use super::segment::{Arc, Segment};
use glam::DVec2;

/// Largest relative difference of the axes' lengths, and cosine of their angle, for which a map is a similarity.
/// Drawings write scales with 6 to 16 digits; at the largest radius (1e6 mm) the error stays below a micrometre.
const SIMILAR: f64 = 1e-12;

/// The map `p -> x * p.x + y * p.y + origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// Image of the unit vector (1, 0).
    pub x: DVec2,
    /// Image of the unit vector (0, 1).
    pub y: DVec2,
    /// Image of the point (0, 0), mm.
    pub origin: DVec2,
}

impl Affine {
    /// The identity.
    pub const IDENTITY: Self = Self { x: DVec2::X, y: DVec2::Y, origin: DVec2::ZERO };

    /// The translation by `v`, mm.
    pub fn translation(v: DVec2) -> Self {
        Self { origin: v, ..Self::IDENTITY }
    }

    /// The rotation around (0, 0) by `a` rad, counter-clockwise. Quarter turns are exact.
    pub fn rotation(a: f64) -> Self {
        let x = math::unit(a);
        // The computed sine or cosine of a quarter turn misses 0 by 1e-16; set it to 0.
        let clean = |v: f64| if v.abs() < 4.0 * f64::EPSILON { 0.0 } else { v };
        let x = DVec2::new(clean(x.x), clean(x.y));
        Self { x, y: x.perp(), origin: DVec2::ZERO }
    }

    /// Scales each axis; negative factors reflect.
    pub fn scale(s: DVec2) -> Self {
        Self { x: DVec2::new(s.x, 0.0), y: DVec2::new(0.0, s.y), origin: DVec2::ZERO }
    }

    /// This map followed by `next`.
    pub fn then(&self, next: &Self) -> Self {
        Self { x: next.vector(self.x), y: next.vector(self.y), origin: next.point(self.origin) }
    }

    /// The image of a point.
    pub fn point(&self, p: DVec2) -> DVec2 {
        self.vector(p) + self.origin
    }

    /// The image of a direction or distance, which the translation does not affect.
    pub fn vector(&self, v: DVec2) -> DVec2 {
        self.x * v.x + self.y * v.y
    }

    /// Factor of areas; negative when the map reflects.
    pub fn determinant(&self) -> f64 {
        self.x.perp_dot(self.y)
    }

    /// Whether the map keeps all angles, so that arcs stay arcs.
    pub fn is_similarity(&self) -> bool {
        let (xx, yy) = (self.x.length_squared(), self.y.length_squared());
        let size = xx.max(yy);
        size > 0.0 && (xx - yy).abs() <= SIMILAR * size && self.x.dot(self.y).abs() <= SIMILAR * size
    }

    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.origin.is_finite()
    }

    /// The image of a line, or of an arc under a similarity; `None` for an arc that becomes elliptic
    /// ([`Ellipse::of_arc`](super::Ellipse::of_arc)). A reflection reverses the arc's sense of rotation.
    pub fn segment(&self, s: &Segment) -> Option<Segment> {
        match *s {
            Segment::Line(l) => Some(Segment::line(self.point(l.start), self.point(l.end))),
            Segment::Arc(a) if self.is_similarity() => Some(Segment::Arc(Arc {
                start: self.point(a.start),
                end: self.point(a.end),
                center: self.point(a.center),
                sweep: if self.determinant() < 0.0 { -a.sweep } else { a.sweep },
            })),
            Segment::Arc(_) => None,
        }
    }
}
