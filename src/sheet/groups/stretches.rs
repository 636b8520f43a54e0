//! Which contours pass close to a point.

use super::super::model::Contour;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment};
use crate::order::sort_by;

/// Stretches that a contour of average length is cut into. The boxes around slanted lines that lie side by side, as in a
/// hatch, overlap almost completely; those around a sixteenth of them overlap with a sixteenth as many.
const STRETCHES: f64 = 16.0;

/// The elements of contours, with the boxes of short stretches of them.
pub(super) struct Stretches<'a> {
    boxes: BoxIndex,
    /// The contour of each box, and the element of it.
    of: Vec<(u32, &'a Segment)>,
}

impl<'a> Stretches<'a> {
    /// The stretches of those contours that are `sound`.
    pub(super) fn new(contours: &'a [Contour], sound: &[bool]) -> Self {
        let length: f64 = contours.iter().map(|c| c.length).sum();
        let longest = length / (STRETCHES * contours.len() as f64);
        let (mut boxes, mut of) = (Vec::new(), Vec::new());
        for (id, contour) in (0_u32..).zip(contours).filter(|(id, _)| sound[*id as usize]) {
            for element in &contour.path.segments {
                let count = (element.length() / longest).ceil().max(1.0);
                let mut part = 0.0;
                while part < count {
                    boxes.push(element.piece(part / count, (part + 1.0) / count).bounds());
                    of.push((id, element));
                    part += 1.0;
                }
            }
        }
        Self { boxes: BoxIndex::new(boxes), of }
    }

    /// The contours with an element within a distance of a point, ascending.
    pub(super) fn around(&self, at: DVec2, distance: f64) -> Vec<u32> {
        let mut found = Vec::new();
        self.boxes.visit(Aabb::of(at).grown(distance), |i| {
            let near = self.of.get(i).filter(|(_, element)| element.nearest(at).1 <= distance * distance);
            found.extend(near.map(|(contour, _)| *contour));
            true
        });
        sort_by(&mut found, |&contour| [contour.into(), 0, 0]);
        found.dedup();
        found
    }
}
