//! Corners in which a cut does not stop (`levers.corners`): loops through waste and rounded corners, what they save, where they may
//! be, and what the checker says of plans that have them wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

use crate::testkit::dialects::read_back;
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, Dice, machine, p, polygon, rectangle};
use kerfway::geometry::{Arc, DVec2, Segment, math};
use kerfway::machine::{AirTime, CornerKind, Corners, LeadKind, Levers, Profile, process_time};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan, Turn, Violation};
use kerfway::problem::Problem;
use kerfway::sheet::{ContourChoice, Sheet};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const LOOPS: Corners = Corners {
    outer: CornerKind::Loop,
    hole: CornerKind::Loop,
    loop_radius: 1.0,
    clearance: 1.0,
    round_radius: 1.0,
    deviation: 0.1,
};
const ROUND: Corners = Corners { outer: CornerKind::Round, hole: CornerKind::Round, ..LOOPS };

/// Thick plate, where corners of less than 75 degrees cool for a second; nothing is left unfinished.
fn plate(corners: Corners) -> Profile {
    let levers = Levers { corners: Some(corners), ..Levers::default() };
    Profile { pre_cut_time: None, pre_cut_length: 0.0, levers, ..machine("fibre-6kw-plate") }
}

/// Thin sheet, cut fast: corners only slow the head down.
fn thin(corners: Corners) -> Profile {
    let levers = Levers { corners: Some(corners), ..Levers::default() };
    Profile { levers, ..machine("fibre-3kw-thin") }
}

fn without(machine: &Profile) -> Profile {
    Profile { levers: Levers { corners: None, ..machine.levers }, ..machine.clone() }
}

/// An isosceles triangle on its base, with this angle at its tip.
fn wedge(at: DVec2, base: f64, tip: f64) -> kerfway::geometry::Path {
    let height = 0.5 * base / math::tan(0.5 * tip);
    polygon(&[at, at + p(base, 0.0), at + p(0.5 * base, height)])
}

fn wedges(count: u32, gap: f64) -> Builder {
    let mut b = Builder::new();
    for k in 0..count {
        b.cut(wedge(p(f64::from(k) * (30.0 + gap) + 20.0, 20.0), 30.0, PI / 3.0), None);
    }
    b
}

fn searched(b: Builder, machine: &Profile) -> (Sheet, Plan) {
    let sheet = oriented(b.sheet);
    let plan = search_of_exact_cost(&sheet, machine, 1).2;
    (sheet, plan)
}

fn turns(plan: &Plan) -> Vec<(u32, Turn)> {
    let of = |m: &Move| match m {
        Move::Cut { contour, turns, .. } => turns.iter().map(|t| (*contour, *t)).collect(),
        _ => Vec::new(),
    };
    plan.moves.iter().flat_map(of).collect()
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9, "{a} is not {b}");
}

#[test]
fn loops_replace_the_pauses_of_sharp_corners() {
    let machine = plate(LOOPS);
    let (_, plan) = searched(wedges(1, 0.0), &machine);
    let (_, before) = searched(wedges(1, 0.0), &without(&machine));
    let s = &plan.summary;
    // It begins in one corner; the other two have loops of two lines and two thirds of a circle.
    assert_eq!((s.loops, s.rounded_corners), (2, 0));
    let each = 2.0 * math::tan(PI / 3.0) + (TAU - 2.0 * PI / 3.0);
    near(s.loop_length, 2.0 * each);
    near(s.cut_length, 90.0 + 2.0 * each);
    near(s.macro_time, 0.0);
    near(before.summary.macro_time, 2.0);
    // The cut runs through both corners at its speed: of three runs from rest to rest, one remains.
    let (v, a) = (machine.cut.speed, machine.cut.accel.unwrap());
    near(s.cut_time, s.cut_length / v + v / a);
    let saved = 2.0 * (1.0 + machine.beam_on_delay + machine.beam_off_delay + v / a - each / v);
    near(before.summary.total_time - s.total_time, saved);
    assert!(saved > 1.0, "{saved}");
}

#[test]
fn a_loop_that_takes_longer_than_the_corner_is_not_cut() {
    let wide = Corners { loop_radius: 8.0, ..LOOPS };
    assert_eq!(searched(wedges(1, 0.0), &plate(wide)).1.summary.loops, 0);
    // In thin sheet, a right angle slows the head down for milliseconds only: a loop of 1 mm is quicker still, one of 8 mm is not.
    let mut b = Builder::new();
    b.cut(rectangle(p(20.0, 20.0), p(30.0, 20.0)), None);
    let rect = |corners| searched(Builder { sheet: b.sheet.clone() }, &thin(corners)).1.summary.loops;
    assert_eq!((rect(wide), rect(LOOPS)), (0, 3));
}

#[test]
fn rounded_corners_stay_within_their_deviation_and_save_time() {
    let rect = || {
        let mut b = Builder::new();
        b.cut(rectangle(p(20.0, 20.0), p(30.0, 20.0)), None);
        b
    };
    let machine = thin(ROUND);
    let (_, plan) = searched(rect(), &machine);
    let s = &plan.summary;
    assert_eq!(s.rounded_corners, 3);
    // The radius that goes with 0.1 mm at a right angle is r (sqrt 2 - 1) = 0.1.
    let radius = 0.1 / (2.0_f64.sqrt() - 1.0);
    near(s.corner_deviation, 0.1);
    near(s.cut_length, 100.0 - 3.0 * (2.0 - FRAC_PI_2) * radius);
    let before = searched(rect(), &without(&machine)).1.summary.total_time;
    assert!(before - s.total_time > 0.01, "{before} {}", s.total_time);
    // The greatest radius counts where the deviation allows more.
    let (_, plan) = searched(rect(), &thin(Corners { round_radius: 0.1, deviation: 1.0, ..ROUND }));
    near(plan.summary.corner_deviation, 0.1 * (2.0_f64.sqrt() - 1.0));
}

#[test]
fn loops_are_outside_parts_and_inside_holes_and_nowhere_else() {
    // A star-like hole: its corners that point inwards have waste beyond them, its tips have the part.
    let (mut b, middle) = (Builder::new(), p(70.0, 70.0));
    let part = b.cut(rectangle(p(20.0, 20.0), p(100.0, 100.0)), None);
    let star: Vec<DVec2> = (0..8)
        .map(|k| middle + math::unit(f64::from(k) * PI / 4.0) * if k % 2 == 0 { 40.0 } else { 12.0 })
        .collect();
    let hole = b.cut(polygon(&star), Some(part));
    let machine = plate(Corners { loop_radius: 0.5, ..LOOPS });
    // Every corner below 75 degrees pauses; those that point inwards are 270 degrees wide and more.
    let wide = Profile {
        sharp_corner: Some(kerfway::machine::SharpCorner { angle: 2.6, time: 1.0 }),
        ..machine.clone()
    };
    let (sheet, plan) = searched(b, &wide);
    assert_eq!((plan.summary.loops, plan.summary.macro_time), (3 + 4, 3.0));
    for (contour, turn) in turns(&plan) {
        let from = turn.at.distance(middle);
        assert!(contour == part || from < 20.0, "contour {hole} has a loop at its tip {}", turn.at);
    }
    assert_eq!(plan::check(&sheet, &wide, &plan), Ok(()));
}

#[test]
fn what_has_no_room_stops_and_is_told() {
    // Two wedges 2 mm apart: base corners that face each other have no room for loops of 1 mm with 1 mm of clearance.
    let machine = plate(LOOPS);
    let sheet = oriented(wedges(2, 2.0).sheet);
    let (problem, _, plan) = search_of_exact_cost(&sheet, &machine, 1);
    let blocked: Vec<_> = problem
        .items
        .iter()
        .filter_map(|i| i.leads.as_ref())
        .flat_map(|l| l.corners.without_room.clone())
        .collect();
    assert_eq!(blocked, [(CornerKind::Loop, p(50.0, 20.0)), (CornerKind::Loop, p(52.0, 20.0))]);
    // Each begins where it would have to pause.
    assert_eq!((plan.summary.loops, plan.summary.macro_time), (4, 0.0));
    let (_, apart) = searched(wedges(2, 20.0), &machine);
    assert_eq!(apart.summary.loops, 4);
}

#[test]
fn a_person_chooses_by_contour() {
    let stop = Corners { outer: CornerKind::Stop, hole: CornerKind::Stop, ..LOOPS };
    let mut sheet = oriented(wedges(3, 20.0).sheet);
    let choice = |contour, kind| ContourChoice { contour, joints: None, lead: None, corners: Some(kind) };
    sheet.choices = vec![choice(0, CornerKind::Loop), choice(2, CornerKind::Round)];
    let plan = search_of_exact_cost(&sheet, &plate(stop), 1).2;
    assert_eq!((plan.summary.loops, plan.summary.rounded_corners), (2, 2));
    assert!(turns(&plan).iter().all(|(c, t)| (*c == 0) == (t.kind == CornerKind::Loop) && *c != 1));
    sheet.choices = vec![choice(1, CornerKind::Stop)];
    let plan = search_of_exact_cost(&sheet, &plate(LOOPS), 1).2;
    assert!(plan.summary.loops == 4 && turns(&plan).iter().all(|(c, _)| *c != 1));
}

#[test]
fn leads_and_joints_go_with_loops() {
    let machine = with_leads(plate(LOOPS), leads(LeadKind::Line, 1.0, 2.0));
    let (_, plan) = searched(wedges(2, 20.0), &machine);
    assert!(plan.summary.loops >= 4 && plan.summary.lead_length > 0.0, "{:?}", plan.summary);
    let rule = kerfway::machine::JointRule { count: 2, ..kerfway::machine::JointRule::default() };
    let joints = Some(kerfway::machine::Joints { rules: vec![rule] });
    let (_, plan) = searched(wedges(2, 20.0), &Profile { joints, ..plate(LOOPS) });
    assert!(plan.summary.loops >= 4 && plan.summary.joints == 4, "{:?}", plan.summary);
}

/// A test's own elements of a corner: a loop, or an arc with what it leaves out of both sides.
fn made(machine: &Profile, kind: CornerKind, a: &Segment, b: &Segment) -> Option<(Vec<Segment>, f64)> {
    let lever = machine.levers.corners?;
    let (at, u, w) = (a.end(), a.tangent(1.0), b.tangent(0.0));
    let turn = math::turn(u, w);
    if kind == CornerKind::Loop {
        let (r, ahead) = (lever.loop_radius, lever.loop_radius * math::tan(0.5 * turn));
        let out = at + u * ahead;
        let center = out - u.perp() * r;
        let arc = Arc::new(out, at - w * ahead, center, false);
        return (turn > 0.36)
            .then(|| (vec![Segment::line(at, out), Segment::Arc(arc), Segment::line(arc.end, at)], 0.0));
    }
    let half = 0.5 * turn.abs();
    let most = lever.deviation / (1.0 / math::cos(half) - 1.0);
    let sides = 0.5 * a.length().min(b.length()) / math::tan(half);
    let r = lever.round_radius.min(most).min(sides);
    let trim = r * math::tan(half);
    let center = at - u * trim + u.perp() * r * turn.signum();
    let arc = Arc::new(at - u * trim, at + w * trim, center, turn > 0.0);
    Some((vec![Segment::Arc(arc)], trim))
}

/// The least seconds of a cut around a contour from one of its places over all choices of corners with room.
fn least_from(
    machine: &Profile,
    sheet: &Sheet,
    id: u32,
    along: f64,
    kind: CornerKind,
    blocked: &[DVec2],
) -> f64 {
    let path = sheet.contours[id as usize].path.starting_at(along).segments;
    let corners: Vec<_> = path
        .windows(2)
        .enumerate()
        .filter(|(_, w)| math::turn(w[0].tangent(1.0), w[1].tangent(0.0)).abs() > 0.36)
        .filter(|(_, w)| blocked.iter().all(|b| b.distance(w[0].end()) > 1e-6))
        .filter_map(|(k, w)| Some((k, made(machine, kind, &w[0], &w[1])?)))
        .collect();
    let seconds = |set: u32| {
        let mut out: Vec<Segment> = Vec::new();
        let mut cut_off = 0.0;
        for (k, s) in path.iter().enumerate() {
            let here = corners.iter().enumerate().find(|(c, (at, _))| *at == k && set >> c & 1 == 1);
            let (from, to) = (cut_off, here.map_or(0.0, |(_, (_, (_, trim)))| *trim));
            let length = s.length();
            if length - from - to <= 1e-3 {
                return f64::INFINITY;
            }
            out.push(s.piece(from / length, 1.0 - to / length));
            out.extend(here.iter().flat_map(|(_, (_, (elements, _)))| elements));
            cut_off = to;
        }
        process_time(machine, &machine.cut, false, &out)
    };
    (0..1_u32 << corners.len()).map(seconds).fold(f64::INFINITY, f64::min)
}

/// The least seconds of all orders, entries and choices of corners: what was cut and where the head is say what the rest takes.
fn brute(machine: &Profile, sheet: &Sheet, problem: &Problem, kind: CornerKind) -> f64 {
    let air = AirTime::new(machine);
    let pierce = machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay;
    let n = problem.items.len();
    let blocked = |id: u32| -> Vec<DVec2> {
        let leads = problem.items[id as usize].leads.as_ref();
        leads.map_or_else(Vec::new, |l| l.corners.without_room.iter().map(|b| b.1).collect())
    };
    let nodes = &problem.nodes;
    let price: Vec<f64> = nodes
        .iter()
        .map(|node| pierce + least_from(machine, sheet, node.item, node.along, kind, &blocked(node.item)))
        .collect();
    let mut best = vec![f64::INFINITY; (1 << n) * nodes.len()];
    for set in 1_usize..1 << n {
        for (k, node) in nodes.iter().enumerate().filter(|(_, node)| set >> node.item & 1 == 1) {
            let before = set & !(1 << node.item);
            let from = |(j, last): (usize, &kerfway::problem::Node)| {
                best[before * nodes.len() + j] + air.seconds(last.exit, node.entry)
            };
            let way = if before == 0 {
                air.seconds(problem.home, node.entry)
            } else {
                nodes.iter().enumerate().map(from).fold(f64::INFINITY, f64::min)
            };
            best[set * nodes.len() + k] = way + price[k];
        }
    }
    let last = &best[((1 << n) - 1) * nodes.len()..];
    let home =
        |(seconds, node): (&f64, &kerfway::problem::Node)| seconds + air.seconds(node.exit, problem.home);
    last.iter().zip(nodes).map(home).fold(f64::INFINITY, f64::min)
}

/// Parts without holes whose corners are near enough to each other to matter: wedges, chamfered plates, combs.
fn parts(dice: &mut Dice, count: u32) -> Builder {
    let mut b = Builder::new();
    for k in 0..count {
        let at = p(f64::from(k % 3) * 50.0 + 20.0, f64::from(k / 3) * 50.0 + 20.0);
        let chamfer = dice.between(0.3, 4.0);
        b.cut(
            match dice.below(3) {
                0 => wedge(at, dice.between(15.0, 30.0), dice.between(0.5, 1.4)),
                1 => polygon(&[
                    at,
                    at + p(25.0 - chamfer, 0.0),
                    at + p(25.0, chamfer),
                    at + p(25.0, 15.0),
                    at + p(chamfer, 15.0),
                ]),
                _ => polygon(&[
                    at,
                    at + p(20.0, 0.0),
                    at + p(20.0 - chamfer, 12.0),
                    at + p(10.0, dice.between(3.0, 9.0)),
                    at + p(0.0, 12.0),
                ]),
            },
            None,
        );
    }
    b
}

#[test]
fn the_search_chooses_as_well_as_every_order_entry_and_choice_of_corners() {
    let (mut loops, mut rounded) = (0, 0);
    for seed in 0..16_u64 {
        let mut dice = Dice::new(seed);
        let sheet = oriented(parts(&mut dice, if seed < 12 { 4 } else { 6 }).sheet);
        let kind = if seed % 2 == 0 { CornerKind::Loop } else { CornerKind::Round };
        let base = if seed % 4 < 2 { plate(LOOPS) } else { thin(LOOPS) };
        let corners = Corners {
            outer: kind,
            loop_radius: dice.between(0.2, 2.0),
            round_radius: dice.between(0.3, 3.0),
            deviation: dice.between(0.02, 0.5),
            ..LOOPS
        };
        let machine = Profile { levers: Levers { corners: Some(corners), ..Levers::default() }, ..base };
        let (problem, least, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let brute = brute(&machine, &sheet, &problem, kind);
        let exact = least + problem.items.iter().map(|i| i.fixed).sum::<f64>();
        let found = plan.summary.total_time;
        // The exact solver on the problem's nodes is as good as everything tried; contours without a better corner may be entered
        // between their nodes as well.
        assert!((exact - brute).abs() < 1e-6, "seed {seed}: {exact} {brute}");
        assert!(found <= brute + 1e-6, "seed {seed}: {found} {brute}");
        loops += plan.summary.loops;
        rounded += plan.summary.rounded_corners;
    }
    assert!(loops > 20 && rounded > 40, "{loops} {rounded}");
}

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

#[test]
fn every_dialect_and_drawing_has_loops_and_arcs() {
    for corners in [LOOPS, ROUND] {
        let planned = |machine: &Profile| searched(wedges(2, 20.0), machine);
        read_back(&plate(corners), planned, 2, |dialect, plan, _| {
            assert!(plan.summary.loops + plan.summary.rounded_corners >= 4, "{dialect}");
        });
        let (sheet, plan) = searched(wedges(2, 20.0), &plate(corners));
        let facts = SheetFacts::of(&sheet);
        assert_eq!(output::dxf(&plan, &facts).matches("LWPOLYLINE").count(), 2);
        let svg = output::svg(&plan, &facts, &plate(corners));
        assert_eq!(svg.matches("Loops at corners").count(), usize::from(corners == LOOPS));
        assert_eq!(output::lbrn2(&plan, &facts, &plate(corners)).unwrap().matches("<Shape").count(), 2);
    }
}
