//! Which pieces of a sheet may tip, and what frees them.

use crate::geometry::{Affine, Path};
use crate::machine::{Falls, PLANS_ALL_LEVERS, Profile, Tips};
use crate::sheet::{Contour, Sheet};
use crate::tipping::{Piece, Zones, polygon};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The pieces that may tip on a machine with `levers.tips`. `is_held`: whether a contour has micro-joints.
///
/// A cut that bounds an area frees what is inside it: a part, or what is cut out of a hole. Of several passes the last one
/// does, and of an outline whose sides are shared with others, the last of its own cuts. A piece with micro-joints is held
/// until a person breaks them, and is never free.
pub(super) fn zones(sheet: &Sheet, machine: &Profile, is_held: impl Fn(u32) -> bool) -> Option<Arc<Zones>> {
    let tips = machine.levers.tips.filter(|_| PLANS_ALL_LEVERS)?;
    // What is left of a shape whose sides are shared with others, by the number of the shape.
    let mut rests: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
    for (id, contour) in (0..).zip(&sheet.contours) {
        if let Some(shape) = contour.rest_of {
            rests.entry(shape).or_default().push(id);
        }
    }
    let mut pieces: Vec<Piece> = Vec::new();
    for (id, contour) in (0..).zip(&sheet.contours).filter(|(_, c)| frees(c)) {
        let Some(outline) = contour.boundary() else { continue };
        let cut_by = match contour.rest_of {
            // Each shape once.
            Some(shape) => rests.remove(&shape).unwrap_or_default(),
            None => vec![id],
        };
        if !cut_by.is_empty() && tips_up(&tips, contour, outline) && !cut_by.iter().any(|&c| is_held(c)) {
            pieces.push(Piece::new(cut_by, polygon(outline)));
        }
    }
    Zones::new(machine, pieces).map(Arc::new)
}

/// Whether cutting a contour frees a piece.
fn frees(contour: &Contour) -> bool {
    contour.bounds_area() && contour.next_pass.is_none()
}

/// Whether what an outline bounds may tip.
fn tips_up(tips: &Tips, contour: &Contour, outline: &Path) -> bool {
    let size = outline.bounds().size();
    let is_hole = contour.depth % 2 == 1;
    if is_hole && tips.crosses_over(size) {
        return false;
    }
    let (across, along) = match tips.slat_angle() {
        // Turned so that the slats run along x.
        Some(angle) => {
            let turned = outline.segments.iter().filter_map(|s| Affine::rotation(-angle).segment(s));
            let size = Path::new(turned.collect(), true).bounds().size();
            (size.y, size.x)
        }
        None => (size.min_element(), size.max_element()),
    };
    tips.falls(across, along) == Falls::Tips
}
