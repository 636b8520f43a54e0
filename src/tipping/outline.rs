//! Outlines as polygons.

use crate::geometry::{DVec2, Path, Segment, arcs};

/// Largest distance between an arc and its chords, mm: a hundredth of what the nozzle keeps clear.
const CHORD: f64 = 0.01;

/// The corners of a closed path, arcs as chords.
pub fn polygon(path: &Path) -> Vec<DVec2> {
    let mut corners = Vec::with_capacity(path.segments.len());
    for segment in &path.segments {
        match segment {
            Segment::Line(line) => corners.push(line.end),
            Segment::Arc(arc) => corners.extend(arcs::flattened(arc, CHORD)),
        }
    }
    corners
}
