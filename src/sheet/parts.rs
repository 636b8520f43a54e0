//! Parts: contours at even depth with their holes, and the orientation of contours.

use super::model::{Contour, Operation, Part};

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
