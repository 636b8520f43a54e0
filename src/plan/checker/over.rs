//! Whether a move is over a piece that may have tipped, or so near it that the nozzle is: measured by places along the move.

use super::fractions::fractions;
use super::nesting::winding;
use crate::geometry::{DVec2, Path, Segment, distance};

/// A move with the head down must not be this deep over a piece, mm.
const DEPTH: f64 = 0.1;
/// A move begins over a piece that it is this deep over, mm: on an outline it may be inside by rounding.
const BEGINS: f64 = 0.02;
/// What is nearer by less than this is not nearer, mm: plans are made with arcs as chords, which are up to 0.01 mm off.
const NEARER: f64 = 0.05;
/// How much farther from a piece a move may be that is said to cross it, mm.
pub(super) const SLACK: f64 = 0.2;
/// Distance between the places along a move, mm, and their largest number.
pub(super) const STEP: f64 = 0.25;
pub(super) const MOST: f64 = 2000.0;

/// What counts as crossing a piece, in mm: being nearer to it than `reach`, and nearer than at both ends of the move by more than
/// `-nearer`; or being `depth` over it, but for a stretch at an end that is over it.
#[derive(Clone, Copy)]
pub(super) struct Limits {
    reach: f64,
    depth: f64,
    nearer: f64,
}

impl Limits {
    /// What must not be in a plan.
    pub(super) fn surely(reach: f64) -> Self {
        Self { reach, depth: DEPTH, nearer: -NEARER }
    }

    /// What a plan may call a crossing.
    pub(super) fn perhaps(reach: f64) -> Self {
        Self { reach: reach + SLACK, depth: 0.1 * DEPTH, nearer: NEARER }
    }
}

/// The distance of a place from an outline, mm.
fn from_outline(outline: &Path, p: DVec2) -> f64 {
    outline.segments.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt()
}

/// The distance of a place from a piece, mm; 0 if it is over it.
pub(super) fn from_piece(outline: &Path, p: DVec2) -> f64 {
    let d = from_outline(outline, p);
    if d > 0.0 && winding(outline, p) != 0.0 { 0.0 } else { d }
}

/// Whether a line crosses a piece.
pub(super) fn line_crosses(line: &Segment, outline: &Path, limits: Limits) -> bool {
    let inside = |p: DVec2| winding(outline, p) != 0.0;
    let from_piece = |p: DVec2| from_piece(outline, p);
    let nearest = outline.segments.iter().map(|s| distance(line, s).0).fold(f64::INFINITY, f64::min);
    let ends = from_piece(line.start()).min(from_piece(line.end()));
    if nearest < limits.reach && nearest < ends + limits.nearer {
        return true;
    }
    // What touches no outline and begins outside is over nothing.
    if nearest > 0.0 && !inside(line.start()) {
        return false;
    }
    let places: Vec<DVec2> = fractions(line.length(), STEP, [2.0, MOST]).map(|f| line.at(f)).collect();
    runs_over(&places, outline, limits.depth)
}

/// The same for a way by places that are close to each other.
pub(super) fn places_cross(places: &[DVec2], outline: &Path, limits: Limits) -> bool {
    let area = outline.bounds().grown(limits.reach);
    let near = places.iter().filter(|p| area.contains(**p));
    let nearest = near.map(|p| from_outline(outline, *p)).fold(f64::INFINITY, f64::min);
    let ends = places.first().into_iter().chain(places.last());
    let ends = ends.map(|p| from_piece(outline, *p)).fold(f64::INFINITY, f64::min);
    nearest < limits.reach && (nearest < ends + limits.nearer || runs_over(places, outline, limits.depth))
}

/// Whether a way is `depth` mm over a piece. Where it begins or ends over the piece, the stretch within the outline is exempt.
fn runs_over(places: &[DVec2], outline: &Path, depth: f64) -> bool {
    let area = outline.bounds();
    let inside = |p: DVec2| area.contains(p) && winding(outline, p) != 0.0;
    let begins = |p: Option<&DVec2>| p.is_some_and(|&p| from_outline(outline, p) > BEGINS && inside(p));
    let outside = |p: &DVec2| !inside(*p);
    let first = if begins(places.first()) { places.iter().position(outside) } else { Some(0) };
    let last = if begins(places.last()) { places.iter().rposition(outside) } else { Some(places.len()) };
    let Some((first, last)) = first.zip(last) else { return false };
    let rest = places.get(first..last);
    rest.is_some_and(|rest| rest.iter().any(|&p| inside(p) && from_outline(outline, p) > depth))
}
