//! Builders for the findings of this stage, with layer, handle and place filled in.

use super::model::{Contour, Operation};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::DVec2;
use crate::machine::FarOut;
use crate::number::fixed;
use rustc_hash::FxHashSet;

/// A finding about the shape with index `index`.
pub(super) fn shape(
    drawing: &Drawing,
    index: u32,
    code: Code,
    severity: Severity,
    message: String,
    at: Option<DVec2>,
) -> Finding {
    let mut f = Finding::new(code, severity, message);
    f.at = at;
    if let Some(s) = drawing.shapes.get(index as usize) {
        f.handle.clone_from(&s.handle);
        f.layer = layer_name(drawing, s.layer);
    }
    f
}

/// A finding for each contour that is cut and does not close, except those of a group, which the group's finding reports.
pub(super) fn open_contours(
    drawing: &Drawing,
    contours: &[Contour],
    in_groups: &FxHashSet<usize>,
    findings: &mut Findings,
) {
    for (index, c) in contours.iter().enumerate() {
        if c.path.closed || c.rest_of.is_some() || c.operation != Operation::Cut || in_groups.contains(&index)
        {
            continue;
        }
        let message = format!(
            "This contour of {} mm does not close: it is cut as an open line and frees no part. Close it in the \
             drawing, or raise the joining tolerance.",
            fixed(c.length, 3)
        );
        let (code, at) = (Code::OpenContour, c.path.start());
        findings.push(shape(drawing, c.first_shape, code, Severity::Warning, message, at));
    }
}

/// The finding that the drawing is too far from the origin to be cut.
pub(super) fn far_from_origin(far: &FarOut) -> Finding {
    let message = format!(
        "The drawing reaches {:.1} m from the origin. The controller's numbers are {:.3} mm apart there, too coarse to \
         cut: move the drawing to the origin, or correct its unit.",
        far.at.length() / 1000.0,
        far.spacing,
    );
    Finding::new(Code::FarFromOrigin, Severity::Error, message).at(far.at)
}

/// The finding that not all near copies were looked for.
pub(super) fn near_copies_partly_checked() -> Finding {
    let message = "So many lines lie close together that only some of them were checked for near copies.";
    Finding::new(Code::NotAllChecked, Severity::Info, message)
}

/// The name of a layer, if the index is valid.
pub(super) fn layer_name(drawing: &Drawing, layer: u32) -> Option<String> {
    drawing.layers.get(layer as usize).map(|l| l.name.clone())
}

/// A number for [`Finding::count`].
pub(super) fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

/// A number with its noun: "1 gap", "3 gaps".
pub(crate) fn plural(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
