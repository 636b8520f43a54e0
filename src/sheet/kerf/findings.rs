//! Findings about contours that keep their drawn line, and about shared lines.

use super::super::findings::{self, count, plural};
use super::super::model::Contour;
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::DVec2;
use crate::number::fixed;

/// Reason a contour keeps its drawn line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Reason {
    /// It shares a side with another contour as drawn.
    SharesSides,
    /// It crosses itself, so it is unclear which side is waste.
    CrossesItself,
    /// The waste between it and another contour has this width, mm, at this place.
    Near(f64, DVec2),
    /// It is narrower than the kerf, at least in part, near this place.
    Narrow(DVec2),
}

/// Reports a contour that keeps its drawn line.
pub(super) fn keeps_drawn_line(drawing: &Drawing, contour: &Contour, reason: Reason, width: f64) -> Finding {
    let start = contour.path.start();
    let (text, at) = match reason {
        Reason::SharesSides => (
            format!(
                "This contour has sides in common with another one as drawn: both keep their drawn lines, and parts come out \
                 smaller by half a kerf there. Lay them out {width} mm apart for one cut between them."
            ),
            start,
        ),
        Reason::CrossesItself => (
            "This contour crosses itself, so it is unclear which side is the part: it keeps its drawn line."
                .to_owned(),
            start,
        ),
        Reason::Near(gap, at) if gap < 0.5e-3 => (
            format!(
                "This contour touches another one, with no room for the kerf between them: both keep their drawn lines, and parts \
                 come out smaller by half a kerf. Lay them out {width} mm apart or more."
            ),
            Some(at),
        ),
        Reason::Near(gap, at) => (
            format!(
                "Only {} mm lie between this contour and another one, less than the kerf: both keep their drawn lines, and \
                 parts come out smaller by half a kerf. Lay them out {width} mm apart or more.",
                fixed(gap, 3)
            ),
            Some(at),
        ),
        Reason::Narrow(at) => (
            format!(
                "This contour is narrower here than the kerf of {width} mm: it keeps its drawn line, which is off by half a \
                 kerf. Widen it, or cut it with a finer beam."
            ),
            Some(at),
        ),
    };
    findings::shape(drawing, contour.first_shape, Code::KerfNotApplied, Severity::Warning, text, at)
}

/// Reports open contours, given by their starts.
pub(super) fn open_contours(starts: &[DVec2]) -> Option<Finding> {
    let at = *starts.first()?;
    let which = plural(starts.len(), "open contour keeps its", "open contours keep their");
    let message = format!(
        "{which} drawn line: it is unclear on which side the part lies, so the kerf is not compensated."
    );
    Some(Finding::new(Code::KerfNotApplied, Severity::Info, message).at(at).times(count(starts.len())))
}

/// Reports a contour that may be the border of the sheet, in which case every line is offset to the wrong side.
pub(super) fn border(drawing: &Drawing, border: &Contour) -> Finding {
    let text = "The border around everything looks like the sheet, but is cut as a part: what lies in it counts as its holes, and comes \
                out smaller by a kerf. Choose to leave it out.";
    let at = border.path.start();
    findings::shape(drawing, border.first_shape, Code::SheetOutline, Severity::Warning, text.to_owned(), at)
}

/// Reports lines that now coincide.
pub(super) fn cut_once(length: f64, at: DVec2) -> Finding {
    let message =
        format!("Parts one kerf apart: {} mm between them are cut once instead of twice.", fixed(length, 3));
    Finding::new(Code::OverlapRemoved, Severity::Info, message).at(at)
}

/// Reports that not every pair of contours was checked.
pub(super) fn partly_checked() -> Finding {
    let message =
        "So many lines lie close together that only some of them were checked for room for the kerf.";
    Finding::new(Code::NotAllChecked, Severity::Warning, message)
}
