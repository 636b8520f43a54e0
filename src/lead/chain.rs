//! Whether a cut that joins two contours lies in waste.

use super::scrap::{Element, Scrap};
use crate::geometry::{DVec2, Segment, distance};

/// Least slope of the cut away from a contour that it joins: within the clearance of its ends it is at least this part of its
/// length away from that contour, which is an angle of 14 degrees. The checker demands the same.
pub(super) const SLOPE: f64 = 0.25;
/// The cut is compared with its own contours piece by piece, and each piece by the distance that its far end needs. A smaller
/// ratio of both ends would only add pieces: so the cut has to leave with up to 22 degrees.
const RATIO: f64 = 1.5;
/// Length next to a contour that is not compared with it, mm: a tenth of the width of a narrow beam.
const JOINT: f64 = 0.02;

impl Scrap<'_> {
    /// Whether a straight cut from the end of contour `a` to the entry of contour `b` lies in waste, away from every other
    /// contour by the clearance, and from these two away from its ends.
    pub(crate) fn joins(&self, [a, b]: [u32; 2], from: DVec2, to: DVec2) -> bool {
        let line = Segment::line(from, to);
        let back = line.reversed();
        let Some(own) = self.contours.get(a as usize).filter(|_| line.length() > JOINT) else { return false };
        let mut fits = true;
        self.index.visit(line.bounds().grown(self.reach()), |k| {
            let Some(element) = self.elements.get(k) else { return true };
            fits = match element.contour {
                c if c == a => leaves(&line, element),
                c if c == b => leaves(&back, element),
                _ => distance(&line, &element.shape).0 >= element.least,
            };
            fits
        });
        fits && self.is_in_scrap(own, (from + to) * 0.5)
    }

    /// Whether a straight cut from the edge of the sheet to the entry of a contour lies in waste, away from every other contour by the
    /// clearance, and from its own away from its end.
    pub(crate) fn leads_in(&self, contour: u32, from: DVec2, to: DVec2) -> bool {
        self.joins([contour; 2], to, from)
    }
}

/// Whether a line that begins at a contour gets away from an element of it.
pub(super) fn leaves(line: &Segment, element: &Element) -> bool {
    let length = line.length();
    let far = element.least / SLOPE;
    let keeps = |from: f64, to: f64, least: f64| {
        distance(&line.piece(from / length, to / length), &element.shape).0 >= least
    };
    if length > far && !keeps(far, length, element.least) {
        return false;
    }
    let mut end = far.min(length);
    while end > JOINT {
        let start = end / RATIO;
        if !keeps(start, end, SLOPE * end) {
            return false;
        }
        end = start;
    }
    true
}
