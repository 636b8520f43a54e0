//! Far from the origin: GRBL computes in 32-bit floats, which are coarse there.

use crate::testkit::gcode::{Motion, Program};
use crate::testkit::paths::Element;
use crate::testkit::plans::{self, Stop};
use glam::DVec2;
use kerfway::finding::{Code, Severity};
use kerfway::geometry::{Arc, Path, Segment};
use kerfway::job::{Job, JobError, LoadOptions, OutputKind, PlanOptions};
use kerfway::output;
use kerfway::sheet::Operation;
use std::f64::consts::{PI, TAU};

/// Arcs of many radii and sweeps around a place, mm.
fn arcs_at(place: DVec2) -> Vec<Arc> {
    let mut arcs = Vec::new();
    for (k, radius) in [0.05, 0.3, 1.0, 2.5, 7.0, 20.0, 60.0, 333.3, 2000.0].into_iter().enumerate() {
        for (n, sweep) in [0.02, 0.3, -1.0, PI / 2.0, -3.0, 4.5, TAU, -TAU].into_iter().enumerate() {
            let (k, n) = (k as f64, n as f64);
            let center = place + DVec2::new(37.123 * k + 0.0137 * n, 11.7 * n + 0.071 * k);
            arcs.push(Arc::from_angles(center, radius, 0.7 * n + 0.3 * k, sweep));
        }
    }
    arcs
}

/// The program that cuts each arc.
fn program(arcs: &[Arc]) -> Result<String, String> {
    let stop = |a: &Arc| Stop {
        layer: 0,
        operation: Operation::Cut,
        path: Path::new(vec![Segment::Arc(*a)], a.sweep.abs() >= TAU),
    };
    let stops = arcs.iter().map(stop).collect();
    let (sheet, plan) = plans::plan_of(stops, &[("0", 7)], &plans::machine());
    output::gcode(
        &plan,
        &output::SheetFacts::of(&sheet),
        &plans::machine(),
        "far.dxf",
        kerfway::machine::Start::Absolute,
    )
    .map_err(|e| e.to_string())
}

fn read(text: &str) -> Program {
    crate::testkit::gcode::run(text).unwrap_or_else(|e| panic!("{e}"))
}

fn works(program: &Program) -> Vec<&Motion> {
    program.motions().filter(|m| !m.rapid).collect()
}

#[test]
fn arcs_far_from_the_origin_are_accepted_by_the_controller() {
    for far in [0.0, 4e3, 1e4, 3e4, 6e4, 1.2e5] {
        for direction in [DVec2::X, DVec2::Y, DVec2::new(-0.7, -0.7)] {
            let arcs = arcs_at(direction * far);
            let program = read(&program(&arcs).unwrap());
            let works = works(&program);
            for arc in &arcs {
                for f in 0..=16 {
                    let p = Segment::Arc(*arc).at(f64::from(f) / 16.0);
                    let off = works.iter().map(|m| m.path.distance(p)).fold(f64::INFINITY, f64::min);
                    assert!(off <= 0.002, "{off} mm off at {far}: {arc:?}");
                }
            }
            let written: f64 = works.iter().map(|m| m.path.length()).sum();
            let wanted: f64 = arcs.iter().map(|a| a.radius() * a.sweep.abs()).sum();
            assert!((written / wanted - 1.0).abs() < 1e-3, "{written} mm, not {wanted}");
        }
    }
}

#[test]
fn arcs_stay_arcs_within_some_metres_of_the_origin() {
    for far in [0.0, 1000.0, 3900.0, 7000.0] {
        let arcs = arcs_at(DVec2::new(-far, far / 2.0));
        let program = read(&program(&arcs).unwrap());
        let is_arc = |m: &&&Motion| m.path.arc.is_some();
        // Full circles and more than half a turn: two pieces each; a flat one is a line.
        let pieces: usize = arcs.iter().map(|a| if a.sweep.abs() > PI { 2 } else { 1 }).sum();
        let flat = arcs.iter().filter(|a| a.radius() * a.sweep * a.sweep / 8.0 <= 0.0005).count();
        assert_eq!(works(&program).iter().filter(is_arc).count(), pieces - flat, "at {far}");
    }
}

#[test]
fn an_arc_whose_centre_is_far_away_is_written_as_chords() {
    // 0.3 m of an arc of 90 m: its centre would be off by a hundredth of a millimetre in the controller's numbers.
    let arc = Arc::from_angles(DVec2::new(20.0, -9e4), 9e4, PI / 2.0, 1.0 / 300.0);
    let program = read(&program(&[arc]).unwrap());
    let works = works(&program);
    assert!(works.len() > 3 && works.iter().all(|m| m.path.arc.is_none()), "{works:?}");
    let elements: Vec<Element> = works.iter().map(|m| m.path).collect();
    crate::testkit::paths::assert_same_path(&elements, &[Segment::Arc(arc)], 0.002);
}

#[test]
fn a_program_beyond_the_precision_of_the_controller_is_refused() {
    let error = program(&arcs_at(DVec2::new(3e5, 10.0))).unwrap_err();
    assert!(error.contains("x 30") && error.contains("0.031 mm") && error.contains("origin"), "{error}");
    assert!(program(&arcs_at(DVec2::new(0.0, -2e5))).unwrap_err().contains("0.016 mm"));
}

fn loaded(x: f64) -> Job {
    let corners = [(x, 5.0), (x + 30.0, 5.0), (x + 30.0, 40.0), (x, 40.0)];
    let square = corners.map(DVec2::from).to_vec();
    Job::load(crate::testkit::outlines::drawing(&[square]), "far.dxf", &LoadOptions::default()).unwrap()
}

#[test]
fn a_drawing_hundreds_of_metres_from_the_origin_gives_an_error_finding() {
    let far = |job: &Job| {
        let found = job.sheet().findings.iter().find(|f| f.code == Code::FarFromOrigin).cloned();
        found.map(|f| (f.severity, f.message, f.at))
    };
    for near in [0.0, 131_000.0] {
        assert_eq!(far(&loaded(near)), None);
    }
    let mut job = loaded(3e5);
    let (severity, message, at) = far(&job).unwrap();
    assert_eq!((severity, at), (Severity::Error, Some(DVec2::new(300_030.0, 40.0))));
    assert!(message.contains("300.0 m") && message.contains("0.031 mm"), "{message}");
    job.start(&PlanOptions { moves: Some(10), allow_off_bed: true, ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(10);
    assert!(job.output(OutputKind::Json).unwrap().contains("far-from-origin"));
    assert!(matches!(job.output(OutputKind::Gcode), Err(JobError::Output(_))));
}
