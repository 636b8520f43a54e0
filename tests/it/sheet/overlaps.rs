//! Drawings of shapes that overlap, share sides and cross themselves, as real drawings do: each of them is planned.

use crate::testkit::dxf_text::{Entity, Scene};
use crate::testkit::rng::{Rng, seeded};
use kerfway::geometry::{DVec2, math};
use kerfway::job::{Job, LoadOptions, OutputKind, PlanOptions};
use rand::RngExt;
use std::f64::consts::TAU;

/// As DXF, in mm.
fn dxf(entities: &[Entity]) -> String {
    Scene { entities: entities.iter().map(|e| (e.clone(), "0".to_owned())).collect(), units: 4 }.dxf()
}

/// The job with its program, or why there is none.
fn planned(entities: &[Entity]) -> Result<Job, String> {
    let mut job = Job::load(dxf(entities).into(), "overlaps.dxf", &LoadOptions::default())
        .map_err(|e| e.to_string())?;
    let options = PlanOptions { seed: 1, moves: Some(200), allow_off_bed: true, ..PlanOptions::default() };
    job.start(&options).map_err(|e| e.to_string())?;
    job.run_mut().map_err(|e| e.to_string())?.step(200);
    job.output(OutputKind::Gcode).map_err(|e| e.to_string())?;
    Ok(job)
}

fn polyline(points: impl IntoIterator<Item = DVec2>) -> Entity {
    Entity::Polyline(points.into_iter().map(|p| (p, 0.0)).collect(), true)
}

fn on_circle(radius: f64, count: u32) -> Vec<DVec2> {
    (0..count).map(|k| math::unit(TAU * f64::from(k) / f64::from(count)) * radius).collect()
}

/// The box of the crossing contour is larger than the disc around it, its area smaller.
#[test]
fn a_contour_that_crosses_itself_lies_inside_the_simple_one_around_it() {
    let mut crossing = on_circle(49.0, 48);
    crossing.swap(10, 11);
    let disc = Entity::Circle(DVec2::ZERO, 50.0);
    for entities in [vec![polyline(crossing.clone()), disc.clone()], vec![disc, polyline(crossing)]] {
        let job = planned(&entities).unwrap();
        let contours = &job.sheet().contours;
        let inner = contours.iter().position(|c| c.self_crossing).unwrap();
        assert_eq!(contours[inner].inside, Some(1 - u32::try_from(inner).unwrap()));
        assert_eq!(contours[1 - inner].inside, None);
    }
}

/// Forty arcs around a circle, each of which begins 30 nanometres beside the end of the one before. A line that bridged a gap would
/// be two corners for the plan, and nothing in the program.
#[test]
fn gaps_that_no_program_shows_take_no_time() {
    let arc = |k: u32| {
        let beside = math::unit(f64::from(k)) * 3e-5;
        Entity::Arc(beside, 30.0, TAU * f64::from(k) / 40.0, TAU * f64::from(k + 1) / 40.0)
    };
    let job = planned(&(0..40).map(arc).collect::<Vec<_>>()).unwrap();
    let [contour] = job.sheet().contours.as_slice() else { panic!("one contour") };
    assert_eq!(contour.path.segments.len(), 40);
    assert!(contour.path.largest_gap() <= 0.0);
    let whole = planned(&[Entity::Circle(DVec2::ZERO, 30.0)]).unwrap();
    let seconds = |job: &Job| job.plan().unwrap().summary.cut_time;
    assert!((seconds(&job) / seconds(&whole) - 1.0).abs() < 1e-3);
}

/// Two squares share a side, so that one of them keeps three sides. A line beside its lower side leaves that only with its tip, which is
/// farther from it than ends are moved.
#[test]
fn a_line_of_one_element_with_only_its_tip_inside_is_cut_before_the_outline() {
    let square = |x: f64| {
        polyline([(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(dx, y)| DVec2::new(x + dx, y)))
    };
    for (length, tip, end) in [(0.3, 0.06, 0.0), (0.3, 0.06, 0.001), (3.0, 0.06, 0.0)] {
        let line = |x: f64| Entity::Line(DVec2::new(x, tip), DVec2::new(x + length, end));
        let job = planned(&[square(0.0), square(20.0), line(5.0), line(30.0)]).unwrap();
        let insides: Vec<Option<u32>> = job.sheet().contours.iter().map(|c| c.inside).collect();
        assert_eq!(insides, [None, None, Some(0), Some(1)], "{length} {tip} {end}");
    }
}

/// Lines of a few elements that run along the sides of two squares, nearer to them than ends are moved or a little farther.
#[test]
fn lines_along_the_sides_of_an_outline_are_planned() {
    let mut rng = seeded(20_261_201);
    let square = |x: f64| {
        polyline([(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|(dx, y)| DVec2::new(x + dx, y)))
    };
    for case in 0..400 {
        let mut line = |x: f64| {
            let count = rng.random_range(2..9);
            let length = [0.02, 0.3, 1.5][rng.random_range(0..3)];
            let point = |k: u32| DVec2::new(x + length * f64::from(k), rng.random_range(-0.01..0.1));
            Entity::Polyline((0..count).map(point).map(|p| (p, 0.0)).collect(), false)
        };
        let entities = [square(0.0), square(20.0), line(5.0), line(25.0)];
        if let Err(sentence) = planned(&entities) {
            panic!("case {case}: {sentence}\n{}", dxf(&entities));
        }
    }
}

/// A shape whose corners lie on a grid, so that sides of different shapes lie on each other, some of them a little apart.
fn random_shape(rng: &mut Rng) -> Entity {
    let apart = [0.0, 0.0, 2e-5, 0.004, 0.03][rng.random_range(0..5)];
    let mut place = |range: u32| {
        let x = f64::from(rng.random_range(0..range)) * 5.0 + apart;
        DVec2::new(x, f64::from(rng.random_range(0..range)) * 5.0)
    };
    let (a, b) = (place(8), place(5) + DVec2::splat(5.0));
    match a.length().to_bits() % 4 {
        0 => polyline([a, a + DVec2::new(b.x, 0.0), a + b, a + DVec2::new(0.0, b.y)]),
        1 => Entity::Line(a, b),
        2 => Entity::Circle(a, b.x),
        _ => polyline([a, b, place(8), place(8), place(8)]),
    }
}

#[test]
fn random_shapes_over_each_other_are_planned() {
    let mut rng = seeded(20_261_130);
    for case in 0..400 {
        let entities: Vec<Entity> = (0..rng.random_range(3..9)).map(|_| random_shape(&mut rng)).collect();
        if let Err(sentence) = planned(&entities) {
            panic!("case {case}: {sentence}\n{}", dxf(&entities));
        }
    }
}
