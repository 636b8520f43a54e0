//! The entries of a closed contour: the places where it may be entered.
//!
//! Element ends come first, because the mark of a start shows least in a corner; evenly spaced places are added:
//! 1. Up to [`MOST`] elements: every element's start is an entry, and stretches longer than an [`EVEN`]th of the contour are
//!    divided evenly. So a circle gets 8 entries, a square 8, and a polygon of 12 equal sides its 12 corners. There are
//!    never more than `MOST` + `EVEN`.
//! 2. More elements: the contour is divided into `MOST` equal stretches. Each gets the element start nearest to its
//!    beginning, or the beginning itself if no element starts within half a stretch.

use crate::geometry::{DVec2, Path};

/// Entries of contours with many elements: more shorten air travel by up to 0.8 % on nested sheets, but slow the search
/// down by more.
const MOST: usize = 16;
/// Fewest entries of a contour: the 8 rim points that Qu & Du (2023) and Yang (2013) use on circles.
const EVEN: usize = 8;

/// Arc length (mm) and point of each entry of a closed path, in order along it.
pub(super) fn entries(path: &Path) -> Vec<(f64, DVec2)> {
    // Arc length at which each element starts, and the whole length last.
    let mut at = vec![0.0];
    for s in &path.segments {
        at.push(at[at.len() - 1] + s.length());
    }
    let length = at[path.segments.len()];
    let starts = || path.segments.iter().zip(&at).map(|(s, &a)| (a, s.start()));
    if length <= 0.0 {
        return starts().take(1).collect();
    }
    if path.segments.len() <= MOST { fill(path, &at, length) } else { thin(path, starts().collect(), length) }
}

/// Rule 1: all element starts, with long stretches divided.
fn fill(path: &Path, at: &[f64], length: f64) -> Vec<(f64, DVec2)> {
    let mut out = Vec::with_capacity(MOST + EVEN);
    for (s, span) in path.segments.iter().zip(at.windows(2)) {
        let along = span[1] - span[0];
        if along <= 0.0 {
            continue;
        }
        // Slightly less, so that a stretch of exactly an eighth is not divided again.
        let pieces = (along * EVEN as f64 / length - 1e-9).ceil().max(1.0);
        let mut k = 0.0;
        while k < pieces {
            let f = k / pieces;
            out.push((span[0] + along * f, s.at(f)));
            k += 1.0;
        }
    }
    out
}

/// Rule 2: evenly spaced, moved to a near element start.
fn thin(path: &Path, starts: Vec<(f64, DVec2)>, length: f64) -> Vec<(f64, DVec2)> {
    let stretch = length / MOST as f64;
    let mut out: Vec<(f64, DVec2)> = Vec::with_capacity(MOST);
    let mut next = 0;
    for k in 0..MOST {
        let wanted = stretch * k as f64;
        // The starts are sorted: walk on while the next one is nearer.
        while next + 1 < starts.len()
            && (starts[next + 1].0 - wanted).abs() <= (starts[next].0 - wanted).abs()
        {
            next += 1;
        }
        let (along, place) = starts[next];
        if (along - wanted).abs() < 0.5 * stretch {
            out.push((along, place));
        } else if let Some(place) = path.at(wanted) {
            out.push((wanted, place));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, Segment};
    use std::f64::consts::TAU;

    fn polygon(n: u32, radius: f64) -> Path {
        let corner = |k: u32| radius * crate::geometry::math::unit(TAU * f64::from(k % n) / f64::from(n));
        Path::new((0..n).map(|k| Segment::line(corner(k), corner(k + 1))).collect(), true)
    }

    #[test]
    fn counts_by_shape() {
        assert_eq!(entries(&Path::new(vec![Segment::Arc(Arc::circle(DVec2::ONE, 3.0))], true)).len(), 8);
        for (sides, count) in [(3, 9), (4, 8), (6, 12), (8, 8), (12, 12), (16, 16), (17, 16), (300, 16)] {
            assert_eq!(entries(&polygon(sides, 50.0)).len(), count, "{sides} sides");
        }
        assert_eq!(entries(&Path::default()).len(), 0);
    }

    #[test]
    fn entries_lie_where_they_say_in_order_and_apart() {
        let long = |x: f64| Segment::line(DVec2::new(x, 0.0), DVec2::new(x + 1.0, 0.0));
        // 20 short elements along one side of a long thin triangle.
        let mut uneven: Vec<Segment> = (0..20).map(|k| long(f64::from(k))).collect();
        uneven.push(Segment::line(DVec2::new(20.0, 0.0), DVec2::new(0.0, 100.0)));
        uneven.push(Segment::line(DVec2::new(0.0, 100.0), DVec2::ZERO));
        for path in [polygon(5, 2.0), polygon(40, 9.0), Path::new(uneven, true)] {
            let (list, length) = (entries(&path), path.length());
            for w in list.windows(2) {
                assert!(w[1].0 - w[0].0 > length / 100.0);
            }
            let largest = list.windows(2).map(|w| w[1].0 - w[0].0).fold(0.0, f64::max);
            assert!(largest <= length / 8.0 + 1e-9);
            for (along, place) in list {
                assert!(path.at(along).unwrap().distance(place) < 1e-9);
            }
        }
    }

    #[test]
    fn corners_are_entries() {
        let path = polygon(5, 2.0);
        let list = entries(&path);
        for s in &path.segments {
            assert!(list.iter().any(|e| e.1 == s.start()));
        }
    }
}
