//! Clearance: finds contours that are closer to each other than the kerf is wide, with waste between them.

use super::super::model::{Contour, Operation};
use crate::geometry::{BoxIndex, DVec2, Segment, intersect};

/// Number of elements visited per element on average, and for a small drawing in total. A sheet needs two or three;
/// thousands of lines from one point need thousands, and a finding then reports that not all were checked.
const ELEMENTS_PER_ELEMENT: usize = 200;
const MIN_ELEMENTS: usize = 2_000_000;
/// Elements that meet within this distance, mm, touch each other.
const TOUCHING: f64 = 1e-9;

/// All outlines that are cut, as drawn.
pub(super) struct Clearance {
    elements: Vec<(u32, Segment)>,
    index: BoxIndex,
    /// Half the kerf less the tolerance, mm.
    clear: f64,
    /// For each contour, the distance to a contour that is too close (mm), and the place.
    near: Vec<Option<(f64, DVec2)>>,
    /// Whether some elements could not be checked.
    pub(super) cut_short: bool,
}

impl Clearance {
    /// `width` is the kerf width, mm; distances smaller than it by up to `slack` mm are accepted.
    pub(super) fn new(contours: &[Contour], width: f64, slack: f64) -> Self {
        let elements: Vec<(u32, Segment)> = (0..)
            .zip(contours)
            .filter(|(_, c)| c.operation == Operation::Cut)
            .flat_map(|(id, c)| c.boundary().unwrap_or(&c.path).segments.iter().map(move |s| (id, *s)))
            .collect();
        let index = BoxIndex::new(elements.iter().map(|(_, s)| s.bounds()));
        let near = vec![None; contours.len()];
        let mut clearance = Self { elements, index, clear: 0.5 * width - slack, near, cut_short: false };
        clearance.find_near(contours, width - slack);
        clearance
    }

    fn find_near(&mut self, contours: &[Contour], least: f64) {
        let waste: Vec<Waste> = (0..).zip(contours).map(|(id, c)| Waste::of(id, c)).collect();
        let mut look = (ELEMENTS_PER_ELEMENT * self.elements.len()).max(MIN_ELEMENTS);
        let mut near = std::mem::take(&mut self.near);
        for (i, (a, s)) in self.elements.iter().enumerate() {
            self.index.visit(s.bounds().grown(least), |j| {
                let (b, other) = &self.elements[j];
                look = look.saturating_sub(1);
                if j > i && a != b && waste[*a as usize].is_between(&waste[*b as usize]) {
                    let (gap, at) = distance(s, other);
                    for c in [*a, *b].into_iter().filter(|_| gap < least) {
                        let known = &mut near[c as usize];
                        if known.is_none_or(|(g, _)| gap < g) {
                            *known = Some((gap, at));
                        }
                    }
                }
                look > 0
            });
        }
        (self.near, self.cut_short) = (near, look == 0);
    }

    /// The distance to another contour if it is less than the kerf (mm), and the place.
    pub(super) fn near(&self, contour: u32) -> Option<(f64, DVec2)> {
        self.near.get(contour as usize).copied().flatten()
    }

    /// Whether a beam along an element removes nothing of any part, except of this contour's own part where it lies
    /// along it.
    pub(super) fn is_free(&self, contour: u32, element: &Segment) -> bool {
        let mut free = true;
        self.index.visit(element.bounds().grown(self.clear), |j| {
            let (other, drawn) = &self.elements[j];
            free = *other == contour || distance(element, drawn).0 >= self.clear;
            free
        });
        free
    }
}

/// Where the waste beside a contour lies.
#[derive(Clone, Copy, PartialEq)]
enum Waste {
    /// Around all parts.
    Sheet,
    /// In this hole.
    Hole(u32),
    /// Nowhere, because it is an open cut in a part, or not cut.
    None,
}

impl Waste {
    fn of(id: u32, c: &Contour) -> Self {
        if c.depth.is_multiple_of(2) {
            c.inside.map_or(Self::Sheet, Self::Hole)
        } else if c.bounds_area() {
            Self::Hole(id)
        } else {
            Self::None
        }
    }

    fn is_between(&self, other: &Self) -> bool {
        self == other && *self != Self::None
    }
}

/// The distance between two elements, mm, and a place between them.
pub(super) fn distance(a: &Segment, b: &Segment) -> (f64, DVec2) {
    if let Some(m) = intersect(a, b, TOUCHING).points.first() {
        return (0.0, m.point);
    }
    let mut best = (f64::INFINITY, a.start());
    let mut from = |p: DVec2, other: &Segment| {
        let (f, d2) = other.nearest(p);
        if d2.sqrt() < best.0 {
            best = (d2.sqrt(), (p + other.at(f)) * 0.5);
        }
    };
    for (s, other) in [(a, b), (b, a)] {
        from(s.start(), other);
        from(s.end(), other);
        // In the interior of both elements the shortest connection is perpendicular to both, so it lies on a line
        // through an arc's centre.
        if let Segment::Arc(arc) = other {
            from(s.at(s.nearest(arc.center).0), other);
            if let Segment::Arc(own) = s {
                from(s.at(s.nearest(own.center * 2.0 - arc.center).0), other);
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    /// Compares with the smallest distance between many places.
    #[test]
    fn distance_equals_that_of_the_nearest_sampled_places() {
        let p = DVec2::new;
        let arc = |c: DVec2, r: f64, from: f64, sweep: f64| Segment::Arc(Arc::from_angles(c, r, from, sweep));
        let all = [
            Segment::line(p(0.0, 0.0), p(10.0, 0.0)),
            Segment::line(p(3.0, 1.0), p(8.0, 4.0)),
            Segment::line(p(-2.0, -3.0), p(-2.0, 7.0)),
            arc(p(5.0, 5.0), 3.0, 3.5, 2.0),
            arc(p(5.0, 5.0), 4.0, 0.2, -2.6),
            arc(p(6.0, 4.5), 1.0, 0.0, 6.0),
            arc(p(14.0, 3.0), 2.5, 1.0, 4.0),
            Segment::Arc(Arc::circle(p(5.0, 8.0), 1.5)),
        ];
        let places = |s: &Segment| (0..=4000).map(|k| s.at(f64::from(k) / 4000.0)).collect::<Vec<_>>();
        for (i, a) in all.iter().enumerate() {
            for b in &all[..i] {
                let sampled =
                    places(a).into_iter().map(|p| b.nearest(p).1.sqrt()).fold(f64::INFINITY, f64::min);
                let found = distance(a, b).0;
                assert!(found <= sampled + 1e-12 && sampled - found < 5e-3, "{found} {sampled}: {a:?} {b:?}");
                assert_eq!(found.to_bits(), distance(a, b).0.to_bits());
            }
        }
    }
}
