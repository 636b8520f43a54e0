//! From an order of nodes to what the head does: air, pierce, cut, and so on, then home.

use super::evaluate::evaluate;
use super::model::{Move, Plan};
use crate::geometry::{DVec2, Path, Segment};
use crate::problem::Problem;
use crate::sheet::{Operation, Sheet};
use crate::solve::Solution;

/// The moves of a solution, with their sums. `solution` is one of `problem`, `problem` one of `sheet`.
///
/// Cuts are pierced, marks are not. There is no air move where the head is in place already.
pub fn from_solution(sheet: &Sheet, problem: &Problem, solution: &Solution) -> Plan {
    let mut moves = Vec::with_capacity(3 * solution.stops.len() + 1);
    let mut head = problem.home;
    for stop in &solution.stops {
        let Some(node) = problem.nodes.get(stop.node as usize) else { continue };
        let Some(contour) = sheet.contours.get(node.item as usize) else { continue };
        let path = path_from(&contour.path, stop.along, node.reversed);
        let (Some(first), Some(last)) = (path.first(), path.last()) else { continue };
        let (entry, exit) = (first.start(), last.end());
        go(&mut moves, &mut head, entry);
        let mark = contour.operation != Operation::Cut;
        if !mark {
            moves.push(Move::Pierce);
        }
        moves.push(Move::Cut { contour: node.item, path, mark });
        head = exit;
    }
    if problem.closed {
        go(&mut moves, &mut head, problem.home);
    }
    let mut summary = evaluate(&moves, &problem.machine);
    summary.parts = u32::try_from(sheet.parts.len()).unwrap_or(u32::MAX);
    Plan { moves, summary }
}

fn go(moves: &mut Vec<Move>, head: &mut DVec2, to: DVec2) {
    if *head != to {
        moves.push(Move::Air { to });
        *head = to;
    }
}

/// A contour's elements from `along` on, run forwards or back.
fn path_from(path: &Path, along: f64, reversed: bool) -> Vec<Segment> {
    let from_entry = path.starting_at(along);
    if reversed { from_entry.reversed().segments } else { from_entry.segments }
}
