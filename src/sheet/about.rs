//! Findings about shapes and contours: the sentence with layer, handle and place filled in.

use crate::dxf::Drawing;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::DVec2;

/// A finding about the shape of that index.
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

/// The name of a layer.
pub(super) fn layer_name(drawing: &Drawing, layer: u32) -> Option<String> {
    drawing.layers.get(layer as usize).map(|l| l.name.clone())
}

/// A count for [`Finding::count`].
pub(super) fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

/// "1 gap", "3 gaps".
pub(super) fn plural(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
