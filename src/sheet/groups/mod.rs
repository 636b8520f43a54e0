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
mod vertices;

use super::model::{Contour, Operation};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, turns, winding};

/// Contours that share cuts.
#[derive(Clone, Debug, PartialEq)]
pub struct PierceGroup {
    /// Contour ids, ascending; the first stands for the group.
    pub contours: Vec<u32>,
    /// Their paths in the group: as those of the sheet, but with a vertex at each node, which they are moved onto within the
    /// copy tolerance. The contours themselves stay as they are for machines that cut them one by one.
    pub paths: Vec<Path>,
    /// Where elements end, mm.
    pub nodes: Vec<DVec2>,
    /// Stretches of its contours between nodes.
    pub elements: Vec<GroupElement>,
    /// How many areas its elements part; 0 is the one around the group.
    pub faces: u32,
    /// Contours that lie in what the group closes in, at any depth.
    pub inside: Vec<u32>,
}

/// A stretch of a contour between two nodes of its group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroupElement {
    /// Whose it is.
    pub contour: u32,
    /// Arc length on the contour's path in the group where it begins and ends, mm; over the contour's end where it ends before it begins,
    /// and once round where both are one.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Nodes at which it begins and ends.
    pub ends: [u32; 2],
    /// Areas to its left and right.
    pub faces: [u32; 2],
}

impl PierceGroup {
    /// The path of one of its contours.
    pub fn path_of(&self, contour: u32) -> Option<&Path> {
        self.contours.iter().position(|&c| c == contour).and_then(|k| self.paths.get(k))
    }

    /// Elements between two areas that the group closes in: cut once for both.
    pub fn between_parts(&self) -> impl Iterator<Item = &GroupElement> {
        self.elements.iter().filter(|e| !e.faces.contains(&0))
    }

    /// The geometry of an element, from beginning to end.
    pub fn path(&self, element: &GroupElement) -> Path {
        let Some(contour) = self.path_of(element.contour) else { return Path::default() };
        let whole = element.from.total_cmp(&element.to).is_eq();
        let segments = match (whole, contour.closed) {
            (true, true) => contour.starting_at(element.from).segments,
            (true, false) => contour.segments.clone(),
            _ => contour.between(element.from, element.to),
        };
        Path::new(segments, false)
    }
}

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
            && places.into_iter().flatten().any(|p| turns(&around, p) != 0)
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
