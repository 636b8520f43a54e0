//! Yang's example: the drawing is the instance, and the genetic algorithm never beats the proved optimum.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::{machine, p};
use kerfway::drawing::ReadOptions;
use kerfway::dxf;
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::problem::{self, Problem};
use kerfway::sheet;
use kerfway::solve::Status;
use kerfway::solve::papers;
use serde_json::Value;

fn fixture(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/fixtures/yang/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The sheet of the drawing, entered at the feature points of the instance; and the optimum.
fn instance() -> (Problem, f64) {
    let drawing = dxf::read(&fixture("yang-27.dxf"), &ReadOptions::default()).unwrap();
    let sheet = sheet::build(&drawing, &sheet::SheetOptions::default());
    let machine = Profile { return_home: false, ..machine("length-chebyshev") };
    let mut problem = problem_of(&sheet, &machine);
    let data: Value = serde_json::from_slice(&fixture("yang-27.json")).unwrap();
    let contours = data["contours"].as_array().unwrap();
    assert_eq!(problem.items.len(), contours.len());
    let old = std::mem::take(&mut problem.nodes);
    for (item, contour) in problem.items.iter_mut().zip(contours) {
        let template = old[item.nodes.start as usize];
        let path = item.track.take().unwrap();
        let first = u32::try_from(problem.nodes.len()).unwrap();
        for point in contour["points"].as_array().unwrap() {
            let entry = p(point[0].as_f64().unwrap(), point[1].as_f64().unwrap());
            let off = path.segments.iter().map(|s| s.nearest(entry).1).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-4, "{entry} lies on its contour, within a hundredth of a millimetre");
            let along = f64::from(u32::try_from(problem.nodes.len()).unwrap());
            let twin = u32::try_from(problem.nodes.len()).unwrap();
            problem.nodes.push(problem::Node { entry, exit: entry, along, twin, ..template });
        }
        item.nodes = first..u32::try_from(problem.nodes.len()).unwrap();
    }
    (problem, data["optimum"]["chebyshev"].as_f64().unwrap())
}

#[test]
fn the_genetic_algorithm_saves_time_but_does_not_beat_the_optimum() {
    let (problem, optimum) = instance();
    let mut search = papers::method("dual-coding-ga", "{}").unwrap().start(&problem, 1, None);
    let first = search.best().cost;
    while search.step(100_000).status == Status::Running {}
    let found = search.best().cost;
    // A random path is three times as long as the result.
    assert!(found >= optimum - 1e-6 && found < 0.6 * first, "{first} {found} {optimum}");
}
