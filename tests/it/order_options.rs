//! Part by part, and contours pinned to the beginning or the end: kept by the search, found by the checker.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kerfway::job::{Job, JobError, LayerChoice, LoadOptions, PlanOptions};
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
    assert!(
        told.starts_with("Contour 4000 is listed as first, last or excluded, but there are only "),
        "{told}"
    );
    let mut job = Job::load(bytes, "a.dxf", &LoadOptions::default()).unwrap();
    assert!(matches!(job.reload(&load(4000)), Err(JobError::UnknownContour { contour: 4000, .. })));
    assert!(job.start(&PlanOptions::default()).is_ok(), "what was loaded before is still there");
}
