//! Recognises the sheet's own border: a single rectangle around everything, drawn to show the sheet and not to be cut.
//!
//! A plate with holes looks similar: a rectangle around everything else. It is a border if the contours directly inside
//! it are parts: the layer's name says so, or they have holes themselves.

use super::model::{Contour, LayerUse, Operation};
use super::{findings, layer_names};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{DVec2, Segment};

/// A border fills at least this fraction of its box, which is aligned with its longest side. This accepts rounded or
/// clipped corners, but not an ellipse (0.79).
const MIN_BOX_FILL: f64 = 0.95;
/// Smallest fraction of the area directly inside a border that belongs to contours with holes. A plate with one window
/// in which another part lies is not a sheet of parts.
const MIN_SHARE_WITH_HOLES: f64 = 0.5;

/// The contour that looks like the sheet's border.
pub(super) fn find(contours: &[Contour], layers: &[LayerUse]) -> Option<u32> {
    let mut outermost = (0_u32..).zip(contours).filter(|(_, c)| c.inside.is_none() && c.is_processed());
    let (index, border) = outermost.next()?;
    let lone = outermost.next().is_none() && contours.len() > 1;
    if !lone || !border.path.closed || border.operation != Operation::Cut || !is_rectangular(border) {
        return None;
    }
    let named = layers.get(border.layer as usize).is_some_and(|l| {
        layer_names::suggestion(&l.name) == Some(Operation::Ignore) && alone_on_layer(contours, index)
    });
    (named || holds_parts(contours, index)).then_some(index)
}

/// Whether it is alone on its layer. A layer FRAME that also holds all parts is no evidence of a border.
fn alone_on_layer(contours: &[Contour], index: u32) -> bool {
    let layer = contours[index as usize].layer;
    contours.iter().filter(|c| c.layer == layer && c.is_processed()).count() == 1
}

fn holds_parts(contours: &[Contour], border: u32) -> bool {
    let mut has_holes = vec![false; contours.len()];
    for c in contours.iter().filter(|c| c.bounds_area()) {
        if let Some(around) = c.inside {
            has_holes[around as usize] = true;
        }
    }
    let (mut all, mut with_holes) = (0.0, 0.0);
    for (c, holes) in contours.iter().zip(has_holes).filter(|(c, _)| c.inside == Some(border)) {
        all += c.area;
        if holes {
            with_holes += c.area;
        }
    }
    with_holes > 0.0 && with_holes >= MIN_SHARE_WITH_HOLES * all
}

fn is_rectangular(c: &Contour) -> bool {
    let longest = c.path.segments.iter().filter(|s| matches!(s, Segment::Line(_)));
    let Some(side) = longest.max_by(|a, b| a.length().total_cmp(&b.length())) else { return false };
    let along = side.tangent(0.0);
    let across = along.perp();
    let extent = |d: DVec2| {
        let on = c.path.segments.iter().map(|s| s.start().dot(d));
        let (low, high) = on.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    };
    c.area >= MIN_BOX_FILL * extent(along) * extent(across)
}

/// Reports the border.
pub(super) fn finding(drawing: &Drawing, border: &Contour, left_out: bool) -> Finding {
    let message = if left_out {
        "The border around everything is left out: it looks like the sheet, not like a cut."
    } else {
        "The border around everything looks like the sheet, not like a cut: currently cut. Choose to skip it."
    };
    let (severity, at) = (if left_out { Severity::Info } else { Severity::Warning }, border.path.start());
    findings::shape(drawing, border.first_shape, Code::SheetOutline, severity, message.to_owned(), at)
}
