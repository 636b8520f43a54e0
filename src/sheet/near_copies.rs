//! Near copies that stay: cuts so close along another one that they would burn the same line again, but farther from it
//! than the copy tolerance.
//!
//! A drawing that is pasted over itself a few hundredths of a millimetre off has every hole twice. Within the copy
//! tolerance cleaning removes the second one; beyond it, both stay, and nothing about them looks wrong: the pieces
//! between them are slivers, and holes become parts. So cuts that run within [`LIMIT`] of others from end to end are
//! reported, with the tolerance that would unite them. They are cut all the same, because only a person knows what is
//! meant.
//!
//! Marks are not compared, because lines that fill an area are often drawn as close as this.

use super::clean::SLACK;
use super::findings::{self, count};
use super::model::{Contour, Operation};
use super::narrow::FINEST_BEAM;
use crate::drawing::Drawing;
use crate::finding::{Code, Findings, Severity};
use crate::geometry::{Aabb, BoxIndex, Budget, DVec2, Segment};
use crate::number::fixed;
use rustc_hash::FxHashSet;

/// Largest distance between near copies, mm: six tenths of the width of the finest beam, of which nothing remains between two cuts so close. It
/// holds what is moved by 0.04 mm in both directions. Lines that are meant to be two are farther apart: the sides of neighbouring parts by a
/// kerf, 0.1 mm and more, and those of a thin ring or bar by a kerf and what has to remain.
const LIMIT: f64 = 0.6 * FINEST_BEAM;
/// Smallest size of a contour that is compared, mm. All of a smaller one can be near a line that it meets or crosses.
const MIN_SIZE: f64 = 5.0 * FINEST_BEAM;
/// Number of places on a line, and the least on an arc, whose distance is measured.
const PLACES: f64 = 8.0;
/// Largest angle between two of these places on an arc, rad. Between them the distance from a circle that is moved aside grows by less than
/// 0.0004 of itself, which [`SLACK`] covers.
const ARC_STEP: f64 = 0.05;
/// Number of elements looked at around a place. Where four parts meet there are a dozen; in a hatch of thousands of slanted lines, whose boxes
/// overlap almost completely, near copies may remain unreported.
const MOST_ELEMENTS: usize = 400;
/// Number of elements looked at per element on average, and for a small drawing in total. A circle over another one needs 500.
const LOOKS_PER_ELEMENT: usize = 1000;
const MIN_LOOKS: usize = 100_000;
/// Unit of the tolerance that is suggested, mm. It is rounded up.
const STEP: f64 = 0.001;

/// Reports the cuts near others as one finding. `copy` and `join` are the copy and the joining tolerance, mm.
pub(super) fn find(drawing: &Drawing, contours: &[Contour], [copy, join]: [f64; 2], findings: &mut Findings) {
    let mut cuts = Elements::new(contours);
    let mut kept: Vec<bool> = contours.iter().map(|c| c.operation == Operation::Cut).collect();
    let mut shapes: FxHashSet<u32> = FxHashSet::default();
    let (mut first, mut number, mut farthest) = (None, 0, 0.0_f64);
    // Of two near copies the one that is drawn first stays, as in cleaning.
    for (id, contour) in contours.iter().enumerate().rev() {
        if !kept[id] {
            continue;
        }
        let is_other = |other: usize| {
            // The rests of one shape run close to each other if it is thin, and that is meant.
            let same_shape = contour.rest_of.is_some() && contour.rest_of == contours[other].rest_of;
            kept[other] && other != id && !same_shape
        };
        let Some(distance) = distance(contour, &mut cuts, is_other).filter(|d| *d > copy) else { continue };
        kept[id] = false;
        farthest = farthest.max(distance);
        first = Some(contour);
        // The rests of one shape are one contour to whoever drew it.
        number += usize::from(contour.rest_of.is_none_or(|shape| shapes.insert(shape)));
    }
    if cuts.looks.is_spent() {
        findings.push(findings::near_copies_partly_checked());
    }
    let Some(first) = first else { return };
    let enough = (farthest / (1.0 + SLACK) / STEP).ceil() * STEP;
    let what = if enough > join { "copy tolerance and the joining tolerance" } else { "copy tolerance" };
    let enough = fixed(enough, 3);
    let message = if number == 1 {
        format!(
            "1 contour lies within {enough} mm of another one and would be cut twice. If it is a copy, raise the {what} to {enough} mm."
        )
    } else {
        format!(
            "{number} contours lie within {enough} mm of another one and would be cut twice. If they are copies, raise the {what} to \
             {enough} mm."
        )
    };
    let at = first.path.start();
    let finding = findings::shape(drawing, first.first_shape, Code::NearCopy, Severity::Warning, message, at);
    findings.push(finding.times(count(number)));
}

/// The largest distance of a contour from the others around it, mm; `None` if it is not near them from end to end, or small.
fn distance(contour: &Contour, others: &mut Elements, is_other: impl Fn(usize) -> bool) -> Option<f64> {
    let segments = &contour.path.segments;
    if contour.bounds.size().max_element() < MIN_SIZE {
        return None;
    }
    // Most contours are alone in the middle of an element; at their ends those that share cuts meet.
    for segment in segments {
        others.nearest(segment.at(0.5), &is_other)?;
    }
    let mut farthest = 0.0_f64;
    for segment in segments {
        let count = match segment {
            Segment::Line(_) => PLACES,
            Segment::Arc(arc) => (arc.sweep.abs() / ARC_STEP).ceil().max(PLACES),
        };
        let mut place = 0.5;
        while place < count {
            farthest = farthest.max(others.nearest(segment.at(place / count), &is_other)?);
            place += 1.0;
        }
    }
    Some(farthest)
}

/// The elements of cuts, by their boxes.
struct Elements<'a> {
    boxes: BoxIndex,
    /// The contour of each element, and the element.
    of: Vec<(usize, &'a Segment)>,
    looks: Budget,
}

impl<'a> Elements<'a> {
    fn new(contours: &'a [Contour]) -> Self {
        let cuts = contours.iter().enumerate().filter(|(_, c)| c.operation == Operation::Cut);
        let of: Vec<_> = cuts.flat_map(|(id, c)| c.path.segments.iter().map(move |s| (id, s))).collect();
        let looks = Budget::new((LOOKS_PER_ELEMENT * of.len()).max(MIN_LOOKS));
        Self { boxes: BoxIndex::new(of.iter().map(|(_, s)| s.bounds())), of, looks }
    }

    /// The distance of a place from the nearest contour that is `wanted`, mm, if one is within the limit.
    fn nearest(&mut self, at: DVec2, wanted: impl Fn(usize) -> bool) -> Option<f64> {
        let mut nearest2 = f64::INFINITY;
        let mut left = MOST_ELEMENTS;
        self.boxes.visit(Aabb::of(at).grown(LIMIT), |i| {
            if let Some((_, element)) = self.of.get(i).filter(|(contour, _)| wanted(*contour)) {
                nearest2 = nearest2.min(element.nearest(at).1);
            }
            left -= 1;
            self.looks.take() && left > 0
        });
        Some(nearest2.sqrt()).filter(|distance| *distance <= LIMIT && !self.looks.is_spent())
    }
}
