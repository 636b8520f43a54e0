//! Cuts through bridges: after the cut around connected parts, the machine cuts across each strip, so that every part comes out with its own
//! outline.
//!
//! At each end of a strip, the stretch of the outline that the bridge left open becomes an open contour. Its ends lie where the cut around the
//! parts turns into the strip, so it begins and ends on a kerf. With a kerf width it runs half a kerf outside the outline, as that cut does.

use super::super::model::{BridgeCut, Bridged, Contour, Operation, Sheet, Strip};
use super::held;
use crate::geometry::{Arc, DVec2, Path, Segment};
use crate::machine::Profile;
use std::sync::Arc as Shared;

impl Sheet {
    /// The sheet, already with the paths of the beam, with the cuts through its bridges; `None` if the machine makes none.
    pub(crate) fn with_bridge_cuts(&self, machine: &Profile) -> Option<Self> {
        machine.levers.bridges.filter(|bridges| bridges.cut_later && !self.bridged.is_empty())?;
        let mut sheet = self.clone();
        let mut groups = Vec::with_capacity(self.bridged.len());
        for group in self.bridged.iter() {
            let mut all = Vec::new();
            let offset = self.contours.get(group.contour as usize).is_some_and(|c| c.drawn.is_some());
            let beside = if offset { 0.5 * machine.kerf_width } else { 0.0 };
            for (k, strip) in group.strips.iter().enumerate() {
                let cuts = [0, 1].into_iter().filter_map(|end| cut(group, strip, end, beside));
                for (outline, shape) in cuts {
                    let Some(new) = self.completing(outline, shape) else { continue };
                    let contour = u32::try_from(sheet.contours.len()).ok()?;
                    all.push(BridgeCut { contour, outline, strip: k });
                    sheet.contours.push(new);
                }
            }
            groups.push(Bridged { cuts: all, ..group.clone() });
        }
        sheet.bridged = Shared::new(groups);
        Some(sheet)
    }

    /// Pairs of contours of which the first comes before the second: the cut around connected parts, and a cut through one of their bridges; and
    /// cuts through bridges that are made in an order of their own.
    pub(crate) fn cut_apart(&self) -> impl Iterator<Item = (u32, u32)> {
        let around = |outline: u32| self.contours.get(outline as usize).and_then(|c| c.bridged);
        let all = (0..).zip(&self.contours);
        let ordered = self.bridged.iter().flat_map(held::in_order);
        all.filter_map(move |(id, c)| Some((around(c.completes()?)?, id))).chain(ordered)
    }

    /// The open contour that completes an outline.
    fn completing(&self, outline: u32, shape: Segment) -> Option<Contour> {
        let part = self.contours.get(outline as usize)?;
        Some(Contour {
            path: Path::new(vec![shape], false),
            outline: None,
            drawn: None,
            operation: Operation::Cut,
            length: shape.length(),
            area: 0.0,
            bounds: shape.bounds(),
            first_shape: u32::MAX,
            bridged: Some(outline),
            ..part.clone()
        })
    }
}

/// The cut at one end of a strip, `beside` mm outside the outline there, with that outline.
fn cut(group: &Bridged, strip: &Strip, end: usize, beside: f64) -> Option<(u32, Segment)> {
    let contour = strip.contours[end];
    let outline = &group.outlines.iter().find(|o| o.0 == contour)?.1;
    let [one, other] = strip.sides;
    // The sides as they leave the outline, in its direction: the strip lies on the left of the first and on the right of the second.
    let [first, second] = if end == 0 { [one, [other[1], other[0]]] } else { [other, [one[1], one[0]]] };
    let (from, to) = (outline.nearest(first[0])?.0, outline.nearest(second[0])?.0);
    let open = outline.between(from, to).into_iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
    let leaves = |[at, far]: [DVec2; 2], aside: f64| {
        let way = (far - at).normalize_or_zero();
        (at + way.perp() * aside, way)
    };
    let ends = [leaves(first, -beside), leaves(second, beside)];
    let shape = match open {
        Segment::Line(line) => {
            let along = (line.end - line.start).normalize_or_zero();
            let origin = first[0] - along.perp() * beside;
            let [start, end] = ends.map(|(at, way)| {
                let sine = way.perp_dot(along);
                at + way * ((origin - at).perp_dot(along) / sine)
            });
            Segment::line(start, end)
        }
        Segment::Arc(arc) => {
            let radius = arc.radius() + beside;
            let [start, end] = ends.map(|(at, way)| {
                let (middle, aside) = ((arc.center - at).dot(way), (arc.center - at).perp_dot(way));
                at + way * (middle + (radius * radius - aside * aside).max(0.0).sqrt())
            });
            Segment::Arc(Arc::new(start, end, arc.center, true))
        }
    };
    shape.length().is_finite().then_some((contour, shape))
}
