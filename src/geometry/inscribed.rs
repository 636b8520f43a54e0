//! The largest circle inside a closed path, for its width: at most slightly too small, and searched only up to a limit. How much room a
//! hole has for a lead, and where, is rougher and quicker: `lead::inscribed`.

use super::{Aabb, BoxIndex, Budget, DVec2, Path, Segment};

/// Number of times that the distance between samples is halved around the best one.
const HALVINGS: u32 = 8;
/// Largest number of steps in which a circle is reduced; most need two.
const MAX_SHRINKS: u32 = 24;

/// Diameter and middle of the largest circle inside a closed path, if the diameter is less than `limit`. At each of some
/// `samples` along each element, the largest circle that touches the line from within is reduced until it crosses no element by
/// more than half of `slack`, mm. If their number is odd, the middle of an element comes first: there a circle touches all
/// sides of a regular polygon. Finds nothing when `budget` is spent.
pub fn inscribed(
    path: &Path,
    [limit, slack]: [f64; 2],
    samples: u32,
    budget: &mut Budget,
) -> Option<(f64, DVec2)> {
    let bounds = path.bounds();
    // No circle inside is larger: a straight slot along an axis is measured by its first sample.
    let most = 0.5 * (bounds.max - bounds.min).min_element();
    let mut search = Search {
        path,
        index: BoxIndex::new(path.segments.iter().map(Segment::bounds)),
        side: path.area().signum(),
        cap: 0.5 * limit,
        slack: 0.5 * slack,
        budget,
        widest: None,
    };
    let enough = search.cap.min(most) - search.slack;
    let step = 1.0 / f64::from(samples);
    let first = samples % 2 * (samples / 2);
    let mut best = None;
    for segment in &path.segments {
        for k in 0..samples {
            let f = (f64::from((first + k) % samples) + 0.5) * step;
            if search.improves(segment, f) {
                best = Some((segment, f));
            }
            if search.radius() >= enough || search.budget.is_spent() {
                return search.found();
            }
        }
    }
    let (segment, mut f) = best?;
    let mut step = step;
    for _ in 0..HALVINGS {
        step *= 0.5;
        if let Some(better) =
            [f - step, f + step].map(|f| f.clamp(0.0, 1.0)).into_iter().find(|&f| search.improves(segment, f))
        {
            f = better;
        }
    }
    search.found()
}

struct Search<'a> {
    path: &'a Path,
    index: BoxIndex,
    /// 1 if the path runs counter-clockwise, with its inside on the left, else -1.
    side: f64,
    /// Radius of the circles at first.
    cap: f64,
    /// How far a circle may cross an element.
    slack: f64,
    budget: &'a mut Budget,
    /// Radius and middle of the largest circle yet.
    widest: Option<(f64, DVec2)>,
}

impl Search<'_> {
    fn radius(&self) -> f64 {
        self.widest.map_or(0.0, |(radius, _)| radius)
    }

    fn found(&self) -> Option<(f64, DVec2)> {
        let small = self.radius() < self.cap - self.slack && !self.budget.is_spent();
        self.widest.filter(|_| small).map(|(radius, at)| (2.0 * radius, at))
    }

    /// Whether the largest circle, up to the cap, that touches the path here from within is larger than all before.
    fn improves(&mut self, segment: &Segment, f: f64) -> bool {
        let (from, inward) = (segment.at(f), segment.tangent(f).perp() * self.side);
        let least = self.radius();
        // Most circles that are hardly larger cross something near: nothing farther away need be compared.
        if least > 0.0 && self.touching(from, inward, least + self.slack).is_some() {
            return false;
        }
        let mut radius = self.cap;
        for _ in 0..MAX_SHRINKS {
            let Some(through) = self.touching(from, inward, radius) else { break };
            radius = radius.min(through);
        }
        let improves = radius > least;
        if improves {
            self.widest = Some((radius, from + inward * radius));
        }
        improves
    }

    /// If the circle of this radius that touches the path here crosses the path: the radius of the one that touches it where
    /// this one crosses it farthest.
    fn touching(&mut self, from: DVec2, inward: DVec2, radius: f64) -> Option<f64> {
        let center = from + inward * radius;
        let within = (radius - self.slack).max(0.0);
        let mut nearest = within * within;
        let mut touched = None;
        self.index.visit(Aabb::of(center).grown(radius), |k| {
            let goes_on = self.budget.take();
            if let Some(segment) = self.path.segments.get(k) {
                let (f, d2) = segment.nearest(center);
                if d2 < nearest {
                    (nearest, touched) = (d2, Some(segment.at(f) - from));
                }
            }
            goes_on
        });
        let away: DVec2 = touched?;
        let along = away.dot(inward);
        (along > 0.0).then(|| 0.5 * away.length_squared() / along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    fn polygon(corners: &[(f64, f64)]) -> Path {
        let at = |k: usize| DVec2::from(corners[k % corners.len()]);
        Path::new((0..corners.len()).map(|k| Segment::line(at(k), at(k + 1))).collect(), true)
    }

    fn width(path: &Path, limit: f64) -> Option<f64> {
        inscribed(path, [limit, 1e-6], 8, &mut Budget::new(1_000_000)).map(|(width, _)| width)
    }

    #[test]
    fn width_is_the_diameter_of_the_largest_inner_circle() {
        let slot = polygon(&[(0.0, 0.0), (5.0, 0.0), (5.0, 0.05), (0.0, 0.05)]);
        for path in [&slot, &slot.reversed()] {
            assert!((width(path, 0.1).unwrap() - 0.05).abs() < 1e-6);
            assert_eq!(width(path, 0.05), None);
        }
        let hole = Path::new(vec![Segment::Arc(Arc::circle(DVec2::new(300.0, 70.0), 0.05))], true);
        assert!((width(&hole, 0.3).unwrap() - 0.1).abs() < 1e-6);
        assert_eq!(width(&hole, 0.1), None);
        // A right triangle of sides 0.3, 0.4 and 0.5 holds a circle of radius 0.1.
        let triangle = width(&polygon(&[(0.0, 0.0), (0.4, 0.0), (0.0, 0.3)]), 0.3).unwrap();
        assert!(triangle <= 0.2 + 1e-9 && triangle > 0.1999, "{triangle}");
    }

    #[test]
    fn a_bent_slot_is_narrow_and_a_neck_of_a_large_contour_is_not() {
        let bent = polygon(&[(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (4.95, 5.0), (4.95, 0.05), (0.0, 0.05)]);
        // In the corner a circle reaches a little into both legs: its diameter is 2 (2 - sqrt 2) times the width at most.
        let bent = width(&bent, 0.2).unwrap();
        assert!((0.05..=0.05859).contains(&bent), "{bent}");
        let dumbbell = polygon(&[
            (0.0, 0.0),
            (5.0, 0.0),
            (5.0, 2.48),
            (9.0, 2.48),
            (9.0, 0.0),
            (14.0, 0.0),
            (14.0, 5.0),
            (9.0, 5.0),
            (9.0, 2.52),
            (5.0, 2.52),
            (5.0, 5.0),
            (0.0, 5.0),
        ]);
        assert_eq!(width(&dumbbell, 0.3), None);
    }
}
