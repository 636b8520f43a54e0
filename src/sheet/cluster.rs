//! Points that are one: clusters of points within rounding or a small radius, in linear time whatever the points.
//!
//! Four grids of cells of side `radius`, shifted by half a cell in x, in y and in both: two points nearer than half a
//! radius share a cell in at least one of them, and two that share a cell are nearer than 1.42 radii. All points of
//! a cell are united at once, so a hundred thousand points in one place cost as much as anywhere else.

use crate::geometry::DVec2;
use rustc_hash::FxHashMap;

/// The cell of side `side` that holds `p`.
pub(super) fn cell(p: DVec2, side: f64) -> (i64, i64) {
    #[allow(
        clippy::cast_possible_truncation,
        reason = "saturates; coordinates are bounded by the reader's limit"
    )]
    ((p.x / side).floor() as i64, (p.y / side).floor() as i64)
}

/// For every point the number of its cluster; clusters are numbered in order of their first point. Points within
/// `radius / 2` of each other are always together; every direct link is shorter than `1.42 radius`.
pub(super) fn cluster(points: &[DVec2], radius: f64) -> Vec<u32> {
    let mut union = Union::new(points.len());
    let half = radius * 0.5;
    let shifts = [DVec2::ZERO, DVec2::new(half, 0.0), DVec2::new(0.0, half), DVec2::splat(half)];
    for shift in shifts {
        let mut first: FxHashMap<(i64, i64), u32> = FxHashMap::default();
        first.reserve(points.len());
        for (i, &p) in (0_u32..).zip(points) {
            let head = *first.entry(cell(p + shift, radius)).or_insert(i);
            union.join(head, i);
        }
    }
    union.numbered()
}

/// Disjoint sets; the smallest member is the root, so numbering follows first members.
pub(super) struct Union(Vec<u32>);

impl Union {
    pub(super) fn new(n: usize) -> Self {
        Self((0_u32..).take(n).collect())
    }

    /// Adds a set of one member, and returns it.
    pub(super) fn add(&mut self) -> u32 {
        let next = u32::try_from(self.0.len()).unwrap_or(u32::MAX);
        self.0.push(next);
        next
    }

    pub(super) fn root(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            let up = self.0[self.0[i as usize] as usize];
            self.0[i as usize] = up;
            i = up;
        }
        i
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    fn numbered(mut self) -> Vec<u32> {
        let mut number = vec![0; self.0.len()];
        let mut next = 0;
        for i in 0_u32.. {
            if i as usize == number.len() {
                break;
            }
            let root = self.root(i);
            if root == i {
                number[i as usize] = next;
                next += 1;
            } else {
                number[i as usize] = number[root as usize];
            }
        }
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_within_half_a_radius_share_a_cluster_and_far_ones_do_not() {
        let mut points = Vec::new();
        for i in 0..50 {
            let p = DVec2::new(f64::from(i) * 0.37 - 5.0, f64::from(i) * 0.11);
            points.push(p);
            points.push(p + DVec2::new(0.004, -0.002));
        }
        let ids = cluster(&points, 0.01);
        for i in 0..50_usize {
            assert_eq!(ids[2 * i], ids[2 * i + 1]);
            assert_eq!(ids[2 * i] as usize, i, "numbered in order of first points");
        }
    }

    #[test]
    fn a_hundred_thousand_points_in_one_place_are_one_cluster() {
        let points = vec![DVec2::new(12.5, -3.25); 100_000];
        assert!(cluster(&points, 1e-6).iter().all(|&c| c == 0));
    }
}
