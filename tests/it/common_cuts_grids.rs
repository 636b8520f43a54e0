//! Grids of rectangles against a bound of what any plan takes.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours"
)]

use crate::testkit::plates::{grid, job, thick};
use kerfway::geometry::DVec2;
use kerfway::machine::{Profile, air_time};
use kerfway::plan::Plan;
use kerfway::sheet::CommonCuts;

/// Cutting at one speed: the same for every plan.
fn even() -> Profile {
    let mut machine = thick();
    machine.cut.accel = None;
    machine
}

/// Lower bound of the seconds besides cutting for any plan of a grid of m by n.
///
/// Trails are what is cut between two air moves, stops for pre-cuts on the way included. Where an odd number of elements
/// meets (the ends of the lines inside, on the frame, three elements each), a trail begins or ends; so there are at least
/// q = m + n - 2 of them, and 2 (r - q) more ends where r are made. S: seconds of a start of the beam, P: of a piercing, C: of
/// a pre-cut.
///
/// - The first trail takes P + S.
/// - Every other one takes S, and P where nothing was cut, or C where something was: then the beam has stopped there before.
///   Either it stopped on the way, for S more; or a trail began or ended there: such a stop is free.
/// - The last element of all ends at a node of areas all of which but one have come loose: it takes C, and a stop likewise.
/// - A free stop is at a node of two trail ends or more, or three, where parity asks for none, or one: t free stops go with t
///   more ends than needed at least (three elements: one stop, two that use it, two more ends; four elements: one for two
///   more, three for four). So r >= q + t / 2, and half a trail more, of S + min(P, C + S) seconds, takes no less than the S
///   that a free stop saves, as P >= S.
///
/// So P + S + (q - 1) (S + min(P, C + S)) + C + S, and the air moves: with the elements they are one walk from home to
/// home, so besides those from and to home they join odd nodes in pairs (or make paths that do, which are no shorter), all
/// but two. Each such move is charged to the two in halves, and takes no less than that to the nearest.
fn bound(m: usize, n: usize, machine: &Profile) -> f64 {
    let (start, pierce, pre_cut) =
        (machine.beam_delays(), machine.pierce_time, machine.pre_cut_time.unwrap());
    assert!(pierce >= start);
    let (w, h) = (20.0, 10.0);
    let mut odd = Vec::new();
    for k in 1..m {
        odd.extend([0.0, h * n as f64].map(|y| DVec2::new(w * k as f64, y)));
    }
    for k in 1..n {
        odd.extend([0.0, w * m as f64].map(|x| DVec2::new(x, h * k as f64)));
    }
    let all = (0..=m).flat_map(|x| (0..=n).map(move |y| DVec2::new(w * x as f64, h * y as f64)));
    let corner = DVec2::splat(100.0);
    let home = all.map(|p| air_time(machine, machine.home(), corner + p)).fold(f64::INFINITY, f64::min);
    let nearest = |p: &DVec2| {
        let others = odd.iter().filter(|o| *o != p);
        others.map(|o| air_time(machine, *p, *o)).fold(f64::INFINITY, f64::min)
    };
    let halves: Vec<f64> = odd.iter().map(|p| 0.5 * nearest(p)).collect();
    let air = halves.iter().sum::<f64>() - 2.0 * halves.iter().copied().fold(0.0, f64::max) + 2.0 * home;
    let further = (odd.len() / 2 - 1) as f64 * (start + pierce.min(pre_cut + start));
    pierce + start + further + pre_cut + start + air
}

fn planned(m: usize, n: usize, machine: &Profile) -> Plan {
    let mut job = job(&grid(m, n), CommonCuts::Best, machine.clone(), None);
    // Neighbours of 100 items are looked for first.
    job.run_mut().unwrap().step(20_000);
    job.plan().unwrap()
}

#[test]
fn grids_are_near_the_bound() {
    let machine = even();
    for (m, n, most) in
        [(2, 2, 1.0), (3, 3, 1.5), (4, 4, 1.9), (5, 4, 2.1), (6, 6, 3.0), (8, 8, 4.1), (10, 10, 5.1)]
    {
        let plan = planned(m, n, &machine);
        let s = &plan.summary;
        let union = (n + 1) as f64 * 20.0 * m as f64 + (m + 1) as f64 * 10.0 * n as f64;
        assert!((s.cut_length - union).abs() < 1e-6, "{m} x {n}: {}", s.cut_length);
        let bound = bound(m, n, &machine);
        let above = |found: f64, bound: f64| 100.0 * (found / bound - 1.0);
        let besides = above(s.total_time - s.cut_time, bound);
        let total = above(s.total_time, bound + union / machine.cut.speed);
        assert!(besides >= 0.0, "{m} x {n}: below the bound");
        // Not one more than in the bound: all that is above it is air.
        assert_eq!((s.pierces, s.pre_cuts as usize), (1, m + n - 2), "{m} x {n}");
        assert!(total <= 1.0 && besides <= most, "{m} x {n}: {total:.2} %, {besides:.2} % above");
    }
}

/// Seconds that a solver has proven any path to take at least (`tests/oracle/grids.py`).
#[derive(serde::Deserialize)]
struct Proven {
    m: usize,
    n: usize,
    seconds: f64,
}

#[test]
fn grids_are_within_two_per_cent_of_what_is_proven() {
    let machine = even();
    let proven: Vec<Proven> = serde_json::from_str(include_str!("../fixtures/grids.json")).unwrap();
    assert_eq!(proven.len(), 10);
    for Proven { m, n, seconds } in proven {
        let s = planned(m, n, &machine).summary;
        let besides = s.total_time - s.cut_time;
        let above = 100.0 * (besides / seconds - 1.0);
        assert!((0.0..=2.0).contains(&above), "{m} x {n}: {besides:.4}, {above:.2} % above");
        // The solver's proof is at least as strong as the bound above.
        assert!(seconds > bound(m, n, &machine) - 1e-3, "{m} x {n}");
    }
}
