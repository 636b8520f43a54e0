//! Compares the closed form with a fine simulation, and tests properties that hold for any machine.

use super::*;
use crate::geometry::Arc;
use crate::machine::presets;
use std::f64::consts::PI;

fn machine(deviation: Option<f64>) -> Profile {
    let mut p = presets().swap_remove(0);
    p.junction_deviation = deviation;
    p
}

fn process(speed: f64, accel: f64) -> Process {
    Process::new(speed, Some(accel), 1.0)
}

fn polyline(points: &[(f64, f64)]) -> Vec<Segment> {
    let points: Vec<DVec2> = points.iter().map(|p| DVec2::new(p.0, p.1)).collect();
    points.windows(2).map(|w| Segment::line(w[0], w[1])).collect()
}

/// A path with every case: lines, tangent and sharp joints, wide and tight arcs, a short element, a reversal.
fn mixed() -> Vec<Segment> {
    let mut path = polyline(&[(0.0, 0.0), (30.0, 0.0)]);
    path.push(Segment::Arc(Arc::from_angles(DVec2::new(30.0, 5.0), 5.0, -PI / 2.0, PI)));
    path.extend(polyline(&[(30.0, 10.0), (29.9, 10.0), (20.0, 14.0), (20.0, 40.0), (20.0, 20.0)]));
    path.push(Segment::Arc(Arc::from_angles(DVec2::new(19.0, 20.0), 1.0, 0.0, -PI)));
    path.push(Segment::Arc(Arc::from_angles(DVec2::new(-42.0, 20.0), 60.0, 0.0, 0.7)));
    path
}

/// Applies the same rules without a closed form: speed limits on a fine grid along the path, a forward and a backward
/// pass over the grid, and the sum of steps divided by mean speeds.
fn simulate(profile: &Profile, process: &Process, path: &[Segment], per_mm: f64) -> f64 {
    let accel = process.accel.unwrap();
    let mut limits: Vec<f64> = Vec::new();
    let mut steps = Vec::new();
    for (i, s) in path.iter().enumerate() {
        let pieces = (s.length() * per_mm).ceil().max(1.0);
        // The speed limit on an arc has a simulation of its own in `tests/it/machine_time.rs`.
        let top = ElementLimits::new(profile, process.speed, accel, s).top2.sqrt();
        let corner = if i == 0 {
            0.0
        } else {
            junction_speed2(profile.junction_deviation, accel, path[i - 1].tangent(1.0), s.tangent(0.0))
                .sqrt()
        };
        match limits.last_mut() {
            Some(last) => *last = last.min(corner).min(top),
            None => limits.push(0.0),
        }
        let mut k = 0.0;
        while k < pieces {
            steps.push(s.length() / pieces);
            limits.push(top);
            k += 1.0;
        }
    }
    *limits.last_mut().unwrap() = 0.0;
    let mut speed = limits;
    for i in 0..steps.len() {
        speed[i + 1] = speed[i + 1].min((speed[i] * speed[i] + 2.0 * accel * steps[i]).sqrt());
    }
    for i in (0..steps.len()).rev() {
        speed[i] = speed[i].min((speed[i + 1] * speed[i + 1] + 2.0 * accel * steps[i]).sqrt());
    }
    // Under constant acceleration the mean of both speeds is exact; only steps that contain a change of acceleration
    // are not.
    steps.iter().zip(speed.windows(2)).map(|(d, v)| 2.0 * d / (v[0] + v[1])).sum()
}

#[track_caller]
fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a} is not {b}");
}

#[test]
fn agrees_with_a_fine_simulation() {
    for deviation in [None, Some(0.0), Some(0.01), Some(0.5)] {
        for (speed, accel) in [(5.0, 800.0), (35.0, 2000.0), (400.0, 5000.0), (1000.0, 300.0)] {
            let (m, p) = (machine(deviation), process(speed, accel));
            near(cut_time(&m, &p, &mixed()), simulate(&m, &p, &mixed(), 500.0), 2e-4);
        }
    }
}

#[test]
fn values_by_hand() {
    let square = polyline(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)]);
    // The head stops at every corner: four times 10 mm at 100 mm/s, with 5 mm up and 5 mm down at 1000 mm/s2.
    near(cut_time(&machine(Some(0.0)), &process(100.0, 1000.0), &square), 4.0 * 0.2, 1e-12);
    // The corners are passed at full speed: 40 mm, and 0.1 s for one start and one stop.
    near(cut_time(&machine(None), &process(100.0, 1000.0), &square), 0.4 + 0.1, 1e-12);
    // GRBL's junction speed for a right angle: sin 45 deg / (1 - sin 45 deg) = 1 + sqrt 2.
    let corner = (1000.0 * 0.01 * (1.0 + 2.0_f64.sqrt())).sqrt();
    let ends = (100.0 + (100.0 - corner)) / 1000.0 + (10.0 - 5.0 - (1e4 - corner * corner) / 2000.0) / 100.0;
    let inner = 2.0 * (100.0 - corner) / 1000.0 + (10.0 - (1e4 - corner * corner) / 1000.0) / 100.0;
    near(cut_time(&machine(Some(0.01)), &process(100.0, 1000.0), &square), 2.0 * ends + 2.0 * inner, 1e-12);
    // Without acceleration, the time is length divided by speed.
    let at_once = Process::new(80.0, None, 1.0);
    near(cut_time(&machine(Some(0.01)), &at_once, &square), 0.5, 1e-12);
    // A circle of radius 2 mm at 500 mm/s2 is run at sqrt(1000) mm/s, with 1 mm to reach that speed and 1 mm to stop.
    let circle = [Segment::Arc(Arc::circle(DVec2::ZERO, 2.0))];
    let v = 1000.0_f64.sqrt();
    near(
        cut_time(&machine(None), &process(100.0, 500.0), &circle),
        2.0 * v / 500.0 + (4.0 * PI - 2.0) / v,
        1e-12,
    );
    assert!(cut_time(&machine(None), &process(100.0, 500.0), &[]).abs() < 1e-300);
}

#[test]
fn splitting_and_reversing_change_nothing() {
    for deviation in [None, Some(0.0), Some(0.01), Some(0.5)] {
        for (speed, accel) in [(5.0, 800.0), (35.0, 2000.0), (400.0, 5000.0), (1000.0, 300.0)] {
            let (m, p) = (machine(deviation), process(speed, accel));
            let whole = cut_time(&m, &p, &mixed());
            let split: Vec<Segment> = mixed()
                .iter()
                .flat_map(|s| [s.piece(0.0, 0.13), s.piece(0.13, 0.5), s.piece(0.5, 1.0)])
                .collect();
            near(cut_time(&m, &p, &split), whole, 1e-9);
            let reversed: Vec<Segment> = mixed().iter().rev().map(Segment::reversed).collect();
            near(cut_time(&m, &p, &reversed), whole, 1e-9);
        }
    }
}

#[test]
fn higher_limits_are_never_slower() {
    let time = |speed: f64, accel: f64, deviation: f64| {
        cut_time(&machine(Some(deviation)), &process(speed, accel), &mixed())
    };
    let steps = [0.5, 1.0, 1.7, 3.0, 10.0, 100.0];
    for w in steps.windows(2) {
        assert!(time(40.0 * w[1], 1000.0, 0.02) <= time(40.0 * w[0], 1000.0, 0.02));
        assert!(time(200.0, 300.0 * w[1], 0.02) < time(200.0, 300.0 * w[0], 0.02));
        assert!(time(200.0, 1000.0, 0.01 * w[1]) <= time(200.0, 1000.0, 0.01 * w[0]));
    }
}

#[test]
fn corners_cost_time() {
    let square = polyline(&[(0.0, 0.0), (25.0, 0.0), (25.0, 25.0), (0.0, 25.0), (0.0, 0.0)]);
    let circle = [Segment::Arc(Arc::circle(DVec2::ZERO, 50.0 / PI))];
    let (m, p) = (machine(Some(0.01)), process(35.0, 2000.0));
    assert!(cut_time(&m, &p, &square) > cut_time(&m, &p, &circle) * 1.01);
    // A reversal is a stop, so out and back takes twice the time of out.
    let (out, both) = (polyline(&[(0.0, 0.0), (9.0, 0.0)]), polyline(&[(0.0, 0.0), (9.0, 0.0), (0.0, 0.0)]));
    near(cut_time(&m, &p, &both), 2.0 * cut_time(&m, &p, &out), 1e-12);
}

#[test]
fn elements_without_length_change_nothing() {
    let (m, p) = (machine(Some(0.01)), process(35.0, 2000.0));
    let mut path = mixed();
    let whole = cut_time(&m, &p, &path);
    let at = path[0].end();
    path.insert(1, Segment::line(at, at));
    near(cut_time(&m, &p, &path), whole, 1e-15);
}
