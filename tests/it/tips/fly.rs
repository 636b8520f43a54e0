//! Cuts on the run on a machine that avoids tipped pieces.

use super::tipping;
use crate::testkit::exact::planned;
use crate::testkit::sheets::{Builder, circle, p, rectangle};
use kerfway::machine::{Fly, Levers, Profile, Tips};
use kerfway::plan::{self, Plan, Violation};
use kerfway::sheet::Sheet;

/// A plate with rows of round holes of 3 mm at these places.
fn plate(rows: &[(f64, f64)]) -> Builder {
    let mut b = Builder::new();
    let outer = b.cut(rectangle(p(0.0, 0.0), p(300.0, 200.0)), None);
    for &(x, y) in rows {
        for k in 0..4 {
            b.cut(circle(p(x + 6.0 * f64::from(k), y), 1.5), Some(outer));
        }
    }
    b
}

/// A machine that flies, and one that avoids tipped pieces as well.
fn machines(reach: f64) -> [Profile; 2] {
    let avoiding = tipping(0.2, Tips { drops_below: Some(10.0), ..Tips::default() });
    let levers = Levers { fly: Some(Fly { reach, overcut: 0.0 }), ..avoiding.levers };
    let avoiding = Profile { levers, ..avoiding };
    [Profile { levers: Levers { tips: None, ..levers }, ..avoiding.clone() }, avoiding]
}

fn checked(sheet: &Sheet, machine: &Profile) -> Plan {
    let plan = planned(sheet, machine);
    assert_eq!(plan::check(sheet, machine, &plan), Ok(()));
    plan
}

#[test]
fn what_drops_is_cut_on_the_run_and_what_tips_is_not() {
    let mut b = plate(&[(20.0, 20.0)]);
    for k in 0..9 {
        let (column, row) = (f64::from(k % 3), f64::from(k / 3));
        b.cut(rectangle(p(20.0 + 15.0 * column, 100.0 + 15.0 * row), p(12.0, 12.0)), Some(0));
    }
    let [flying, avoiding] = machines(20.0);
    // Without tips, the sides of the nine squares are runs as well.
    let all = checked(&b.sheet, &flying).summary.fly_cuts;
    assert!(all > 3, "{all}");
    assert_eq!(checked(&b.sheet, &avoiding).summary.fly_cuts, 3);
}

#[test]
fn no_run_goes_over_a_piece_that_may_tip() {
    // Eight holes of 3 mm in a row, with a hole of 60 mm in the middle.
    let mut b = plate(&[(20.0, 100.0), (140.0, 100.0)]);
    b.cut(circle(p(89.0, 100.0), 30.0), Some(0));
    let [flying, avoiding] = machines(150.0);
    let over = planned(&b.sheet, &flying);
    assert_eq!(over.summary.fly_cuts, 7);
    assert_eq!(plan::check(&b.sheet, &flying, &over), Ok(()));
    let safe = checked(&b.sheet, &avoiding);
    assert_eq!(safe.summary.fly_cuts, 0, "a row that crosses it is cut hole by hole");

    // The same run after the large hole has been cut is found.
    let mut wrong = over.clone();
    let large = 9;
    let first =
        wrong.moves.iter().position(|m| matches!(m, plan::Move::Cut { contour, .. } if *contour == large));
    let is_run = |m: &plan::Move| matches!(m, plan::Move::Fly { .. });
    let (first, run) = (first.unwrap(), wrong.moves.iter().position(is_run).unwrap());
    if first > run {
        // Its cut and what leads to it, before everything.
        let begin = wrong.moves[..first].iter().rposition(|m| matches!(m, plan::Move::Air { .. })).unwrap();
        let cut: Vec<plan::Move> = wrong.moves.drain(begin..=first).collect();
        wrong.moves.splice(0..0, cut);
    }
    let found = plan::check(&b.sheet, &avoiding, &wrong).unwrap_err();
    let runs =
        |v: &&Violation| matches!(v, Violation::Tipped { what, contour: 9, .. } if what.contains("runs on"));
    assert_eq!(found.iter().filter(runs).count(), 1, "{found:?}");
}
