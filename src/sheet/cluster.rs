//! Points that are one: clusters of points within rounding or a small radius, in linear time whatever the points.
//!
//! Four grids of cells of side `radius`, shifted by half a cell in x, in y and in both: two points nearer than half a
//! radius share a cell in at least one of them, and two that share a cell are nearer than 1.42 radii. All points of
//! a cell are united at once, so a hundred thousand points in one place cost as much as anywhere else.

use crate::geometry::{DVec2, Union};
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
