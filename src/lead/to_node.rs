//! The lead-in of contours that are cut together: a straight line through the scrap to the node of their net where they are
//! pierced.
//!
//! Several contours meet at a node, so the line has no contour of its own. It keeps its clearance from every contour that does not meet the
//! node, and leaves those that do steeply enough.

use super::planner::Planner;
use super::scrap::Scrap;
use crate::geometry::{Aabb, DVec2, Segment, distance, math};
use crate::machine::{LeadKind, LeadSide};
use crate::sheet::Contour;
use std::f64::consts::TAU;

/// Directions that are tried, evenly around the node.
const DIRECTIONS: u32 = 32;
/// Lengths that are tried, in lengths of the rule's lead, the wanted one first.
const LENGTHS: [f64; 4] = [1.0, 0.75, 0.5, 0.25];
/// Contours meet a node within this, mm: twice the largest distance between copies.
const MEETS: f64 = 0.02;
/// Least distance of a point of the lead from the contours at the node, in distances from the node: 30 degrees from a straight one.
const STEEP: f64 = 0.5;
/// Points of the lead at which it is measured: each is nearer to the node than the one before by this factor, so that a corner
/// between two of them would be too near to one, down to this distance, mm.
const NEXT_POINT: f64 = 0.75;
const NEAREST: f64 = 0.05;

impl Planner<'_> {
    /// The lead-in to a node at which the cut of a group begins along a contour; `None` if no rule asks for it, or it fits nowhere.
    pub(crate) fn lead_to_node(&self, contour: u32, node: DVec2) -> Option<Segment> {
        let own = self.sheet.contours.get(contour as usize)?;
        let outline = own.boundary()?;
        let side = if own.depth.is_multiple_of(2) { LeadSide::Outer } else { LeadSide::Hole };
        let asked = self.leads.rule(side, outline.bounds().size().max_element(), outline.length());
        let base = || asked.or(self.leads.rules.first()).cloned().unwrap_or_default();
        let chosen = self.sheet.chosen_lead(contour).map(|kind| base().with_lead_in(kind));
        let shape = chosen.as_ref().or(asked)?.lead_in;
        if shape.kind == LeadKind::None {
            return None;
        }
        LENGTHS.into_iter().find_map(|share| {
            let length = share * shape.size();
            let fits = |k: u32| {
                let tip = node + length * math::unit(TAU * f64::from(k) / f64::from(DIRECTIONS));
                Some((self.scrap.slope_to_node(own, tip, node)?, tip))
            };
            // The first of several that are as steep.
            let best = (0..DIRECTIONS).filter_map(fits).reduce(|a, b| if b.0 > a.0 + 1e-9 { b } else { a });
            best.map(|(_, tip)| Segment::line(tip, node))
        })
    }
}

impl Scrap<'_> {
    /// How steeply a straight lead from `tip` to a node of a group leaves the contours that meet there: the least distance of its points
    /// from them, in distances from the node. `None` if it does not lie in the scrap of `own`, one of them, or has no room.
    fn slope_to_node(&self, own: &Contour, tip: DVec2, node: DVec2) -> Option<f64> {
        let lead = Segment::line(tip, node);
        if self.bed.is_some_and(|bed| !bed.contains_box(&lead.bounds())) {
            return None;
        }
        let mut meeting: Vec<u32> = Vec::new();
        self.index.visit(Aabb::of(node).grown(MEETS), |k| {
            let known = self.elements.get(k).filter(|e| e.shape.nearest(node).1 <= MEETS * MEETS);
            meeting.extend(known.map(|e| e.contour));
            true
        });
        let mut slope = f64::INFINITY;
        self.index.visit(lead.bounds().grown(self.reach()), |k| {
            let Some(element) = self.elements.get(k) else { return true };
            if meeting.contains(&element.contour) {
                let (mut rest, length) = (1.0, lead.length());
                while rest * length > NEAREST {
                    let at = lead.at(1.0 - rest);
                    rest *= NEXT_POINT;
                    slope = slope.min(element.shape.nearest(at).1.sqrt() / at.distance(node));
                }
            } else if distance(&lead, &element.shape).0 < element.least {
                slope = 0.0;
            }
            slope >= STEEP
        });
        (slope >= STEEP && self.is_in_scrap(own, tip)).then_some(slope)
    }
}
