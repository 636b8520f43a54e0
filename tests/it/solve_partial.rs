//! Partial cutting: contours left unfinished for others.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::{Builder, assert_feasible, machine, nested_sheet, polygon};
use kerfway::drawing::ReadOptions;
use kerfway::dxf;
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::plan;
use kerfway::problem::{Node, Problem};
use kerfway::sheet::{self, Sheet};
use kerfway::solve;
use serde_json::Value;

fn point(v: &Value) -> DVec2 {
    DVec2::new(v[0].as_f64().unwrap(), v[1].as_f64().unwrap())
}

/// Sheets with their exact optima.
pub(crate) fn hull(name: &str) -> Vec<(Sheet, f64)> {
    let file = format!("{}/tests/fixtures/hull/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let all: Vec<Value> = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    let sheet = |v: &Value| {
        let mut b = Builder::new();
        for contour in v["contours"].as_array().unwrap() {
            let corners: Vec<DVec2> = contour.as_array().unwrap().iter().map(point).collect();
            b.cut(polygon(&corners), None);
        }
        b.sheet
    };
    all.iter().map(|v| (sheet(v), v["optimum"].as_f64().unwrap())).collect()
}

/// The problem with entries at corners only, as in the paper.
pub(crate) fn at_corners(sheet: &Sheet, machine: &Profile) -> Problem {
    let mut problem = problem_of(sheet, machine);
    problem.nodes.clear();
    for ((item, contour), id) in problem.items.iter_mut().zip(&sheet.contours).zip(0..) {
        let first = u32::try_from(problem.nodes.len()).unwrap();
        let mut along = 0.0;
        for (s, twin) in contour.path.segments.iter().zip(first..) {
            let entry = s.start();
            problem.nodes.push(Node { item: id, entry, exit: entry, along, reversed: false, twin });
            along += s.length();
        }
        item.nodes = first..u32::try_from(problem.nodes.len()).unwrap();
        item.track = None;
    }
    problem
}

fn reached(problem: &Problem, seed: u64, goal: f64, moves: u64) -> f64 {
    let mut search = solve::method("tour-tree").unwrap().start(problem, seed, None);
    let mut done = 0;
    while search.best().cost > goal + 1e-6 && done < moves {
        search.step(50_000);
        done += 50_000;
    }
    assert_feasible(problem, search.best());
    search.best().cost
}

#[test]
fn the_exact_optimum_of_partial_cutting_is_reached_on_every_sheet() {
    let machine = machine("length-partial");
    for (name, moves) in [("hull-5-20", 500_000), ("hull-10-45", 8_000_000)] {
        let sheets = hull(name);
        assert_eq!(sheets.len(), 10);
        for ((sheet, optimum), seed) in sheets.iter().zip(1..) {
            let found = reached(&at_corners(sheet, &machine), seed, *optimum, moves);
            assert!((found - optimum).abs() < 1e-6, "{name} {seed}: {found}, optimum {optimum}");
        }
    }
}

#[test]
fn interrupting_anywhere_is_no_worse_than_at_corners() {
    let machine = machine("length-partial");
    for (sheet, optimum) in hull("hull-5-20").into_iter().chain(hull("hull-10-45")) {
        let problem = problem_of(&sheet, &machine);
        let found = reached(&problem, 1, optimum, 8_000_000);
        assert!(found <= optimum + 1e-6, "{found}, at corners {optimum}");
    }
}

/// The root's cycles take half of the work, where leaving does not pay.
#[test]
fn expensive_interruptions_are_avoided_and_little_is_lost() {
    for seed in 1..4 {
        let sheet = nested_sheet(120, seed);
        let search = |pre_cut_time| {
            let machine = Profile { pre_cut_time, ..machine("length") };
            let problem = problem_of(&sheet, &machine);
            let mut search = solve::methods()[0].start(&problem, seed, None);
            search.step(4_000_000);
            assert_feasible(&problem, search.best());
            (search.best().cost, search.best().stops.len() - problem.items.len())
        };
        let (forbidden, free, dear) = (search(None), search(Some(0.0)), search(Some(1e4)));
        assert_eq!((forbidden.1, dear.1), (0, 0));
        assert!(dear.0 < 1.01 * forbidden.0, "{dear:?} {forbidden:?}");
        assert!(free.0 < 0.99 * forbidden.0 && free.1 > 10, "{free:?} {forbidden:?}");
    }
}

#[test]
fn every_improvement_passes_the_checker_on_real_and_nested_sheets() {
    let file = |name: &str| {
        let path = format!("{}/tests/fixtures/dxf-dev/{name}", env!("CARGO_MANIFEST_DIR"));
        let drawing = dxf::read(&std::fs::read(path).unwrap(), &ReadOptions::default()).unwrap();
        sheet::build(&drawing, &sheet::SheetOptions::default())
    };
    let sheets = [
        file("mozman_ezdxf__forms.dxf"),
        file("peej_lumberjack-keyboard__lumberjack-polaris.dxf"),
        file("skymakerolof_dxf__arrayed-holes.dxf"),
        nested_sheet(150, 11),
    ];
    let mut left = 0;
    for (sheet, name) in sheets.iter().flat_map(|s| ["fibre-3kw-thin", "co2-100w", "length"].map(|m| (s, m)))
    {
        let machine = Profile { pre_cut_time: Some(0.02), ..machine(name) };
        let problem = problem_of(sheet, &machine);
        let mut search = solve::methods()[0].start(&problem, 3, None);
        for _ in 0..150 {
            if !search.step(5_000).improved {
                continue;
            }
            assert_feasible(&problem, search.best());
            let plan = plan::from_solution(sheet, &problem, search.best());
            assert_eq!(plan::check(sheet, &machine, &plan), Ok(()), "{name}");
        }
        left += search.best().stops.len() - problem.items.len();
    }
    assert!(left > 50, "only {left} times was anything left unfinished");
}

/// A layer of one pass on a machine of two, and two passes sheet by sheet: contours may be left there, so pre-cuts are written.
#[test]
fn contours_that_are_left_get_pre_cuts_on_a_machine_of_two_passes() {
    let mut machine = Profile { pre_cut_time: Some(1e-3), ..machine("length") };
    machine.cut.passes = 2;
    let mut by_layer = nested_sheet(120, 1);
    by_layer.layers.iter_mut().for_each(|layer| layer.settings.passes = Some(1));
    let problem = problem_of(&by_layer, &machine);
    let mut search = solve::methods()[0].start(&problem, 3, None);
    search.step(600_000);
    let left = search.best().stops.len() - problem.items.len();
    let plan = plan::from_solution(&by_layer, &problem, search.best());
    assert_eq!(plan::check(&by_layer, &machine, &plan), Ok(()));
    let pre_cuts = plan.moves.iter().filter(|m| matches!(m, plan::Move::PreCut { .. })).count();
    assert!(left > 0, "nothing is left unfinished");
    assert_eq!(pre_cuts, left);
}

#[test]
fn a_search_continues_from_a_path_with_interrupted_contours() {
    let sheet = nested_sheet(60, 5);
    let problem = problem_of(&sheet, &machine("length-partial"));
    let method = solve::methods()[0];
    let mut first = method.start(&problem, 1, None);
    first.step(1_000_000);
    assert!(first.best().stops.len() > problem.items.len());
    let mut warm = method.start(&problem, 2, Some(first.best()));
    assert_eq!(warm.best(), first.best());
    let mut other = method.start(&problem, 2, None);
    other.offer(first.best());
    assert_eq!(other.best(), first.best());
    for search in [&mut warm, &mut other] {
        search.step(300_000);
        assert_feasible(&problem, search.best());
        assert!(search.best().cost <= first.best().cost);
    }
}
