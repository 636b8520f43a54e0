//! What the checker says of plans whose cuts on the run are wrong.

use super::{flying, plate, round, square};
use crate::testkit::exact::planned;
use crate::testkit::sheets::p;
use kerfway::geometry::Segment;
use kerfway::machine::{Levers, Profile};
use kerfway::plan::{self, Move, Violation};
use kerfway::sheet::Sheet;

/// What the checker says of a plan of the plate after a change to its moves.
fn after(
    sheet: &Sheet,
    machine: &Profile,
    checked: &Profile,
    change: impl FnOnce(&mut Vec<Move>),
) -> Vec<Violation> {
    let mut plan = planned(sheet, machine);
    change(&mut plan.moves);
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, sheet, checked);
    plan.summary.parts = parts;
    plan::check(sheet, checked, &plan).unwrap_err()
}

fn says(found: &[Violation], wanted: &str) -> bool {
    found.iter().any(|v| matches!(v, Violation::Beam { what, .. } if *what == wanted))
}

#[test]
fn the_checker_finds_wrong_cuts_on_the_run() {
    let (rows, grid) = (plate(4, 2, 6.0, 0.0, round), plate(4, 2, 20.0, 0.0, square));
    let machine = flying(20.0, 0.3);
    let fly = |moves: &[Move]| moves.iter().position(|m| matches!(m, Move::Fly { .. })).unwrap();
    let without = Profile { levers: Levers::default(), ..machine.clone() };
    assert!(says(&after(&rows, &machine, &without, |_| ()), "cuts on the run, which the machine does not"));
    let short = flying(4.0, 0.3);
    assert!(says(&after(&rows, &machine, &short, |_| ()), "runs on farther than the machine does"));
    let longer = flying(20.0, 0.5);
    assert!(says(&after(&rows, &machine, &longer, |_| ()), "does not cut the beginning again on the run"));
    let found = after(&rows, &machine, &machine, |moves| {
        let at = fly(moves);
        moves.remove(at + 1);
    });
    assert!(
        says(&found, "runs on without a cut before it") || says(&found, "runs on without a cut after it"),
        "{found:?}"
    );
    assert!(
        found.iter().any(|v| matches!(v, Violation::Missing { .. } | Violation::Partly { .. })),
        "{found:?}"
    );
    // The beam is on along the way.
    let found = after(&rows, &machine, &machine, |moves| {
        let at = fly(moves);
        let Move::Fly { path } = moves.remove(at) else { panic!() };
        let Move::Cut { path: before, .. } = &mut moves[at - 1] else { panic!() };
        before.extend(path);
    });
    assert!(!found.is_empty());
    // A side of a grid that is left out, cut twice, or cut a little too far.
    let side = |moves: &[Move]| {
        moves.iter().position(|m| matches!(m, Move::Cut { path, .. } if path.len() == 1)).unwrap() + 2
    };
    let found = after(&grid, &machine, &machine, |moves| {
        let at = side(moves);
        let Move::Cut { path, .. } = &mut moves[at] else { panic!() };
        path[0] = path[0].piece(0.0, 0.9);
        let end = path[0].end();
        if let Move::Fly { path } = &mut moves[at + 1] {
            path[0] = Segment::line(end, path[0].end());
        }
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Partly { .. })), "{found:?}");
    let found = after(&grid, &machine, &machine, |moves| {
        let at = side(moves);
        let Move::Cut { path, .. } = &mut moves[at] else { panic!() };
        let (from, to) = (path[0].start() + p(0.0, 0.01), path[0].end() + p(0.0, 0.01));
        path[0] = Segment::line(from, to);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Strays { .. })), "{found:?}");
    // A side twice and its neighbour not at all.
    let found = after(&grid, &machine, &machine, |moves| {
        let at = side(moves);
        let (Move::Cut { contour: c, .. }, Move::Cut { path: first, .. }) =
            (moves[at].clone(), moves[at - 2].clone())
        else {
            panic!()
        };
        moves[at] = Move::Cut {
            contour: c,
            with: Vec::new(),
            path: first,
            mark: false,
            leads: plan::Leads::default(),
            turns: vec![],
        };
    });
    assert!(!found.is_empty());
    // The plate is cut free before its holes are complete.
    let found = after(&grid, &machine, &machine, |moves| {
        let outline = moves.iter().position(|m| matches!(m, Move::Cut { contour: 0, .. })).unwrap();
        let cut: Vec<Move> = moves.drain(outline - 2..=outline).collect();
        moves.splice(0..0, cut);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::CutFree { .. })), "{found:?}");
}
