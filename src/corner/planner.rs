//! The corners of a contour that may be cut in loops or rounded.

use super::turned::Corner;
use crate::geometry::{DVec2, Segment, math};
use crate::lead::Scrap;
use crate::machine::{CornerKind, Corners, PLANS_ALL_LEVERS, Profile};
use crate::sheet::{Operation, Sheet};
use std::f64::consts::PI;

/// Corners that turn by less are none, rad: the head passes them at a good speed, and a loop would run along the next side.
const LEAST_TURN: f64 = 20.0 * PI / 180.0;
/// Corners that turn by more have no loop, rad: it would reach eight times its radius into the waste.
const MOST_TURN: f64 = 165.0 * PI / 180.0;
/// Smallest radius of a rounded corner, mm: a smaller arc is no quicker than the corner.
const LEAST_RADIUS: f64 = 0.01;

/// The corners of one contour.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ContourCorners {
    /// Those that may be cut otherwise, in order along the contour.
    pub corners: Vec<Corner>,
    /// Those for which there is no room, with what they should be, mm.
    pub without_room: Vec<(CornerKind, DVec2)>,
}

/// Finds the corners of contours.
pub struct Planner<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    lever: Corners,
    scrap: Scrap<'s>,
    /// By contour: whether it may be cut as one with others.
    grouped: Vec<bool>,
}

impl<'s> Planner<'s> {
    /// The planner for a sheet; `None` if the beam turns in every corner.
    pub fn new(sheet: &'s Sheet, machine: &'s Profile) -> Option<Self> {
        let lever = machine.levers.corners.filter(|_| PLANS_ALL_LEVERS)?;
        let stops = [lever.outer, lever.hole].iter().all(|kind| *kind == CornerKind::Stop);
        if stops && !sheet.asks_for_corners() {
            return None;
        }
        // A job that does not lie on the bed is reported elsewhere.
        let bed = machine.bed().filter(|bed| bed.contains_box(&sheet.bounds));
        let grouped = sheet.may_be_cut_as_one(machine.cuts_as_one());
        let scrap = Scrap::new(&sheet.contours, lever.clearance, machine.kerf_width, bed);
        Some(Self { sheet, machine, lever, scrap, grouped })
    }

    /// What is done at the corners of a contour; `Stop` for what is not cut, or not in one go.
    pub fn kind(&self, id: u32) -> CornerKind {
        let Some(contour) = self.sheet.contours.get(id as usize) else { return CornerKind::Stop };
        let once = self.sheet.process_of(contour, self.machine).passes == 1 && contour.next_pass.is_none();
        let plain = contour.path.closed && contour.operation == Operation::Cut && !contour.self_crossing;
        let grouped = self.grouped.get(id as usize).is_some_and(|g| *g);
        if !once || !plain || contour.pass > 0 || grouped {
            return CornerKind::Stop;
        }
        let hole = !contour.depth.is_multiple_of(2);
        let rule = if hole { self.lever.hole } else { self.lever.outer };
        self.sheet.chosen_corners(id).unwrap_or(rule)
    }

    /// The corners of a contour; `None` if it has none that may be cut otherwise, nor wants any.
    pub fn corners(&self, id: u32) -> Option<ContourCorners> {
        let kind = self.kind(id);
        let contour = self.sheet.contours.get(id as usize).filter(|_| kind != CornerKind::Stop)?;
        let mut all = ContourCorners::default();
        let elements: Vec<&Segment> = contour.path.segments.iter().filter(|s| s.length() > 0.0).collect();
        let next = elements.iter().cycle().skip(1);
        for (before, after) in elements.iter().zip(next) {
            let (at, arrives, leaves) = (before.end(), before.tangent(1.0), after.tangent(0.0));
            let turn = Corner::turn(arrives, leaves);
            let corner = match kind {
                // The part is on the left: a corner to the right turns around waste, and beyond it there is none.
                CornerKind::Loop if (LEAST_TURN..=MOST_TURN).contains(&turn) => {
                    let corner = Corner::looped(at, arrives, leaves, self.lever.loop_radius);
                    Some(corner).filter(|c| self.scrap.holds_loop(id, at, &c.path))
                }
                CornerKind::Round if turn.abs() >= LEAST_TURN => self.rounded(before, after, turn),
                _ => continue,
            };
            match corner {
                Some(corner) => all.corners.push(corner),
                None => all.without_room.push((kind, at)),
            }
        }
        (all != ContourCorners::default()).then_some(all)
    }

    /// The largest arc within the deviation between two straight sides, of which it takes at most half.
    fn rounded(&self, before: &Segment, after: &Segment, turn: f64) -> Option<Corner> {
        let (Segment::Line(_), Segment::Line(_)) = (before, after) else { return None };
        let half = 0.5 * turn.abs();
        let cos = math::cos(half);
        let by_deviation = self.lever.deviation * cos / (1.0 - cos);
        let by_sides = 0.5 * before.length().min(after.length()) / math::tan(half);
        let radius = self.lever.round_radius.min(by_deviation).min(by_sides);
        let fits = radius >= LEAST_RADIUS;
        fits.then(|| Corner::rounded(before.end(), before.tangent(1.0), after.tangent(0.0), radius))
    }
}
