//! Webs: the material between two cuts of a part. The narrowest is where two of them are closest to each other.

use super::shape::Shape;
use crate::geometry::{Aabb, BoxIndex, DVec2};
use crate::order::sort_by;

/// Two contours and the distance between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Web {
    pub(super) contours: [usize; 2],
    pub(super) width: f64,
    pub(super) at: DVec2,
}

/// The narrowest web between any two of these contours; its width is 0 where they cross.
pub(super) fn between(shapes: &[Shape], contours: &[usize]) -> Option<Web> {
    webs(shapes, contours, None).pop()
}

/// Each pair of these contours that is closer than `limit` somewhere, at its narrowest place; in the order of their ids.
pub(super) fn closer_than(shapes: &[Shape], contours: &[usize], limit: f64) -> Vec<Web> {
    let mut webs = webs(shapes, contours, Some(limit));
    for web in &mut webs {
        web.contours.sort_unstable();
    }
    sort_by(&mut webs, |Web { contours: [a, b], .. }| [*a as u64, *b as u64, 0]);
    webs
}

/// Each pair that is closer than the limit; without one, each that is closer than all before it.
fn webs(shapes: &[Shape], contours: &[usize], limit: Option<f64>) -> Vec<Web> {
    let lines: Vec<(usize, Chords)> =
        contours.iter().filter_map(|&id| Some((id, Chords::of(shapes.get(id)?)))).collect();
    let index = BoxIndex::new(lines.iter().map(|(_, line)| line.boxes[1]));
    let mut webs = Vec::new();
    let mut reach = limit.unwrap_or(f64::INFINITY);
    for (k, (id, line)) in lines.iter().enumerate() {
        index.visit(line.boxes[1].grown(reach), |other| {
            let (other_id, other_line) = &lines[other];
            if other > k
                && let Some((width, at)) = line.nearest(other_line, reach)
            {
                webs.push(Web { contours: [*id, *other_id], width, at });
                if limit.is_none() {
                    reach = width;
                }
            }
            true
        });
    }
    webs
}

/// Boxes are compared with this share to spare, because their distance is rounded in other ways than that of chords.
const ROUNDING: f64 = 1e-12;

/// The chords of a contour in a binary tree of boxes.
pub(super) struct Chords {
    chords: Vec<[DVec2; 2]>,
    /// Box 1 is around everything, and each box `k` around boxes `2 k` and `2 k + 1`. The last half are those of the chords in
    /// order, then empty ones.
    boxes: Vec<Aabb>,
}

impl Chords {
    pub(super) fn of(shape: &Shape) -> Self {
        let chords: Vec<[DVec2; 2]> = shape.chords().collect();
        let leaves = chords.len().next_power_of_two();
        let mut boxes = vec![Aabb::EMPTY; 2 * leaves];
        for (slot, [a, b]) in boxes[leaves..].iter_mut().zip(&chords) {
            *slot = Aabb::of(*a).with(*b);
        }
        for k in (1..leaves).rev() {
            boxes[k] = boxes[2 * k].union(boxes[2 * k + 1]);
        }
        Self { chords, boxes }
    }

    /// The distance of two contours and the place halfway between them, if it is less than `reach`.
    pub(super) fn nearest(&self, other: &Self, reach: f64) -> Option<(f64, DVec2)> {
        let mut best = (reach, None);
        let mut open = vec![[1, 1]];
        while let Some(pair @ [i, j]) = open.pop() {
            if self.gap(other, pair) >= best.0 * (1.0 + ROUNDING) {
                continue;
            }
            let [leaf, other_leaf] =
                [(i, self), (j, other)].map(|(k, line)| k.checked_sub(line.boxes.len() / 2));
            if let (Some(leaf), Some(other_leaf)) = (leaf, other_leaf) {
                let (width, at) = apart(self.chords[leaf], other.chords[other_leaf]);
                if width < best.0 {
                    best = (width, Some(at));
                }
                continue;
            }
            let size = |b: Aabb| b.size().length_squared();
            let halves =
                leaf.is_none() && (other_leaf.is_some() || size(self.boxes[i]) >= size(other.boxes[j]));
            let mut next = if halves { [[2 * i, j], [2 * i + 1, j]] } else { [[i, 2 * j], [i, 2 * j + 1]] };
            // The nearer half is the next to be looked at.
            if self.gap(other, next[0]) <= self.gap(other, next[1]) {
                next.reverse();
            }
            open.extend(next);
        }
        best.1.map(|at| (best.0, at))
    }

    /// The distance of two boxes; infinite if one is empty.
    fn gap(&self, other: &Self, [i, j]: [usize; 2]) -> f64 {
        let (a, b) = (self.boxes[i], other.boxes[j]);
        (a.min - b.max).max(b.min - a.max).max(DVec2::ZERO).length()
    }
}

/// Distance of two chords and the point halfway between them; 0 and the crossing where they cross.
fn apart([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> (f64, DVec2) {
    #[cfg(test)]
    tests::COMPARISONS.set(tests::COMPARISONS.get() + 1);
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let [from, to] = [side(c, d, a), side(c, d, b)];
    if side(a, b, c) * side(a, b, d) < 0.0 && from * to < 0.0 {
        return (0.0, a + (b - a) * (from / (from - to)));
    }
    let mut best = (f64::INFINITY, a);
    for (p, [u, v]) in [(a, [c, d]), (b, [c, d]), (c, [a, b]), (d, [a, b])] {
        let along = ((p - u).dot(v - u) / (v - u).length_squared()).clamp(0.0, 1.0);
        let foot = u + (v - u) * along;
        if p.distance(foot) < best.0 {
            best = (p.distance(foot), (p + foot) / 2.0);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, Segment, math};
    use std::cell::Cell;

    thread_local! {
        /// Number of pairs of chords that were compared.
        pub(super) static COMPARISONS: Cell<usize> = const { Cell::new(0) };
    }

    #[test]
    fn between_two_circles_and_by_brute_force() {
        let mut shapes = Vec::new();
        // A row of circles of radius 1, 3 mm apart; the last two are closer.
        for k in 0..30 {
            let x = f64::from(k) * 3.0 - if k == 29 { 0.4 } else { 0.0 };
            let mut shape = Shape::default();
            shape.add(&[Segment::Arc(Arc::circle(DVec2::new(x, 0.5 * f64::from(k % 3)), 1.0))]);
            shapes.push(shape);
        }
        let all: Vec<usize> = (0..30).collect();
        let web = between(&shapes, &all).unwrap();
        let mut least = f64::INFINITY;
        for i in 0..30 {
            for j in 0..i {
                for a in shapes[i].chords() {
                    for b in shapes[j].chords() {
                        least = least.min(apart(a, b).0);
                    }
                }
            }
        }
        assert_eq!(web.width.to_bits(), least.to_bits());
        assert_eq!(web.contours, [28, 29]);
        assert!(between(&shapes, &[3]).is_none());
        // The same web, and no other is so narrow: the others are about 1 mm wide.
        let close = closer_than(&shapes, &all, web.width + 0.1);
        assert_eq!(close, [Web { contours: [28, 29], ..web }]);
        assert_eq!(closer_than(&shapes, &all, 2.0).len(), 29);
    }

    /// The middle of the first chord was reported, here 500 mm away.
    #[test]
    fn a_web_of_contours_that_cross_is_where_they_cross() {
        let line = |a, b| {
            let mut shape = Shape::default();
            shape.add(&[Segment::line(DVec2::from(a), DVec2::from(b))]);
            shape
        };
        let shapes = [line((0.0, 0.0), (1000.0, 0.0)), line((10.0, -5.0), (12.0, 5.0))];
        let web = between(&shapes, &[0, 1]).unwrap();
        assert_eq!((web.contours, web.width, web.at), ([0, 1], 0.0, DVec2::new(11.0, 0.0)));
        assert_eq!(closer_than(&shapes, &[1, 0], 1.0), [Web { contours: [0, 1], ..web }]);
    }

    /// All chords within that distance were compared, here millions more: four times the time for twice the chords.
    #[test]
    fn the_web_of_two_rings_of_many_chords_is_found_in_few_comparisons() {
        let ring = |radius: f64, count: u32| {
            let at = |k: u32| {
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(count);
                math::rotate(DVec2::new(radius, 0.0), angle)
            };
            Shape { points: (0..=count).map(at).collect() }
        };
        let least = |shapes: &[Shape; 2]| {
            let pairs = shapes[0].chords().flat_map(|a| shapes[1].chords().map(move |b| apart(a, b).0));
            pairs.fold(f64::INFINITY, f64::min)
        };
        for (count, other) in [(50, 70), (200, 200), (333, 3)] {
            let shapes = [ring(200.0, count), ring(100.0, other)];
            assert_eq!(between(&shapes, &[0, 1]).map(|w| w.width.to_bits()), Some(least(&shapes).to_bits()));
        }
        let shapes = [ring(200.0, 8000), ring(100.0, 8000)];
        COMPARISONS.set(0);
        assert!((between(&shapes, &[0, 1]).unwrap().width - 100.0).abs() < 1e-4);
        assert_eq!(closer_than(&shapes, &[0, 1], 150.0).len(), 1);
        assert!(COMPARISONS.get() < 2 * 8000 * 200, "{}", COMPARISONS.get());
    }
}
