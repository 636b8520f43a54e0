//! Converts a solution to moves of the head: air, pierce, cut, and so on, then home.
//!
//! Each stop is converted by itself (`visits.rs`), to moves of a head that knows where it is (`head.rs`). Then the moves with the beam off
//! are led past pieces that may have tipped, and waits are put in where the sheet is hot.

mod head;
mod visits;

use super::cooled::cooled;
use super::evaluate::evaluate;
use super::model::{Move, Plan};
use super::past_tipped::past_tipped;
use crate::machine::PLANS_ALL_LEVERS;
use crate::problem::Problem;
use crate::sheet::{Sheet, Strip};
use crate::solve::{Solution, begun};
use visits::Visits;

/// The plan of a solution. `solution` must belong to `problem`, and `problem` to `sheet`.
///
/// Cuts are pierced in every pass; marks are not. A contour that is left unfinished gets a pre-cut where it is left, if
/// the machine charges for pre-cuts, and is resumed without piercing; so is a pierce group. A cut pauses in sharp corners, and
/// is interrupted by micro-joints. There is no air move if the head is already in place. Between nodes with a link there is a chain
/// or an edge start instead, and no piercing. Each cut begins in the quickest way that there is, which may be on a kerf that was cut
/// before; cuts through bridges begin on that of the cut around the connected parts.
pub fn from_solution(sheet: &Sheet, problem: &Problem, solution: &Solution) -> Plan {
    let mut visits = Visits::new(sheet, problem, solution.stops.len());
    let begun = begun(problem, &solution.stops);
    for (k, stop) in solution.stops.iter().enumerate() {
        visits.make(stop, begun.get(k).copied().filter(|_| PLANS_ALL_LEVERS));
    }
    let moves = visits.finish();
    let moves = match &problem.zones {
        Some(zones) if PLANS_ALL_LEVERS => past_tipped(zones, &problem.machine, moves),
        _ => moves,
    };
    let (mut moves, hot_pairs) = match problem.cooling() {
        Some(cooling) => cooled(cooling, sheet, &problem.machine, moves),
        None => (moves, 0),
    };
    let bridges: Vec<Strip> = if PLANS_ALL_LEVERS {
        name_bridged(&mut moves, sheet);
        sheet.bridged.iter().flat_map(|b| &b.strips).copied().collect()
    } else {
        Vec::new()
    };
    let mut summary = evaluate(&moves, sheet, &problem.machine);
    summary.joints = joints_of(problem);
    summary.hot_pairs = hot_pairs;
    summary.bridges = u32::try_from(bridges.len()).unwrap_or(u32::MAX);
    summary.parts = u32::try_from(sheet.parts.len()).unwrap_or(u32::MAX);
    Plan { moves, summary, bridges }
}

/// Names the outlines of connected parts in each cut that goes around them.
fn name_bridged(moves: &mut [Move], sheet: &Sheet) {
    for step in moves {
        let Move::Cut { contour, with, .. } = step else { continue };
        let around = sheet.contours.get(*contour as usize).filter(|c| c.path.closed);
        let Some(root) = around.and_then(|c| c.bridged) else { continue };
        let group = sheet.bridged.binary_search_by_key(&root, |b| b.contour).ok();
        let group = group.and_then(|k| sheet.bridged.get(k));
        let outlines = group.iter().flat_map(|b| &b.outlines).map(|o| o.0);
        with.extend(outlines.filter(|&id| id != root));
    }
}

/// Number of joints of all contours.
fn joints_of(problem: &Problem) -> u32 {
    let joints = problem.items.iter().filter_map(|i| i.joints.as_ref());
    u32::try_from(joints.map(|j| j.joints.len()).sum::<usize>()).unwrap_or(u32::MAX)
}
