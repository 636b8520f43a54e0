//! Corners that are cut in a loop or rounded.

use crate::geometry::{DVec2, Segment};
use crate::machine::CornerKind;
use serde::{Deserialize, Serialize};

/// A corner in which a cut does not stop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turn {
    /// What is cut instead.
    pub kind: CornerKind,
    /// The corner, mm.
    pub at: DVec2,
    /// Number of the first element of the cut that is not the contour.
    pub first: usize,
    /// Number of these elements: those of a loop, or the arc that replaces the corner.
    pub count: usize,
}

impl Turn {
    /// The elements of it.
    pub fn of<'p, T>(&self, path: &'p [T]) -> &'p [T] {
        path.get(self.first..self.first.saturating_add(self.count)).unwrap_or_default()
    }

    /// The elements of a cut as if it turned in its corners: without loops, and with the corner drawn in place of every arc.
    pub fn undone(path: &[Segment], turns: &[Self]) -> Vec<Segment> {
        let mut out = Vec::with_capacity(path.len());
        let mut done = 0;
        for turn in turns {
            let Some(before) = path.get(done..turn.first) else { continue };
            let elements = turn.of(path);
            out.extend_from_slice(before);
            if let (CornerKind::Round, Some(a), Some(b)) = (turn.kind, elements.first(), elements.last()) {
                out.extend([Segment::line(a.start(), turn.at), Segment::line(turn.at, b.end())]);
            }
            done = turn.first + elements.len();
        }
        out.extend_from_slice(path.get(done..).unwrap_or_default());
        out
    }
}
