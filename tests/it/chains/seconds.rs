//! Quotes and calibration count the seconds of chains as the plan does: with the speed of the cut that a start from the edge of the sheet leads to.

use super::{near, starting};
use crate::testkit::dxf_text::document;
use kerfway::calibration::{Measured, calibrate};
use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Process, Profile};
use kerfway::plan::document::Move;
use kerfway::quote::Terms;
use kerfway::sheet::Operation;

/// Squares of 20 mm on layers A, B and C, 10 mm from the left edge of a sheet of 300 x 200 mm, too far apart for chains.
fn drawing() -> Vec<u8> {
    let rectangle = |layer: &str, [x, y]: [f64; 2], [width, height]: [f64; 2]| {
        let corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)];
        let points: String = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
        format!("0\nLWPOLYLINE\n8\n{layer}\n90\n4\n70\n1\n{points}")
    };
    let square = |layer, y| rectangle(layer, [10.0, y], [20.0, 20.0]);
    let sheet = rectangle("SHEET", [0.0, 0.0], [300.0, 200.0]);
    let entities = [sheet, square("A", 40.0), square("B", 90.0), square("C", 140.0)].concat();
    document(4, "", &entities).into_bytes()
}

#[test]
fn starts_at_the_edge_are_counted_at_the_speed_of_their_cut() {
    let machine = Profile { cut: Process::new(50.0, None, 0.8), ..starting(15.0, 1.0) };
    let layers = [("A", 60.0), ("B", 80.0), ("C", 100.0)];
    let layer = |(name, speed)| LayerChoice { speed: Some(speed), ..LayerChoice::new(name, Operation::Cut) };
    let sheet = LayerChoice::new("SHEET", Operation::Ignore);
    let choices = layers.map(layer).into_iter().chain([sheet]).collect();
    let load = LoadOptions { layers: choices, ..LoadOptions::default() };
    let mut job = Job::load(drawing(), "three.dxf", &load).unwrap();
    job.start(&PlanOptions {
        machine: MachineChoice::Profile(Box::new(machine.clone())),
        seed: 1,
        moves: Some(20_000),
        ..PlanOptions::default()
    })
    .unwrap();
    job.run_mut().unwrap().step(20_000);
    let written = job.document().unwrap();
    let starts = written.moves.iter().filter(|m| matches!(m, Move::Chain { .. })).count();
    assert_eq!(starts, 3, "{:?}", written.moves);

    let measured = Measured { plan: written.clone(), seconds: written.summary.total_time };
    near(calibrate(&machine, &[measured]).unwrap().jobs[0].before, written.summary.total_time);

    let quote = job.quote(&Terms::default()).unwrap();
    let items = quote.parts.iter().flat_map(|group| &group.items);
    let mut shares: Vec<f64> = items.map(|item| item.times.cut).collect();
    shares.sort_by(f64::total_cmp);
    // Four sides, and the way from the edge.
    let mut expected = layers.map(|(_, speed)| (80.0 + 10.0) / speed);
    expected.sort_by(f64::total_cmp);
    shares.iter().zip(&expected).for_each(|(&share, &expected)| near(share, expected));
    assert_eq!(shares.len(), 3);
}
