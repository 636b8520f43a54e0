//! A sheet, its plan, and how faults are planted in it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::type_complexity, reason = "helpers of tests")]

use crate::testkit::sheets::{Builder, circle, line, machine, p, rectangle, slot};
use kerfway::geometry::Segment;
use kerfway::plan::{self, Move, Violation};
use kerfway::sheet::Sheet;

/// A plate with two holes (one a slot) and a mark, an open cut, and a disc with a part in its hole.
/// 0 plate, 1 hole, 2 slot, 3 mark, 4 open cut, 5 ring, 6 its hole, 7 part in the hole.
pub(super) fn sheet() -> Sheet {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(10.0, 10.0), p(60.0, 40.0)), None);
    b.cut(circle(p(25.0, 25.0), 4.0), Some(plate));
    b.cut(slot(p(50.0, 30.0), 12.0, 3.0), Some(plate));
    b.mark(line(p(20.0, 40.0), p(40.0, 42.0)), Some(plate));
    b.cut(line(p(80.0, 5.0), p(95.0, 9.0)), None);
    let ring = b.cut(circle(p(110.0, 40.0), 20.0), None);
    let hole = b.cut(circle(p(110.0, 40.0), 15.0), Some(ring));
    b.cut(rectangle(p(105.0, 36.0), p(10.0, 8.0)), Some(hole));
    b.sheet
}

pub(super) use crate::testkit::exact::planned;

/// The violations after a change to the moves, the sums brought in line with the changed moves.
pub(super) fn after(change: impl FnOnce(&mut Vec<Move>)) -> Vec<Violation> {
    let (sheet, machine) = (sheet(), machine("co2-100w"));
    let mut plan = planned(&sheet, &machine);
    change(&mut plan.moves);
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, &sheet, &machine);
    plan.summary.parts = parts;
    plan::check(&sheet, &machine, &plan).unwrap_err()
}

/// The index of the cut of a contour.
pub(super) fn cut_of(moves: &[Move], id: u32) -> usize {
    moves.iter().position(|m| matches!(m, Move::Cut { contour, .. } if *contour == id)).unwrap()
}

pub(super) fn path_of(moves: &mut [Move], id: u32) -> &mut Vec<Segment> {
    let at = cut_of(moves, id);
    match &mut moves[at] {
        Move::Cut { path, .. } => path,
        _ => unreachable!(),
    }
}

/// Takes out the air move, the piercing and the cut of a contour.
pub(super) fn take_out(moves: &mut Vec<Move>, id: u32) -> Vec<Move> {
    let at = cut_of(moves, id);
    moves.drain(at - 2..=at).collect()
}
