//! Pieces of an ellipse, as the image of an arc under any affine map.

use super::affine::Affine;
use super::fit;
use super::math;
use super::sampler::Curve;
use super::segment::{Arc, Segment};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The points `center + major * cos(a) + minor * sin(a)` for `a` from `start` over `sweep`.
///
/// `major` and `minor` are conjugate half axes, which need not be perpendicular (an affine map keeps conjugate axes
/// conjugate). Angles are parameters in rad, not directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Centre, mm.
    pub center: DVec2,
    /// Half axis at parameter 0, mm.
    pub major: DVec2,
    /// Half axis at parameter pi / 2, mm.
    pub minor: DVec2,
    /// Parameter of the first end, rad.
    pub start: f64,
    /// Signed parameter range, rad, in [-2 pi, 2 pi]; +-2 pi is the whole ellipse.
    pub sweep: f64,
}

/// Largest relative difference of the half axes' lengths, and cosine of their angle, for which the ellipse is a circle.
const CIRCLE: f64 = 1e-12;

impl Ellipse {
    /// The image of an arc under an affine map. Its ends equal the images of the arc's ends up to rounding.
    pub fn of_arc(arc: &Arc, map: &Affine) -> Self {
        let radius = arc.start - arc.center;
        Self {
            center: map.point(arc.center),
            major: map.vector(radius),
            minor: map.vector(radius.perp()),
            start: 0.0,
            sweep: arc.sweep,
        }
    }

    /// The image under an affine map, which is exactly an elliptic arc again.
    pub fn transformed(&self, map: &Affine) -> Self {
        Self {
            center: map.point(self.center),
            major: map.vector(self.major),
            minor: map.vector(self.minor),
            ..*self
        }
    }

    /// The point at parameter `a` (rad).
    pub fn at(&self, a: f64) -> DVec2 {
        self.center + self.major * math::cos(a) + self.minor * math::sin(a)
    }

    /// Whether the piece is the whole ellipse.
    pub fn is_full(&self) -> bool {
        self.sweep.abs() >= TAU
    }

    /// The equivalent circular arc, if the half axes are those of a circle.
    pub fn as_arc(&self) -> Option<Arc> {
        let (aa, bb) = (self.major.length_squared(), self.minor.length_squared());
        let size = aa.max(bb);
        let round = (aa - bb).abs() <= CIRCLE * size && self.major.dot(self.minor).abs() <= CIRCLE * size;
        if !(round && size > 0.0 && self.sweep != 0.0) {
            return None;
        }
        let (start, full) = (self.at(self.start), self.is_full());
        let end = if full { start } else { self.at(self.start + self.sweep) };
        let mirrored = self.major.perp_dot(self.minor) < 0.0;
        let sweep = self.sweep.clamp(-TAU, TAU);
        Some(Arc { start, end, center: self.center, sweep: if mirrored { -sweep } else { sweep } })
    }

    /// The same piece in the opposite direction.
    pub fn reversed(&self) -> Self {
        Self { start: self.start + self.sweep, sweep: -self.sweep, ..*self }
    }

    /// The piece as lines and arcs within `tolerance` mm of it: one exact arc when it is circular, lines when it is
    /// flat (half axes on one line). The ends are exact, and a whole ellipse closes bit for bit. The result is empty
    /// when the piece has no length. A reversed piece gives the same elements reversed.
    pub fn to_segments(&self, tolerance: f64) -> Vec<Segment> {
        if let Some(arc) = self.as_arc() {
            return vec![Segment::Arc(arc)];
        }
        // Every piece is fitted counter-clockwise.
        if self.sweep * self.major.perp_dot(self.minor) < 0.0 {
            let other = fit::fit(&EllipseCurve::new(&self.reversed()), tolerance);
            return other.iter().rev().map(Segment::reversed).collect();
        }
        fit::fit(&EllipseCurve::new(self), tolerance)
    }
}

/// The piece with its parameter range divided at the vertices, where the curvature has its extremes.
struct EllipseCurve {
    ellipse: Ellipse,
    breaks: Vec<f64>,
}

impl EllipseCurve {
    fn new(e: &Ellipse) -> Self {
        let sweep = e.sweep.clamp(-TAU, TAU);
        // The derivative is orthogonal to the radius where tan(2 a) = 2 u.v / (u.u - v.v).
        let (uu, vv) = (e.major.length_squared(), e.minor.length_squared());
        let vertex = 0.5 * math::atan2(2.0 * e.major.dot(e.minor), uu - vv);
        let (low, high) = if sweep < 0.0 { (e.start + sweep, e.start) } else { (e.start, e.start + sweep) };
        let mut breaks = vec![0.0];
        // Positions relative to the start in the direction of travel, so that they ascend; at most five quarters.
        let quarters: Vec<f64> = (0..=8)
            .map(|k| vertex + ((low - vertex) / FRAC_PI_2).floor() * FRAC_PI_2 + f64::from(k) * FRAC_PI_2)
            .filter(|a| *a > low + 1e-9 && *a < high - 1e-9)
            .map(|a| (a - e.start) / sweep)
            .collect();
        breaks.extend(quarters);
        breaks.push(1.0);
        crate::order::sort_by(&mut breaks, |&b| [crate::order::real(b), 0, 0]);
        Self { ellipse: Ellipse { sweep, ..*e }, breaks }
    }
}

impl Curve for EllipseCurve {
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn at(&self, _: usize, t: f64) -> (DVec2, DVec2) {
        let e = &self.ellipse;
        let closes = e.is_full() && t >= 1.0;
        let a = e.start + if closes { 0.0 } else { e.sweep * t };
        let (s, c) = (math::sin(a), math::cos(a));
        (e.center + e.major * c + e.minor * s, (e.minor * c - e.major * s) * e.sweep)
    }

    fn intervals(&self) -> usize {
        1
    }

    fn extent(&self) -> f64 {
        self.ellipse.major.length().max(self.ellipse.minor.length())
    }
}
