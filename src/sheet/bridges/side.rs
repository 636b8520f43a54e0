//! Sides of an outline: stretches along one line or one circle, however many elements they are drawn with.

use crate::geometry::{Arc, DVec2, Path, Segment};

/// Directions of lines, as sines, and centres of arcs, in mm, agree within this: what six decimals of a drawing leave.
const SAME: f64 = 1e-6;

/// A side of an outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// The contour.
    pub(super) contour: u32,
    /// Its whole stretch as one element.
    pub(super) shape: Segment,
    /// Arc length from the start of the outline to its start, mm.
    from: f64,
    /// Length of the outline, mm.
    whole: f64,
    /// Its first element, and their number; they may run across the start of the outline.
    elements: [usize; 2],
    /// Number of elements of the outline.
    count: usize,
}

/// A place on a side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    /// Where it is on the line that hits the side, mm from the origin of that line.
    pub(super) far: f64,
    /// The point.
    pub(super) at: DVec2,
    /// Fraction of the side's length.
    pub(super) fraction: f64,
}

impl Side {
    /// The sides of an outline, in order.
    pub(super) fn all(contour: u32, path: &Path) -> Vec<Self> {
        let (whole, count) = (path.length(), path.segments.len());
        let mut sides: Vec<Self> = Vec::new();
        let mut from = 0.0;
        for (index, &shape) in path.segments.iter().enumerate() {
            let joined = sides.last().and_then(|last| joined(&last.shape, &shape));
            match (sides.last_mut(), joined) {
                (Some(last), Some(shape)) => (last.shape, last.elements[1]) = (shape, last.elements[1] + 1),
                _ => sides.push(Self { contour, shape, from, whole, elements: [index, 1], count }),
            }
            from += shape.length();
        }
        if let [first, .., last] = sides.as_mut_slice()
            && let Some(shape) = joined(&last.shape, &first.shape)
        {
            (last.shape, last.elements[1]) = (shape, last.elements[1] + first.elements[1]);
            sides.remove(0);
        }
        sides
    }

    /// Whether an element of its outline is part of it.
    pub(super) fn holds(&self, element: usize) -> bool {
        let [first, number] = self.elements;
        (element + self.count - first) % self.count < number
    }

    /// Arc length along the outline to a fraction of the side, mm.
    pub(super) fn along(&self, fraction: f64) -> f64 {
        let along = self.from + fraction * self.shape.length();
        if along < self.whole { along } else { along - self.whole }
    }

    /// Where the line through `origin` along the unit vector `way` meets the side: of two places the far one, or the near one.
    pub(super) fn hit(&self, origin: DVec2, way: DVec2, far: bool) -> Option<Hit> {
        match &self.shape {
            Segment::Line(line) => {
                let along = line.end - line.start;
                let fraction = way.perp_dot(origin - line.start) / way.perp_dot(along);
                let at = line.start + along * fraction;
                (0.0..=1.0).contains(&fraction).then(|| Hit { far: (at - origin).dot(way), at, fraction })
            }
            Segment::Arc(arc) => {
                let middle = (arc.center - origin).dot(way);
                let aside = (arc.center - origin).perp_dot(way);
                let half = (arc.radius() * arc.radius() - aside * aside).max(0.0).sqrt();
                let far = if far { middle + half } else { middle - half };
                let at = origin + way * far;
                Some(Hit { far, at, fraction: arc.fraction_of(at - arc.center)? })
            }
        }
    }
}

/// Two elements that follow each other on one line or circle, as one.
fn joined(a: &Segment, b: &Segment) -> Option<Segment> {
    match (a, b) {
        (Segment::Line(l), Segment::Line(m)) => {
            let (u, v) = (a.tangent(1.0), b.tangent(0.0));
            (u.perp_dot(v).abs() < SAME && u.dot(v) > 0.0).then(|| Segment::line(l.start, m.end))
        }
        (Segment::Arc(l), Segment::Arc(m)) => {
            let same = l.center.distance(m.center) < SAME
                && (l.radius() - m.radius()).abs() < SAME
                && l.ccw() == m.ccw()
                && !l.is_circle();
            same.then_some(Segment::Arc(Arc { end: m.end, sweep: l.sweep + m.sweep, ..*l }))
        }
        _ => None,
    }
}
