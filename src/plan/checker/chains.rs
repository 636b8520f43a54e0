//! Checks chains: only where the machine has them, between two closed cuts of one layer, and through waste alone.
//!
//! A chain is followed in small steps. A place on it is in waste if an even number of outlines is around it. It is as far from
//! every contour as the machine says; from the two that the chain joins it may be as near as a quarter of the way to its end,
//! so that the chain does not run along them. Where the machine has edge starts, it may begin on a kerf that was cut before, or at the edge of the sheet.

use super::fractions::fractions;
use super::kerfs::Kerfs;
use super::tolerance::SAME;
use super::violation::Violation;
use super::waste::{JOINT, Near, Waste};
use crate::geometry::{Aabb, DVec2, Segment};
use crate::machine::{Chains, PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{Contour, Operation, Sheet};

/// Distance of the places that are looked at, mm, and their greatest number.
const STEP: f64 = 0.02;
const MOST: f64 = 20_000.0;

pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    // Builds without them refuse machines with chains.
    if !PLANS_ALL_LEVERS || !plan.moves.iter().any(|m| matches!(m, Move::Chain { .. })) {
        return;
    }
    let room = machine.levers.chains.map(|lever| Room {
        waste: Waste::new(sheet, machine, lever.clearance),
        sheet,
        machine,
        lever,
    });
    let kerfs = Kerfs::new(plan, |_| true);
    let edge = edge_of(sheet).unwrap_or_default();
    for (step, m) in plan.moves.iter().enumerate() {
        let Move::Chain { path } = m else { continue };
        let before = step.checked_sub(1).and_then(|k| plan.moves.get(k));
        let mut fault = |what, at| found.push(Violation::Chain { step, what, at });
        let at = path.first().map_or(DVec2::ZERO, Segment::start);
        let Some(room) = &room else {
            fault("is one that the machine does not cut", at);
            continue;
        };
        let Some(Move::Cut { contour, .. }) = plan.moves.get(step + 1) else {
            fault("does not join two cuts", at);
            continue;
        };
        if let Some(Move::Cut { contour: last, .. }) = before {
            if let Some((what, at)) = room.fault([*last, *contour], path, at) {
                fault(what, at);
            }
            continue;
        }
        if !room.lever.edge_starts {
            fault("begins on a kerf, which the machine does not", at);
        }
        if edge.iter().any(|s| s.nearest(at).1.sqrt() <= SAME) {
            if let Some((what, at)) = room.fault_from_edge(*contour, path, at) {
                fault(what, at);
            }
            continue;
        }
        let all = kerfs.at(at);
        let cut: Vec<u32> = all.iter().filter(|k| k.0 < step).map(|k| k.1).collect();
        let Some(&first) = cut.first() else {
            let what = if all.is_empty() {
                "does not begin on a kerf"
            } else {
                "begins on a kerf that is cut later"
            };
            fault(what, at);
            continue;
        };
        // Where kerfs meet, it begins on any of them.
        if let Some((what, at)) = room.fault([first, *contour], path, at)
            && cut.iter().all(|&a| room.fault([a, *contour], path, at).is_some())
        {
            fault(what, at);
        }
    }
}

/// The edge of the sheet: the smallest outline that is drawn around everything and not cut.
pub(super) fn edge_of(sheet: &Sheet) -> Option<&[Segment]> {
    let worked = sheet.contours.iter().filter(|c| c.is_processed() && !c.skeleton);
    let all = worked.fold(Aabb::EMPTY, |all, c| all.union(c.path.bounds()));
    let around = sheet.ignored.iter().map(|i| &i.path).filter(|p| p.closed && p.bounds().contains_box(&all));
    around.reduce(|a, b| if b.area().abs() < a.area().abs() { b } else { a }).map(|p| p.segments.as_slice())
}

/// Where chains may be.
struct Room<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    lever: Chains,
    waste: Waste<'s>,
}

impl Room<'_> {
    /// Whether a cut through waste may lead to a contour: it is closed, and cut in one pass.
    fn may_be_joined(&self, contour: &Contour) -> bool {
        let once = self.sheet.process_of(contour, self.machine).passes == 1;
        contour.path.closed && contour.operation == Operation::Cut && !contour.skeleton && once
    }

    /// What is wrong with a chain between two contours that begins at `at`, and where.
    fn fault(&self, [a, b]: [u32; 2], path: &[Segment], at: DVec2) -> Option<(&'static str, DVec2)> {
        let [Segment::Line(line)] = path else { return Some(("is not straight", at)) };
        let way = line.end - line.start;
        let length = way.length();
        if length > self.lever.reach + SAME {
            return Some(("is longer than the machine allows", at));
        }
        let known = |id: u32| self.sheet.contours.get(id as usize);
        let (first, second) = known(a).zip(known(b))?;
        if a == b || first.layer != second.layer || !self.may_be_joined(first) || !self.may_be_joined(second)
        {
            return Some(("joins contours that are not cut alike", at));
        }
        for f in fractions(length, STEP, [2.0, MOST]) {
            let (gone, p) = (length * f, line.start + way * f);
            match self.waste.too_near([(a, gone), (b, length - gone)], p) {
                Near::None => {}
                Near::Own => return Some(("runs along a contour that it joins", p)),
                Near::Other => return Some(("is too near to another cut", p)),
            }
            let ends = gone.min(length - gone) <= JOINT;
            if !ends && self.waste.depth(p) % 2 == 1 {
                return Some(("cuts into a part", p));
            }
        }
        None
    }

    /// What is wrong with a cut from the edge of the sheet to a contour that begins at `at`, and where.
    fn fault_from_edge(&self, contour: u32, path: &[Segment], at: DVec2) -> Option<(&'static str, DVec2)> {
        let [Segment::Line(line)] = path else { return Some(("is not straight", at)) };
        let way = line.end - line.start;
        let length = way.length();
        if length > self.lever.reach + SAME {
            return Some(("is longer than the machine allows", at));
        }
        if !self.may_be_joined(self.sheet.contours.get(contour as usize)?) {
            return Some(("joins contours that are not cut alike", at));
        }
        fractions(length, STEP, [2.0, MOST]).find_map(|f| {
            let (left, p) = (length * (1.0 - f), line.start + way * f);
            let part = left > JOINT && self.waste.depth(p) % 2 == 1;
            let what = match self.waste.too_near([(contour, left); 2], p) {
                Near::None => part.then_some("cuts into a part"),
                Near::Own => Some("runs along a contour that it joins"),
                Near::Other => Some("is too near to another cut"),
            };
            what.map(|what| (what, p))
        })
    }
}
