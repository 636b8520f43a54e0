//! Boxes around places: what lies in one is no nearer than the box.

use super::ring::GATES;
use crate::geometry::{Aabb, DVec2};

/// Arcs of a ring, each with a box: more exclude more candidates at a higher price.
pub(super) const ARCS: usize = 4;

/// The box of some places: middle and half size.
#[derive(Clone, Copy)]
pub(super) struct Boxed {
    middle: DVec2,
    half: DVec2,
}

impl Boxed {
    pub(super) fn new(b: Aabb) -> Self {
        Self { middle: b.center(), half: b.size() * 0.5 }
    }

    /// How far a place is outside along both axes.
    #[inline(always)]
    pub(super) fn outside(&self, p: DVec2) -> DVec2 {
        let d = (p - self.middle).abs() - self.half;
        // In wasm the maximum of glam is a call, and a choice of two numbers a jump.
        let outside = |d: f64| 0.5 * (d + d.abs());
        DVec2::new(outside(d.x), outside(d.y))
    }
}

/// The boxes of the arcs of a ring: of its gates, and half way to the next on both sides.
pub(super) fn arcs(ring: &[DVec2]) -> [Boxed; ARCS] {
    let (count, half) = (ring.len(), ring.len() / GATES / 2);
    std::array::from_fn(|arc| {
        let from = arc * count / ARCS + count - half;
        let last = from + count / ARCS - count / GATES + 2 * half;
        Boxed::new((from..=last).fold(Aabb::EMPTY, |b, k| b.with(ring[k & (count - 1)])))
    })
}
