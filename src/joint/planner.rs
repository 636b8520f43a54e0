//! The joints of the contours of a sheet: which contours have some, and how many.

use super::grid::Grid;
use super::outcome::{ContourJoints, Outcome, Refusal};
use super::room::{Cuts, Room, corners};
use crate::machine::{JointRule, LeadSide, Profile};
use crate::sheet::{Contour, HandJoint, Operation, Sheet};

/// Finds the joints of contours.
pub struct Planner<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    /// By contour: whether it may be cut as one with others.
    grouped: Vec<bool>,
    cuts: Cuts,
}

impl<'s> Planner<'s> {
    /// The planner for a sheet; `None` if there are no joints.
    pub fn new(sheet: &'s Sheet, machine: &'s Profile) -> Option<Self> {
        if !sheet.asks_for_joints(machine) {
            return None;
        }
        let grouped = sheet.may_be_cut_as_one(machine.cuts_as_one());
        Some(Self { sheet, machine, grouped, cuts: Cuts::new(&sheet.contours) })
    }

    /// The rule of a contour, and the places of joints by hand. `None` if it is not cut or nothing asks for joints.
    fn asked(&self, id: u32) -> Option<(JointRule, Vec<f64>)> {
        let contour = self.sheet.contours.get(id as usize)?;
        if contour.operation != Operation::Cut || contour.next_pass.is_some() {
            return None;
        }
        let side = if contour.depth.is_multiple_of(2) { LeadSide::Outer } else { LeadSide::Hole };
        let rules = self.machine.joints.as_ref();
        let rule = rules.and_then(|j| j.rule(side, contour.bounds.size().to_array()));
        let own = self.sheet.joints.iter().filter(|j| j.contour == id);
        let by_hand: Vec<f64> = own.filter_map(|j| place_by_hand(contour, j)).collect();
        let chosen = self.sheet.chosen_joints(id);
        if by_hand.is_empty() && chosen.is_none() {
            let rule = *rule?;
            return (rule.count > 0 || rule.spacing.is_some()).then_some((rule, by_hand));
        }
        let first = || rules.and_then(|j| j.rules.first()).copied();
        let own = rule.copied().or_else(first).unwrap_or_default();
        match chosen.filter(|_| by_hand.is_empty()) {
            None => Some((own, by_hand)),
            Some(0) => None,
            Some(count) => Some((JointRule { count, spacing: None, ..own }, by_hand)),
        }
    }

    /// Why a contour has no joints although they are asked for.
    pub fn refused(&self, id: u32) -> Option<Refusal> {
        let contour = self.sheet.contours.get(id as usize)?;
        let (_, by_hand) = self.asked(id)?;
        if self.grouped.get(id as usize).is_some_and(|g| *g) {
            Some(Refusal::Group)
        } else if !contour.path.closed {
            // By rule, joints are for what falls out: not for lines and slots that were drawn open.
            let by_choice = !by_hand.is_empty() || self.sheet.chosen_joints(id).is_some();
            (contour.outline.is_some() || by_choice).then_some(Refusal::Open)
        } else if self.sheet.process_of(contour, self.machine).passes > 1 {
            Some(Refusal::Passes)
        } else {
            contour.self_crossing.then_some(Refusal::CrossesItself)
        }
    }

    /// The joints of a contour; `None` if it has none, or is refused.
    pub fn joints(&self, id: u32) -> Option<ContourJoints> {
        let contour = self.sheet.contours.get(id as usize)?;
        let path = &contour.path;
        let whole = path.length();
        if !path.closed || whole <= 0.0 || self.refused(id).is_some() {
            return None;
        }
        let (rule, by_hand) = self.asked(id)?;
        let gap = rule.width + self.machine.kerf_width;
        let clearance = rule.corner_clearance;
        let room =
            Room { cuts: &self.cuts, contour: id, path, whole, gap, clearance, corners: corners(path) };
        let mut grid = Grid::new(room);
        let at = contour.path.start().unwrap_or_default();
        let mut outcome = Outcome { at, ..Outcome::default() };
        let places = if by_hand.is_empty() {
            grid.spread(&rule, &mut outcome)
        } else {
            grid.by_hand(&by_hand, &mut outcome)
        };
        let joints = places.into_iter().map(|at| grid.room.joint(at)).collect();
        Some(ContourJoints { joints, kind: rule.kind, outcome })
    }
}

/// The arc length on the path of the beam that is nearest to a place on the drawn contour.
fn place_by_hand(contour: &Contour, joint: &HandJoint) -> Option<f64> {
    let drawn = contour.drawn.as_ref().unwrap_or(&contour.path);
    let along = joint.at.clamp(0.0, 1.0) * drawn.length();
    if contour.drawn.is_none() {
        return Some(along);
    }
    Some(contour.path.nearest(drawn.at(along)?)?.0)
}
