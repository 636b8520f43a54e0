//! Pierce groups: contours that share cuts, as one planar net of elements.
//!
//! Cleaning leaves every stretch that two outlines share on one of them only; the other is cut open there and ends on
//! it. Where an open contour ends on others at both ends, they are one group: it can be pierced once and cut as a whole,
//! from element to element.
//!
//! [`contacts`] finds where contours of a group meet, [`vertices`] lets them meet bit for bit; [`faces`] tells the areas that
//! the elements close in: parts, and islands between parts. What is closed in falls out when the last element around it
//! is cut, so a face may be closed only when nothing in it is left to cut; a stretch shared by two parts comes before
//! the contour that both have together.

mod contacts;
mod faces;
mod group;
mod vertices;

pub use group::{GroupElement, PierceGroup};

use super::model::{Contour, Operation};
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment, winding, winding_number};

/// The groups of a sheet. `tolerance`, mm: within it ends are looked for; `limit`: what meets is moved by this at most.
/// `crossing`: contours that cross each other, of which no net can be made. `same`: whether two contours may be worked one after the other at all.
pub(super) fn find(
    contours: &[Contour],
    crossing: &[(u32, u32)],
    [tolerance, limit]: [f64; 2],
    same: impl Fn(&Contour, &Contour) -> bool,
) -> Vec<PierceGroup> {
    let mut groups = Vec::new();
    let mut sound: Vec<bool> =
        contours.iter().map(|c| c.operation == Operation::Cut && !c.self_crossing).collect();
    for &(a, b) in crossing {
        sound[a as usize] = false;
        sound[b as usize] = false;
    }
    for mut set in contacts::sets(contours, &sound, tolerance) {
        let first = &contours[set.contours[0] as usize];
        let alike = set.contours.iter().all(|&c| same(first, &contours[c as usize]));
        let paths = if alike { contacts::join(contours, &mut set, limit) } else { None };
        groups.extend(paths.and_then(|paths| faces::group(&set, paths)));
    }
    let boxes = BoxIndex::new(contours.iter().map(|c| c.bounds));
    groups.retain(|group| lies_clear(contours, &boxes, group));
    for group in &mut groups {
        group.inside = inside(contours, &boxes, group);
    }
    groups
}

/// Whether every other contour that bounds an area has all of a group in it, and is known to be around it, or nothing of
/// it: outlines that overlap leave in doubt what falls out when.
fn lies_clear(contours: &[Contour], boxes: &BoxIndex, group: &PierceGroup) -> bool {
    let places: Vec<DVec2> = group
        .elements
        .iter()
        .filter_map(|e| {
            let path = group.path(e);
            path.at(0.5 * path.length())
        })
        .collect();
    let bounds = places.iter().fold(Aabb::EMPTY, |b, p| b.with(*p));
    let outer = |c: u32| contours[c as usize].inside;
    let around: Vec<u32> =
        std::iter::successors(outer(group.contours[0]), |&c| outer(c)).take(contours.len()).collect();
    boxes.query(bounds).into_iter().filter_map(|c| u32::try_from(c).ok()).all(|c| {
        let contour = &contours[c as usize];
        let Some(boundary) = contour.boundary().filter(|_| contour.bounds_area()) else { return true };
        if group.contours.contains(&c) {
            return true;
        }
        let within = places.iter().filter(|p| winding(boundary, **p).is_inside()).count();
        within == 0 || (within == places.len() && around.contains(&c))
    })
}

/// Contours that are closed in by a group.
fn inside(contours: &[Contour], boxes: &BoxIndex, group: &PierceGroup) -> Vec<u32> {
    let around = around(group);
    let bounds = around.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds()));
    let mut found = boxes.query(bounds);
    crate::order::sort_by(&mut found, |&c| [c as u64, 0, 0]);
    let lies_in = |c: &u32| {
        let contour = &contours[*c as usize];
        let path = &contour.path;
        // Ends may lie on the outline.
        let places = [0.0, 0.5, 1.0].map(|part| path.at(part * contour.length));
        contour.operation != Operation::Ignore
            && !group.contours.contains(c)
            && within(bounds, contour.bounds)
            && places.into_iter().flatten().any(|p| winding_number(&around, p) != 0)
    };
    found.into_iter().filter_map(|c| u32::try_from(c).ok()).filter(lies_in).collect()
}

fn within(outer: Aabb, inner: Aabb) -> bool {
    outer.union(inner) == outer
}

/// The elements that the area around a group ends at, in no order: enough to count crossings.
fn around(group: &PierceGroup) -> Vec<Segment> {
    let mut segments = Vec::new();
    for e in &group.elements {
        let path = group.path(e);
        match e.faces {
            [0, 0] => {}
            [_, 0] => segments.extend(path.segments),
            [0, _] => segments.extend(path.reversed().segments),
            _ => {}
        }
    }
    segments
}
