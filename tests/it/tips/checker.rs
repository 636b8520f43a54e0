//! What the checker says of wrong plans near tipped pieces.

use super::{all_tip, ignored, tipping};
use crate::testkit::exact::planned;
use crate::testkit::sheets::{Builder, nested_sheet, p, rectangle};
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::machine::{Levers, Profile};
use kerfway::plan::{self, Move, Plan, Violation, Way};
use kerfway::sheet::Sheet;
use kerfway::solve::{Solution, Stop};

/// The violations other than sums.
fn found(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Vec<Violation> {
    let all = plan::check(sheet, machine, plan).err().unwrap_or_default();
    all.into_iter().filter(|v| !matches!(v, Violation::Sum { .. })).collect()
}

/// Squares of 40 mm in a row, 10 mm apart.
fn row() -> Sheet {
    let mut b = Builder::new();
    for k in 0..5 {
        b.cut(rectangle(p(50.0 + 50.0 * f64::from(k), 50.0), p(40.0, 40.0)), None);
    }
    b.sheet
}

#[test]
fn moves_with_the_head_down_over_tipped_pieces_are_found() {
    let sheet = row();
    let machine = tipping(0.1, all_tip());
    let plan = planned(&sheet, &machine);
    assert_eq!(found(&sheet, &machine, &plan), []);
    assert!(plan.summary.lifts + plan.summary.detours > 0, "{:?}", plan.summary);
    // Each lift left out, and each way point, is a crossing.
    let mut wrong = 0;
    for (k, step) in plan.moves.iter().enumerate() {
        let mut other = plan.clone();
        match step {
            Move::Air { to, way: Way::Lifted } => other.moves[k] = Move::air(*to),
            Move::Air { way: Way::Around, .. } => {
                other.moves.remove(k);
            }
            _ => continue,
        }
        let violations = found(&sheet, &machine, &other);
        let tipped =
            |v: &&Violation| matches!(v, Violation::Tipped { what, .. } if what.contains("down over"));
        assert_eq!(violations.iter().filter(tipped).count(), violations.len(), "{violations:?}");
        wrong += violations.len();
    }
    assert!(wrong > 0);
}

#[test]
fn what_a_machine_does_not_ask_for_is_found() {
    let sheet = row();
    let machine = tipping(0.1, all_tip());
    let plan = planned(&sheet, &machine);
    let without = Profile { levers: Levers { tips: None, ..machine.levers }, ..machine.clone() };
    let violations = found(&sheet, &without, &plan);
    assert!(violations.iter().all(|v| matches!(v, Violation::Unasked { .. })) && !violations.is_empty());
    // Ignored: crossings have to be marked, and nothing else may be.
    let mut ignoring = tipping(0.1, all_tip());
    ignoring.levers.tips = ignoring.levers.tips.map(ignored);
    ignoring.levers.lift = None;
    let plan = planned(&sheet, &ignoring);
    assert_eq!(found(&sheet, &ignoring, &plan), []);
    assert!(plan.summary.crossings > 0);
    for k in 0..plan.moves.len() {
        let mut other = plan.clone();
        let Move::Air { to, way } = other.moves[k] else { continue };
        // The move from home crosses nothing; near a piece the checker does not say which moves may be called risky.
        if way == Way::Plain && k > 0 {
            continue;
        }
        let turned = if way == Way::Crosses { Way::Plain } else { Way::Crosses };
        other.moves[k] = Move::Air { to, way: turned };
        let violations = found(&sheet, &ignoring, &other);
        assert!(
            matches!(violations[..], [Violation::Tipped { step, .. }] if step == k),
            "{k}: {violations:?}"
        );
    }
}

#[test]
fn plans_of_nested_sheets_pass() {
    for seed in 0..6 {
        let sheet = nested_sheet(30, seed);
        for lift in [0.05, 0.5, 5.0] {
            let machine = tipping(lift, all_tip());
            let plan = planned(&sheet, &machine);
            assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()), "{seed} {lift}");
        }
    }
}

/// The checker took a move that begins 0.07 mm inside a piece for one that begins beside it and goes over it.
#[test]
fn a_move_may_begin_a_little_inside_a_tipped_piece() {
    let mut b = Builder::new();
    b.cut(rectangle(p(100.0, 40.0), p(40.0, 40.0)), None);
    // Its left side is 0.07 mm inside the first square.
    b.cut(rectangle(p(139.93, 50.0), p(20.0, 20.0)), None);
    b.cut(rectangle(p(20.0, 50.0), p(20.0, 20.0)), None);
    let machine = tipping(0.1, all_tip());
    let problem = problem_of(&b.sheet, &machine);
    let node_at = |item: usize, place: DVec2| {
        let known = |n: &u32| problem.nodes[*n as usize].entry.distance(place) < 1e-9;
        problem.items[item].nodes.clone().find(known).unwrap()
    };
    let nodes = [problem.items[0].nodes.start, node_at(1, p(139.93, 50.0)), node_at(2, p(40.0, 50.0))];
    let stops = nodes.map(|n| Stop::at(&problem, n)).to_vec();
    let plan = plan::from_solution(&b.sheet, &problem, &Solution::new(&problem, stops));
    let over =
        |m: &&Move| matches!(m, Move::Air { to, way: Way::Plain } if to.distance(p(40.0, 50.0)) < 1e-9);
    assert!(plan.moves.iter().any(|m| over(&m)), "{:?}", plan.moves);
    assert_eq!(found(&b.sheet, &machine, &plan), []);
}
