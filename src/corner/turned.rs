//! The elements of a cut whose corners are cut in loops or rounded.

use crate::geometry::{Arc, DVec2, Segment, math};
use crate::machine::CornerKind;
use std::f64::consts::TAU;

/// A corner this near to where two elements meet is that corner, mm, and the directions there agree by this much.
const SAME: f64 = 1e-7;
/// Shortest side that a rounded corner leaves, mm: the finest step of machines.
const LEAST_SIDE: f64 = 1e-3;

/// A corner of a contour, and what is cut there instead of stopping.
#[derive(Clone, Debug, PartialEq)]
pub struct Corner {
    /// A loop or an arc.
    pub kind: CornerKind,
    /// The corner, mm.
    pub at: DVec2,
    /// Unit directions of travel into it and on from it.
    arrives: DVec2,
    leaves: DVec2,
    /// What is cut: a line, an arc and a line through the waste, or the arc that replaces the corner.
    pub path: Vec<Segment>,
    /// Length that is left out of both sides, mm; 0 for a loop.
    pub trim: f64,
}

/// A corner that was cut so: which, and its elements in the cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Made {
    /// Its place in the list of corners.
    pub corner: usize,
    /// Its first element.
    pub first: usize,
    /// Number of its elements.
    pub count: usize,
}

impl Corner {
    /// By how much a contour turns between two directions, rad, positive to the left, where its part lies.
    pub(super) fn turn(arrives: DVec2, leaves: DVec2) -> f64 {
        math::atan2(arrives.perp_dot(leaves), arrives.dot(leaves))
    }

    /// A loop to the right of a corner that turns left: straight on, around a circle that touches the directions of both sides,
    /// and back through the corner.
    pub(super) fn looped(at: DVec2, arrives: DVec2, leaves: DVec2, radius: f64) -> Self {
        let turn = Self::turn(arrives, leaves);
        let ahead = radius * math::tan(0.5 * turn);
        let (from, to) = (at + arrives * ahead, at - leaves * ahead);
        let center = from - arrives.perp() * radius;
        let around = Segment::Arc(Arc { start: from, end: to, center, sweep: turn - TAU });
        let path = vec![Segment::line(at, from), around, Segment::line(to, at)];
        Self { kind: CornerKind::Loop, at, arrives, leaves, path, trim: 0.0 }
    }

    /// An arc that touches both sides of a corner.
    pub(super) fn rounded(at: DVec2, arrives: DVec2, leaves: DVec2, radius: f64) -> Self {
        let turn = Self::turn(arrives, leaves);
        let trim = radius * math::tan(0.5 * turn.abs());
        let (start, end) = (at - arrives * trim, at + leaves * trim);
        let center = start + arrives.perp() * (radius * turn.signum());
        let arc = Segment::Arc(Arc { start, end, center, sweep: turn });
        Self { kind: CornerKind::Round, at, arrives, leaves, path: vec![arc], trim }
    }

    /// Whether a cut turns this corner between two of its elements.
    pub(super) fn is_between(&self, before: &Segment, after: &Segment) -> bool {
        let same = |a: DVec2, b: DVec2| a.distance(b) <= SAME;
        same(before.end(), self.at)
            && same(before.tangent(1.0), self.arrives)
            && same(after.tangent(0.0), self.leaves)
    }
}

/// The elements of a cut with some corners cut in loops or rounded, and which of them were. `on`: the elements of the contour, among
/// leads and an overcut. A corner at which the cut begins or ends is not turned, nor one whose sides are too short in this cut.
pub fn turned(
    path: &[Segment],
    on: std::ops::Range<usize>,
    corners: &[Corner],
    chosen: &[usize],
) -> (Vec<Segment>, Vec<Made>) {
    let mut out: Vec<Segment> = Vec::with_capacity(path.len() + 3 * chosen.len());
    let mut made = Vec::with_capacity(chosen.len());
    for (index, element) in path.iter().enumerate() {
        let before = index.checked_sub(1).filter(|k| on.contains(k) && on.contains(&index));
        let before = before.and_then(|k| path.get(k));
        let is_here = |c: &&usize| {
            let corner = before.zip(corners.get(**c));
            corner.is_some_and(|(before, corner)| corner.is_between(before, element))
        };
        let here = before.and_then(|_| chosen.iter().find(is_here)).and_then(|&c| Some((c, corners.get(c)?)));
        let Some((index, corner)) = here else {
            out.push(*element);
            continue;
        };
        let mut after = *element;
        if let Some(arc) = corner.path.first().filter(|_| corner.kind == CornerKind::Round) {
            let has_room = |s: &Segment| s.length() > corner.trim + LEAST_SIDE;
            let Some(side) = out.last_mut().filter(|side| has_room(side) && has_room(element)) else {
                out.push(*element);
                continue;
            };
            *side = Segment::line(side.start(), arc.start());
            after = Segment::line(arc.end(), element.end());
        }
        made.push(Made { corner: index, first: out.len(), count: corner.path.len() });
        out.extend_from_slice(&corner.path);
        out.push(after);
    }
    (out, made)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn square() -> Vec<Segment> {
        let at = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(DVec2::from_array);
        (0..4).map(|k| Segment::line(at[k], at[(k + 1) % 4])).collect()
    }

    fn length(path: &[Segment]) -> f64 {
        path.iter().map(Segment::length).sum()
    }

    #[track_caller]
    fn is_joined(path: &[Segment]) {
        for pair in path.windows(2) {
            assert!(pair[0].end().distance(pair[1].start()) < 1e-12, "{pair:?}");
        }
    }

    #[test]
    fn a_loop_crosses_its_corner_straight_and_turns_outside() {
        let corner = Corner::looped(DVec2::new(10.0, 0.0), DVec2::X, DVec2::Y, 2.0);
        let (path, made) = turned(&square(), 0..4, &[corner], &[0]);
        assert_eq!(made, [Made { corner: 0, first: 1, count: 3 }]);
        is_joined(&path);
        assert!((length(&path) - (40.0 + 4.0 + 2.0 * 1.5 * PI)).abs() < 1e-12);
        for pair in path[..6].windows(2).take(4) {
            assert!(pair[0].tangent(1.0).distance(pair[1].tangent(0.0)) < 1e-12);
        }
        // Three quarters of a circle around (12, -2).
        let Segment::Arc(arc) = path[2] else { panic!("an arc") };
        assert!(arc.center.distance(DVec2::new(12.0, -2.0)) < 1e-12 && (arc.sweep + 1.5 * PI).abs() < 1e-12);
        assert!(Segment::Arc(arc).at(0.5).distance(DVec2::new(12.0, -2.0)) - 2.0 < 1e-12);
    }

    #[test]
    fn a_rounded_corner_is_as_far_from_the_drawn_one_as_its_radius_says() {
        let corner = Corner::rounded(DVec2::new(10.0, 0.0), DVec2::X, DVec2::Y, 1.0);
        assert!((corner.trim - 1.0).abs() < 1e-12);
        let (path, made) = turned(&square(), 0..4, &[corner], &[0]);
        assert_eq!(made, [Made { corner: 0, first: 1, count: 1 }]);
        is_joined(&path);
        assert!((length(&path) - (40.0 - 2.0 + FRAC_PI_2)).abs() < 1e-12);
        let off = path[1].nearest(DVec2::new(10.0, 0.0)).1.sqrt();
        assert!((off - (2.0_f64.sqrt() - 1.0)).abs() < 1e-12);
    }

    #[test]
    fn corners_at_the_ends_of_a_cut_and_on_leads_are_left_as_they_are() {
        let corners = [
            Corner::looped(DVec2::ZERO, -DVec2::Y, DVec2::X, 2.0),
            Corner::looped(DVec2::new(10.0, 0.0), DVec2::X, DVec2::Y, 2.0),
        ];
        let (path, made) = turned(&square(), 0..4, &corners, &[0, 1]);
        assert_eq!((made.len(), made[0].corner, path.len()), (1, 1, 7));
        let (path, made) = turned(&square(), 1..4, &corners, &[0, 1]);
        assert_eq!((made.len(), path), (0, square()));
        // A cut that begins half a millimetre before a corner has no room for an arc of 1 mm.
        let round = Corner::rounded(DVec2::new(10.0, 0.0), DVec2::X, DVec2::Y, 1.0);
        let mut cut = square();
        cut[0] = Segment::line(DVec2::new(9.5, 0.0), DVec2::new(10.0, 0.0));
        assert_eq!(turned(&cut, 0..4, &[round], &[0]), (cut, vec![]));
    }
}
