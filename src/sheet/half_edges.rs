//! The half-edges of a planar graph: which one a round along an area goes on with.

use crate::geometry::{DVec2, math};
use crate::order::{real, sort_by};

/// Links the half-edges that leave one node. Half-edge `h ^ 1` is `h` in the other direction: whoever arrives along it goes on
/// with the one before `h` in counter-clockwise order, so that the area stays on the left; `after` gets it. Directions from the
/// node are taken at one distance for all, as a fraction (`ahead`) of the shortest of them: where those with a common
/// tangent have diverged.
pub(super) fn link(
    leaving: &mut Vec<usize>,
    after: &mut [usize],
    ahead: f64,
    length: impl Fn(usize) -> f64,
    direction: impl Fn(usize, f64) -> DVec2,
) {
    let shortest = leaving.iter().map(|&h| length(h)).fold(f64::INFINITY, f64::min);
    sort_by(leaving, |&h| [real(math::angle_order(direction(h, ahead * shortest))), 0, 0]);
    for (k, &h) in leaving.iter().enumerate() {
        after[h ^ 1] = leaving[(k + leaving.len() - 1) % leaving.len()];
    }
}
