//! Pieces that come free where the machine cuts through bridges: the parts, and the strips between them.
//!
//! Until then they are one piece, which stays where it is (`sheet/bridges/held.rs`). A part is free once its outline is cut from end to end, and a
//! strip once it is cut at both ends. Micro-joints of the cut around all of them hold what they are on.

use crate::geometry::{Path, Segment};
use crate::joint::ContourJoints;
use crate::machine::{Falls, Tips};
use crate::sheet::{Bridged, Sheet, Strip};
use crate::tipping::{Piece, polygon};

/// The parts and strips that may tip. `joints`: the micro-joints of a contour.
pub(super) fn pieces(
    sheet: &Sheet,
    tips: &Tips,
    joints: impl Fn(u32) -> Option<ContourJoints>,
) -> Vec<Piece> {
    let mut found = Vec::new();
    for group in sheet.bridged.iter().filter(|group| !group.cuts.is_empty()) {
        let strips: Vec<Path> = group.strips.iter().map(around).collect();
        let held = joints(group.contour).map_or_else(Vec::new, |j| held(sheet, group, &strips, &j));
        let parts = group.outlines.iter().map(|(id, outline)| (*id, outline, None));
        let between = strips.iter().enumerate().map(|(k, outline)| (group.contour, outline, Some(k)));
        for (place, (id, outline, strip)) in parts.chain(between).enumerate() {
            if held.contains(&place) || tips.falls_within(outline) != Falls::Tips {
                continue;
            }
            let own = group.cuts.iter().filter(|cut| strip.map_or(cut.outline == id, |k| cut.strip == k));
            let own: Vec<u32> = own.map(|cut| cut.contour).collect();
            let drawn = if strip.is_none() { Some(id) } else { own.first().copied() };
            let cut_by = std::iter::once(group.contour).chain(own).collect();
            found.push(Piece::new(cut_by, polygon(outline)).drawn_as(drawn.unwrap_or(group.contour)));
        }
    }
    found
}

/// The outline of a strip between the outlines of its parts.
fn around(strip: &Strip) -> Path {
    let [[a, b], [c, d]] = strip.sides;
    let corners = [a, b, c, d, a];
    Path::new(corners.windows(2).map(|w| Segment::line(w[0], w[1])).collect(), true)
}

/// What micro-joints hold: the parts and then the strips, as places in one list.
fn held(sheet: &Sheet, group: &Bridged, strips: &[Path], joints: &ContourJoints) -> Vec<usize> {
    let path = sheet.contours.get(group.contour as usize).map(|c| &c.path);
    let whole = path.map_or(0.0, Path::length);
    let on = |joint: &crate::joint::Joint| {
        let at = path?.at((joint.from + 0.5 * joint.length) % whole)?;
        let from = |outline: &Path| outline.nearest(at).map_or(f64::INFINITY, |n| n.1.distance(at));
        let all = group.outlines.iter().map(|o| &o.1).chain(strips);
        all.map(from).enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).map(|n| n.0)
    };
    joints.joints.iter().filter_map(on).collect()
}
