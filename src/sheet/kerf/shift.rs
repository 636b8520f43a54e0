//! Shifts of whole parts that bring them one kerf from a neighbour, so that one line between them cuts both (`levers.common_cuts`).
//!
//! Parts are looked at from the lower left on. Each may move towards those before it, across the straight sides that face each
//! other, at most by the distance that the machine states from where it is drawn, and once along each of two directions that are
//! square to each other. It never comes nearer than a kerf to anything: neither to parts that have moved, nor to those that have not, nor to marks
//! and open cuts beside it. What lies in a part moves with it.

use super::super::model::{Contour, Operation, Sheet};
use crate::geometry::{Aabb, Affine, BoxIndex, DVec2, Path, Segment, distance};
use crate::order::{real, sort_by};

/// Least length over which two sides face each other, mm: less saves nothing.
const FACING: f64 = 1.0;
/// Sides are parallel, or directions square, if sine or cosine are below this: what six decimals of a drawing leave of a short side.
const PARALLEL: f64 = 1e-5;
/// Most elements of an outline of a part that is moved: every pair with those of its neighbours is compared.
const MOST: usize = 200;
/// Rounding of distances, mm.
const ROUNDING: f64 = 1e-6;

/// A part that would stand one kerf from a neighbour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shift {
    /// Its outer contour.
    pub(crate) contour: u32,
    /// By how much it is moved, mm.
    pub(crate) by: DVec2,
}

/// The parts of a sheet as they are moved.
struct Parts<'s> {
    sheet: &'s Sheet,
    width: f64,
    /// Distances within this are one kerf, mm.
    same: f64,
    most: f64,
    /// By contour: the outermost one around it, or itself.
    root: Vec<u32>,
    /// By contour: how far its part is moved.
    by: Vec<DVec2>,
    boxes: BoxIndex,
}

/// The shifts, each of at most `most` mm, that bring parts `width` mm from a neighbour; distances that differ by up to `same` mm are one.
pub(crate) fn shifts(sheet: &Sheet, width: f64, most: f64, same: f64) -> Vec<Shift> {
    let up = |c: &u32| sheet.contours.get(*c as usize).and_then(|c| c.inside).filter(|o| o != c);
    let count = sheet.contours.len();
    let ids = || (0..).take(count);
    let root = ids().map(|c| std::iter::successors(Some(c), up).take(count).last().unwrap_or(c)).collect();
    let boxes = BoxIndex::new(sheet.contours.iter().map(|c| c.bounds));
    let mut parts = Parts { sheet, width, same, most, root, by: vec![DVec2::ZERO; count], boxes };
    let mut order: Vec<(u32, DVec2)> = ids()
        .zip(&sheet.contours)
        .filter(|(id, c)| parts.root.get(*id as usize) == Some(id) && is_part(c))
        .map(|(id, c)| (id, c.bounds.min))
        .collect();
    sort_by(&mut order, |(id, low)| [real(low.x + low.y), (*id).into(), 0]);
    let mut done = vec![false; count];
    let mut found = Vec::new();
    for (id, _) in order {
        let by = parts.moved(id, &done);
        if by != DVec2::ZERO {
            found.push(Shift { contour: id, by });
        }
        if let Some(by_part) = parts.by.get_mut(id as usize) {
            *by_part = by;
        }
        done[id as usize] = true;
    }
    found
}

impl Sheet {
    /// The sheet with parts moved.
    pub(crate) fn shifted(&self, shifts: &[Shift]) -> Self {
        let mut sheet = self.clone();
        let up = |c: &u32| self.contours.get(*c as usize).and_then(|c| c.inside).filter(|o| o != c);
        for (id, contour) in (0..).zip(&mut sheet.contours) {
            let around = std::iter::successors(Some(id), up).take(self.contours.len());
            let shift = around.last().and_then(|root| shifts.iter().find(|s| s.contour == root));
            let Some(shift) = shift else { continue };
            let moved = Affine::translation(shift.by);
            contour.path = moved.path(&contour.path, 0.0);
            contour.outline = contour.outline.as_ref().map(|o| moved.path(o, 0.0));
            contour.bounds = contour.path.bounds();
        }
        sheet
    }
}

/// Whether a contour without another one around it is a part that may be moved.
fn is_part(c: &Contour) -> bool {
    c.operation == Operation::Cut && c.path.closed && !c.self_crossing && c.path.segments.len() <= MOST
}

impl Parts<'_> {
    fn outline(&self, id: u32) -> Option<&Path> {
        self.sheet.contours.get(id as usize).map(|c| &c.path)
    }

    /// How far a contour has been moved with its part.
    fn by(&self, id: u32) -> DVec2 {
        let root = self.root.get(id as usize).copied().unwrap_or(id);
        self.by.get(root as usize).copied().unwrap_or_default()
    }

    /// Where a part is moved, next to those that are done.
    fn moved(&self, id: u32, done: &[bool]) -> DVec2 {
        let mut by = DVec2::ZERO;
        // The directions in which it stands one kerf from a neighbour.
        let mut held: Vec<DVec2> = Vec::new();
        for _ in 0..2 {
            let mut ways = Vec::new();
            for (normal, way) in self.ways(id, by, done) {
                if way.abs() <= self.same {
                    held.push(normal);
                } else if way > 0.0 {
                    ways.push((way, normal));
                }
            }
            sort_by(&mut ways, |(way, normal)| [real(*way), real(normal.x), real(normal.y)]);
            let next =
                ways.into_iter().map(|(way, normal)| (by + normal * way, normal)).find(|(to, normal)| {
                    let square = held.iter().all(|h| h.dot(*normal).abs() < PARALLEL);
                    square && to.length() <= self.most + ROUNDING && self.is_clear(id, *to)
                });
            let Some((to, normal)) = next else { break };
            by = to;
            held.push(normal);
        }
        by
    }

    /// The other contours near a part that is moved by `by`.
    fn near(&self, id: u32, by: DVec2) -> Vec<u32> {
        let bounds = self.outline(id).map_or(Aabb::EMPTY, Path::bounds);
        let around = Aabb { min: bounds.min + by, max: bounds.max + by }.grown(self.width + 2.0 * self.most);
        let mut near: Vec<u32> =
            self.boxes.query(around).into_iter().filter_map(|k| u32::try_from(k).ok()).collect();
        near.retain(|&other| self.root.get(other as usize) != Some(&id));
        sort_by(&mut near, |&c| [c.into(), 0, 0]);
        near
    }

    /// For each side of a part that faces one of a part that is done: the direction towards it, and how far it is more than a kerf away.
    fn ways(&self, id: u32, by: DVec2, done: &[bool]) -> Vec<(DVec2, f64)> {
        let mut ways = Vec::new();
        let sides = |id: u32, by: DVec2| {
            let segments = self.outline(id).map_or(&[][..], |p| p.segments.as_slice());
            let lines = segments.iter().filter(|s| matches!(s, Segment::Line(_)) && s.length() > FACING);
            lines.map(move |s| (s.start() + by, s.end() + by)).collect::<Vec<_>>()
        };
        let own = sides(id, by);
        for other in self.near(id, by).into_iter().filter(|&o| done.get(o as usize) == Some(&true)) {
            for (c, d) in sides(other, self.by(other)) {
                for &(a, b) in &own {
                    let along = (b - a).normalize_or_zero();
                    // Outlines run counter-clockwise, so outside is on the right, and sides that face each other run against each other.
                    let (outside, across) = (-along.perp(), (d - c).normalize_or_zero());
                    let (from, to) = ((d - a).dot(along), (c - a).dot(along));
                    let facing = to.min((b - a).length()) - from.max(0.0);
                    if across.dot(along) < 0.0 && across.perp_dot(along).abs() < PARALLEL && facing > FACING {
                        let gap = (c - a).dot(outside);
                        if gap > 0.0 && gap <= self.width + self.most + self.same {
                            ways.push((outside, gap - self.width));
                        }
                    }
                }
            }
        }
        ways
    }

    /// Whether a part that is moved by `by` stays a kerf away from everything else.
    fn is_clear(&self, id: u32, by: DVec2) -> bool {
        let Some(own) = self.outline(id) else { return false };
        let moved = Affine::translation(by).path(own, 0.0);
        self.near(id, by).into_iter().all(|other| {
            let Some(path) = self.outline(other) else { return true };
            let path = Affine::translation(self.by(other)).path(path, 0.0);
            path.segments.iter().all(|s| {
                let reach = s.bounds().grown(self.width);
                moved
                    .segments
                    .iter()
                    .filter(|t| t.bounds().overlaps(&reach))
                    .all(|t| distance(s, t).0 >= self.width - self.same - ROUNDING)
            })
        })
    }
}
