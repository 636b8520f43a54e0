//! What the checker says of plans whose chains are wrong.

use super::{chaining, searched, squares};
use crate::testkit::leads::oriented;
use crate::testkit::sheets::{Builder, p, rectangle};
use kerfway::geometry::Segment;
use kerfway::machine::{Levers, Profile};
use kerfway::plan::{self, Leads, Move, Plan, Violation};

/// What the checker says of a plan after a change to its moves.
fn after(checked: &Profile, change: impl FnOnce(&mut Vec<Move>)) -> Vec<Violation> {
    let (sheet, mut plan) = searched(squares(2, 2, 8.0), &chaining(30.0, 1.0));
    change(&mut plan.moves);
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, &sheet, checked);
    plan.summary.parts = parts;
    plan::check(&sheet, checked, &plan).err().unwrap_or_default()
}

pub(crate) fn says(found: &[Violation], wanted: &str) -> bool {
    let said = |v: &Violation| match v {
        Violation::Chain { what, .. } | Violation::Beam { what, .. } => *what == wanted,
        _ => false,
    };
    found.iter().any(said)
}

#[test]
fn the_checker_finds_wrong_chains() {
    let machine = chaining(30.0, 1.0);
    assert!(after(&machine, |_| ()).is_empty());
    let without = Profile { levers: Levers::default(), ..machine.clone() };
    assert!(says(&after(&without, |_| ()), "is one that the machine does not cut"));
    assert!(says(&after(&chaining(7.0, 1.0), |_| ()), "is longer than the machine allows"));
    assert!(says(&after(&chaining(30.0, 9.0), |_| ()), "is too near to another cut"));
    let chain = |moves: &[Move]| moves.iter().position(|m| matches!(m, Move::Chain { .. })).unwrap();
    // The beam goes off and on instead, without piercing.
    let found = after(&machine, |moves| {
        let at = chain(moves);
        let to = moves[at].end().unwrap();
        moves[at] = Move::air(to);
    });
    assert!(says(&found, "cuts without piercing"), "{found:?}");
    // Pierced again after the chain; no cut after it; no cut before it.
    let found = after(&machine, |moves| moves.insert(chain(moves) + 1, Move::Pierce));
    assert!(says(&found, "cuts through waste without a cut after it"), "{found:?}");
    let found = after(&machine, |moves| moves.insert(chain(moves), Move::Pierce));
    assert!(says(&found, "cuts through waste without a cut before it"), "{found:?}");
    // Bent through a part.
    let found = after(&machine, |moves| {
        let at = chain(moves);
        let Move::Chain { path } = &mut moves[at] else { panic!() };
        let (from, to) = (path[0].start(), path[0].end());
        *path = vec![Segment::line(from, p(20.0, 20.0)), Segment::line(p(20.0, 20.0), to)];
    });
    assert!(says(&found, "is not straight"), "{found:?}");
    // Not where the head is.
    let found = after(&machine, |moves| {
        let at = chain(moves);
        let Move::Chain { path } = &mut moves[at] else { panic!() };
        path[0] = Segment::line(path[0].start() + p(0.1, 0.0), path[0].end());
    });
    assert!(found.iter().any(|v| matches!(v, Violation::NotJoined { .. })), "{found:?}");
}

/// A plan by hand: two contours joined from one place to another.
fn joined_at(b: Builder, machine: &Profile, [from, to]: [f64; 2]) -> Vec<Violation> {
    let sheet = oriented(b.sheet);
    let cut = |id: u32, along: f64| {
        let path = sheet.contours[id as usize].path.starting_at(along).segments;
        Move::Cut { contour: id, with: Vec::new(), path, mark: false, leads: Leads::default(), turns: vec![] }
    };
    let place = |id: usize, along: f64| sheet.contours[id].path.at(along).unwrap();
    let (start, end) = (place(0, from), place(1, to));
    let mut moves = vec![Move::air(start), Move::Pierce, cut(0, from)];
    moves.extend([Move::Chain { path: vec![Segment::line(start, end)] }, cut(1, to)]);
    for id in 2..sheet.contours.len() {
        moves.extend([Move::air(place(id, 0.0)), Move::Pierce, cut(u32::try_from(id).unwrap(), 0.0)]);
    }
    moves.push(Move::air(machine.home()));
    let mut summary = plan::evaluate(&moves, &sheet, machine);
    summary.parts = u32::try_from(sheet.parts.len()).unwrap();
    plan::check(&sheet, machine, &Plan { moves, summary, bridges: Vec::new() }).err().unwrap_or_default()
}

#[test]
fn the_checker_finds_chains_through_parts_and_along_edges() {
    let machine = chaining(100.0, 1.0);
    let two = || squares(2, 1, 8.0);
    // From the right side of the first to the left side of the second: sides begin at 0, 20, 40 and 60 mm.
    assert_eq!(joined_at(two(), &machine, [30.0, 70.0]), []);
    // From the left side of the first, through the part.
    let found = joined_at(two(), &machine, [70.0, 70.0]);
    assert!(
        says(&found, "cuts into a part") || says(&found, "runs along a contour that it joins"),
        "{found:?}"
    );
    // Along the tops of both.
    assert!(says(&joined_at(two(), &machine, [50.0, 50.0]), "runs along a contour that it joins"));
    // Through a part between them, which is not cut yet.
    let mut b = two();
    b.cut(rectangle(p(33.0, 15.0), p(2.0, 10.0)), None);
    assert!(says(&joined_at(b, &machine, [30.0, 70.0]), "is too near to another cut"));
    // Through a hole that lies around a part, where every place is inside an even number of outlines or crosses one.
    let mut b = Builder::new();
    let frame = b.cut(rectangle(p(0.0, 0.0), p(100.0, 60.0)), None);
    b.cut(rectangle(p(10.0, 10.0), p(80.0, 40.0)), Some(frame));
    let found = joined_at(b, &machine, [0.0, 0.0]);
    assert!(says(&found, "cuts into a part"), "{found:?}");
}
