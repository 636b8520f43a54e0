//! Pierce groups that are left for other contours and resumed: small cases against brute force, plans that pass the checker,
//! and faults that it finds.
#![allow(clippy::unwrap_used, clippy::panic, dead_code, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "groups of a few elements"
)]

use crate::testkit::by_hand::{ByHand, CELL, air};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::{rectangle, thick};
use crate::testkit::rng::seeded;
use kerfway::geometry::DVec2;
use kerfway::job::{BestPath, Job, LoadOptions, MachineChoice, PlanOptions, SliceEnd, WarmPath, problem_of};
use kerfway::machine::Profile;
use kerfway::plan::{self, LowerBound, Move, Plan, Violation};
use kerfway::problem::{Item, Problem};
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Search, Solution, Status, papers};
use rand::RngExt;
use std::collections::HashMap;

/// Cutting at one speed, so that all but the order is the same. Piercing takes seconds, and so do long air moves.
pub(crate) fn plate() -> Profile {
    let mut machine = thick();
    machine.cut.accel = None;
    machine.rapid.speed = [50.0, 50.0];
    machine.pre_cut_time = Some(0.3);
    machine
}

/// Rectangles by lattice: left, bottom, width, height.
pub(crate) type Part = [i32; 4];
/// An open cut from one place to another, in cells of the lattice.
pub(crate) type Slit = [[f64; 2]; 2];

fn place(p: [f64; 2]) -> DVec2 {
    DVec2::from(p) * CELL
}

/// A drawing of parts that share cuts, and of slits.
fn plate_drawing(parts: &[Part], slits: &[Slit]) -> Vec<u8> {
    let outlines: Vec<_> = parts.iter().map(|r| rectangle(r.map(|k| f64::from(k) * CELL))).collect();
    let text = String::from_utf8(drawing(&outlines)).unwrap();
    let lines: String = slits
        .iter()
        .map(|s| {
            let [a, b] = s.map(place);
            format!("0\nLINE\n8\n0\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", a.x, a.y, b.x, b.y)
        })
        .collect();
    text.replace("0\nENDSEC\n0\nEOF", &format!("{lines}0\nENDSEC\n0\nEOF")).into_bytes()
}

pub(crate) fn load(parts: &[Part], slits: &[Slit]) -> Job {
    Job::load(plate_drawing(parts, slits), "plate.dxf", &LoadOptions::default()).unwrap()
}

/// Least seconds besides cutting, over all orders and directions of elements and slits. The group may be left after any
/// element and gone on with at any node where that is possible.
fn brute(net: &mut ByHand, machine: &Profile, slits: &[Slit]) -> f64 {
    #[derive(Clone, Copy, PartialEq, Eq, Hash)]
    struct State {
        cut: usize,
        slits: usize,
        /// Where the head is: a node, then both ends of each slit, then home.
        head: usize,
        /// Nodes at which the beam has stopped in time.
        ready: usize,
    }
    let nodes = net.nodes.len();
    let ends: Vec<DVec2> = slits.iter().flat_map(|s| s.map(place)).collect();
    let home = nodes + ends.len();
    let places: Vec<DVec2> = net.nodes.iter().copied().chain(ends).chain([machine.home()]).collect();
    let begin = machine.beam_on_delay + machine.beam_off_delay;
    let (pierce, pre_cut) = (machine.pierce_time, machine.pre_cut_time.unwrap());
    // The cells of the slits that lie in parts, and what holds by elements cut.
    let cell = |s: &Slit| [0, 1].map(|k| (0.5 * (s[0][k] + s[1][k])).floor() as i32);
    let inside: Vec<_> = slits.iter().map(|s| Some(cell(s)).filter(|&cell| net.covers(cell))).collect();
    let mut cells = HashMap::new();
    let mut layer = HashMap::from([(State { cut: 0, slits: 0, head: home, ready: 0 }, 0.0)]);
    for _ in 0..net.count() + slits.len() {
        let mut next: HashMap<State, f64> = HashMap::new();
        let mut offer = |state: State, seconds: f64| {
            let least = next.entry(state).or_insert(f64::INFINITY);
            *least = least.min(seconds);
        };
        for (state, seconds) in layer {
            let State { cut, head, .. } = state;
            let (may, loose) = net.stand(cut);
            let held = &*cells.entry(cut).or_insert_with(|| net.held(cut));
            // Before it goes away from a node, the beam may make pre-cuts there.
            let gone = if head < nodes { state.ready | (1 << head & !loose) } else { state.ready };
            for s in (0..slits.len()).filter(|s| state.slits >> s & 1 == 0) {
                let holds = inside[s].is_none_or(|cell| held.contains(&cell));
                for end in [0, 1].into_iter().filter(|_| holds) {
                    let (from, to) = (nodes + 2 * s + end, nodes + 2 * s + 1 - end);
                    let legs = air(machine, places[head], places[from]) + pierce + begin;
                    let state = State { cut, slits: state.slits | 1 << s, head: to, ready: gone };
                    offer(state, seconds + legs);
                }
            }
            let visited = (0..net.count()).filter(|e| cut >> e & 1 == 1).map(|e| net.element(e).0);
            let visited = visited.flatten().fold(0, |set, n| set | 1 << n);
            for e in (0..net.count()).filter(|e| may >> e & 1 == 1) {
                let [a, b] = net.element(e).0;
                for (from, to) in [(a, b), (b, a)] {
                    let mut ways = Vec::new();
                    if from == head {
                        ways.push((0.0, state.ready));
                        if (state.ready | loose) >> from & 1 == 0 {
                            ways.push((begin, state.ready | 1 << from));
                        }
                    }
                    let there = air(machine, places[head], places[from]) + begin;
                    if from == head {
                    } else if visited >> from & 1 == 0 {
                        ways.push((there + pierce, gone | 1 << from));
                    } else if gone >> from & 1 == 1 {
                        ways.push((there + pre_cut, gone));
                    }
                    for (more, ready) in ways {
                        let shifted = loose >> to & 1 == 1;
                        if shifted && ready >> to & 1 == 0 {
                            continue;
                        }
                        let more = more + if shifted { pre_cut } else { 0.0 };
                        offer(
                            State { cut: cut | 1 << e, slits: state.slits, head: to, ready },
                            seconds + more,
                        );
                    }
                }
            }
        }
        layer = next;
    }
    let back = |(s, seconds): (State, f64)| seconds + air(machine, places[s.head], machine.home());
    layer.into_iter().map(back).fold(f64::INFINITY, f64::min)
}

/// The problem with groups that are cut in one go.
pub(crate) fn in_one_go(problem: &Problem) -> Problem {
    let mut whole = problem.clone();
    whole.items.iter_mut().flat_map(|i| &mut i.paths).for_each(|p| p.leave_points.clear());
    whole
}

fn solved(problem: &Problem, method: &str, moves: u64) -> Solution {
    let mut search = start(problem, method);
    while moves > 0 && search.telemetry().moves < moves && search.step(20_000).status == Status::Running {}
    search.best().clone()
}

fn start<'p>(problem: &'p Problem, method: &str) -> Box<dyn Search + 'p> {
    match solve::method(method) {
        Some(method) => method.start(problem, 1, None),
        None => papers::method(method, "{}").unwrap().start(problem, 1, None),
    }
}

/// The plan of a solution, which passes the checker; and its seconds besides cutting.
fn checked(sheet: &Sheet, problem: &Problem, solution: &Solution) -> (Plan, f64) {
    let plan = plan::from_solution(sheet, problem, solution);
    if let Err(found) = plan::check(sheet, &problem.machine, &plan) {
        panic!("{found:?}\n{:#?}", plan.moves);
    }
    let fixed: f64 = problem.items.iter().map(|i| i.fixed).sum();
    let total = plan.summary.total_time;
    assert!((total - fixed - solution.cost).abs() < 1e-9, "{total} is not {fixed} and {}", solution.cost);
    let seconds = total - plan.summary.cut_time;
    (plan, seconds)
}

/// Seconds with groups that may and must not be left, and the least by brute force.
fn compare(parts: &[Part], slits: &[Slit], method: &str) -> [f64; 3] {
    let (job, machine) = (load(parts, slits), plate());
    let sheet = job.sheet();
    let [group] = &sheet.groups[..] else { panic!("{} groups", sheet.groups.len()) };
    let least = brute(&mut ByHand::net(group, &machine), &machine, slits);
    let problem = problem_of(sheet, &machine);
    let whole = in_one_go(&problem);
    let [left, whole] = [&problem, &whole].map(|p| checked(sheet, p, &solved(p, method, 60_000)).1);
    assert!(left >= least - 1e-9, "{left} is below the least {least}");
    [left, whole, least]
}

/// A row of three tall parts: its four nodes are the ends of the two shared sides.
const TALL: [Part; 3] = [[3, 3, 8, 6], [11, 3, 8, 6], [19, 3, 8, 6]];
/// Slits beside each of these nodes, outside of the parts.
const OUTSIDE: [Slit; 4] = [
    [[10.5, 1.5], [11.5, 1.5]],
    [[18.5, 1.5], [19.5, 1.5]],
    [[10.5, 10.5], [11.5, 10.5]],
    [[18.5, 10.5], [19.5, 10.5]],
];
/// Slits in the left, the middle and the right part.
const INSIDE: [Slit; 3] = [[[9.5, 7.5], [9.5, 8.5]], [[13.5, 4.5], [14.5, 4.5]], [[20.5, 7.5], [20.5, 8.5]]];

#[test]
fn leaving_a_group_saves_seconds_and_is_the_least_of_all() {
    for slits in [&INSIDE[..], &[INSIDE[0], OUTSIDE[3]]] {
        let [left, whole, least] = compare(&TALL, slits, "tour-tree");
        assert!((left - least).abs() < 1e-9, "{left} is not the least {least}");
        assert!(whole - left > 1.0, "leaving the group saves {} s", whole - left);
    }
}

#[test]
fn all_methods_gain_by_leaving_and_none_is_below_the_least() {
    for slits in [&INSIDE[..], &[INSIDE[0], OUTSIDE[3]], &[INSIDE[1], INSIDE[2], OUTSIDE[2]], &OUTSIDE[..]] {
        for method in ["tour-tree", "partition-tree"] {
            let [left, whole, _] = compare(&TALL, slits, method);
            assert!(left < whole, "{method}: {left} with groups that may be left, {whole} without");
        }
    }
}

#[test]
fn a_path_with_longer_air_moves_that_others_bridge_is_the_least_of_all() {
    for method in ["tour-tree", "partition-tree"] {
        let [left, whole, least] = compare(&TALL, &OUTSIDE, method);
        assert!((left - least).abs() < 1e-9, "{method}: {left} is not the least {least}");
        assert!(whole - left > 1.5, "{method}: {whole} without leaving the group, {left} with");
    }
}

/// Parts on a lattice with slits in them and beside them.
pub(crate) fn random(seed: u64) -> (Vec<Part>, Vec<Slit>) {
    let mut rng = seeded(seed);
    let mut below = |n: i32| rng.random_range(0..n);
    let (columns, rows) = (2 + below(3), 1 + below(3));
    let (w, h) = (2 + below(5), 2 + below(5));
    let parts = (0..columns * rows).map(|k| [3 + w * (k % columns), 3 + h * (k / columns), w, h]).collect();
    let (right, top) = (4 + w * columns, 4 + h * rows);
    let slits = (0..3 + below(6))
        .map(|_| {
            let [x, y] = [below(right + 4), below(top + 4)].map(f64::from);
            if below(2) == 0 {
                [[x + 0.25, y + 0.5], [x + 0.75, y + 0.5]]
            } else {
                [[x + 0.5, y + 0.25], [x + 0.5, y + 0.75]]
            }
        })
        .collect();
    (parts, slits)
}

/// Visits of pierce groups beyond the first of each.
fn times_left(problem: &Problem, solution: &Solution) -> usize {
    let item = |node: u32| &problem.items[problem.nodes[node as usize].item as usize];
    let visits = solution.stops.iter().filter(|s| item(s.node).is_pierce_group()).count();
    visits - problem.items.iter().filter(|i| i.is_pierce_group() && !i.nodes.is_empty()).count()
}

#[test]
fn every_best_passes_the_checker_and_costs_no_less_than_the_bound() {
    let mut left = HashMap::new();
    for seed in 0..25 {
        let (parts, slits) = random(seed);
        let job = load(&parts, &slits);
        let machine = Profile { return_home: seed % 2 == 0, ..plate() };
        let problem = problem_of(job.sheet(), &machine);
        let least: f64 = problem.items.iter().map(Item::least).sum();
        let mut bound = LowerBound::new(&problem);
        while bound.improve(100_000, f64::INFINITY) {}
        for method in ["tour-tree", "pfr", "partition-tree"] {
            let mut search = start(&problem, method);
            for _ in 0..20 {
                let ended = search.step(3_000).status == Status::Exhausted;
                let (plan, _) = checked(job.sheet(), &problem, search.best());
                assert!(plan.summary.total_time >= least + bound.value() - 1e-9, "{method} {seed}");
                if ended {
                    break;
                }
            }
            *left.entry(method).or_insert(0) += times_left(&problem, search.best());
        }
    }
    for (method, times) in left {
        assert!(times > 10, "{method} left a group only {times} times");
    }
}

#[test]
fn slices_and_warm_paths_give_the_same() {
    for method in ["tour-tree", "partition-tree"] {
        let machine = MachineChoice::Profile(Box::new(plate()));
        let options =
            PlanOptions { machine, method: Some(method.to_owned()), seed: 1, ..PlanOptions::default() };
        let run = |slice: u64, warm: Option<WarmPath>| {
            let mut job = load(&TALL, &OUTSIDE);
            job.start(&PlanOptions { warm, ..options.clone() }).unwrap();
            // A slice may be shorter than it was asked to be.
            let (mut left, mut end) = (40_000, SliceEnd::Running);
            while left > 0 && end == SliceEnd::Running {
                let done = job.run_mut().unwrap().step(left.min(slice));
                (left, end) = (left - done.done, done.end);
            }
            job
        };
        let whole = run(40_000, None);
        let found = whole.run().unwrap();
        assert!(times_left(found.problem(), found.best()) > 0, "{method}");
        assert_eq!(run(1_000, None).run().unwrap().best(), found.best(), "{method}");
        let (path, _) = BestPath::of(found, whole.sheet());
        let BestPath { contours, along, until, reversed, .. } = path;
        if method == "tour-tree" {
            let again = run(50_000, Some(WarmPath { contours, along, until, reversed }));
            assert_eq!(again.run().unwrap().best().stops, found.best().stops);
        }
    }
}

/// A plan that leaves its group for a slit in one of the parts.
fn left_for_a_slit() -> (Sheet, Profile, Plan) {
    let (job, machine) = (load(&TALL, &INSIDE), plate());
    let problem = problem_of(job.sheet(), &machine);
    let best = solved(&problem, "tour-tree", 60_000);
    assert!(times_left(&problem, &best) > 0);
    let (plan, _) = checked(job.sheet(), &problem, &best);
    (job.sheet().clone(), machine, plan)
}

fn found(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Vec<Violation> {
    plan::check(sheet, machine, plan).unwrap_err()
}

#[test]
fn the_checker_finds_a_group_that_is_gone_on_with_without_a_pre_cut() {
    let (sheet, machine, mut plan) = left_for_a_slit();
    let at = plan.moves.iter().position(|m| matches!(m, Move::PreCut { .. })).unwrap();
    plan.moves.remove(at);
    let found = found(&sheet, &machine, &plan);
    assert!(found.iter().any(|v| matches!(v, Violation::NoPreCut { .. })), "{found:?}");
}

#[test]
fn the_checker_finds_a_slit_that_is_cut_after_its_part_has_fallen_out() {
    let (sheet, machine, mut plan) = left_for_a_slit();
    // The last slit goes to the end: air, pierce, cut.
    let inside = &sheet.groups[0].inside;
    let is_slit = |m: &Move| matches!(m, Move::Cut { contour, .. } if inside.contains(contour));
    let at = plan.moves.iter().rposition(is_slit).unwrap();
    let slit: Vec<Move> = plan.moves.drain(at - 2..=at).collect();
    let home = plan.moves.len() - 1;
    plan.moves.splice(home..home, slit);
    let found = found(&sheet, &machine, &plan);
    assert!(found.iter().any(|v| matches!(v, Violation::CutFree { .. })), "{found:?}");
}
