//! Plans that leave contours unfinished and resume them.
#![allow(clippy::unwrap_used, clippy::panic, clippy::type_complexity, reason = "helpers of tests")]

use super::planted::sheet;
use crate::testkit::sheets::{machine, p};
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Stop};

/// A machine that leaves contours for a pre-cut of 0.3 s, and the sheet on it: the plate is left for its hole and its
/// slot, and again for the ring. The ring is left for its hole, and the hole for the part in it.
fn left(sheet: &Sheet) -> (Profile, Plan) {
    let machine = Profile { pre_cut_time: Some(0.3), ..machine("co2-100w") };
    let problem = problem_of(sheet, &machine);
    let node = |item: usize| problem.items[item].nodes.start;
    let whole = |item| Stop::at(&problem, node(item));
    let stretch = |item, along, until| Stop { node: node(item), along, until };
    let stops = vec![
        whole(3),
        stretch(0, 5.0, 40.0),
        whole(1),
        whole(2),
        stretch(0, 40.0, 190.0),
        stretch(5, 0.0, 30.0),
        stretch(6, 90.0, 50.0),
        whole(7),
        stretch(6, 50.0, 90.0),
        stretch(5, 30.0, 0.0),
        whole(4),
        stretch(0, 190.0, 5.0),
    ];
    let solution = solve::Solution::new(&problem, stops);
    let plan = plan::from_solution(sheet, &problem, &solution);
    // What the search counts, with the stops on the way, and what each contour takes anyhow are the whole job.
    let fixed: f64 = problem.items.iter().map(|item| item.fixed).sum();
    let (cost, total) = (solution.cost, plan.summary.total_time);
    assert!((fixed + cost - total).abs() < 1e-9 * total, "{fixed} {cost} {total}");
    (machine, plan)
}

#[test]
fn interrupted_contours_pass_if_the_machine_allows_them() {
    let sheet = sheet();
    let (machine, plan) = left(&sheet);
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    let s = &plan.summary;
    assert_eq!((s.contours, s.open_contours, s.pierces, s.pre_cuts), (8, 2, 7, 4));
    assert!((s.pre_cut_time - 1.2).abs() < 1e-12);
    // Free of charge there are no pre-cuts.
    let free = Profile { pre_cut_time: Some(0.0), ..machine };
    let mut moves = plan.moves.clone();
    moves.retain(|m| !matches!(m, Move::PreCut { .. }));
    let parts = s.parts;
    let mut summary = plan::evaluate(&moves, &sheet, &free);
    summary.parts = parts;
    assert_eq!(plan::check(&sheet, &free, &Plan { moves, summary, bridges: Vec::new() }), Ok(()));
}

#[test]
fn contours_interrupted_where_that_is_forbidden() {
    let sheet = sheet();
    let (machine, plan) = left(&sheet);
    let found = plan::check(&sheet, &Profile { pre_cut_time: None, ..machine }, &plan).unwrap_err();
    for id in [0, 5, 6] {
        let told =
            found.iter().filter(|v| matches!(v, Violation::Left { contour, .. } if *contour == id)).count();
        assert_eq!(told, if id == 0 { 2 } else { 1 });
    }
}

#[test]
fn faults_of_interrupted_contours() {
    let sheet = sheet();
    let (machine, good) = left(&sheet);
    let after = |change: &dyn Fn(&mut Vec<Move>)| {
        let mut plan = good.clone();
        change(&mut plan.moves);
        plan.summary = plan::evaluate(&plan.moves, &sheet, &machine);
        plan.summary.parts = good.summary.parts;
        plan::check(&sheet, &machine, &plan).unwrap_err()
    };
    let beam = |found: &[Violation], words: &str| {
        assert!(
            found.iter().any(|v| matches!(v, Violation::Beam { what, .. } if *what == words)),
            "{found:?}"
        );
    };
    let cuts = |moves: &[Move], id: u32| -> Vec<usize> {
        let of = |m: &Move| matches!(m, Move::Cut { contour, .. } if *contour == id);
        (0..moves.len()).filter(|&k| of(&moves[k])).collect()
    };
    // Without its pre-cut a contour may not be resumed; with one it is not pierced again.
    beam(&after(&|m| drop(m.remove(cuts(m, 6)[0] + 1))), "cuts without piercing");
    beam(&after(&|m| m.insert(cuts(m, 6)[1], Move::Pierce)), "pierces where it goes on with a cut");
    beam(
        &after(&|m| m.insert(cuts(m, 7)[0] + 1, Move::PreCut { contour: 7, to: p(0.0, 0.0), ahead: vec![] })),
        "makes a pre-cut where it leaves nothing unfinished",
    );
    // The last stretch of the plate is never cut.
    let found = after(&|m| drop(m.remove(cuts(m, 0)[2])));
    assert!(found.iter().any(|v| matches!(v, Violation::Partly { contour: 0, .. })), "{found:?}");
    // Two stretches in the wrong order.
    let found = after(&|m| {
        let at = cuts(m, 0);
        m.swap(at[1], at[2]);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Strays { contour: 0, .. })), "{found:?}");
    // The ring is continued while its hole is unfinished: the visits cross, and the part inside comes after the ring.
    let found = after(&|m| {
        let (hole, ring) = (cuts(m, 6)[1], cuts(m, 5)[1]);
        m.swap(hole, ring);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Crossed { contour: 5, inner: 6, .. })), "{found:?}");
    assert!(found.contains(&Violation::CutFree { outer: 5, inner: 6 }), "{found:?}");
}
