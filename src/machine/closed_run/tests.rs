//! Compares the prices with the look-ahead itself, run over the path re-cut to start at the place.

use super::*;
use crate::geometry::{Arc, DVec2, Path, math};
use crate::machine::{SharpCorner, presets, process_time};
use std::f64::consts::{PI, TAU};

fn polygon(points: &[(f64, f64)]) -> Path {
    let point = |k: usize| DVec2::from(points[k % points.len()]);
    Path::new((0..points.len()).map(|k| Segment::line(point(k), point(k + 1))).collect(), true)
}

/// A regular polygon with one corner cut off very slightly, so that long and very short elements are neighbours.
fn regular(sides: u32, radius: f64) -> Path {
    let at = |k: u32| radius * math::unit(TAU * f64::from(k) / f64::from(sides));
    let mut points: Vec<(f64, f64)> = (0..sides).map(|k| at(k).into()).collect();
    points.push((radius, -1e-3));
    polygon(&points)
}

/// Two half circles joined by lines.
fn slot(length: f64, radius: f64) -> Path {
    let p = DVec2::new;
    let turn = |x: f64, from: f64, to: f64| {
        Segment::Arc(Arc::new(p(x, from * radius), p(x, to * radius), p(x, 0.0), true))
    };
    let lines = [(0.0, -radius, length), (length, radius, 0.0)];
    let [a, b] = lines.map(|(from, y, to)| Segment::line(p(from, y), p(to, y)));
    Path::new(vec![a, turn(length, -1.0, 1.0), b, turn(0.0, 1.0, -1.0)], true)
}

/// A wave of tight tangent arcs, like a fitted spline, closed by corners and a line back.
fn wave(bends: u32, radius: f64) -> Path {
    let mut segments = Vec::new();
    for k in 0..bends {
        let centre = DVec2::new(2.0 * radius * f64::from(k), 0.0);
        let sweep = if k % 2 == 0 { -PI } else { PI };
        segments.push(Segment::Arc(Arc::new(
            centre - DVec2::X * radius,
            centre + DVec2::X * radius,
            centre,
            sweep > 0.0,
        )));
    }
    let (from, to) = (segments[segments.len() - 1].end(), segments[0].start());
    let corner = DVec2::new(0.3 * from.x, -30.0);
    segments.extend([Segment::line(from, corner), Segment::line(corner, to)]);
    Path::new(segments, true)
}

fn shapes() -> Vec<(&'static str, Path)> {
    vec![
        ("square", polygon(&[(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0)])),
        ("small square", polygon(&[(0.0, 0.0), (0.2, 0.0), (0.2, 0.2), (0.0, 0.2)])),
        ("spike", polygon(&[(0.0, 0.0), (100.0, 0.5), (0.0, 1.0), (50.0, 0.5)])),
        ("60 sides", regular(60, 20.0)),
        ("2,000 sides", regular(2000, 15.0)),
        ("slot", slot(30.0, 0.4)),
        ("large slot", slot(300.0, 90.0)),
        ("wave", wave(9, 0.3)),
        ("wide wave", wave(4, 12.0)),
        ("out and back", polygon(&[(0.0, 0.0), (25.0, 0.0)])),
        (
            "half disc",
            Path::new(
                vec![
                    Segment::Arc(Arc::from_angles(DVec2::ZERO, 6.0, 0.0, PI)),
                    Segment::line(6.0 * math::unit(PI), DVec2::new(6.0, 0.0)),
                ],
                true,
            ),
        ),
    ]
}

#[test]
fn extra_seconds_match_the_path_re_cut_to_start_there() {
    for mut profile in presets() {
        let free = profile.junction_deviation;
        // The last two settings wait in the corners of the triangle, and also in those of the square.
        let settings =
            [(free, 0.0), (None, 0.0), (Some(0.0), 0.0), (Some(0.4), 0.0), (free, 1.5), (None, 1.6)];
        for (deviation, angle) in settings {
            profile.junction_deviation = deviation;
            profile.sharp_corner = (angle > 0.0).then_some(SharpCorner { angle, time: 0.7 });
            for (name, path) in shapes() {
                for mark in [false, true] {
                    let time = |along: f64| {
                        process_time(&profile, profile.process(mark), mark, &path.starting_at(along).segments)
                    };
                    let Some(run) = ClosedRun::new(&profile, profile.process(mark), mark, &path.segments)
                    else {
                        assert_eq!(profile.process(mark).accel, None);
                        continue;
                    };
                    let length = path.length();
                    let every = (path.segments.len() / 50).max(1);
                    let corners =
                        run.joints().step_by(every).flat_map(|(c, _)| [c, c + 1e-4, c + length - 1e-4]);
                    let inside = (0..=97).map(|k| length * f64::from(k) / 97.0);
                    for along in corners.chain(inside).map(|a| a % length).chain([length]) {
                        let (wanted, extra) = (time(along), run.extra(along));
                        let found = run.least() + extra;
                        assert!(
                            (found - wanted).abs() <= 1e-9 * wanted,
                            "{} {name} {deviation:?} at {along}: {found}, not {wanted}",
                            profile.name
                        );
                    }
                }
            }
        }
    }
}

/// The lower bound replaces the extra seconds by straight functions below them.
#[test]
fn between_kinks_the_extra_seconds_lie_above_their_chords() {
    let mut looked = 0;
    for mut profile in presets() {
        let free = profile.junction_deviation;
        for (deviation, angle) in [(free, 0.0), (None, 0.0), (Some(0.4), 0.0), (free, 1.5), (None, 1.6)] {
            profile.junction_deviation = deviation;
            profile.sharp_corner = (angle > 0.0).then_some(SharpCorner { angle, time: 0.7 });
            for (name, path) in shapes() {
                let Some(run) = ClosedRun::new(&profile, profile.process(false), false, &path.segments)
                else {
                    continue;
                };
                let length = path.length();
                let mut kinks = run.kinks();
                assert!(
                    kinks.is_sorted() && kinks.iter().all(|k| (0.0..=length).contains(k)),
                    "{name}: {kinks:?}"
                );
                kinks.insert(0, 0.0);
                kinks.push(length);
                let every = (kinks.len() / 100).max(1);
                for ends in kinks.windows(2).step_by(every).filter(|w| w[1] - w[0] > 1e-6) {
                    let at = |share: f64| ends[0] + share * (ends[1] - ends[0]);
                    // Chords of the whole stretch and of parts of it.
                    for (a, b) in [(0.0, 1.0), (0.0, 0.5), (0.5, 1.0), (0.2, 0.3), (0.0, 0.01), (0.99, 1.0)] {
                        let [from, to] = [a, b].map(|share| run.extra(run.on_path(at(share))));
                        for share in [0.1, 0.35, 0.5, 0.8] {
                            let (chord, real) =
                                (from + share * (to - from), run.extra(at(a + share * (b - a))));
                            assert!(
                                real >= chord - 1e-9,
                                "{} {name} {deviation:?} {angle} in {ends:?}, {a} to {b}: {real} under {chord}",
                                profile.name
                            );
                            looked += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(looked > 10_000, "{looked}");
}

/// [`ClosedRun::least`] was less than the run from any entry, so that no job with corners was proven optimal to the end.
#[test]
fn some_entry_has_no_extra_seconds() {
    for profile in presets() {
        for (name, path) in shapes() {
            let Some(run) = ClosedRun::new(&profile, &profile.cut, false, &path.segments) else { continue };
            let length = path.length();
            let places =
                (0..20_000).map(|k| length * f64::from(k) / 20_000.0).chain(run.joints().map(|j| j.0));
            let least = places.map(|along| run.extra(along)).fold(f64::INFINITY, f64::min);
            assert!(least < 1e-6, "{} {name}: {least}", profile.name);
        }
    }
}

/// At GRBL's defaults the head takes a right angle at 7 mm/s and the sides at 35 mm/s, so a stop at a corner costs a
/// fraction of one on a side.
#[test]
fn a_stop_is_cheap_at_a_sharp_corner_and_expensive_in_the_middle_of_a_side() {
    let profile = presets().swap_remove(0);
    let (_, square) = shapes().swap_remove(0);
    let run = ClosedRun::new(&profile, &profile.cut, false, &square.segments).unwrap();
    let (v, a) = (35.0, 2000.0);
    // Stopping from v and returning to it takes v / a each, over v^2 / 2a each, which take half of that at speed v.
    let middle = run.extra(20.0) + run.stop;
    assert!((middle - v / a).abs() < 1e-12, "{middle}");
    let corner = (a * 0.01 * (1.0 + 2.0_f64.sqrt())).sqrt();
    // Two ramps between rest and the corner's speed, less the time over the way by which the ramps from rest are
    // longer.
    let lost = corner * corner / (2.0 * a) / v;
    let at_corner = run.extra(40.0) + run.stop;
    assert!((at_corner - 2.0 * (corner / a - lost)).abs() < 1e-12, "{at_corner}");
    assert!(run.extra(40.0) < 0.5 * run.extra(20.0));
}

#[test]
fn uniform_runs_have_no_extra_seconds() {
    for profile in presets() {
        let circle = [Segment::Arc(Arc::circle(DVec2::ONE, 5.0))];
        let run = ClosedRun::new(&profile, &profile.cut, false, &circle);
        assert!(run.is_none_or(|r| r.is_uniform() && r.extra(1.0) == 0.0));
        assert_eq!(ClosedRun::new(&profile, &profile.cut, false, &[]), None);
        let point = [Segment::line(DVec2::ONE, DVec2::ONE)];
        assert_eq!(ClosedRun::new(&profile, &profile.cut, false, &point), None);
    }
    let length = presets().into_iter().find(|p| p.name == "length").unwrap();
    assert_eq!(ClosedRun::new(&length, &length.cut, false, &shapes()[0].1.segments), None);
}
