//! SOLID, TRACE, 3DFACE: filled areas, which become their outlines.

use crate::dxf::entity::{Geometry, Polyline3d};
use crate::dxf::ocs;
use crate::dxf::record::Record;
use glam::DVec3;

/// SOLID and TRACE: the third and fourth corner are swapped, as in a bow tie.
pub(super) fn solid<'a>(record: &Record<'a>) -> Geometry<'a> {
    let plane = ocs::axes(record.normal);
    outline([10, 11, 13, 12].map(|code| record.point(code).map(|p| plane * p)), 0)
}

/// 3DFACE: the corners are in order, and bits of group 70 hide edges.
pub(super) fn face<'a>(record: &Record<'a>) -> Geometry<'a> {
    outline([10, 11, 12, 13].map(|code| record.point(code)), record.int(70).unwrap_or(0))
}

/// The visible edges of a triangle or quadrilateral, whose corners are in world coordinates, as one closed chain or several open ones. Bit i of `hidden` hides
/// the edge that starts at corner i.
fn outline<'a>(corners: [Option<DVec3>; 4], hidden: i64) -> Geometry<'a> {
    let place = corners[0];
    let mut visible: Vec<(DVec3, bool)> = Vec::with_capacity(4);
    for (i, corner) in corners.into_iter().enumerate() {
        let Some(corner) = corner else { continue };
        let seen = hidden & (1 << i) == 0;
        match visible.last_mut() {
            // A triangle repeats a corner; the edge between the two has no length and its flag is ignored.
            Some(last) if last.0 == corner => last.1 = seen,
            _ => visible.push((corner, seen)),
        }
    }
    if visible.len() > 2 && visible.first().map(|v| v.0) == visible.last().map(|v| v.0) {
        visible.pop();
    }
    let n = visible.len();
    if n < 3 {
        return Geometry::Invalid("it has fewer than three corners", place);
    }
    // Start after a hidden edge, so that no chain wraps around the end of the list.
    let Some(first_hidden) = visible.iter().position(|v| !v.1) else {
        return Geometry::Polylines3d(vec![Polyline3d {
            points: visible.into_iter().map(|v| v.0).collect(),
            closed: true,
        }]);
    };
    visible.rotate_left((first_hidden + 1) % n);
    let mut chains: Vec<Polyline3d> = Vec::new();
    let mut open: Vec<DVec3> = Vec::new();
    for (corner, seen) in visible {
        open.push(corner);
        if !seen {
            if open.len() > 1 {
                chains.push(Polyline3d { points: open, closed: false });
            }
            open = Vec::new();
        }
    }
    if chains.is_empty() {
        return Geometry::Invalid("all its edges are invisible", place);
    }
    Geometry::Polylines3d(chains)
}
