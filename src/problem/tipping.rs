//! Which pieces of a sheet may tip, and what frees them.

use super::cut_apart;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path};
use crate::joint::ContourJoints;
use crate::machine::{Falls, PLANS_ALL_LEVERS, Profile, Tips};
use crate::sheet::{Contour, Operation, Sheet};
use crate::tipping::{Piece, Zones, polygon};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Lines that are nearer than this are one, mm: more than sides that are taken for shared may be apart.
const SAME_LINE: f64 = 0.1;
/// Distance of the places at which it is looked who cuts a side, mm, and their largest number on an element.
const SPACING: f64 = 1.0;
const MOST_PLACES: f64 = 500.0;

/// The pieces that may tip on a machine with `levers.tips`. `joints`: the micro-joints of a contour.
///
/// A cut that bounds an area frees what is inside it: a part, or what is cut out of a hole. Of several passes the last one
/// does, and of an outline whose sides are shared with others, the last of its own cuts and of those that cut the shared sides. A
/// piece with micro-joints is held until a person breaks them, and is never free.
pub(super) fn zones(
    sheet: &Sheet,
    machine: &Profile,
    joints: impl Fn(u32) -> Option<ContourJoints>,
) -> Option<Arc<Zones>> {
    let tips = machine.levers.tips.filter(|_| PLANS_ALL_LEVERS)?;
    let is_held = |c| joints(c).is_some_and(|j| !j.joints.is_empty());
    // What is left of a shape whose sides are shared with others, by the number of the shape.
    let mut rests: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
    for (id, contour) in (0..).zip(&sheet.contours) {
        if let Some(shape) = contour.rest_of {
            rests.entry(shape).or_default().push(id);
        }
    }
    let bounds = sheet.contours.iter().map(|c| if rests.is_empty() { Aabb::EMPTY } else { c.bounds });
    let index = BoxIndex::new(bounds);
    let mut pieces: Vec<Piece> = Vec::new();
    for (id, contour) in (0..).zip(&sheet.contours).filter(|(_, c)| frees(c)) {
        let Some(outline) = contour.boundary() else { continue };
        let own = match contour.rest_of {
            // Each shape once.
            Some(shape) => rests.remove(&shape).unwrap_or_default(),
            None => vec![id],
        };
        // A neighbour may be held elsewhere.
        if !own.is_empty() && tips_up(&tips, contour, outline) && !own.iter().any(|&c| is_held(c)) {
            let is_all = contour.rest_of.is_none();
            let cut_by = if is_all { own } else { with_shared(sheet, &index, outline, own) };
            pieces.push(Piece::new(cut_by, polygon(outline)));
        }
    }
    pieces.extend(cut_apart::pieces(sheet, &tips, &joints));
    Zones::new(machine, pieces).map(Arc::new)
}

/// All that cuts an outline of which a contour's own cuts are only a part: at places along it where none of them runs, the cuts
/// of others do.
fn with_shared(sheet: &Sheet, index: &BoxIndex, outline: &Path, own: Vec<u32>) -> Vec<u32> {
    let runs_by = |contour: &Contour, place: DVec2| {
        contour.path.segments.iter().any(|s| s.nearest(place).1 <= SAME_LINE * SAME_LINE)
    };
    let get = |id: u32| sheet.contours.get(id as usize);
    let mut all = own.clone();
    for segment in &outline.segments {
        let count = (segment.length() / SPACING).ceil().clamp(1.0, MOST_PLACES);
        let mut k = 0.5;
        while k < count {
            let place = segment.at(k / count);
            k += 1.0;
            if own.iter().filter_map(|&id| get(id)).any(|c| runs_by(c, place)) {
                continue;
            }
            for id in index.query(Aabb::of(place).grown(SAME_LINE)) {
                let Ok(id) = u32::try_from(id) else { continue };
                let cuts = |c: &&Contour| c.operation == Operation::Cut && c.next_pass.is_none();
                if !all.contains(&id) && get(id).filter(cuts).is_some_and(|c| runs_by(c, place)) {
                    all.push(id);
                }
            }
        }
    }
    all
}

/// Whether cutting a contour frees a piece.
fn frees(contour: &Contour) -> bool {
    contour.bounds_area() && contour.next_pass.is_none()
}

/// Whether what an outline bounds may tip.
fn tips_up(tips: &Tips, contour: &Contour, outline: &Path) -> bool {
    let is_hole = contour.depth % 2 == 1;
    let crossed = is_hole && tips.crosses_over(outline.bounds().size());
    !crossed && tips.falls_within(outline) == Falls::Tips
}
