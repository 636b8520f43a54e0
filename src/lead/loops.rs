//! Whether a loop beyond a corner lies in waste.

use super::chain::{SLOPE, leaves};
use super::scrap::Scrap;
use crate::geometry::{DVec2, Segment, distance};

impl Scrap<'_> {
    /// Whether a loop at a corner of a contour lies in waste: a line that leaves the corner, arcs, and a line back to it. It is away
    /// from every other contour by the clearance, and so from its own; next to the corner it leaves that as a chain does.
    pub(crate) fn holds_loop(&self, contour: u32, corner: DVec2, path: &[Segment]) -> bool {
        let (Some(own), [first, around @ .., last]) = (self.contours.get(contour as usize), path) else {
            return false;
        };
        if !self.bed.as_ref().is_none_or(|bed| path.iter().all(|s| bed.contains_box(&s.bounds()))) {
            return false;
        }
        let (ahead, back) = (*first, last.reversed());
        let near = SLOPE * first.end().distance(corner);
        let mut fits = true;
        for s in path {
            self.index.visit(s.bounds().grown(self.reach()), |k| {
                let Some(element) = self.elements.get(k) else { return true };
                fits = if element.contour != contour {
                    distance(s, &element.shape).0 >= element.least
                } else if around.contains(s) {
                    distance(s, &element.shape).0 >= element.least.min(near)
                } else {
                    leaves(if s == first { &ahead } else { &back }, element)
                };
                fits
            });
            if !fits {
                return false;
            }
        }
        around.first().is_some_and(|arc| self.is_in_scrap(own, arc.at(0.5)))
    }
}
