//! Clearance: finds contours that are closer to each other than the kerf is wide, with waste between them.

use super::super::model::{Contour, Operation};
use crate::geometry::{BoxIndex, DVec2, Segment, distance};

/// Number of elements visited per element on average, and for a small drawing in total. A sheet needs two or three;
/// thousands of lines from one point need thousands, and a finding then reports that not all were checked.
const ELEMENTS_PER_ELEMENT: usize = 200;
const MIN_ELEMENTS: usize = 2_000_000;

/// All outlines that are cut, as drawn.
pub(super) struct Clearance {
    elements: Vec<(u32, Segment)>,
    index: BoxIndex,
    /// Half the kerf less the tolerance, mm.
    clear: f64,
    /// For each contour, the distance to a contour that is too close (mm), and the place.
    near: Vec<Option<(f64, DVec2)>>,
    /// Pairs of contours that meet, without waste between them, and where.
    pub(super) touching: Vec<(u32, u32, DVec2)>,
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
        let (clear, touching) = (0.5 * width - slack, Vec::new());
        let mut clearance = Self { elements, index, clear, near, touching, cut_short: false };
        clearance.find_near(contours, width - slack);
        clearance
    }

    fn find_near(&mut self, contours: &[Contour], least: f64) {
        let waste: Vec<Waste> = (0..).zip(contours).map(|(id, c)| Waste::of(id, c)).collect();
        let mut look = (ELEMENTS_PER_ELEMENT * self.elements.len()).max(MIN_ELEMENTS);
        let (mut near, mut touching) = (std::mem::take(&mut self.near), Vec::new());
        for (i, (a, s)) in self.elements.iter().enumerate() {
            self.index.visit(s.bounds().grown(least), |j| {
                let (b, other) = &self.elements[j];
                look = look.saturating_sub(1);
                if j > i && a != b {
                    let (gap, at) = distance(s, other);
                    let between = waste[*a as usize].is_between(&waste[*b as usize]);
                    if !between && gap == 0.0 {
                        touching.push((*a, *b, at));
                    }
                    for c in [*a, *b].into_iter().filter(|_| between && gap < least) {
                        let known = &mut near[c as usize];
                        if known.is_none_or(|(g, _)| gap < g) {
                            *known = Some((gap, at));
                        }
                    }
                }
                look > 0
            });
        }
        touching.dedup_by_key(|&mut (a, b, _)| (a, b));
        (self.near, self.touching, self.cut_short) = (near, touching, look == 0);
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
