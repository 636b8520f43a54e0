//! Bounding boxes of places: no place in a box is nearer than the box.

use super::ring::GATES;
use crate::geometry::{Aabb, DVec2};

/// Arcs of a ring, each with a box: more arcs exclude more candidates, but take longer to look at.
pub(super) const ARCS: usize = 4;

/// An axis-parallel box: its centre and half its size, mm.
#[derive(Clone, Copy)]
pub(super) struct BoundingBox {
    center: DVec2,
    half: DVec2,
}

impl BoundingBox {
    pub(super) fn new(b: Aabb) -> Self {
        Self { center: b.center(), half: b.size() * 0.5 }
    }

    /// Its middle, mm.
    pub(super) fn center(&self) -> DVec2 {
        self.center
    }

    /// The longer of its sides, mm.
    pub(super) fn largest_side(&self) -> f64 {
        2.0 * self.half.max_element()
    }

    /// How far a point is outside the box along each axis, mm.
    #[inline(always)]
    pub(super) fn outside(&self, p: DVec2) -> DVec2 {
        let d = (p - self.center).abs() - self.half;
        // In wasm the maximum of glam is a call and a choice of two numbers a jump; this is neither.
        let outside = |d: f64| 0.5 * (d + d.abs());
        DVec2::new(outside(d.x), outside(d.y))
    }
}

/// The boxes of the arcs of a ring. Each holds the gates of its arc and the places half way to the next gate on both sides.
pub(super) fn arcs(ring: &[DVec2]) -> [BoundingBox; ARCS] {
    let (count, half) = (ring.len(), ring.len() / GATES / 2);
    std::array::from_fn(|arc| {
        let from = arc * count / ARCS + count - half;
        let last = from + count / ARCS - count / GATES + 2 * half;
        BoundingBox::new((from..=last).fold(Aabb::EMPTY, |b, k| b.with(ring[k & (count - 1)])))
    })
}
