//! Parts: contours at even depth with their holes, and the orientation of contours.

use super::model::{Contour, Operation, Part, Sheet};
use std::iter::successors;

/// Orients closed contours: outer ones (even depth) and closed marks counter-clockwise, holes clockwise. The start
/// point stays as drawn.
pub(super) fn orient(contours: &mut [Contour]) {
    for c in contours.iter_mut().filter(|c| c.path.closed) {
        let clockwise = c.operation == Operation::Cut && c.depth % 2 == 1;
        if (c.path.area() < 0.0) != clockwise {
            c.path = c.path.reversed();
        }
    }
}

/// The parts, in drawing order of their outer contours. Parts in holes are separate parts.
pub(super) fn parts(contours: &[Contour]) -> Vec<Part> {
    let is_outer = |c: &Contour| c.bounds_area() && c.depth.is_multiple_of(2);
    let mut part_of = vec![None; contours.len()];
    let mut parts = Vec::new();
    for (i, c) in (0_u32..).zip(contours).filter(|(_, c)| is_outer(c)) {
        part_of[i as usize] = u32::try_from(parts.len()).ok();
        parts.push(Part { outer: i, holes: Vec::new(), inside: None });
        debug_assert!(c.area >= 0.0);
    }
    for (i, c) in (0_u32..).zip(contours) {
        let Some(around) = c.inside else { continue };
        let on = if is_outer(c) { contours[around as usize].inside } else { Some(around) };
        let Some(part) = on.and_then(|o| part_of[o as usize]) else { continue };
        match part_of[i as usize] {
            Some(own) => parts[own as usize].inside = Some(part),
            None => parts[part as usize].holes.push(i),
        }
    }
    parts
}

impl Sheet {
    /// The parts around a contour, the innermost first; `of` is [`Sheet::part_of`].
    pub(crate) fn parts_around(&self, of: &[Option<u32>], contour: u32) -> impl Iterator<Item = u32> {
        let own = of.get(contour as usize).copied().flatten();
        successors(own, |&p| self.parts.get(p as usize)?.inside).take(self.parts.len())
    }

    /// The outermost part around a contour that is not around another one.
    pub(crate) fn part_without(&self, of: &[Option<u32>], contour: u32, other: u32) -> Option<u32> {
        let holds_both = |part: u32| self.parts_around(of, other).any(|p| p == part);
        self.parts_around(of, contour).take_while(|&part| !holds_both(part)).last()
    }

    /// By contour: the innermost part that it is cut with where the sheet is cut part by part. What lies in a hole of a part, and is
    /// no part itself, has to be cut before the hole, so that it is cut with the part. Each pass belongs to the part of its contour.
    pub(crate) fn part_of(&self) -> Vec<Option<u32>> {
        let mut own = vec![None; self.contours.len()];
        for (part, p) in (0..).zip(&self.parts) {
            for &contour in p.holes.iter().chain([&p.outer]) {
                if let Some(own) = own.get_mut(contour as usize) {
                    *own = Some(part);
                }
            }
        }
        let part = |c: u32| own.get(c as usize).copied().flatten();
        (0..)
            .zip(&self.contours)
            .map(|(id, _)| self.last_pass(id))
            .map(|c| part(c).or_else(|| part(self.contours.get(c as usize)?.inside?)))
            .collect()
    }

    /// The last pass over a contour that is worked in several passes, sheet by sheet; otherwise the contour itself.
    pub(crate) fn last_pass(&self, contour: u32) -> u32 {
        let next = |&c: &u32| self.contours.get(c as usize)?.next_pass;
        successors(Some(contour), next).last().unwrap_or(contour)
    }
}
