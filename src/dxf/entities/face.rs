//! SOLID, TRACE, 3DFACE: filled areas, of which the outline is taken.

use crate::dxf::entity::{Chain, Form};
use crate::dxf::ocs;
use crate::dxf::record::Record;
use glam::DVec3;

/// SOLID and TRACE: the third and fourth corner stand crosswise, as in a bow tie.
pub(super) fn solid<'a>(record: &Record<'a>) -> Form<'a> {
    let plane = ocs::axes(record.normal);
    outline([10, 11, 13, 12].map(|code| record.point(code).map(|p| plane * p)), record, 0)
}

/// 3DFACE: corners in order; bits of group 70 hide edges.
pub(super) fn face<'a>(record: &Record<'a>) -> Form<'a> {
    outline([10, 11, 12, 13].map(|code| record.point(code)), record, record.int(70).unwrap_or(0))
}

/// The visible edges of a triangle or quadrangle, as one closed chain or open ones. Bit i of `hidden`: the edge
/// from corner i on.
fn outline<'a>(corners: [Option<DVec3>; 4], record: &Record<'a>, hidden: i64) -> Form<'a> {
    let mut visible: Vec<(DVec3, bool)> = Vec::with_capacity(4);
    for (i, corner) in corners.into_iter().enumerate() {
        let Some(corner) = corner else { continue };
        let seen = hidden & (1 << i) == 0;
        match visible.last_mut() {
            // A triangle repeats a corner; the edge between the two has no length and hides nothing.
            Some(last) if last.0 == corner => last.1 = seen,
            _ => visible.push((corner, seen)),
        }
    }
    if visible.len() > 2 && visible.first().map(|v| v.0) == visible.last().map(|v| v.0) {
        visible.pop();
    }
    let n = visible.len();
    if n < 3 {
        return Form::Invalid("it has fewer than three corners", record.point(10));
    }
    // Start after a hidden edge, so that no chain runs over the end of the list.
    let Some(first_hidden) = visible.iter().position(|v| !v.1) else {
        return Form::Chains(vec![Chain {
            points: visible.into_iter().map(|v| v.0).collect(),
            closed: true,
        }]);
    };
    visible.rotate_left((first_hidden + 1) % n);
    let mut chains: Vec<Chain> = Vec::new();
    let mut open: Vec<DVec3> = Vec::new();
    for (corner, seen) in visible {
        open.push(corner);
        if !seen {
            if open.len() > 1 {
                chains.push(Chain { points: open, closed: false });
            }
            open = Vec::new();
        }
    }
    Form::Chains(chains)
}
