//! What every format asks of a plan: its cuts and marks in order, and the names of their layers.

use crate::geometry::{DVec2, Segment};
use crate::plan::{Move, Plan};
use crate::sheet::Sheet;

/// A cut or mark of a plan.
#[derive(Clone, Copy)]
pub(super) struct Cut<'a> {
    /// The contour's id.
    pub(super) contour: u32,
    /// Where it is entered, mm.
    pub(super) entry: DVec2,
    /// Its elements from the entry on; never empty.
    pub(super) path: &'a [Segment],
    /// Marks instead of cutting through.
    pub(super) mark: bool,
}

/// The cuts and marks of a plan, in order.
pub(super) fn cuts(plan: &Plan) -> impl Iterator<Item = Cut<'_>> {
    plan.moves.iter().filter_map(|step| match step {
        Move::Cut { contour, path, mark } => {
            let entry = path.first()?.start();
            Some(Cut { contour: *contour, entry, path, mark: *mark })
        }
        Move::Air { .. } | Move::Pierce => None,
    })
}

/// The name of a contour's layer; empty when the sheet does not know it.
pub(super) fn layer_name(sheet: &Sheet, contour: u32) -> &str {
    let known = sheet.contours.get(contour as usize).and_then(|c| sheet.layers.get(c.layer as usize));
    known.map_or("", |l| l.name.as_str())
}

/// Whether a contour closes.
pub(super) fn is_closed(sheet: &Sheet, contour: u32) -> bool {
    sheet.contours.get(contour as usize).is_some_and(|c| c.path.closed)
}
