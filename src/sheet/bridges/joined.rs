//! The closed path around parts and the strips between them.

use super::strip::Candidate;
use crate::geometry::{DVec2, Path, Segment, pin_ends};
use crate::order::{real, sort_by};

/// One end of a strip on an outline.
#[derive(Clone, Copy)]
struct Opening {
    /// The outline, by its place in the list.
    outline: usize,
    /// Arc length at which it begins and ends, mm.
    along: [f64; 2],
    /// The points there, mm.
    at: [DVec2; 2],
    /// The other end of the strip, by its place in the list of openings.
    other: usize,
}

/// Goes once around a tree of parts: along the outline of the first one to an opening, over a side of the strip to the next part, and so on.
/// `outlines` are those of the parts with their contours.
pub(super) fn around(outlines: &[(u32, Path)], strips: &[Candidate]) -> Path {
    let mut openings = Vec::with_capacity(2 * strips.len());
    for Candidate { strip, openings: [first, second], .. } in strips {
        let [[a, b], [c, d]] = strip.sides;
        let place = |k: usize| outlines.iter().position(|(id, _)| *id == strip.contours[k]);
        let (Some(from), Some(to)) = (place(0), place(1)) else { continue };
        let next = openings.len();
        openings.push(Opening { outline: from, along: *first, at: [a, d], other: next + 1 });
        openings.push(Opening { outline: to, along: *second, at: [c, b], other: next });
    }
    // The openings of each outline in its direction.
    let mut of: Vec<Vec<usize>> = vec![Vec::new(); outlines.len()];
    for (k, opening) in openings.iter().enumerate() {
        of[opening.outline].push(k);
    }
    for list in &mut of {
        sort_by(list, |&k| [real(openings[k].along[0]), 0, 0]);
    }
    let mut segments: Vec<Segment> = Vec::new();
    let Some(first) = of.first().and_then(|list| list.first()).copied() else {
        return outlines.first().map(|o| o.1.clone()).unwrap_or_default();
    };
    let mut here = first;
    // Every opening is passed once.
    for _ in 0..openings.len() {
        let Opening { outline, along: [_, from], at: [_, start], .. } = openings[here];
        let list = &of[outline];
        let place = list.iter().position(|&k| k == here).unwrap_or_default();
        let next = openings[list[(place + 1) % list.len()]];
        let mut stretch = outlines[outline].1.between(from, next.along[0]);
        stretch.retain(|s| s.length() > 0.0);
        pin_ends(&mut stretch, start, next.at[0]);
        segments.extend(stretch);
        here = next.other;
        segments.push(Segment::line(next.at[0], openings[here].at[1]));
        if here == first {
            break;
        }
    }
    Path::new(segments, true)
}
