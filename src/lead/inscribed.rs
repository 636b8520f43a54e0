//! The largest circle in a hole: how much room a lead has there, and where its centre is.
//!
//! A circle is its own answer. For other holes squares are divided, the most promising first, until none can hold a centre
//! that is better by a twentieth (V. Agafonkin, "A new algorithm for finding a visual center of a polygon", 2016; the
//! distances here are exact for arcs).

use crate::geometry::{DVec2, Path, Segment, winding_number};

/// The result is at most this fraction too small: far below what people mean by a share of a radius.
const PRECISION: f64 = 0.05;
/// Most distances between a point and an element that one hole may take: a millisecond or two.
const MOST_DISTANCES: usize = 200_000;

/// The centre and radius (mm) of about the largest circle in a closed path. A circle of radius `enough` ends the search.
pub(super) fn inscribed(path: &Path, enough: f64) -> Option<(DVec2, f64)> {
    if let Some(circle) = as_circle(path) {
        return Some(circle);
    }
    let bounds = path.bounds();
    let size = bounds.size();
    let half = 0.5 * size.min_element();
    if !half.is_finite() || half <= 0.0 {
        return None;
    }
    let mut squares: Vec<Square> = Vec::new();
    let steps = |length: f64| (length / (2.0 * half)).ceil().clamp(1.0, 64.0);
    let (columns, rows) = (steps(size.x), steps(size.y));
    let mut x = 0.0;
    while x < columns {
        let mut y = 0.0;
        while y < rows {
            let center = bounds.min + size * DVec2::new((x + 0.5) / columns, (y + 0.5) / rows);
            squares.push(Square::new(path, center, half));
            y += 1.0;
        }
        x += 1.0;
    }
    let mut best = squares.iter().fold(squares[0], |a, b| if b.distance > a.distance { *b } else { a });
    let mut left = (MOST_DISTANCES / path.segments.len().max(1)).max(16);
    while best.distance < enough && left > 0 {
        let Some(k) =
            (0..squares.len()).reduce(|a, b| if squares[b].most() > squares[a].most() { b } else { a })
        else {
            break;
        };
        let square = squares.swap_remove(k);
        if square.most() <= best.distance * (1.0 + PRECISION) {
            break;
        }
        let half = 0.5 * square.half;
        for corner in [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]] {
            let part = Square::new(path, square.center + half * DVec2::from_array(corner), half);
            if part.distance > best.distance {
                best = part;
            }
            if part.most() > best.distance {
                squares.push(part);
            }
        }
        left = left.saturating_sub(4);
    }
    (best.distance > 0.0).then_some((best.center, best.distance))
}

#[derive(Clone, Copy)]
struct Square {
    center: DVec2,
    /// Half of its side, mm.
    half: f64,
    /// Distance of its centre from the path, mm; negative outside.
    distance: f64,
}

impl Square {
    fn new(path: &Path, center: DVec2, half: f64) -> Self {
        let nearest = path.segments.iter().map(|s| s.nearest(center).1).fold(f64::INFINITY, f64::min).sqrt();
        let inside = winding_number(&path.segments, center) != 0;
        Self { center, half, distance: if inside { nearest } else { -nearest } }
    }

    /// The distance that no point of it exceeds.
    fn most(&self) -> f64 {
        self.distance + self.half * std::f64::consts::SQRT_2
    }
}

/// The centre and radius of a path of arcs that are all of one circle.
fn as_circle(path: &Path) -> Option<(DVec2, f64)> {
    let arc = |s: &Segment| match s {
        Segment::Arc(a) => Some((a.center, a.radius())),
        Segment::Line(_) => None,
    };
    let (center, radius) = arc(path.segments.first()?)?;
    let same = |s: &Segment| {
        arc(s)
            .is_some_and(|(c, r)| c.distance(center) <= 1e-6 * radius && (r - radius).abs() <= 1e-6 * radius)
    };
    path.segments.iter().all(same).then_some((center, radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    fn polygon(corners: &[[f64; 2]]) -> Path {
        let at = |k: usize| DVec2::from_array(corners[k % corners.len()]);
        Path::new((0..corners.len()).map(|k| Segment::line(at(k), at(k + 1))).collect(), true)
    }

    #[test]
    fn known_shapes_have_their_circle() {
        let circle = Path::new(vec![Segment::Arc(Arc::circle(DVec2::new(3.0, 1.0), 2.5))], true);
        assert_eq!(inscribed(&circle.reversed(), f64::INFINITY), Some((DVec2::new(3.0, 1.0), 2.5)));
        let slot = polygon(&[[0.0, 0.0], [40.0, 0.0], [40.0, 4.0], [0.0, 4.0]]);
        let l = polygon(&[[0.0, 0.0], [20.0, 0.0], [20.0, 5.0], [5.0, 5.0], [5.0, 20.0], [0.0, 20.0]]);
        // In the corner of the L the circle touches the inner corner: r (1 + 1/sqrt 2) sqrt 2 = 5 sqrt 2.
        for (path, radius) in [(slot, 2.0), (l, 5.0 / (1.0 + 0.5_f64.sqrt()))] {
            let (center, found) = inscribed(&path, f64::INFINITY).unwrap();
            assert!(found <= radius + 1e-9 && found >= radius / (1.0 + PRECISION), "{found} of {radius}");
            assert!(path.segments.iter().all(|s| s.nearest(center).1.sqrt() >= found - 1e-9));
        }
    }

    #[test]
    fn enough_is_enough() {
        let slot = polygon(&[[0.0, 0.0], [400.0, 0.0], [400.0, 40.0], [0.0, 40.0]]);
        assert!(inscribed(&slot, 3.0).unwrap().1 >= 3.0);
        assert_eq!(inscribed(&Path::default(), 1.0), None);
    }
}
