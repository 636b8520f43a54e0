//! Checks at points along leads that they lie in scrap, and far enough from everything else.

use super::fractions::fractions;
use super::tolerance::SAME;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment, winding};
use crate::machine::Profile;
use crate::sheet::{Contour, Operation, Sheet};

/// Distance of the points along a lead, mm, and their greatest number on one element.
const STEP: f64 = 0.1;
const MOST: f64 = 100.0;
/// Rounding of distances, mm.
const ROUNDING: f64 = 1e-6;
/// Part of a lead next to the joint where it is as near to its own contour as it has to be, as a fraction of its length.
const JOINT: f64 = 0.1;
/// Contours of a group meet at a node within this, mm.
const NODE: f64 = 0.025;
/// Least slope of a lead to a node: distance from the contours there in distances from the node.
const SLOPE: f64 = 0.4;
/// A lead that is this near to its own contour elsewhere touches it, mm.
const TOUCHING: f64 = 1e-5;
/// Least distance of a lead from its own contour, in distances from the lines along which that runs where they join: it is less
/// than planned leads keep, because these are measured stage by stage.
const COMES_BACK: f64 = 0.1;

/// Everything that is cut, as leads see it.
pub(super) struct Room<'s> {
    sheet: &'s Sheet,
    /// All elements of cuts with their contour, and how far leads of others stay away, mm.
    elements: Vec<(u32, Segment, f64)>,
    index: BoxIndex,
    /// The outlines of parts and holes, by their boxes.
    outlines: Vec<u32>,
    boxes: BoxIndex,
    clearance: f64,
    reach: f64,
}

impl<'s> Room<'s> {
    pub(super) fn new(sheet: &'s Sheet, machine: &Profile) -> Self {
        let clearance = Sheet::lead_clearance(machine);
        let beside = |c: &Contour| if c.drawn.is_some() { 0.0 } else { 0.5 * machine.kerf_width };
        let of = |(id, c): (u32, &'s Contour)| {
            let path = c.boundary().unwrap_or(&c.path);
            path.segments.iter().map(move |s| (id, *s, clearance + beside(c)))
        };
        let cuts = (0..)
            .zip(&sheet.contours)
            .filter(|(_, c)| c.operation == Operation::Cut && c.pass == 0 && !c.is_added());
        let elements: Vec<_> = cuts.flat_map(of).collect();
        let index = BoxIndex::new(elements.iter().map(|e| e.1.bounds()));
        let all = (0..).zip(&sheet.contours).filter(|(_, c)| c.bounds_area() && c.pass == 0);
        let (outlines, boxes): (Vec<u32>, Vec<Aabb>) =
            all.filter_map(|(id, c)| Some((id, c.boundary()?.bounds()))).unzip();
        let reach = clearance + 0.5 * machine.kerf_width + ROUNDING;
        Self { sheet, elements, index, outlines, boxes: BoxIndex::new(boxes), clearance, reach }
    }

    /// What is wrong with a lead of a contour, and where. `lead` touches the contour at one of its ends.
    pub(super) fn fault(&self, contour: u32, lead: &[Segment]) -> Option<(&'static str, DVec2)> {
        let own = self.sheet.contours.get(contour as usize)?;
        let length: f64 = lead.iter().map(Segment::length).sum();
        let (first, last) = (lead.first()?.start(), lead.last()?.end());
        let off =
            |p: DVec2| own.path.segments.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt();
        let tip = if off(first) > off(last) { first } else { last };
        let joint = if tip == first { last } else { first };
        let sides: Vec<DVec2> = own.path.segments.iter().filter_map(|s| direction_at(s, joint)).collect();
        for p in points(lead) {
            if self.nearness(contour, p).is_some() {
                return Some(("is too near to another cut", p));
            }
            if p.distance(joint) <= JOINT * length {
                continue;
            }
            let away = p - joint;
            let beside = |d: &DVec2| (d.x * away.y - d.y * away.x).abs();
            let depth = sides.iter().map(beside).reduce(f64::min).unwrap_or_default();
            let off = off(p);
            if off < TOUCHING {
                return Some(("touches its contour again", p));
            }
            if off < self.clearance.min(COMES_BACK * depth) - ROUNDING {
                return Some(("comes back to its contour", p));
            }
        }
        let around = self.depth(tip);
        let hole = own.depth % 2 == 1;
        (around != own.depth + u32::from(hole)).then_some(("does not lie in the scrap", tip))
    }

    /// What is wrong with a straight lead to a node at which contours of a group meet, one of them `own`, and where.
    pub(super) fn fault_to_node(&self, own: &Contour, lead: &[Segment]) -> Option<(&'static str, DVec2)> {
        let (tip, node) = (lead.first()?.start(), lead.last()?.end());
        let meets = |s: &Segment| s.nearest(node).1.sqrt() <= NODE;
        let meeting: Vec<u32> = self.elements.iter().filter(|e| meets(&e.1)).map(|e| e.0).collect();
        let near = |p: DVec2| {
            self.index.query(Aabb::of(p).grown(self.reach)).into_iter().any(|k| {
                let (id, s, least) = &self.elements[k];
                let own = SLOPE * p.distance(node);
                s.nearest(p).1.sqrt() < if meeting.contains(id) { own } else { *least } - ROUNDING
            })
        };
        if let Some(p) = points(lead).find(|p| near(*p)) {
            return Some(("is too near to another cut", p));
        }
        let hole = own.depth % 2 == 1;
        (self.depth(tip) != own.depth + u32::from(hole)).then_some(("does not lie in the scrap", tip))
    }

    /// Another cut that is too near to a point.
    fn nearness(&self, contour: u32, p: DVec2) -> Option<u32> {
        let mut found = None;
        self.index.visit(Aabb::of(p).grown(self.reach), |k| {
            let (id, s, least) = &self.elements[k];
            let near = *id != contour && s.nearest(p).1.sqrt() < least - ROUNDING;
            found = near.then_some(*id);
            !near
        });
        found
    }

    /// Number of outlines around a point.
    fn depth(&self, p: DVec2) -> u32 {
        let around = |k: &usize| {
            let outline = self.sheet.contours.get(self.outlines[*k] as usize).and_then(Contour::boundary);
            outline.is_some_and(|o| winding(o, p).is_inside())
        };
        u32::try_from(self.boxes.query(Aabb::of(p)).iter().filter(|k| around(k)).count()).unwrap_or(u32::MAX)
    }
}

/// The unit direction of an element of a contour at a place, if it passes there.
fn direction_at(s: &Segment, place: DVec2) -> Option<DVec2> {
    let (fraction, d2) = s.nearest(place);
    (d2.sqrt() <= SAME && s.length() > 0.0).then(|| s.tangent(fraction))
}

/// Points along a lead, both ends included.
fn points(lead: &[Segment]) -> impl Iterator<Item = DVec2> {
    lead.iter().flat_map(|s| fractions(s.length(), STEP, [1.0, MOST]).map(move |f| s.at(f)))
}
