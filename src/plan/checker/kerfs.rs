//! The kerfs of a plan: what is cut, and at which move.

use super::tolerance::SAME;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment};
use crate::plan::model::{Move, Plan};

/// The elements of all cuts, with their move and contour.
pub(super) struct Kerfs {
    elements: Vec<(usize, u32, Segment)>,
    index: BoxIndex,
}

impl Kerfs {
    /// Those of a plan; `wanted` says of which contours.
    pub(super) fn new(plan: &Plan, wanted: impl Fn(u32) -> bool) -> Self {
        let mut elements = Vec::new();
        for (step, m) in plan.moves.iter().enumerate() {
            if let Move::Cut { contour, path, mark: false, .. } = m
                && wanted(*contour)
            {
                elements.extend(path.iter().map(|s| (step, *contour, *s)));
            }
        }
        let index = BoxIndex::new(elements.iter().map(|e| e.2.bounds()));
        Self { elements, index }
    }

    /// The cuts whose kerf is at a place: the move and the contour of each.
    pub(super) fn at(&self, place: DVec2) -> Vec<(usize, u32)> {
        let mut found = Vec::new();
        self.index.visit(Aabb::of(place).grown(SAME), |k| {
            if let Some((step, contour, s)) = self.elements.get(k)
                && s.nearest(place).1.sqrt() <= SAME
            {
                found.push((*step, *contour));
            }
            true
        });
        found.sort_unstable();
        found.dedup();
        found
    }
}
