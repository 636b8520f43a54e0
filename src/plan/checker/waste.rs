//! Where cuts through waste may be: their distances from contours, and how many outlines are around a place.

use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, winding};
use crate::machine::Profile;
use crate::sheet::{Contour, Operation, Sheet};

/// Rounding of distances, mm.
const ROUNDING: f64 = 1e-6;
/// Least distance from other contours if the machine says 0, mm.
const LEAST: f64 = 0.01;
/// Least slope against the contours at the ends.
const SLOPE: f64 = 0.25;
/// Length at both ends that is not compared with the contours there, mm.
pub(super) const JOINT: f64 = 0.02;

/// What a place is too near to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Near {
    /// Nothing.
    None,
    /// A contour at which the cut through waste begins or ends.
    Own,
    /// Another contour.
    Other,
}

/// Everything that is cut, as cuts through waste see it.
pub(super) struct Waste<'s> {
    /// All elements of cuts with their contour, and their least distance from cuts through waste, mm.
    elements: Vec<(u32, Segment, f64)>,
    index: BoxIndex,
    /// The outlines of parts and holes, by their boxes.
    outlines: Vec<&'s Contour>,
    boxes: BoxIndex,
    reach: f64,
}

impl<'s> Waste<'s> {
    pub(super) fn new(sheet: &'s Sheet, machine: &Profile, clearance: f64) -> Self {
        let is_cut = |c: &&Contour| c.operation == Operation::Cut && c.pass == 0 && !c.is_added();
        let mut elements = Vec::new();
        for (id, c) in (0..).zip(&sheet.contours).filter(|(_, c)| is_cut(c)) {
            let beside = if c.drawn.is_some() { 0.0 } else { 0.5 * machine.kerf_width };
            let least = clearance.max(LEAST) + beside;
            elements.extend(c.boundary().unwrap_or(&c.path).segments.iter().map(|s| (id, *s, least)));
        }
        let index = BoxIndex::new(elements.iter().map(|e| e.1.bounds()));
        let outlines: Vec<&Contour> =
            sheet.contours.iter().filter(|c| c.bounds_area() && c.pass == 0).collect();
        let boxes = outlines.iter().filter_map(|c| c.boundary()).map(Path::bounds);
        let boxes = BoxIndex::new(boxes.collect::<Vec<Aabb>>());
        let reach = clearance.max(LEAST) + 0.5 * machine.kerf_width + ROUNDING;
        Self { elements, index, outlines, boxes, reach }
    }

    /// What a place of a cut through waste is too near to. `own`: the contours at its ends, each with how far the place is from
    /// there, mm.
    pub(super) fn too_near(&self, own: [(u32, f64); 2], p: DVec2) -> Near {
        let mut found = Near::None;
        self.index.visit(Aabb::of(p).grown(self.reach), |k| {
            let Some((id, s, least)) = self.elements.get(k) else { return true };
            let off = s.nearest(p).1.sqrt();
            let ends = own.iter().filter(|(o, _)| o == id).map(|o| o.1);
            let along = ends.fold(f64::INFINITY, f64::min);
            if along < f64::INFINITY {
                if along > JOINT && off < least.min(SLOPE * along) - ROUNDING {
                    found = Near::Own;
                }
            } else if off < least - ROUNDING {
                found = Near::Other;
            }
            found == Near::None
        });
        found
    }

    /// Number of outlines around a point.
    pub(super) fn depth(&self, p: DVec2) -> u32 {
        let boundary = |k: usize| self.outlines.get(k).and_then(|c| c.boundary());
        let around = |k: &usize| boundary(*k).is_some_and(|o| winding(o, p).is_inside());
        u32::try_from(self.boxes.query(Aabb::of(p)).iter().filter(|k| around(k)).count()).unwrap_or(u32::MAX)
    }
}
