//! What decides where a part may stand: the straight sides of its neighbours that face its own, and what it must stay clear of.

use super::super::model::{Contour, Operation, Sheet};
use crate::geometry::{Aabb, Affine, BoxIndex, DVec2, Path, Segment, distance};
use crate::order::sort_by;

/// Least length over which two sides face each other, mm: less saves nothing.
const FACING: f64 = 1.0;
/// Sides are parallel, or directions square, if sine or cosine are below this: what six decimals of a drawing leave of a short side.
pub(super) const PARALLEL: f64 = 1e-5;
/// Most elements of an outline of a part that is moved: every pair with those of its neighbours is compared.
const MOST: usize = 200;
/// Rounding of distances, mm.
pub(super) const ROUNDING: f64 = 1e-6;

/// A side of a part that faces one of a neighbour.
pub(super) struct Facing {
    /// Towards the neighbour.
    pub(super) normal: DVec2,
    /// By how much the sides are more than a kerf apart, mm; below zero if they are nearer.
    pub(super) way: f64,
    /// Whether the neighbour is not where it is drawn.
    pub(super) is_moved: bool,
    /// Over which length they face each other, mm.
    length: f64,
}

/// The parts of a sheet, and how near they may stand.
pub(super) struct Parts<'s> {
    sheet: &'s Sheet,
    width: f64,
    /// Distances within this are one kerf, mm.
    pub(super) same: f64,
    /// How far a part may be moved, mm.
    pub(super) most: f64,
    /// By contour: the outermost one around it, or itself.
    root: Vec<u32>,
    boxes: BoxIndex,
}

/// How far parts are moved: by contour, the place of its part in `by`; parts that have none stay.
pub(super) struct Moved<'m> {
    pub(super) slots: &'m [Option<u32>],
    pub(super) by: &'m [DVec2],
}

impl<'s> Parts<'s> {
    pub(super) fn new(sheet: &'s Sheet, width: f64, most: f64, same: f64) -> Self {
        let count = sheet.contours.len();
        let up = |c: &u32| sheet.contours.get(*c as usize).and_then(|c| c.inside).filter(|o| o != c);
        let outermost = |c| std::iter::successors(Some(c), up).take(count).last().unwrap_or(c);
        let root = (0..).take(count).map(outermost).collect();
        Parts {
            sheet,
            width,
            same,
            most,
            root,
            boxes: BoxIndex::new(sheet.contours.iter().map(|c| c.bounds)),
        }
    }

    /// Whether a contour is a part that may be moved: one without another around it.
    pub(super) fn is_part(&self, id: u32) -> bool {
        let is_simple = |c: &Contour| {
            c.operation == Operation::Cut
                && c.path.closed
                && !c.self_crossing
                && c.path.segments.len() <= MOST
        };
        self.root(id) == Some(id) && self.sheet.contours.get(id as usize).is_some_and(is_simple)
    }

    fn outline(&self, id: u32) -> Option<&Path> {
        self.sheet.contours.get(id as usize).map(|c| &c.path)
    }

    /// The outermost contour around one, or itself.
    pub(super) fn root(&self, id: u32) -> Option<u32> {
        self.root.get(id as usize).copied()
    }

    /// How far a contour is moved with its part.
    pub(super) fn by(&self, id: u32, moved: &Moved<'_>) -> DVec2 {
        let slot = self.root(id).and_then(|root| *moved.slots.get(root as usize)?);
        slot.and_then(|slot| moved.by.get(slot as usize)).copied().unwrap_or_default()
    }

    /// The contours that a part may meet when both are moved, without its own.
    pub(super) fn near(&self, id: u32) -> Vec<u32> {
        let around = self.outline(id).map_or(Aabb::EMPTY, Path::bounds).grown(self.width + 2.0 * self.most);
        let mut near: Vec<u32> =
            self.boxes.query(around).into_iter().filter_map(|k| u32::try_from(k).ok()).collect();
        near.retain(|&other| self.root(other) != Some(id));
        sort_by(&mut near, |&c| [c.into(), 0, 0]);
        near
    }

    /// The sides of a part that face one of another part, at most as far away as it may be moved, if it stands `by` from where it is drawn.
    pub(super) fn facing(&self, id: u32, by: DVec2, near: &[u32], moved: &Moved<'_>) -> Vec<Facing> {
        let sides = |id: u32, by: DVec2| {
            let segments = self.outline(id).map_or(&[][..], |p| p.segments.as_slice());
            let lines = segments.iter().filter(|s| matches!(s, Segment::Line(_)) && s.length() > FACING);
            lines.map(move |s| (s.start() + by, s.end() + by)).collect::<Vec<_>>()
        };
        let own = sides(id, by);
        let mut found = Vec::new();
        for &other in near.iter().filter(|&&other| self.is_part(other)) {
            let away = self.by(other, moved);
            let is_moved = away != DVec2::ZERO;
            for (c, d) in sides(other, away) {
                for &(a, b) in &own {
                    let along = (b - a).normalize_or_zero();
                    // Outlines run counter-clockwise, so outside is on the right, and sides that face each other run against each other.
                    let (normal, across) = (-along.perp(), (d - c).normalize_or_zero());
                    let (from, to) = ((d - a).dot(along), (c - a).dot(along));
                    let length = to.min((b - a).length()) - from.max(0.0);
                    if across.dot(along) < 0.0 && across.perp_dot(along).abs() < PARALLEL && length > FACING {
                        let gap = (c - a).dot(normal);
                        if gap > 0.0 && gap <= self.width + self.most + self.same {
                            found.push(Facing { normal, way: gap - self.width, is_moved, length });
                        }
                    }
                }
            }
        }
        found
    }

    /// Length of the sides that are one kerf from another part, mm.
    pub(super) fn shared(&self, facing: &[Facing]) -> f64 {
        facing.iter().filter(|f| f.way.abs() <= self.same).map(|f| f.length).sum()
    }

    /// Whether a part that stands `by` from where it is drawn is a kerf away from everything else.
    pub(super) fn is_clear(&self, id: u32, by: DVec2, near: &[u32], moved: &Moved<'_>) -> bool {
        let Some(own) = self.outline(id) else { return false };
        let own = Affine::translation(by).path(own, 0.0);
        near.iter().all(|&other| {
            let Some(path) = self.outline(other) else { return true };
            let path = Affine::translation(self.by(other, moved)).path(path, 0.0);
            path.segments.iter().all(|s| {
                let reach = s.bounds().grown(self.width);
                own.segments
                    .iter()
                    .filter(|t| t.bounds().overlaps(&reach))
                    .all(|t| distance(s, t).0 >= self.width - self.same - ROUNDING)
            })
        })
    }
}
