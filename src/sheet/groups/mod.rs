//! Pierce groups: contours that share cuts, as one planar graph of elements.
//!
//! Cleaning leaves every stretch that two outlines share on only one of them; the other outline becomes an open contour
//! that ends on the first. Where an open contour ends on others at both ends, they form one group, which can be pierced
//! once and cut as a whole, from element to element.
//!
//! [`contacts`] finds where contours of a group meet, and [`vertices`] makes them meet bit for bit. [`faces`] finds the
//! faces that the elements enclose: parts, and islands between parts. The material of a face falls out when the last
//! element around it is cut, so a face may be closed only when nothing in it is left to cut. A stretch shared by two
//! parts comes before the contour around both.

mod contacts;
mod faces;
mod group;
mod stretches;
mod vertices;

pub use group::{GroupElement, PierceGroup};

use super::model::{Contour, Operation};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, winding, winding_number};

/// The groups of a sheet. Ends are searched within `tolerance` mm, and moved by at most `limit` mm. `crossing` lists
/// contours that cross each other, for which no planar graph exists. `same` says whether two contours may be cut one
/// after the other at all.
pub(super) fn find(
    contours: &[Contour],
    crossing: &[(u32, u32)],
    [tolerance, limit]: [f64; 2],
    same: impl Fn(&Contour, &Contour) -> bool,
) -> Vec<PierceGroup> {
    let mut groups = Vec::new();
    // Both ends of a shorter contour would be one node, and nothing between them.
    let has_two_ends = |c: &Contour| c.path.closed || c.path.length() > contacts::SAME_NODE * tolerance;
    let is_sound = |c: &Contour| c.operation == Operation::Cut && !c.self_crossing && has_two_ends(c);
    let mut sound: Vec<bool> = contours.iter().map(is_sound).collect();
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
    // What is left of an outline may lie elsewhere than the sides that its neighbours cut.
    let around = |c: &Contour| c.boundary().map_or(Aabb::EMPTY, Path::bounds);
    let boxes = BoxIndex::new(contours.iter().map(|c| c.bounds.union(around(c))));
    groups.retain(|group| lies_clear(contours, &boxes, group));
    for group in &mut groups {
        group.inside = inside(contours, &boxes, group);
    }
    groups
}

/// Whether every other contour that bounds an area either contains the whole group, and is known to lie around it, or
/// nothing of it. For overlapping outlines it is unclear what falls out when.
fn lies_clear(contours: &[Contour], boxes: &BoxIndex, group: &PierceGroup) -> bool {
    let places: Vec<DVec2> = group
        .elements
        .iter()
        .filter_map(|e| {
            let path = group.path(e);
            path.at(0.5 * path.length())
        })
        .collect();
    let index = BoxIndex::new(places.iter().map(|p| Aabb::of(*p)));
    let bounds = places.iter().fold(Aabb::EMPTY, |b, p| b.with(*p));
    let outer = |c: u32| contours[c as usize].inside;
    let around: Vec<u32> =
        std::iter::successors(outer(group.contours[0]), |&c| outer(c)).take(contours.len()).collect();
    boxes.query(bounds).into_iter().filter_map(|c| u32::try_from(c).ok()).all(|c| {
        let contour = &contours[c as usize];
        let Some(boundary) = contour.boundary().filter(|_| contour.bounds_area()) else { return true };
        if group.contours.binary_search(&c).is_ok() {
            return true;
        }
        let mut within = 0;
        index.visit(boundary.bounds(), |p| {
            within += usize::from(places.get(p).is_some_and(|p| winding(boundary, *p).is_inside()));
            true
        });
        within == 0 || (within == places.len() && around.contains(&c))
    })
}

/// Contours enclosed by a group.
fn inside(contours: &[Contour], boxes: &BoxIndex, group: &PierceGroup) -> Vec<u32> {
    let around = around(group);
    let bounds = around.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds()));
    let mut found = boxes.query(bounds);
    crate::order::sort_by(&mut found, |&c| [c as u64, 0, 0]);
    let lies_in = |c: &u32| {
        let contour = &contours[*c as usize];
        let path = &contour.path;
        // The ends may lie on the outline.
        let places = [0.0, 0.5, 1.0].map(|part| path.at(part * contour.length));
        contour.operation != Operation::Ignore
            && group.contours.binary_search(c).is_err()
            && within(bounds, contour.bounds)
            && places.into_iter().flatten().any(|p| winding_number(&around, p) != 0)
    };
    found.into_iter().filter_map(|c| u32::try_from(c).ok()).filter(lies_in).collect()
}

fn within(outer: Aabb, inner: Aabb) -> bool {
    outer.union(inner) == outer
}

/// The elements that bound the outer face of a group, in no particular order; enough for a winding number.
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
