//! Part by part, and contours pinned to the beginning or the end: kept by the search, found by the checker.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::job::{Job, JobError, LayerChoice, LoadOptions, MachineChoice, PlanOptions};
use kerfway::plan::{self, Move, Plan};
use kerfway::sheet::Operation;

/// More than the first cycle of the search takes, which gives the first good path.
const MOVES: u64 = 500_000;

/// A nested sheet of 100 contours with holes and parts in holes, planned.
fn planned(load: LoadOptions, moves: u64) -> (Job, Plan) {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/sheets/sheet_100.dxf");
    let ignore = |name: &str| LayerChoice::new(name, Operation::Ignore);
    let load = LoadOptions { layers: vec![ignore("SHEET"), ignore("MARK")], ..load };
    let mut job = Job::load(std::fs::read(file).unwrap(), "sheet_100.dxf", &load).unwrap();
    job.start(&PlanOptions { seed: 1, moves: Some(moves), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(moves);
    let plan = job.plan().unwrap();
    (job, plan)
}

fn order(plan: &Plan) -> Vec<u32> {
    let contour = |m: &Move| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None };
    plan.moves.iter().filter_map(contour).collect()
}

#[test]
fn a_part_is_finished_before_the_next_one() {
    let (job, together) = planned(LoadOptions { part_by_part: true, ..LoadOptions::default() }, MOVES);
    let sheet = job.sheet();
    let (order, parts) = (order(&together), &sheet.parts);
    assert!(parts.iter().any(|p| p.inside.is_some()) && parts.len() > 10);
    for part in parts.iter().filter(|p| p.inside.is_none()) {
        // Everything inside the part's outer contour, at any depth.
        let inside = |mut c: u32| loop {
            match sheet.contours[c as usize].inside {
                _ if c == part.outer => return true,
                Some(around) => c = around,
                None => return false,
            }
        };
        let places: Vec<usize> = (0..order.len()).filter(|&k| inside(order[k])).collect();
        assert_eq!(places.last().unwrap() - places[0] + 1, places.len(), "part around {}", part.outer);
        assert_eq!(order[*places.last().unwrap()], part.outer);
    }
    // Free of that, the path is faster, and the checker sees that it is not part by part.
    let (free_job, free) = planned(LoadOptions::default(), MOVES);
    assert!(free.summary.air_time < together.summary.air_time);
    let machine = &free_job.run().unwrap().machine;
    let torn = plan::check(sheet, machine, &free).unwrap_err();
    assert!(torn.iter().all(|v| matches!(v, plan::Violation::Torn { .. })) && !torn.is_empty());
}

#[test]
fn pinned_contours_come_first_and_last_with_what_must_come_before_them() {
    let outer = {
        let (job, _) = planned(LoadOptions::default(), 1);
        let parts = &job.sheet().parts;
        parts
            .iter()
            .filter(|p| p.inside.is_none() && !p.holes.is_empty())
            .map(|p| p.outer)
            .collect::<Vec<_>>()
    };
    let (first, last) = (outer[0], outer[1]);
    let (job, plan) =
        planned(LoadOptions { first: vec![first], last: vec![last], ..LoadOptions::default() }, 50_000);
    let order = order(&plan);
    let sheet = job.sheet();
    let around = |c: u32, o: u32| {
        std::iter::successors(Some(c), |&c| sheet.contours[c as usize].inside).any(|c| c == o)
    };
    let begin = order.iter().position(|&c| c == first).unwrap();
    assert!(
        begin > 0 && order[..=begin].iter().all(|&c| around(c, first)),
        "only what lies inside it comes before"
    );
    assert_eq!(order.last(), Some(&last));
    // A sheet without pins is another one: the order by rank is not kept.
    let free = plan::check(
        &planned(LoadOptions { first: vec![last], ..LoadOptions::default() }, 1).0.sheet().clone(),
        &job.run().unwrap().machine,
        &plan,
    );
    assert!(free.unwrap_err().iter().any(|v| matches!(v, plan::Violation::Rank { .. })));
}

#[test]
fn a_pin_on_an_unknown_contour_is_refused() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/sheets/sheet_100.dxf");
    let bytes = std::fs::read(file).unwrap();
    let load = |last: u32| LoadOptions { last: vec![last], ..LoadOptions::default() };
    let told = Job::load(bytes.clone(), "a.dxf", &load(4000)).err().unwrap().to_string();
    assert!(told.starts_with("Contour 4000 is listed in the options, but there are only "), "{told}");
    let mut job = Job::load(bytes, "a.dxf", &LoadOptions::default()).unwrap();
    assert!(matches!(job.reload(&load(4000)), Err(JobError::UnknownContour { contour: 4000, .. })));
    assert!(job.start(&PlanOptions::default()).is_ok(), "what was loaded before is still there");
}

#[test]
fn a_contour_is_marked_at_a_persons_request() {
    let (job, _) = planned(LoadOptions::default(), 1);
    let part = job.sheet().parts.iter().find(|p| !p.holes.is_empty()).unwrap().clone();
    let (job, plan) = planned(LoadOptions { mark: vec![part.outer], ..LoadOptions::default() }, 20_000);
    let sheet = job.sheet();
    assert_eq!(sheet.contours[part.outer as usize].operation, Operation::Mark);
    assert!(sheet.parts.iter().all(|p| p.outer != part.outer), "a mark bounds no part");
    assert_eq!(order(&plan)[0], part.outer, "marks come before cuts");
    assert_eq!(plan::check(sheet, &job.run().unwrap().machine, &plan), Ok(()));
}

/// Outer contours of parts that lie in no other part.
fn outer_parts(sheet: &kerfway::sheet::Sheet) -> Vec<u32> {
    sheet.parts.iter().filter(|p| p.inside.is_none()).map(|p| p.outer).collect()
}

/// Fails unless each contour of a sequence is finished before the next one, and what lies inside that, begins.
fn assert_in_turn(sheet: &kerfway::sheet::Sheet, order: &[u32], sequence: &[u32]) {
    let inside = |c: u32, o: u32| {
        std::iter::successors(Some(c), |&c| sheet.contours[c as usize].inside).any(|c| c == o)
    };
    for pair in sequence.windows(2) {
        let end = order.iter().rposition(|&c| c == pair[0]).unwrap();
        let begin = order.iter().position(|&c| inside(c, pair[1])).unwrap();
        assert!(end < begin, "contour {} before {}", pair[0], pair[1]);
    }
}

#[test]
fn a_sequence_of_parts_is_kept_and_the_rest_is_optimised() {
    let sequence: Vec<u32> = {
        let (job, free) = planned(LoadOptions::default(), 50_000);
        let outer = outer_parts(job.sheet());
        let visited: Vec<u32> = order(&free).into_iter().filter(|c| outer.contains(c)).collect();
        // Backwards, so that it is not what the search would choose.
        visited.iter().rev().step_by(3).copied().collect()
    };
    assert!(sequence.len() >= 4);
    for part_by_part in [false, true] {
        let load = LoadOptions { sequences: vec![sequence.clone()], part_by_part, ..LoadOptions::default() };
        let (job, plan) = planned(load, MOVES);
        let found = order(&plan);
        assert_in_turn(job.sheet(), &found, &sequence);
        assert_eq!(plan::check(job.sheet(), &job.run().unwrap().machine, &plan), Ok(()));
        // Other contours are cut in between, and the whole is faster than nearest first with the same sequence.
        let places: Vec<usize> =
            sequence.iter().map(|s| found.iter().position(|c| c == s).unwrap()).collect();
        assert!(places.windows(2).any(|p| p[1] > p[0] + 1));
        assert!(plan.summary.air_time < job.run().unwrap().baselines.greedy.air_time);
        // The checker sees a plan that does not keep it.
        let other = LoadOptions {
            sequences: vec![sequence.iter().rev().copied().collect()],
            part_by_part,
            ..LoadOptions::default()
        };
        let torn = plan::check(planned(other, 1).0.sheet(), &job.run().unwrap().machine, &plan).unwrap_err();
        assert!(torn.iter().any(|v| matches!(v, plan::Violation::Rank { .. })));
    }
}

#[test]
fn first_and_last_contours_may_have_an_order_of_their_own() {
    let outer = outer_parts(planned(LoadOptions::default(), 1).0.sheet());
    let [first, last] = [outer[..4].to_vec(), outer[4..7].to_vec()];
    let sequences = vec![first.iter().rev().copied().collect(), last.iter().rev().copied().collect()];
    let load = LoadOptions { first, last, sequences: sequences.clone(), ..LoadOptions::default() };
    let (job, plan) = planned(load, 50_000);
    for sequence in &sequences {
        assert_in_turn(job.sheet(), &order(&plan), sequence);
    }
    assert_eq!(order(&plan).last(), sequences[1].last());
    assert_eq!(plan::check(job.sheet(), &job.run().unwrap().machine, &plan), Ok(()));
}

#[test]
fn a_sequence_goes_before_pins_and_layers() {
    let outer = outer_parts(planned(LoadOptions::default(), 1).0.sheet());
    // The contour that should be first comes after one that should be last.
    let sequence = vec![outer[1], outer[0]];
    let load = LoadOptions {
        first: vec![outer[0]],
        last: vec![outer[1]],
        sequences: vec![sequence.clone()],
        order_by_layer: true,
        ..LoadOptions::default()
    };
    let (job, plan) = planned(load, 20_000);
    assert_in_turn(job.sheet(), &order(&plan), &sequence);
    assert_eq!(plan::check(job.sheet(), &job.run().unwrap().machine, &plan), Ok(()));
}

#[test]
fn sequences_that_are_not_possible_are_refused_in_a_sentence() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/sheets/sheet_100.dxf");
    let bytes = std::fs::read(file).unwrap();
    let hole = {
        let (job, _) = planned(LoadOptions::default(), 1);
        job.sheet().parts.iter().find(|p| !p.holes.is_empty()).map(|p| (p.holes[0], p.outer)).unwrap()
    };
    let other = outer_parts(planned(LoadOptions::default(), 1).0.sheet()).into_iter().find(|&c| c != hole.1);
    let other = other.unwrap();
    let ignore = |name: &str| LayerChoice::new(name, Operation::Ignore);
    let told = |sequences: Vec<Vec<u32>>| {
        let layers = vec![ignore("SHEET"), ignore("MARK")];
        let load = LoadOptions { sequences, layers, ..LoadOptions::default() };
        Job::load(bytes.clone(), "a.dxf", &load).err().map(|e| e.to_string()).unwrap_or_default()
    };
    assert_eq!(told(vec![vec![hole.0, hole.1]]), "", "a hole before its part is the usual order");
    assert_eq!(told(vec![vec![hole.0, other, hole.1]]), "", "another contour between a hole and its part");
    assert!(told(vec![vec![hole.1, hole.0]]).contains("would have to be cut before itself"));
    assert!(told(vec![vec![3, 4], vec![4, 5]]).contains("names contour 4 twice"));
    assert!(told(vec![vec![3, 4000]]).starts_with("Contour 4000 is listed"));
}

/// A hole that is cut together with another part: the tour without nesting was repaired by cutting the outline of the hole's part right
/// after it, between the two.
#[test]
fn a_hole_stays_together_with_a_foreign_part() {
    let part = |x: f64, y: f64, hole: bool| {
        let outline = rectangle([x, y, 30.0, 20.0]);
        if hole { vec![outline, rectangle([x + 10.0, y + 6.0, 8.0, 8.0])] } else { vec![outline] }
    };
    let parts =
        [part(5.0, 60.0, false), part(60.0, 8.0, true), part(8.0, 20.0, true), part(70.0, 55.0, false)];
    let drawing = drawing(&parts.concat());
    let load = LoadOptions { together: vec![vec![0, 2]], ..LoadOptions::default() };
    for seed in 1..=12 {
        let mut job = Job::load(drawing.clone(), "parts.dxf", &load).unwrap();
        let machine = MachineChoice::Preset("length".into());
        job.start(&PlanOptions { machine, seed, ..PlanOptions::default() }).unwrap();
        job.run_mut().unwrap().step(5_000);
        let order = order(&job.plan().unwrap());
        let at = |c: u32| order.iter().position(|o| *o == c).unwrap();
        assert_eq!(at(0).abs_diff(at(2)), 1, "seed {seed}: {order:?}");
    }
}
