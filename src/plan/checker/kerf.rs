//! Checks that parts come out as drawn: the beam runs half a kerf beside their outlines, in the waste.
//!
//! Points along the cuts are checked, however the cuts were made. Where the beam is nearer to an outline than half a kerf,
//! some of the part is lost. Where it is farther away some material remains, as happens in sharp corners. On the wrong
//! side, the part is lost.

use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, winding};
use crate::machine::Profile;
use crate::plan::model::{Move, Plan};
use crate::sheet::Sheet;

/// Distance within which two lines count as one, mm: the tolerance for duplicates, of which one is cut for all.
const ONE: f64 = 0.01;
/// Largest distance of corners from the drawn ones, in multiples of half the kerf.
const CORNER: f64 = 4.0;
/// Positions on each element of a cut that are checked.
const PLACES: [f64; 3] = [0.0, 0.37, 0.74];
/// Number of elements of a contour that are checked for the side they are on. Each check visits the whole outline.
const SIDES: usize = 8;

/// An outline as drawn.
struct Outline<'s> {
    path: &'s Path,
    index: BoxIndex,
    hole: bool,
}

impl Outline<'_> {
    /// Its distance from a point, if it is at most `reach`.
    fn distance(&self, p: DVec2, reach: f64) -> Option<f64> {
        let mut least: Option<f64> = None;
        self.index.visit(Aabb::of(p).grown(reach), |k| {
            let d = self.path.segments.get(k).map_or(reach, |s| s.nearest(p).1.sqrt());
            least = Some(least.map_or(d, |l| l.min(d)));
            true
        });
        least.filter(|d| *d <= reach)
    }
}

/// Checks all cuts of contours that represent drawn outlines.
pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    let half = 0.5 * machine.kerf_width;
    let outlines: Vec<Option<Outline>> = sheet
        .contours
        .iter()
        .map(|c| {
            let path = c.drawn.as_ref()?;
            let index = BoxIndex::new(path.segments.iter().map(Segment::bounds));
            Some(Outline { path, index, hole: !c.depth.is_multiple_of(2) })
        })
        .collect();
    for (step, m) in plan.moves.iter().enumerate() {
        let Move::Cut { contour, with, path, leads, .. } = m else { continue };
        // Leads run through the waste; `leads.rs` checks them.
        let [_, on, overcut, _] = leads.divide(path);
        let path: Vec<&Segment> = on.iter().chain(overcut).collect();
        let of = |c: &u32| outlines.get(*c as usize).and_then(Option::as_ref).map(|o| (*c, o));
        let named: Vec<(u32, &Outline)> = std::iter::once(contour).chain(with).filter_map(of).collect();
        let stride = path.len().div_ceil(SIDES).max(1);
        for (k, s) in path.iter().enumerate() {
            for (at, side) in PLACES.map(|f| s.at(f)).into_iter().zip([false, k % stride == 0, false]) {
                if let Some(contour) = fault(&named, at, half, side) {
                    found.push(Violation::Kerf { step, contour, at });
                    return;
                }
            }
        }
    }
}

/// The contour for which a point of the cut is wrong. If a run cuts several contours, the point must be beside one of them.
fn fault(named: &[(u32, &Outline)], at: DVec2, half: f64, side: bool) -> Option<u32> {
    let near: Vec<_> =
        named.iter().filter_map(|(c, o)| Some((*c, o, o.distance(at, CORNER * half + ONE)?))).collect();
    if let Some((contour, ..)) = near.iter().find(|(_, _, d)| *d < half - ONE.min(0.5 * half)) {
        return Some(*contour);
    }
    if near.is_empty() {
        return named.first().map(|(c, _)| *c);
    }
    let wrong = |(_, o, _): &&(u32, &&Outline, f64)| winding(o.path, at).is_inside() != o.hole;
    near.iter().filter(|_| side).find(wrong).map(|(c, ..)| *c)
}
