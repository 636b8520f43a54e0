//! Outlines that cross as drawn, one of which would lie inside the other with the kerf: a hole that breaks through a narrow part fits
//! into it once the part is offset outwards and the hole inwards. Then one would be cut out of what the other has cut free, which the
//! nesting as drawn does not know. Both keep their drawn lines.

use super::super::model::Contour;
use super::findings::Reason;
use crate::geometry::{DVec2, Path, winding_number};

/// Takes the offset lines of such contours away, and returns them. `touching`: pairs of contours that meet as drawn, and where.
pub(super) fn keep_drawn(
    contours: &[Contour],
    touching: &[(u32, u32, DVec2)],
    lines: &mut [Option<Path>],
) -> Vec<(u32, Reason)> {
    let mut kept = Vec::new();
    loop {
        let before = kept.len();
        for &(a, b, at) in touching {
            let pair = [a, b];
            let line = |c: u32| lines[c as usize].as_ref().unwrap_or(&contours[c as usize].path);
            let is_moved = pair.iter().any(|&c| lines[c as usize].is_some());
            let contains = |outer: u32, inner: u32| {
                lies_in(line(inner), line(outer)) && !is_known_around(contours, outer, inner)
            };
            if is_moved && (contains(a, b) || contains(b, a)) {
                for c in pair {
                    kept.extend(lines[c as usize].take().map(|_| (c, Reason::Near(0.0, at))));
                }
            }
        }
        // What keeps its line may now lie inside something else that it crosses.
        if kept.len() == before {
            return kept;
        }
    }
}

fn is_known_around(contours: &[Contour], outer: u32, inner: u32) -> bool {
    let up = |c: &u32| contours.get(*c as usize)?.inside;
    std::iter::successors(up(&inner), up).take(contours.len()).any(|c| c == outer)
}

fn lies_in(inner: &Path, outer: &Path) -> bool {
    let is_inside = |p: DVec2| winding_number(&outer.segments, p) != 0;
    outer.closed
        && outer.bounds().contains_box(&inner.bounds())
        && inner.segments.iter().all(|s| is_inside(s.start()) && is_inside(s.at(0.5)))
}
