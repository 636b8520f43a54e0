//! Slivers: closed shapes narrower than the copy tolerance.
//!
//! A rectangle a few micrometres wide is a line that some program offset to both sides. Cut as drawn, the beam would burn
//! it there and back, and a quote would count a part. Such a shape collapses to one of its two sides.
//!
//! The two sides of a sliver are equally long. Its first tip is the corner at which its outline turns back most sharply,
//! and its second one the corner nearest to half of its length from there. It is a sliver if every corner and middle of
//! one side lies within the tolerance of the other side.

use crate::geometry::{DVec2, Path, Segment};

/// Shapes with more elements are kept. Each element of one side is compared with all of the other one.
const MAX_ELEMENTS: usize = 400;

/// The side that replaces a closed path narrower than `tolerance` mm; `None` if it is wider.
pub(super) fn collapsed(path: &Path, tolerance: f64) -> Option<Path> {
    let n = path.segments.len();
    if !path.closed || !(2..=MAX_ELEMENTS).contains(&n) {
        return None;
    }
    let length = path.length();
    // The area of a sliver is at most its width times half its length.
    if length <= 4.0 * tolerance || 2.0 * path.area().abs() > tolerance * length {
        return None;
    }
    let turn = |k: usize| path.segments[(k + n - 1) % n].tangent(1.0).dot(path.segments[k].tangent(0.0));
    let first = (0..n).min_by(|&a, &b| turn(a).total_cmp(&turn(b)))?;
    let around: Vec<Segment> =
        path.segments[first..].iter().chain(&path.segments[..first]).copied().collect();
    let mut along = 0.0;
    let mut second = (f64::INFINITY, 1);
    for (k, s) in around.iter().enumerate().take(n - 1) {
        along += s.length();
        let off = (along - 0.5 * length).abs();
        if off < second.0 {
            second = (off, k + 1);
        }
    }
    let (there, back) = around.split_at(second.1);
    let lies_along = |side: &[Segment], other: &[Segment]| {
        side.iter()
            .flat_map(|s| [0.0, 0.25, 0.5, 0.75, 1.0].map(|f| s.at(f)))
            .all(|p: DVec2| other.iter().any(|s| s.nearest(p).1 <= tolerance * tolerance))
    };
    (lies_along(there, back) && lies_along(back, there)).then(|| Path::new(there.to_vec(), false))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[(f64, f64)]) -> Path {
        let at = |k: usize| DVec2::from(corners[k % corners.len()]);
        Path::new((0..corners.len()).map(|k| Segment::line(at(k), at(k + 1))).collect(), true)
    }

    #[test]
    fn a_shape_a_few_micrometres_wide_is_one_of_its_sides() {
        let sliver = polygon(&[(0.0, 0.0), (50.0, 0.0), (50.0, 0.004), (0.0, 0.004)]);
        let line = collapsed(&sliver, 0.01).unwrap();
        assert!((line.length() - 50.0).abs() < 0.01 && !line.closed);
        let bent =
            polygon(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (19.995, 20.0), (19.995, 0.005), (0.0, 0.005)]);
        assert!((collapsed(&bent, 0.01).unwrap().length() - 40.0).abs() < 0.02);
        // Drawn there and back along one line.
        assert!(collapsed(&polygon(&[(0.0, 0.0), (30.0, 0.0)]), 0.01).is_some());
    }

    #[test]
    fn a_shape_wider_than_the_tolerance_stays() {
        for width in [0.02, 0.1, 5.0] {
            let slot = polygon(&[(0.0, 0.0), (50.0, 0.0), (50.0, width), (0.0, width)]);
            assert_eq!(collapsed(&slot, 0.01), None);
        }
        let wedge = polygon(&[(0.0, 0.0), (50.0, 0.0), (50.0, 0.03)]);
        assert_eq!(collapsed(&wedge, 0.01), None, "it is wider than the tolerance at one end");
    }
}
