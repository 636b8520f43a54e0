//! Moved, turned, at random and hostile.

use super::made::{KERF, bulged, kerfed, machine, spaced, started, told};
use crate::testkit::outlines::drawing;
use crate::testkit::rng::{Rng, seeded};
use kerfway::finding::Severity;
use kerfway::geometry::DVec2;
use rand::RngExt;
use std::f64::consts::PI;

#[test]
fn moved_turned_and_mirrored_drawings_give_the_same_lines() {
    let triangle = vec![DVec2::new(0.0, 0.0), DVec2::new(31.0, 4.0), DVec2::new(12.0, 23.0)];
    let mut outlines = spaced(2, 2, KERF);
    outlines.push(triangle);
    let length = |f: &dyn Fn(DVec2) -> DVec2| {
        let all: Vec<Vec<DVec2>> = outlines.iter().map(|o| o.iter().map(|p| f(*p)).collect()).collect();
        let job = kerfed(&all);
        assert!(told(&job).is_empty());
        (job.beam_sheet().groups[0].faces, job.plan().unwrap().summary.cut_length)
    };
    let wanted = length(&|p| p);
    let (sin, cos) = 0.3_f64.sin_cos();
    let ways: [&dyn Fn(DVec2) -> DVec2; 4] = [
        &|p| p + DVec2::new(-317.3, 44.1),
        &|p| DVec2::new(500.0 - p.x, p.y),
        &|p| DVec2::new(-p.y, p.x),
        &|p| DVec2::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos),
    ];
    for way in ways {
        let (faces, found) = length(way);
        assert_eq!(faces, wanted.0);
        assert!((found - wanted.1).abs() < 1e-6, "{found} {}", wanted.1);
    }
}

/// Outlines around a middle, whose distance from it jumps about, some sides bent.
fn jagged(rng: &mut Rng, corners: usize, at: DVec2) -> Vec<[f64; 3]> {
    let turn = 2.0 * PI / corners as f64;
    (0..corners)
        .map(|k| {
            let angle = turn * (k as f64 + 0.6 * rng.random_range(0.0..1.0));
            let far = 3.0 + 17.0 * rng.random_range(0.0..1.0) * rng.random_range(0.0..1.0);
            let bulge =
                if rng.random_range(0.0..1.0) < 0.4 { 0.6 * rng.random_range(0.0..1.0) - 0.3 } else { 0.0 };
            [at.x + far * angle.cos(), at.y + far * angle.sin(), bulge]
        })
        .collect()
}

#[test]
fn outlines_of_all_kinds_are_offset_or_reported() {
    let mut rng = seeded(11);
    let (mut moved, mut kept) = (0, 0);
    for _ in 0..40 {
        let outlines: Vec<Vec<[f64; 3]>> = (0..12)
            .map(|k| {
                let corners = 3 + (rng.random_range(0.0..1.0) * rng.random_range(0.0..1.0) * 60.0) as usize;
                jagged(&mut rng, corners, DVec2::new(50.0 * f64::from(k), 0.0))
            })
            .collect();
        let slices: Vec<&[[f64; 3]]> = outlines.iter().map(Vec::as_slice).collect();
        let kerf = 0.05 + 2.0 * rng.random_range(0.0..1.0) * rng.random_range(0.0..1.0);
        // Checked, place by place.
        let job = started(bulged(&slices, &[]), machine(kerf));
        let closed = job.beam_sheet().contours.iter().filter(|c| c.boundary().is_some());
        let (some, none): (Vec<_>, Vec<_>) = closed.partition(|c| c.drawn.is_some());
        assert_eq!(told(&job).iter().filter(|f| f.severity == Severity::Warning).count(), none.len());
        for c in &some {
            let drawn = c.drawn.as_ref().unwrap();
            assert!(c.path.area() > drawn.area() && c.path.closed);
        }
        moved += some.len();
        kept += none.len();
    }
    assert!(moved > 300 && kept > 10, "{moved} {kept}");
}

/// Hostile: thousands of spikes from one place, and a comb of thousands of teeth.
#[test]
fn dense_outlines_terminate_in_time() {
    let began = std::time::Instant::now();
    let n = 10_000;
    let star: Vec<DVec2> = (0..2 * n)
        .map(|k| {
            let angle = PI * f64::from(k) / f64::from(n);
            DVec2::new(angle.cos(), angle.sin()) * if k % 2 == 0 { 100.0 } else { 0.01 }
        })
        .collect();
    let mut comb: Vec<DVec2> = vec![DVec2::new(200.0, -10.0), DVec2::new(400.0, -10.0)];
    comb.extend((0..n).rev().flat_map(|k| {
        let x = 200.0 + 200.0 * f64::from(k) / f64::from(n);
        [DVec2::new(x + 0.01, 50.0), DVec2::new(x, 0.0)]
    }));
    let job = started(drawing(&[star, comb]), machine(5.0));
    assert!(job.beam_sheet().contours.iter().all(|c| c.drawn.is_none()));
    // A guard against endless loops, not a target: it takes 9 s alone and 25 s next to two builds.
    assert!(began.elapsed().as_secs() < 120, "{:?}", began.elapsed());
}
