//! Cuts on the run (`levers.fly`): what they save, how rows and grids are cut, and what the checker says of plans that do it wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]
#![allow(clippy::print_stdout, reason = "the figures of docs/levers.md")]

use crate::testkit::exact::{planned, search_of_exact_cost};
use crate::testkit::gcode;
use crate::testkit::grbl_planner::{self, Machine, Settings};
use crate::testkit::paths::Element;
use crate::testkit::sheets::{Builder, circle, line, machine, p, polygon, rectangle, slot};
use kerfway::geometry::{DVec2, Path, Segment, math};
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{
    AirTime, Fly, JointRule, Joints, LeadKind, LeadRule, LeadShape, Leads, Levers, MovingPierce, Process,
    Profile, Start, cut_time,
};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::Sheet;
use std::f64::consts::{PI, TAU};

fn flying(reach: f64, overcut: f64) -> Profile {
    let levers = Levers { fly: Some(Fly { reach, overcut }), ..Levers::default() };
    Profile { levers, ..machine("fibre-3kw-thin") }
}

/// A plate with holes at the places of a grid, the first at 20, 20. `turn` turns all of it, rad.
fn plate(columns: u32, rows: u32, pitch: f64, turn: f64, hole: impl Fn(DVec2, f64) -> Path) -> Sheet {
    let mut b = Builder::new();
    let u = math::unit(turn);
    let size = p(40.0 + pitch * f64::from(columns), 40.0 + pitch * f64::from(rows));
    let corners = [p(0.0, 0.0), p(size.x, 0.0), size, p(0.0, size.y)].map(|c| u.rotate(c));
    let outer = b.cut(polygon(&corners), None);
    for row in 0..rows {
        for column in 0..columns {
            let at = p(20.0 + pitch * f64::from(column), 20.0 + pitch * f64::from(row));
            b.cut(hole(u.rotate(at), turn), Some(outer));
        }
    }
    b.sheet
}

fn round(at: DVec2, _: f64) -> Path {
    circle(at, 1.5)
}

fn square(at: DVec2, turn: f64) -> Path {
    let u = math::unit(turn);
    polygon(&[p(0.0, 0.0), p(10.0, 0.0), p(10.0, 10.0), p(0.0, 10.0)].map(|c| at + u.rotate(c)))
}

fn checked(sheet: &Sheet, machine: &Profile) -> Plan {
    let plan = planned(sheet, machine);
    assert_eq!(plan::check(sheet, machine, &plan), Ok(()));
    plan
}

#[track_caller]
fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

#[test]
fn a_row_of_round_holes_is_one_motion_along_its_tangent() {
    let machine = flying(20.0, 0.0);
    let plan = checked(&plate(4, 1, 6.0, 0.0, round), &machine);
    let s = &plan.summary;
    assert_eq!((s.fly_cuts, s.moving_starts, s.pierces), (3, 1, 1));
    let first = plan.moves.iter().position(|m| *m == Move::MovingStart).unwrap();
    let row = &plan.moves[first + 1..first + 8];
    let mut motion: Vec<Segment> = Vec::new();
    for (k, m) in row.iter().enumerate() {
        match m {
            Move::Cut { path, .. } if k % 2 == 0 => {
                assert!((path.iter().map(Segment::length).sum::<f64>() - 3.0 * PI).abs() < 1e-9);
                motion.extend(path);
            }
            Move::Fly { path } if k % 2 == 1 => {
                assert_eq!(path.len(), 1);
                near(path[0].length(), 6.0, 1e-9);
                // On the line that touches the holes, above or below them.
                near((path[0].start().y - 20.0).abs(), 1.5, 1e-9);
                motion.extend(path);
            }
            other => panic!("{k}: {other:?}"),
        }
    }
    // Straight on at every join, so only the ends slow the head down.
    for pair in motion.windows(2) {
        assert!(pair[0].tangent(1.0).dot(pair[1].tangent(0.0)) > 1.0 - 1e-9);
    }
    let outline = plan.moves.iter().find_map(|m| match m {
        Move::Cut { contour: 0, path, .. } => Some(cut_time(&machine, &machine.cut, path)),
        _ => None,
    });
    near(s.cut_time, cut_time(&machine, &machine.cut, &motion) + outline.unwrap(), 1e-9);
    near(s.pierce_time, machine.pierce_time + machine.beam_on_delay + 2.0 * machine.beam_off_delay, 1e-12);
}

#[test]
fn a_row_is_found_from_either_side() {
    // Discs of four sizes that hang from one line, and two outlines of ten sides that lean towards each other.
    let hung = |turned: bool| {
        let mut b = Builder::new();
        for (k, r) in [2.0, 3.0, 1.5, 2.5].into_iter().enumerate() {
            b.cut(circle(p(10.0 * k as f64, if turned { r } else { -r }), r), None);
        }
        b.sheet
    };
    let lean = |turned: bool| {
        let points = [
            p(-3.0, 0.0),
            p(3.0, 0.0),
            p(5.5, 5.0),
            p(8.0, 10.0),
            p(10.0, 15.0),
            p(11.0, 20.0),
            p(5.0, 20.0),
            p(3.0, 15.0),
            p(1.0, 10.0),
            p(-1.5, 5.0),
        ];
        let mut b = Builder::new();
        let shape = |mirrored: bool| {
            let mut all: Vec<DVec2> =
                points.iter().map(|q| if mirrored { p(30.0 - q.x, q.y) } else { *q }).collect();
            all.iter_mut().filter(|_| turned).for_each(|q| *q = -*q);
            if mirrored {
                all.reverse();
            }
            polygon(&all)
        };
        b.cut(shape(false), None);
        b.cut(shape(true), None);
        b.sheet
    };
    for turned in [false, true] {
        let machine = flying(20.0, 0.0);
        let found = [hung(turned), lean(turned)].map(|sheet| checked(&sheet, &machine).summary);
        assert_eq!(
            found.each_ref().map(|s| (s.moving_starts, s.fly_cuts)),
            [(1, 3), (1, 1)],
            "turned: {turned}"
        );
    }
}

#[test]
fn an_overcut_is_cut_on_the_run() {
    let machine = flying(20.0, 0.4);
    let plan = checked(&plate(5, 2, 6.0, 0.0, round), &machine);
    assert_eq!(plan.summary.fly_cuts, 8);
    near(plan.summary.lead_length, 10.0 * 0.4, 1e-9);
}

#[test]
fn a_grid_of_squares_is_cut_line_by_line() {
    let sheet = plate(6, 5, 20.0, 0.0, square);
    let machine = flying(15.0, 0.0);
    let plan = checked(&sheet, &machine);
    // 10 lines with 6 sides along x, and 12 with 5 along y: each line is one start.
    assert_eq!((plan.summary.moving_starts, plan.summary.fly_cuts), (22, 10 * 5 + 12 * 4));
    let sides = plan.moves.iter().filter(|m| matches!(m, Move::Cut { path, .. } if path.len() == 1)).count();
    assert_eq!(sides, 4 * 30);
    near(plan.summary.cut_length, 30.0 * 40.0 + sheet.contours[0].length, 1e-6);
    let one_by_one = planned(&sheet, &crate::testkit::sheets::machine("fibre-3kw-thin")).summary.total_time;
    assert!(plan.summary.total_time < 0.6 * one_by_one, "{} of {one_by_one}", plan.summary.total_time);
    // Nearer than the gaps, nothing is flown.
    assert_eq!(checked(&sheet, &flying(9.0, 0.0)).summary.fly_cuts, 0);
}

#[test]
fn slots_in_a_line_and_outlines_in_a_row_are_flown() {
    let slots = plate(8, 3, 20.0, 0.0, |at, _| slot(at, 10.0, 2.0));
    assert_eq!(checked(&slots, &flying(25.0, 0.0)).summary.fly_cuts, 3 * 7);
    let mut b = Builder::new();
    for k in 0..5 {
        b.cut(slot(p(50.0, 20.0 * f64::from(k)), 10.0, 2.0), None);
    }
    // Beside each other, slots are flown by their round ends.
    assert_eq!(checked(&b.sheet, &flying(25.0, 0.0)).summary.fly_cuts, 4);
}

#[test]
fn a_turned_sheet_is_flown_as_one_that_is_not() {
    for (hole, reach) in [(round as fn(DVec2, f64) -> Path, 10.0), (square, 15.0)] {
        let pitch = if reach < 12.0 { 6.0 } else { 20.0 };
        let straight = checked(&plate(5, 4, pitch, 0.0, hole), &flying(reach, 0.0)).summary;
        for turn in [0.3, 1.0, 2.5] {
            let turned = checked(&plate(5, 4, pitch, turn, hole), &flying(reach, 0.0)).summary;
            assert_eq!(
                (turned.fly_cuts, turned.moving_starts),
                (straight.fly_cuts, straight.moving_starts),
                "{turn}"
            );
            near(turned.cut_time, straight.cut_time, 0.02 * straight.cut_time);
        }
    }
}

#[test]
fn what_cannot_be_flown_is_cut_one_by_one() {
    let sheet = plate(4, 1, 6.0, 0.0, round);
    let flies = |machine: &Profile, sheet: &Sheet| checked(sheet, machine).summary.fly_cuts;
    let machine = flying(20.0, 0.0);
    assert_eq!(flies(&machine, &sheet), 3);
    let lead_in = LeadShape { kind: LeadKind::Line, length: 0.5, ..LeadShape::default() };
    let leads = Leads { clearance: 0.1, rules: vec![LeadRule { lead_in, ..LeadRule::default() }] };
    assert_eq!(flies(&Profile { leads: Some(leads), ..machine.clone() }, &sheet), 0);
    let joints = Joints { rules: vec![JointRule { count: 1, ..JointRule::default() }] };
    assert_eq!(flies(&Profile { joints: Some(joints), ..machine.clone() }, &sheet), 0);
    assert_eq!(flies(&Profile { cut: Process { passes: 2, ..machine.cut }, ..machine.clone() }, &sheet), 0);
    // Holes around something else, of another size, or with another contour around them.
    let mut b = Builder::new();
    let outer = b.cut(rectangle(p(0.0, 0.0), p(200.0, 50.0)), None);
    let holes: Vec<u32> =
        (0..4).map(|k| b.cut(circle(p(20.0 + 20.0 * f64::from(k), 20.0), 5.0), Some(outer))).collect();
    b.cut(circle(p(20.0, 20.0), 2.0), Some(holes[0]));
    b.mark(line(p(39.0, 20.0), p(41.0, 20.0)), Some(holes[1]));
    assert_eq!(flies(&machine, &b.sheet), 1);
}

#[test]
fn machines_with_pre_cuts_are_refused() {
    let plate = machine("fibre-6kw-plate");
    let both = Profile { levers: flying(20.0, 0.0).levers, ..plate };
    let message = both.validate().unwrap_err().to_string();
    assert!(message.contains("levers.fly and pre_cut_time"), "{message}");
    let message = flying(0.0, 0.0).validate().unwrap_err().to_string();
    assert!(message.contains("\"levers.fly.reach\" is 0"), "{message}");
    let message = flying(10.0, -1.0).validate().unwrap_err().to_string();
    assert!(message.contains("\"levers.fly.overcut\" is -1"), "{message}");
}

/// Seconds of the program of a plan in a simulation of a controller that looks ahead over `blocks` lines.
fn simulated(sheet: &Sheet, machine: &Profile, plan: &Plan, blocks: usize) -> f64 {
    let text = output::gcode(plan, &SheetFacts::of(sheet), machine, "plate.dxf", Start::Absolute).unwrap();
    let program = gcode::run(&text).unwrap();
    let [ax, ay] = machine.rapid.accel.unwrap();
    let told = Machine {
        rapid_speed: machine.rapid.speed,
        rapid_accel: [ax, ay],
        accel: machine.cut.accel.unwrap(),
        junction_deviation: machine.junction_deviation.unwrap(),
        blocks,
        stops: true,
    };
    grbl_planner::program_seconds(told, &program)
}

#[test]
fn ten_thousand_holes_on_the_run_take_as_long_as_a_simulation_of_the_motion_says() {
    let sheet = plate(100, 100, 6.0, 0.0, round);
    let rest = machine("fibre-3kw-thin");
    let moving = Levers { moving_pierce: Some(MovingPierce { overcut: 0.0 }), ..Levers::default() };
    let moving = Profile { levers: moving, ..rest.clone() };
    let mut seconds = Vec::new();
    for (name, machine) in
        [("hole by hole", rest), ("moving pierce", moving), ("on the run", flying(20.0, 0.0))]
    {
        let plan = checked(&sheet, &machine);
        // The longest braking is over 16 mm, 110 chords of such a hole.
        let run = simulated(&sheet, &machine, &plan, 200);
        let planned = plan.summary.total_time;
        println!("{name}: {planned:.1} s, simulated {run:.1} s");
        assert!((run / planned - 1.0).abs() < 0.02, "{name}: {planned} s, simulated {run} s");
        seconds.push(planned);
    }
    assert!(seconds[2] < 0.5 * seconds[1] && seconds[2] < 0.3 * seconds[0], "{seconds:?}");
}

#[test]
fn grids_take_as_long_as_a_simulation_of_the_motion_says() {
    let machine = flying(20.0, 0.3);
    for sheet in [plate(12, 9, 20.0, 0.0, square), plate(12, 9, 20.0, 0.4, |at, _| circle(at, 4.0))] {
        let plan = checked(&sheet, &machine);
        assert!(plan.summary.fly_cuts > 0);
        let element = |s: &Segment| Element {
            from: s.start(),
            to: s.end(),
            arc: if let Segment::Arc(a) = s { Some((a.center, a.sweep)) } else { None },
        };
        let (mut run, mut seconds) = (Vec::new(), 0.0);
        let settings = Settings { accel: 5000.0, junction_deviation: 0.02 };
        for m in &plan.moves {
            match m {
                Move::Cut { path, .. } | Move::Fly { path } => {
                    let halves = path.iter().flat_map(|s| [s.piece(0.0, 0.5), s.piece(0.5, 1.0)]);
                    run.extend(halves.map(|s| (element(&s), 400.0)));
                }
                _ => seconds += grbl_planner::seconds(settings, &std::mem::take(&mut run)),
            }
        }
        let off = seconds / plan.summary.cut_time - 1.0;
        assert!(off.abs() < 0.015, "{seconds} s, planned {}", plan.summary.cut_time);
    }
}

/// A run over some holes of a row: its ends and its seconds.
fn run_over(holes: &[f64], y: f64, above: bool, machine: &Profile) -> ([DVec2; 2], f64) {
    let r = if above { 1.5 } else { -1.5 };
    let mut motion: Vec<Segment> = Vec::new();
    let mut ends = [p(holes[0], y + r); 2];
    for &x in holes {
        let at = p(x, y + r);
        if at != ends[1] {
            motion.push(Segment::line(ends[1], at));
        }
        let (from, ahead) =
            (if above { PI / 2.0 } else { -PI / 2.0 }, x >= holes[0] && holes[0] <= holes[holes.len() - 1]);
        // With the holes on the left, around them counter-clockwise.
        let sweep = if ahead == above { -TAU } else { TAU };
        motion.push(Segment::Arc(kerfway::geometry::Arc::from_angles(p(x, y), 1.5, from, sweep)));
        ends[1] = at;
    }
    // A hole alone is pierced at rest.
    let start =
        if holes.len() > 1 { machine.beam_off_delay } else { machine.pierce_time + machine.beam_delays() };
    (ends, cut_time(machine, &machine.cut, &motion) + start)
}

/// The least seconds of every order, side and direction of these runs.
fn least(runs: &[&[f64]], ys: &[f64], machine: &Profile) -> f64 {
    let air = AirTime::new(machine);
    let ways: Vec<Vec<([DVec2; 2], f64)>> = runs
        .iter()
        .zip(ys)
        .map(|(run, &y)| {
            let back: Vec<f64> = run.iter().rev().copied().collect();
            [true, false]
                .into_iter()
                .flat_map(|above| [run_over(run, y, above, machine), run_over(&back, y, above, machine)])
                .collect()
        })
        .collect();
    fn go(air: &AirTime, ways: &[Vec<([DVec2; 2], f64)>], left: u32, head: DVec2) -> f64 {
        if left == 0 {
            return air.seconds(head, DVec2::ZERO);
        }
        let mut best = f64::INFINITY;
        for (k, ways_of) in ways.iter().enumerate().filter(|(k, _)| left >> k & 1 == 1) {
            for (ends, seconds) in ways_of {
                let rest = go(air, ways, left & !(1 << k), ends[1]);
                best = best.min(air.seconds(head, ends[0]) + seconds + rest);
            }
        }
        best
    }
    go(&air, &ways, (1 << runs.len()) - 1, DVec2::ZERO)
}

#[test]
fn six_holes_are_cut_as_well_as_by_every_way_to_divide_their_rows() {
    let machine = flying(30.0, 0.0);
    for (k, (pitch, between, shift)) in
        [(6.0, 8.0, 0.0), (12.0, 5.0, 3.0), (25.0, 40.0, 60.0)].into_iter().enumerate()
    {
        let xs = [
            [30.0, 30.0 + pitch, 30.0 + 2.0 * pitch],
            [30.0 + shift, 30.0 + shift + pitch, 30.0 + shift + 2.0 * pitch],
        ];
        let ys = [25.0, 25.0 + between];
        let mut b = Builder::new();
        for (row, y) in xs.iter().zip(ys) {
            for &x in row {
                b.cut(circle(p(x, y), 1.5), None);
            }
        }
        let (_, _, plan) = search_of_exact_cost(&b.sheet, &machine, 1);
        // Each row as one run, in two, or hole by hole.
        let divided = |row: &[f64; 3]| -> Vec<Vec<Vec<f64>>> {
            let [a, b, c] = *row;
            vec![
                vec![vec![a, b, c]],
                vec![vec![a], vec![b, c]],
                vec![vec![a, b], vec![c]],
                vec![vec![a], vec![b], vec![c]],
            ]
        };
        let mut best = f64::INFINITY;
        for one in divided(&xs[0]) {
            for two in divided(&xs[1]) {
                let runs: Vec<&[f64]> = one.iter().chain(&two).map(Vec::as_slice).collect();
                let ys: Vec<f64> = one.iter().map(|_| ys[0]).chain(two.iter().map(|_| ys[1])).collect();
                best = best.min(least(&runs, &ys, &machine));
            }
        }
        let found = plan.summary.total_time;
        assert!((found - best).abs() < 1e-9, "case {k}: {found} s, not {best} s");
        assert_eq!(plan.summary.fly_cuts, 4);
    }
}

#[test]
fn the_search_is_as_good_as_every_order_of_rows_and_single_contours() {
    for seed in 0..6_u32 {
        let mut b = Builder::new();
        let far = f64::from(seed * 7 % 5);
        for k in 0..3 {
            b.cut(circle(p(20.0 + 8.0 * f64::from(k), 20.0 + far), 2.0), None);
        }
        b.cut(slot(p(60.0 + far * 9.0, 30.0), 10.0, 2.0), None);
        b.cut(rectangle(p(10.0, 60.0 + far * 3.0), p(20.0, 12.0)), None);
        let (_, _, plan) = search_of_exact_cost(&b.sheet, &flying(20.0, 0.2), seed.into());
        assert_eq!(plan.summary.fly_cuts, 2);
    }
}

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

#[test]
fn every_dialect_writes_cuts_on_the_run_or_refuses_them() {
    let machine = Profile { beam_off_delay: 0.0, ..flying(20.0, 0.2) };
    let mut refused = Vec::new();
    for sheet in [plate(5, 3, 6.0, 0.0, round), plate(5, 3, 20.0, 0.0, square)] {
        let plan = checked(&sheet, &machine);
        let dark: f64 = plan
            .moves
            .iter()
            .map(|m| if let Move::Fly { path } = m { path.iter().map(Segment::length).sum() } else { 0.0 })
            .sum();
        assert!(dark > 10.0);
        for dialect in dialects() {
            let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..machine.clone() };
            let profile = Profile { pierce_time: 0.0, beam_on_delay: 0.0, ..profile };
            let plan = checked(&sheet, &profile);
            match output::gcode(&plan, &SheetFacts::of(&sheet), &profile, "plate.dxf", Start::Absolute) {
                Ok(text) => {
                    let check = output::check_against(&text, &profile, &plan).unwrap();
                    assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
                    let alone = output::check(&text, &profile).unwrap();
                    assert!(alone.passed, "{}, alone: {:?}", dialect.name, alone.problems);
                }
                Err(e) => {
                    assert!(e.to_string().contains("or cut on the run"), "{}: {e}", dialect.name);
                    refused.push(dialect.name.clone());
                }
            }
        }
        // In GRBL's program, every way between cuts is a dark G1 with the length of the plan.
        let text =
            output::gcode(&plan, &SheetFacts::of(&sheet), &machine, "plate.dxf", Start::Absolute).unwrap();
        let program = gcode::run(&text).unwrap();
        let ways = program.motions().filter(|m| !m.rapid && m.beam == 0.0);
        near(ways.map(|m| m.path.length()).sum(), dark, 0.1);
    }
    refused.sort();
    refused.dedup();
    assert_eq!(refused, ["linuxcnc-spindle", "marlin-fan", "template"]);
}

/// Outlines of nine sides, two of them along x, each `lean` mm farther along x on the far side; every second one leans the other way.
fn leaning(count: u32, pitch: f64, lean: f64, turn: f64) -> Sheet {
    let mut b = Builder::new();
    let u = math::unit(turn);
    for k in 0..count {
        let lean = if k % 2 == 0 { -lean } else { lean };
        let corners = [(-2.0, 0.0), (2.0, 0.0), (3.0, 2.0), (3.5, 4.0), (lean + 2.0, 8.0), (lean - 2.0, 8.0)];
        let more = [(-3.6, 5.0), (-3.5, 4.0), (-3.0, 2.0)];
        let at = p(50.0 + pitch * f64::from(k), 50.0);
        let corners: Vec<DVec2> =
            corners.iter().chain(&more).map(|&(x, y)| p(400.0, 400.0) + u.rotate(at + p(x, y))).collect();
        b.cut(polygon(&corners), None);
    }
    b.sheet
}

#[test]
fn rows_whose_far_sides_are_farther_apart_than_the_reach_are_not_run_there() {
    let machine = flying(20.0, 0.3);
    for (lean, longest) in [(0.5, 19.0 + 1.0), (1.2, 19.0)] {
        for turn in [0.0, 0.5 * PI, PI, 1.5 * PI] {
            let plan = checked(&leaning(4, 19.0, lean, turn), &machine);
            assert!(plan.summary.fly_cuts > 0, "{lean} {turn}");
            let ways =
                plan.moves.iter().filter_map(|m| if let Move::Fly { path } = m { Some(path) } else { None });
            let way = ways.map(|path| path.iter().map(Segment::length).sum::<f64>()).fold(0.0, f64::max);
            assert!(way <= longest, "{way} mm");
        }
    }
}
