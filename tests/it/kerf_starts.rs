//! Starts without piercing (`levers.chains.edge_starts`) on the kerf of any contour that was cut before: what they save, and
//! what the checker says of plans that begin where there is no kerf yet.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

use super::chains::{brute, chaining, says, searched, squares, starting};
use crate::testkit::dialects::read_back;
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, XorShift, circle, p, rectangle};
use kerfway::geometry::Segment;
use kerfway::job::problem_of;
use kerfway::machine::{AirTime, LeadKind, Lift, Profile};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::Sheet;
use kerfway::solve;

#[test]
fn the_search_chooses_as_well_as_every_start_on_a_kerf() {
    let (mut joined, mut on_kerfs) = (0, 0);
    for seed in 0..8_u64 {
        let mut rng = XorShift::new(50 + seed);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(10.0 + 27.0 * f64::from(k), 10.0 + rng.between(0.0, 6.0));
            if rng.below(3) == 0 {
                b.cut(circle(at + p(10.0, 10.0), rng.between(7.0, 9.0)), None);
            } else {
                b.cut(rectangle(at, p(rng.between(14.0, 20.0), rng.between(10.0, 20.0))), None);
            }
        }
        let machine = starting(25.0, rng.between(0.2, 2.0));
        let sheet = oriented(b.sheet);
        let (problem, exact, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let least = brute(&sheet, &machine, &problem, 0.25);
        let most = brute(&sheet, &machine, &problem, 0.375);
        // Contours that are not joined to others are entered anywhere by the search, and at their nodes here.
        let at_nodes = exact + problem.items.iter().map(|i| i.fixed).sum::<f64>();
        assert!(
            least <= at_nodes + 1e-6 && at_nodes <= most + 1e-6,
            "seed {seed}: {least} {at_nodes} {most}"
        );
        assert!(plan.summary.total_time <= at_nodes + 1e-6, "seed {seed}");
        joined += plan.summary.chains;
        on_kerfs += plan.summary.edge_starts;
    }
    assert!(joined > 16 && on_kerfs > 4, "{joined} {on_kerfs}");
}

#[test]
fn the_checker_finds_wrong_starts_on_kerfs() {
    let machine = starting(30.0, 1.0);
    let (sheet, plan) = searched(squares(4, 1, 8.0), &machine);
    let start = |moves: &[Move]| {
        let is = |w: &[Move]| matches!(w, [Move::Air { .. }, Move::Chain { .. }]);
        moves.windows(2).position(is).unwrap()
    };
    let after = |checked: &Profile, change: &dyn Fn(&mut Vec<Move>)| {
        let mut plan = plan.clone();
        change(&mut plan.moves);
        let parts = plan.summary.parts;
        plan.summary = plan::evaluate(&plan.moves, &sheet, checked);
        plan.summary.parts = parts;
        plan::check(&sheet, checked, &plan).err().unwrap_or_default()
    };
    assert!(after(&machine, &|_| ()).is_empty());
    assert!(says(&after(&chaining(30.0, 1.0), &|_| ()), "begins on a kerf, which the machine does not"));
    // A millimetre beside the kerf.
    let found = after(&machine, &|moves| {
        let at = start(moves);
        let Move::Chain { path } = &mut moves[at + 1] else { panic!() };
        let from = path[0].at(0.125);
        path[0] = Segment::line(from, path[0].end());
        moves[at] = Move::air(from);
    });
    assert!(says(&found, "does not begin on a kerf"), "{found:?}");
    // Pierced before it.
    let found = after(&machine, &|moves| moves.insert(start(moves) + 1, Move::Pierce));
    assert!(says(&found, "cuts through waste without a cut before it"), "{found:?}");
    // Before anything is cut.
    let found = after(&machine, &|moves| {
        let at = start(moves);
        let two: Vec<Move> = moves.drain(at..at + 2).collect();
        moves.splice(0..0, two);
    });
    assert!(says(&found, "does not join two cuts"), "{found:?}");
}

/// Parts with a hole each in columns and rows, this far apart.
fn parts(columns: u32, rows: u32, gap: f64) -> Builder {
    let mut b = squares(columns, rows, gap);
    for k in 0..columns * rows {
        let at = p(f64::from(k % columns), f64::from(k / columns)) * (20.0 + gap) + p(20.0, 20.0);
        b.cut(circle(at, 4.0), Some(k));
    }
    b
}

/// A bar with squares above it that are out of each other's reach.
fn comb(squares: u32, gap: f64) -> Builder {
    let mut b = Builder::new();
    b.cut(rectangle(p(10.0, 10.0), p(50.0 * f64::from(squares), 12.0)), None);
    for k in 0..squares {
        b.cut(rectangle(p(20.0 + 50.0 * f64::from(k), 22.0 + gap), p(16.0, 16.0)), None);
    }
    b
}

fn starts(plan: &Plan) -> Vec<usize> {
    let is = |w: &[Move]| matches!(w, [Move::Air { .. }, Move::Chain { .. }]);
    plan.moves.windows(2).enumerate().filter(|w| is(w.1)).map(|w| w.0 + 1).collect()
}

#[test]
fn parts_with_holes_begin_on_each_others_kerfs() {
    for (columns, rows) in [(2, 1), (3, 1), (3, 2), (3, 3), (6, 5)] {
        let machine = starting(30.0, 1.0);
        let sheet = oriented(parts(columns, rows, 8.0).sheet);
        let problem = problem_of(&sheet, &machine);
        let mut search = solve::start(solve::methods()[0], &problem, 1, None);
        search.step(100_000);
        let plan = plan::from_solution(&sheet, &problem, search.best());
        assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
        let all = columns * rows;
        // Every hole is pierced, and one outline.
        assert_eq!((plan.summary.pierces, plan.summary.chains), (all + 1, all - 1), "{columns} x {rows}");
        // The search knows the seconds of the plan.
        let known = search.best().cost + problem.items.iter().map(|i| i.fixed).sum::<f64>();
        assert!((plan.summary.total_time - known).abs() < 1e-6, "{} {known}", plan.summary.total_time);
    }
}

#[test]
fn every_order_entry_and_kerf_is_no_better() {
    let (mut on_kerfs, mut earlier) = (0, 0);
    for seed in 0..10_u64 {
        let mut rng = XorShift::new(900 + seed);
        let mut b = Builder::new();
        b.cut(rectangle(p(10.0, 10.0), p(150.0, rng.between(8.0, 14.0))), None);
        for k in 0..3 {
            let at = p(20.0 + 50.0 * f64::from(k) + rng.between(-5.0, 5.0), rng.between(30.0, 34.0));
            if rng.below(3) == 0 {
                b.cut(circle(at + p(8.0, 8.0), rng.between(6.0, 8.0)), None);
            } else {
                b.cut(rectangle(at, p(rng.between(10.0, 16.0), rng.between(10.0, 16.0))), None);
            }
        }
        let machine = starting(25.0, rng.between(0.2, 2.0));
        let sheet = oriented(b.sheet);
        let (problem, exact, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let (least, most) =
            (brute(&sheet, &machine, &problem, 0.25), brute(&sheet, &machine, &problem, 0.375));
        let at_nodes = exact + problem.items.iter().map(|i| i.fixed).sum::<f64>();
        assert!(
            least <= at_nodes + 1e-6 && at_nodes <= most + 1e-6,
            "seed {seed}: {least} {at_nodes} {most}"
        );
        assert!(plan.summary.total_time <= at_nodes + 1e-6, "seed {seed}");
        on_kerfs += plan.summary.edge_starts;
        let last = |k: usize| {
            plan.moves[..k]
                .iter()
                .rev()
                .find_map(|m| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None })
        };
        let from_earlier = |k: &usize| {
            let Move::Chain { path } = &plan.moves[*k] else { return false };
            let known = &sheet.contours[last(*k).unwrap() as usize].path;
            known.segments.iter().all(|s| s.nearest(path[0].start()).1 > 1e-12)
        };
        earlier += starts(&plan).iter().filter(|k| from_earlier(k)).count();
    }
    assert!(on_kerfs >= 8 && earlier >= 6, "{on_kerfs} {earlier}");
}

/// What the checker says of a plan with other moves.
fn checked(sheet: &Sheet, machine: &Profile, plan: &Plan, moves: Vec<Move>) -> Vec<Violation> {
    let mut summary = plan::evaluate(&moves, sheet, machine);
    summary.parts = plan.summary.parts;
    plan::check(sheet, machine, &Plan { moves, summary, bridges: Vec::new() }).err().unwrap_or_default()
}

#[test]
fn a_kerf_that_is_cut_later_is_none() {
    let machine = starting(25.0, 1.0);
    let (sheet, plan) = searched(comb(3, 8.0), &machine);
    assert_eq!((plan.summary.pierces, plan.summary.chains, plan.summary.edge_starts), (1, 3, 2));
    // The last square, with the moves that lead to it, comes first.
    let at = *starts(&plan).last().unwrap();
    let mut moves = plan.moves.clone();
    let three: Vec<Move> = moves.drain(at - 1..=at + 1).collect();
    moves.splice(0..0, three);
    let found = checked(&sheet, &machine, &plan, moves);
    assert!(says(&found, "begins on a kerf that is cut later"), "{found:?}");
    assert_eq!(found.len(), 1, "{found:?}");
}

#[test]
fn leads_begin_on_kerfs_too() {
    for kind in [LeadKind::Line, LeadKind::Arc] {
        let machine = with_leads(starting(30.0, 1.0), leads(kind, 1.0, 0.5));
        let (_, plan) = searched(comb(3, 14.0), &machine);
        assert!(plan.summary.edge_starts >= 2 && plan.summary.pierces == 1, "{kind:?} {:?}", plan.summary);
        assert!(plan.summary.lead_length > 0.0);
        // Where contours end with a gap, there may be no kerf.
        let gap = with_leads(starting(30.0, 1.0), leads(kind, 1.0, -0.5));
        let (_, plan) = searched(comb(3, 14.0), &gap);
        assert_eq!(plan.summary.edge_starts, 0, "{kind:?}");
    }
}

#[test]
fn every_dialect_begins_there_without_piercing() {
    let machine = starting(30.0, 1.0);
    let planned = |machine: &Profile| searched(comb(3, 8.0), machine);
    read_back(&machine, planned, 4, |dialect, plan, text| {
        assert_eq!((plan.summary.pierces, plan.summary.edge_starts), (1, 2), "{dialect}");
        let starts = |text: &str| text.matches("from a kerf or an edge through waste for ").count();
        assert!(text.is_none_or(|text| starts(text) == 2), "{dialect}");
    });
}

/// The head may stay down on the way to the kerf of the bar, and be lifted on the way to the next square.
#[test]
fn what_starts_may_save_counts_a_lift_that_is_not_needed() {
    let mut machine = starting(6.0, 1.0);
    machine.z_speed = Some(5.0);
    machine.levers.lift = Some(Lift { height: 10.0, stay_down: 36.0, at_rest: true });
    let problem = problem_of(&oriented(comb(2, 4.0).sheet), &machine);
    let air = AirTime::new(&machine);
    let mut most = f64::NEG_INFINITY;
    for (node, to) in (0..).zip(&problem.nodes) {
        for start in problem.starts.of(node) {
            for before in problem.nodes.iter().filter(|before| before.item != to.item) {
                let pierced = air.seconds(before.exit, to.entry);
                most = most.max(pierced - air.seconds(before.exit, start.from) - start.seconds);
            }
        }
    }
    // Twice 10 mm at 5 mm/s, besides piercing.
    assert!(most > 4.0 && problem.most_saved() >= most, "{} of {most}", problem.most_saved());
}
