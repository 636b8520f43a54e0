//! Whether a strip lies in waste, away from everything that it does not connect and from the corners beside it.

use super::side::Side;
use super::strip::Candidate;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment, distance};
use crate::sheet::{Sheet, Strip};

/// Rounding of distances, mm.
const ROUNDING: f64 = 1e-9;

/// Everything that is cut or marked, element by element.
pub(super) struct Room {
    elements: Vec<Element>,
    index: BoxIndex,
    /// Least distance of a strip from all that, mm.
    least: f64,
}

struct Element {
    contour: u32,
    /// Its number on the contour.
    number: usize,
    shape: Segment,
}

impl Room {
    /// Strips keep `least` mm from everything else.
    pub(super) fn new(sheet: &Sheet, least: f64) -> Self {
        let mut elements = Vec::new();
        for (contour, known) in (0..).zip(&sheet.contours).filter(|(_, c)| c.is_processed()) {
            let numbered = known.path.segments.iter().enumerate();
            elements.extend(numbered.map(|(number, &shape)| Element { contour, number, shape }));
        }
        let index = BoxIndex::new(elements.iter().map(|e| e.shape.bounds()));
        Self { elements, index, least }
    }

    /// The box around a strip in which it has no other one.
    pub(super) fn around(&self, strip: &Strip) -> Aabb {
        bounds(strip).grown(self.least)
    }

    /// Whether there is room for a strip between its sides.
    pub(super) fn holds(&self, candidate: &Candidate, sides: &[Side]) -> bool {
        let strip = &candidate.strip;
        let ends = candidate.of.map(|k| sides.get(k));
        let mut free = true;
        self.index.visit(self.around(strip), |k| {
            let Some(element) = self.elements.get(k) else { return true };
            let own = |side: &&Side| side.contour == element.contour && side.holds(element.number);
            free = ends.iter().flatten().any(own) || self.is_free(strip, &element.shape);
            free
        });
        free
    }

    /// Whether two strips keep their distance.
    pub(super) fn apart(&self, a: &Strip, b: &Strip) -> bool {
        !self.around(a).overlaps(&bounds(b))
            || lines(b).iter().all(|side| self.is_free(a, side)) && !holds(b, a.sides[0][0])
    }

    /// Whether a contour keeps `width` mm from all others.
    pub(super) fn is_alone(&self, contour: u32, path: &[Segment], width: f64) -> bool {
        path.iter().all(|own| {
            let mut free = true;
            self.index.visit(own.bounds().grown(width), |k| {
                let other = self.elements.get(k).filter(|e| e.contour != contour);
                free = other.is_none_or(|e| distance(own, &e.shape).0 >= width);
                free
            });
            free
        })
    }

    fn is_free(&self, strip: &Strip, shape: &Segment) -> bool {
        let far = lines(strip).iter().all(|side| distance(side, shape).0 >= self.least - ROUNDING);
        far && !holds(strip, shape.start())
    }
}

fn lines(strip: &Strip) -> [Segment; 2] {
    strip.sides.map(|[from, to]| Segment::line(from, to))
}

/// The smallest box around a strip.
pub(super) fn bounds(strip: &Strip) -> Aabb {
    strip.sides.as_flattened().iter().fold(Aabb::EMPTY, |b, &p| b.with(p))
}

/// Whether a point lies within a strip, whose corners go around it counter-clockwise.
fn holds(strip: &Strip, point: DVec2) -> bool {
    let [[a, b], [c, d]] = strip.sides;
    [[a, b], [b, c], [c, d], [d, a]].iter().all(|[p, q]| (*q - *p).perp_dot(point - *p) >= 0.0)
}
