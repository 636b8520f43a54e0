//! Skeleton cuts that begin at the edge of the sheet and on each other, without piercing (`levers.chains.edge_starts`).

use super::*;
use crate::testkit::dialects::read_back;
use kerfway::geometry::{DVec2, Segment};
use kerfway::job::{BestPath, MachineChoice, PlanOptions, WarmPath};
use kerfway::machine::{AirTime, Chains, Levers, cut_time};
use kerfway::plan::{Violation, check, evaluate};
use kerfway::sheet::Sheet;

fn machine(edge_starts: bool) -> Profile {
    let chains = Some(Chains { reach: 15.0, clearance: 1.0, edge_starts });
    Profile {
        skeleton: Some(grid(100.0, 100.0)),
        bed: Some([0.0, 0.0, 300.0, 200.0]),
        levers: Levers { chains, ..Levers::default() },
        ..preset("fibre-6kw-thick").unwrap()
    }
}

/// A plan for a disc on a sheet of 300 x 200 mm, whose edge is drawn or is the bed.
fn solved(drawn: bool, machine: &Profile) -> (Sheet, Plan) {
    let sheet = if drawn { rectangle("PLATE", [0.0, 0.0, 300.0, 200.0]) } else { String::new() };
    let job = started(drawing(&[circle([150.0, 100.0, 30.0]), sheet]), machine.clone()).unwrap();
    let (sheet, plan) = (job.beam_sheet().clone(), job.plan().unwrap());
    assert_eq!(check(&sheet, machine, &plan), Ok(()));
    (sheet, plan)
}

/// What the checker says of a plan with other moves.
fn checked(sheet: &Sheet, machine: &Profile, plan: &Plan, moves: Vec<Move>) -> Vec<Violation> {
    let mut summary = evaluate(&moves, sheet, machine);
    summary.parts = plan.summary.parts;
    check(sheet, machine, &Plan { moves, summary, bridges: Vec::new() }).err().unwrap_or_default()
}

fn says(found: &[Violation], wanted: &str) -> bool {
    found.iter().any(|v| matches!(v, Violation::Beam { what, .. } if *what == wanted))
}

/// Least seconds in which all these lines are cut from `head`, and the head goes home. `on_edge`: whether nothing is pierced at a place.
fn least(
    machine: &Profile,
    lines: &[[DVec2; 2]],
    on_edge: &dyn Fn(DVec2) -> bool,
    left: u32,
    head: DVec2,
) -> f64 {
    let air = AirTime::new(machine);
    if left == 0 {
        return air.seconds(head, machine.home());
    }
    let delays = machine.beam_on_delay + machine.beam_off_delay;
    let cut = |a: DVec2, b: DVec2| delays + cut_time(machine, &machine.cut, &[Segment::line(a, b)]);
    let mut best = f64::INFINITY;
    for (k, line) in lines.iter().enumerate().filter(|(k, _)| left >> k & 1 == 1) {
        for [a, b] in [*line, [line[1], line[0]]] {
            let mut go = |from: DVec2, seconds: f64| {
                let rest = least(machine, lines, on_edge, left & !(1 << k), b);
                best = best.min(air.seconds(head, from) + seconds + rest);
            };
            go(a, if on_edge(a) { 0.0 } else { machine.pierce_time } + cut(a, b));
            // From where a line that is cut already crosses it, to one end, back, and to the other.
            for (_, [c, d]) in lines.iter().enumerate().filter(|(o, _)| left >> o & 1 == 0) {
                let upright = (a.x - b.x).abs() < 1e-9;
                if ((c.x - d.x).abs() < 1e-9) == upright {
                    continue;
                }
                let at = if upright { DVec2::new(a.x, c.y) } else { DVec2::new(c.x, a.y) };
                let on = |a: DVec2, b: DVec2| at.distance(a) + at.distance(b) - a.distance(b) < 1e-9;
                if on(a, b) && on(*c, *d) {
                    go(at, cut(at, a) + air.seconds(a, at) + cut(at, b));
                }
            }
        }
    }
    best
}

#[test]
fn skeleton_cuts_begin_at_the_edge_and_on_each_other() {
    for drawn in [true, false] {
        let machine = machine(true);
        let (sheet, plan) = solved(drawn, &machine);
        let lines: Vec<[DVec2; 2]> = sheet
            .contours
            .iter()
            .filter(|c| c.skeleton)
            .map(|c| [c.path.start().unwrap(), c.path.end().unwrap()])
            .collect();
        assert_eq!(lines.len(), 4);
        // The disc, and the two upright cuts if nothing is known of the edge: each level one crosses one of them.
        assert_eq!(plan.summary.pierces, if drawn { 1 } else { 3 }, "{:?}", plan.summary);
        assert_eq!(plan.summary.skeleton_cuts, 4);
        // Exhaustive choice of what comes after the disc.
        let is_disc = |m: &Move| matches!(m, Move::Cut { contour: 0, .. });
        let end = plan.moves.iter().position(is_disc).unwrap();
        let head = plan.moves[end].end().unwrap();
        let on_edge =
            |at: DVec2| drawn && (at.x.min(at.y) < 1e-9 || at.x > 300.0 - 1e-9 || at.y > 200.0 - 1e-9);
        let rest = least(&machine, &lines, &on_edge, 15, head);
        let before = evaluate(&plan.moves[..=end], &sheet, &machine).total_time;
        let found = plan.summary.total_time - before;
        assert!((found - rest).abs() < 1e-6, "{found} {rest}");
        assert_eq!(solved(drawn, &self::machine(false)).1.summary.pierces, 5);
    }
}

#[test]
fn a_cut_from_a_crossing_is_played_as_two_stops_and_read_again() {
    let machine = machine(true);
    let mut job = started(drawing(&[circle([150.0, 100.0, 30.0])]), machine.clone()).unwrap();
    let (path, plan) = BestPath::of(job.run().unwrap(), job.beam_sheet());
    // The disc and two upright cuts; each of the two level ones begins at a crossing, and is cut to both of its ends.
    assert_eq!(path.contours.len(), 1 + 2 + 2 * 2);
    let cuts: Vec<[DVec2; 2]> = plan
        .moves
        .iter()
        .filter_map(|m| match m {
            Move::Cut { path, .. } => Some([path[0].start(), m.end()?]),
            _ => None,
        })
        .collect();
    assert_eq!(cuts.len(), path.contours.len());
    for (k, [from, to]) in cuts.iter().enumerate().skip(1) {
        let line = &job.beam_sheet().contours[path.contours[k] as usize].path;
        assert_eq!(&path.points[4 * k..4 * k + 4], [from.x, from.y, to.x, to.y]);
        if (path.along[k] - path.until[k]).abs() > 1e-9 {
            assert!(line.at(path.along[k]).unwrap().distance(*from) < 1e-9, "{k}");
            assert!(line.at(path.until[k]).unwrap().distance(*to) < 1e-9, "{k}");
            assert_eq!(path.reversed[k] == 1, path.until[k] < path.along[k]);
        }
        // What lies between two cuts is what their moves take.
        let end = |k: usize| {
            plan.moves.iter().enumerate().filter(|m| matches!(m.1, Move::Cut { .. })).nth(k).unwrap().0
        };
        let off = machine.beam_off_delay;
        let seconds = evaluate(&plan.moves[..=end(k)], job.beam_sheet(), &machine).total_time - off;
        assert!((path.times[2 * k + 1] - seconds).abs() < 1e-9, "{k}: {} {seconds}", path.times[2 * k + 1]);
    }
    let BestPath { contours, along, until, reversed, .. } = path.clone();
    let warm = Some(WarmPath { contours, along, until, reversed });
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, warm, ..PlanOptions::default() }).unwrap();
    let again = BestPath::of(job.run().unwrap(), job.beam_sheet());
    assert_eq!(again, (path, plan));
}

#[test]
fn the_checker_finds_wrong_starts_of_skeleton_cuts() {
    let machine = machine(true);
    let (sheet, plan) = solved(false, &machine);
    assert_eq!(checked(&sheet, &machine, &plan, plan.moves.clone()), []);
    let is_skeleton = |m: &Move| matches!(m, Move::Cut { contour, .. } if *contour > 0);
    let first = plan.moves.iter().position(is_skeleton).unwrap();
    // The first one is not pierced.
    let mut moves = plan.moves.clone();
    assert_eq!(moves.remove(first - 1), Move::Pierce);
    let found = checked(&sheet, &machine, &plan, moves);
    assert!(says(&found, "cuts without piercing"), "{found:?}");
    // The one on which another begins comes last.
    let mut moves = plan.moves.clone();
    let home = moves.pop().unwrap();
    let one: Vec<Move> = moves.drain(first - 2..=first).collect();
    moves.extend(one);
    moves.push(home);
    let found = checked(&sheet, &machine, &plan, moves);
    assert!(says(&found, "cuts without piercing"), "{found:?}");
    // Without the lever.
    let found = checked(&sheet, &self::machine(false), &plan, plan.moves.clone());
    assert!(says(&found, "cuts without piercing"), "{found:?}");
    // Half of one is left out.
    let twice = plan.moves.windows(3).position(|w| match w {
        [Move::Cut { contour: a, .. }, Move::Air { .. }, Move::Cut { contour: b, .. }] => a == b,
        _ => false,
    });
    let at = twice.unwrap();
    let mut moves = plan.moves.clone();
    moves.drain(at + 1..at + 3);
    let found = checked(&sheet, &machine, &plan, moves);
    assert!(says(&found, "does not cut a skeleton cut from end to end"), "{found:?}");
}

#[test]
fn skeleton_cuts_that_begin_on_kerfs_are_written_in_every_dialect() {
    for drawn in [true, false] {
        read_back(
            &machine(true),
            |machine| solved(drawn, machine),
            1,
            |dialect, plan, _| {
                assert_eq!(plan.summary.pierces, if drawn { 1 } else { 3 }, "{dialect}");
            },
        );
    }
}
