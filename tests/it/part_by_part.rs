//! Part by part: what lies in the holes of parts, and sequences that would tear parts.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::dxf_text::document;
use kerfway::job::{Job, LayerChoice, LoadOptions, PlanOptions};
use kerfway::plan::{self, Move};
use kerfway::sheet::{Operation, PassOrder};

fn square(x: f64, y: f64, side: f64) -> String {
    let corners = [(x, y), (x + side, y), (x + side, y + side), (x, y + side)];
    let points: String = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
    format!("0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n{points}")
}

fn line(x: f64, y: f64) -> String {
    format!("0\nLINE\n8\n0\n10\n{x}\n20\n{y}\n11\n{}\n21\n{}\n", x + 7.0, y + 4.0)
}

fn load(entities: &[String], sequences: Vec<Vec<u32>>) -> Result<Job, String> {
    let options = LoadOptions { part_by_part: true, sequences, ..LoadOptions::default() };
    let bytes = document(4, "", &entities.concat()).into_bytes();
    Job::load(bytes, "parts.dxf", &options).map_err(|error| error.to_string())
}

/// The contours in the order in which they are cut. The plan passes the check.
fn cut(job: &mut Job) -> Vec<u32> {
    job.start(&PlanOptions { seed: 1, moves: Some(20_000), allow_off_bed: true, ..PlanOptions::default() })
        .unwrap();
    job.run_mut().unwrap().step(20_000);
    let plan = job.plan().unwrap();
    assert_eq!(plan::check(job.beam_sheet(), &job.run().unwrap().machine, &plan), Ok(()));
    let contour = |m: &Move| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None };
    plan.moves.iter().filter_map(contour).collect()
}

/// Three frames with a part and two open cuts in the hole of each: six contours of each frame, its outline first.
fn frames() -> Vec<String> {
    let frame = |x: f64| {
        let part = [square(x + 50.0, 50.0, 20.0), square(x + 55.0, 55.0, 8.0)];
        let slits = [line(x + 30.0, 28.0), line(x + 80.0, 85.0)];
        [vec![square(x, 0.0, 110.0), square(x + 20.0, 20.0, 80.0)], part.to_vec(), slits.to_vec()].concat()
    };
    [0.0, 150.0, 300.0].map(frame).concat()
}

/// The search stopped with an error where an open cut lies in a hole that also holds a part.
#[test]
fn open_cuts_in_a_hole_with_a_part_are_cut_with_the_part_around_the_hole() {
    let mut job = load(&frames(), vec![]).unwrap();
    let order = cut(&mut job);
    assert_eq!(order.len(), 18);
    let frame = |id: u32| job.sheet().contours[id as usize].path.bounds().min.x.div_euclid(150.0);
    let frames: Vec<f64> = order.iter().map(|&c| frame(c)).collect();
    for three in frames.chunks(6) {
        assert!(three.iter().all(|f| f.to_bits() == three[0].to_bits()), "{frames:?}");
    }
    // A plan with an open cut of another frame in between is refused.
    let run = job.run().unwrap();
    let mut torn = job.plan().unwrap();
    let open = |m: &Move| matches!(m, Move::Cut { contour, .. } if !job.sheet().contours[*contour as usize].path.closed);
    let at = torn.moves.iter().rposition(open).unwrap();
    let slit: Vec<Move> = torn.moves.drain(at - 2..=at).collect();
    torn.moves.splice(0..0, slit);
    let found = plan::check(job.sheet(), &run.machine, &torn).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, plan::Violation::Torn { .. })), "{found:?}");
}

/// Such a sequence gave a plan that left out most contours.
#[test]
fn sequences_that_would_tear_a_part_are_refused() {
    // Two parts with two holes each: 0 and 1 lie in 2, 3 and 4 in 5.
    let part = |x: f64| [square(x + 10.0, 15.0, 20.0), square(x + 40.0, 15.0, 20.0), square(x, 0.0, 100.0)];
    let parts = [part(0.0), part(150.0)].concat();
    for sequence in [vec![0, 3], vec![0, 1, 3], vec![2, 5], vec![5, 2], vec![1, 5], vec![4, 0]] {
        let mut job = load(&parts, vec![sequence.clone()]).unwrap();
        let order = cut(&mut job);
        let place = |id: &u32| order.iter().position(|c| c == id).unwrap();
        assert!(sequence.iter().map(place).is_sorted(), "{sequence:?}: {order:?}");
        assert_eq!(order.len(), 6);
    }
    for torn in [vec![vec![0, 3, 1]], vec![vec![0, 3], vec![4, 1]], vec![vec![3, 0], vec![2, 5]]] {
        let why = load(&parts, torn.clone()).map(|_| ()).unwrap_err();
        assert!(why.ends_with("and a part is cut without others in between."), "{torn:?}: {why}");
    }
}

/// The first passes belonged to no part for the planner, and to one for the checker, which refused the plan.
#[test]
fn every_pass_is_run_part_by_part_where_passes_are_run_sheet_by_sheet() {
    for passes in [2, 3] {
        let layers = vec![LayerChoice { passes: Some(passes), ..LayerChoice::new("0", Operation::Cut) }];
        let options = LoadOptions {
            part_by_part: true,
            layers,
            pass_order: PassOrder::Sheet,
            ..LoadOptions::default()
        };
        let bytes = document(4, "", &frames().concat()).into_bytes();
        let mut job = Job::load(bytes, "parts.dxf", &options).unwrap();
        let order = cut(&mut job);
        assert_eq!(order.len(), 18 * passes as usize);
        let sheet = job.beam_sheet();
        let frame = |id: u32| sheet.contours[id as usize].path.bounds().min.x.div_euclid(150.0).to_bits();
        for (pass, run) in (0..).zip(order.chunks(18)) {
            assert!(run.iter().all(|&id| sheet.contours[id as usize].pass == pass), "{passes}: {run:?}");
            let frames: Vec<u64> = run.iter().map(|&id| frame(id)).collect();
            assert!(frames.chunks(6).all(|six| six.iter().all(|f| *f == six[0])), "{passes}: {frames:?}");
        }
        // A plan with a first pass over a contour of another frame in between is refused.
        let mut torn = job.plan().unwrap();
        let first = torn.moves.iter().position(|m| matches!(m, Move::Cut { .. })).unwrap();
        let moved: Vec<Move> = torn.moves.drain(first - 1..=first).collect();
        let at =
            torn.moves.iter().enumerate().filter(|(_, m)| matches!(m, Move::Cut { .. })).nth(9).unwrap().0;
        torn.moves.splice(at + 1..at + 1, moved);
        let found = plan::check(sheet, &job.run().unwrap().machine, &torn).unwrap_err();
        assert!(found.iter().any(|v| matches!(v, plan::Violation::Torn { .. })), "{found:?}");
    }
}
