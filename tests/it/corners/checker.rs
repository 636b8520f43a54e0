//! What the checker says of plans whose loops and arcs are wrong.

use super::{LOOPS, ROUND, plate, searched, wedges, without};
use crate::testkit::sheets::p;
use kerfway::geometry::{Arc, DVec2, Segment};
use kerfway::machine::{Corners, Profile};
use kerfway::plan::{self, Move, Turn, Violation};

/// What the checker says of a plan after a change to its cuts.
fn after(
    corners: Corners,
    checked: &Profile,
    change: impl Fn(&mut Vec<Segment>, &mut Vec<Turn>),
) -> Vec<Violation> {
    let (sheet, mut plan) = searched(wedges(1, 0.0), &plate(corners));
    for m in &mut plan.moves {
        if let Move::Cut { path, turns, .. } = m {
            change(path, turns);
        }
    }
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, &sheet, checked);
    plan.summary.parts = parts;
    plan::check(&sheet, checked, &plan).err().unwrap_or_default()
}

fn says(found: &[Violation], wanted: &str) -> bool {
    found.iter().any(|v| matches!(v, Violation::Corner { what, .. } if *what == wanted))
}

#[test]
fn the_checker_finds_wrong_loops_and_arcs() {
    let machine = plate(LOOPS);
    assert_eq!(after(LOOPS, &machine, |_, _| ()), []);
    assert!(says(&after(LOOPS, &without(&machine), |_, _| ()), "is cut otherwise than the machine allows"));
    assert!(says(&after(LOOPS, &plate(ROUND), |_, _| ()), "is cut otherwise than the machine allows"));
    let other = plate(Corners { loop_radius: 1.5, ..LOOPS });
    assert!(says(&after(LOOPS, &other, |_, _| ()), "has a loop of another radius"));
    // On the wrong side of the corner, through the part.
    let found = after(LOOPS, &machine, |path, turns| {
        for turn in turns {
            let (from, to) = (path[turn.first].start(), path[turn.first].end());
            for s in &mut path[turn.first..turn.first + turn.count] {
                let mirrored = |q: DVec2| from - (q - from);
                *s = match *s {
                    Segment::Line(l) => Segment::line(mirrored(l.start), mirrored(l.end)),
                    Segment::Arc(a) => Segment::Arc(Arc {
                        start: mirrored(a.start),
                        end: mirrored(a.end),
                        center: mirrored(a.center),
                        sweep: a.sweep,
                    }),
                };
            }
            assert!(from.distance(to) > 1.0);
        }
    });
    assert!(says(&found, "is not run straight on"), "{found:?}");
    assert!(
        says(&found, "has a loop that is not in waste") || says(&found, "has a loop along its own contour")
    );
    // The loop is not said to be one: the beam leaves its contour.
    let found = after(LOOPS, &machine, |_, turns| turns.clear());
    assert!(found.iter().any(|v| matches!(v, Violation::Strays { .. })), "{found:?}");
    // One element of it is missing from what is said.
    let found = after(LOOPS, &machine, |_, turns| turns.iter_mut().for_each(|t| t.count = 2));
    assert!(says(&found, "is no loop"), "{found:?}");
    let found = after(LOOPS, &machine, |_, turns| turns.iter_mut().for_each(|t| t.count = 100));
    assert!(says(&found, "is not within the cut"), "{found:?}");
    // Rounded by more than is allowed; another corner than there is; a sum that is wrong.
    let round = plate(ROUND);
    assert_eq!(after(ROUND, &round, |_, _| ()), []);
    let finer = plate(Corners { deviation: 0.05, ..ROUND });
    assert!(says(&after(ROUND, &finer, |_, _| ()), "is rounded by more than the machine allows"));
    let found = after(ROUND, &round, |_, turns| turns.iter_mut().for_each(|t| t.at += p(0.05, 0.02)));
    assert!(found.iter().any(|v| matches!(v, Violation::Strays { .. })), "{found:?}");
    let (sheet, mut plan) = searched(wedges(1, 0.0), &machine);
    plan.summary.loops += 1;
    let found = plan::check(&sheet, &machine, &plan).unwrap_err();
    assert!(matches!(found[..], [Violation::Sum { what: "the number of loops", .. }]), "{found:?}");
}

#[test]
fn the_checker_finds_loops_into_a_neighbour() {
    // Planned for a clearance of 0.2 mm, checked for 1 mm.
    let tight = plate(Corners { clearance: 0.2, loop_radius: 0.4, ..LOOPS });
    // The wedge in the middle has neighbours at both of its corners on the base, and begins in one of them at most.
    let (sheet, plan) = searched(wedges(3, 3.0), &tight);
    let wide = plate(Corners { clearance: 2.9, loop_radius: 0.4, ..LOOPS });
    let found = plan::check(&sheet, &wide, &plan).unwrap_err();
    assert!(says(&found, "has a loop too near to another cut"), "{found:?}");
}
