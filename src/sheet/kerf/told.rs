//! What the kerf changes, and what keeps its drawn line, in words.

use super::super::about::{self, count, plural};
use super::super::model::Contour;
use crate::dxf::Drawing;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::DVec2;

/// Why a contour keeps its drawn line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Why {
    /// It shares a side with another one as drawn.
    SharesSides,
    /// It crosses itself: nobody knows what is waste.
    CrossesItself,
    /// Waste of this width, mm, lies between it and another one, here.
    Near(f64, DVec2),
    /// It, or part of it, is narrower than the kerf; about here.
    Narrow(DVec2),
}

/// A contour that keeps its drawn line.
pub(super) fn kept(drawing: &Drawing, contour: &Contour, why: Why, width: f64) -> Finding {
    let start = contour.path.start();
    let (text, at) = match why {
        Why::SharesSides => (
            format!(
                "This contour has sides in common with another one as drawn: both keep their drawn lines, and parts come out \
                 smaller by half a kerf there. Lay them out {width} mm apart for one cut between them."
            ),
            start,
        ),
        Why::CrossesItself => (
            "This contour crosses itself, so what of it is a part is in doubt: it keeps its drawn line."
                .to_owned(),
            start,
        ),
        Why::Near(gap, at) if gap < 0.5e-3 => (
            format!(
                "This contour touches another one, with no room for the kerf between them: both keep their drawn lines, and parts \
                 come out smaller by half a kerf. Lay them out {width} mm apart or more."
            ),
            Some(at),
        ),
        Why::Near(gap, at) => (
            format!(
                "Only {gap:.3} mm lie between this contour and another one, less than the kerf: both keep their drawn lines, and \
                 parts come out smaller by half a kerf. Lay them out {width} mm apart or more."
            ),
            Some(at),
        ),
        Why::Narrow(at) => (
            format!(
                "This contour is narrower here than the kerf of {width} mm: it keeps its drawn line, which is off by half a \
                 kerf. Widen it, or cut it with a finer beam."
            ),
            Some(at),
        ),
    };
    about::shape(drawing, contour.first_shape, Code::KerfNotApplied, Severity::Warning, text, at)
}

/// Open contours, by where they start.
pub(super) fn open(starts: &[DVec2]) -> Option<Finding> {
    let at = *starts.first()?;
    let which = plural(starts.len(), "open contour keeps its", "open contours keep their");
    let message =
        format!("{which} drawn line: nobody knows on which side the part lies, so no kerf is made up for.");
    Some(Finding::new(Code::KerfNotApplied, Severity::Info, message).at(at).times(count(starts.len())))
}

/// A contour that may be the border of the sheet: then everything is on the wrong side.
pub(super) fn border(drawing: &Drawing, border: &Contour) -> Finding {
    let text = "The border around everything looks like the sheet, but is cut as a part: what lies in it counts as its holes, and comes \
                out smaller by a kerf. Choose to leave it out.";
    let at = border.path.start();
    about::shape(drawing, border.first_shape, Code::SheetOutline, Severity::Warning, text.to_owned(), at)
}

/// Lines that have become one.
pub(super) fn once(length: f64, at: DVec2) -> Finding {
    let message = format!("Parts one kerf apart: {length:.3} mm between them are cut once instead of twice.");
    Finding::new(Code::OverlapRemoved, Severity::Info, message).at(at)
}

/// Not every pair of contours was looked at.
pub(super) fn crowded() -> Finding {
    let message =
        "So many lines lie close together that room for the kerf between them was looked for in part only.";
    Finding::new(Code::NotAllChecked, Severity::Warning, message)
}
