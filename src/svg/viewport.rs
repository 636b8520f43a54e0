//! The inside of a nested `svg` or of a copied `symbol`: its place, its size, and its view box.

use super::aspect::ViewBox;
use super::length::{Axis, Lengths};
use super::own::Own;
use super::xml::Document;
use crate::geometry::{Affine, DVec2};

/// The map from the user units inside to those outside, and the size of the viewport in the units inside. A `use` may
/// give a size; `own`: what its style sheets say.
pub(super) fn inside(
    document: &Document<'_>,
    element: u32,
    own: &Own,
    given: [Option<f64>; 2],
    lengths: &Lengths,
) -> (Affine, DVec2) {
    let length = |name: &str, axis| own.length(document, element, name, axis, lengths);
    let at = DVec2::new(length("x", Axis::Width).unwrap_or(0.0), length("y", Axis::Height).unwrap_or(0.0));
    let size = DVec2::new(
        given[0].or(length("width", Axis::Width)).unwrap_or(lengths.viewport.x),
        given[1].or(length("height", Axis::Height)).unwrap_or(lengths.viewport.y),
    );
    let view_box = document.attribute(element, "viewBox").and_then(ViewBox::read);
    let move_there = Affine::translation(at);
    match view_box {
        Some(view_box) if size.min_element() > 0.0 => {
            let aspect = document.attribute(element, "preserveAspectRatio").unwrap_or_default();
            (view_box.fit(size, aspect).then(&move_there), view_box.size)
        }
        _ => (move_there, size),
    }
}
