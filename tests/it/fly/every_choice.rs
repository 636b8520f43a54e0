//! Rows and grids on the run against every way to cut them.

use super::flying;
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::sheets::{Builder, circle, p, rectangle, slot};
use kerfway::geometry::{DVec2, Segment};
use kerfway::machine::{AirTime, Profile, cut_time};
use std::f64::consts::{PI, TAU};

/// A run over some holes of a row: its ends and its seconds.
fn run_over(holes: &[f64], y: f64, above: bool, machine: &Profile) -> ([DVec2; 2], f64) {
    let r = if above { 1.5 } else { -1.5 };
    let mut motion: Vec<Segment> = Vec::new();
    let mut ends = [p(holes[0], y + r); 2];
    for &x in holes {
        let at = p(x, y + r);
        if at != ends[1] {
            motion.push(Segment::line(ends[1], at));
        }
        let (from, ahead) =
            (if above { PI / 2.0 } else { -PI / 2.0 }, x >= holes[0] && holes[0] <= holes[holes.len() - 1]);
        // With the holes on the left, around them counter-clockwise.
        let sweep = if ahead == above { -TAU } else { TAU };
        motion.push(Segment::Arc(kerfway::geometry::Arc::from_angles(p(x, y), 1.5, from, sweep)));
        ends[1] = at;
    }
    // A hole alone is pierced at rest.
    let start =
        if holes.len() > 1 { machine.beam_off_delay } else { machine.pierce_time + machine.beam_delays() };
    (ends, cut_time(machine, &machine.cut, &motion) + start)
}

/// The least seconds of every order, side and direction of these runs.
fn least(runs: &[&[f64]], ys: &[f64], machine: &Profile) -> f64 {
    let air = AirTime::new(machine);
    let ways: Vec<Vec<([DVec2; 2], f64)>> = runs
        .iter()
        .zip(ys)
        .map(|(run, &y)| {
            let back: Vec<f64> = run.iter().rev().copied().collect();
            [true, false]
                .into_iter()
                .flat_map(|above| [run_over(run, y, above, machine), run_over(&back, y, above, machine)])
                .collect()
        })
        .collect();
    fn go(air: &AirTime, ways: &[Vec<([DVec2; 2], f64)>], left: u32, head: DVec2) -> f64 {
        if left == 0 {
            return air.seconds(head, DVec2::ZERO);
        }
        let mut best = f64::INFINITY;
        for (k, ways_of) in ways.iter().enumerate().filter(|(k, _)| left >> k & 1 == 1) {
            for (ends, seconds) in ways_of {
                let rest = go(air, ways, left & !(1 << k), ends[1]);
                best = best.min(air.seconds(head, ends[0]) + seconds + rest);
            }
        }
        best
    }
    go(&air, &ways, (1 << runs.len()) - 1, DVec2::ZERO)
}

#[test]
fn six_holes_are_cut_as_well_as_by_every_way_to_divide_their_rows() {
    let machine = flying(30.0, 0.0);
    for (k, (pitch, between, shift)) in
        [(6.0, 8.0, 0.0), (12.0, 5.0, 3.0), (25.0, 40.0, 60.0)].into_iter().enumerate()
    {
        let xs = [
            [30.0, 30.0 + pitch, 30.0 + 2.0 * pitch],
            [30.0 + shift, 30.0 + shift + pitch, 30.0 + shift + 2.0 * pitch],
        ];
        let ys = [25.0, 25.0 + between];
        let mut b = Builder::new();
        for (row, y) in xs.iter().zip(ys) {
            for &x in row {
                b.cut(circle(p(x, y), 1.5), None);
            }
        }
        let (_, _, plan) = search_of_exact_cost(&b.sheet, &machine, 1);
        // Each row as one run, in two, or hole by hole.
        let divided = |row: &[f64; 3]| -> Vec<Vec<Vec<f64>>> {
            let [a, b, c] = *row;
            vec![
                vec![vec![a, b, c]],
                vec![vec![a], vec![b, c]],
                vec![vec![a, b], vec![c]],
                vec![vec![a], vec![b], vec![c]],
            ]
        };
        let mut best = f64::INFINITY;
        for one in divided(&xs[0]) {
            for two in divided(&xs[1]) {
                let runs: Vec<&[f64]> = one.iter().chain(&two).map(Vec::as_slice).collect();
                let ys: Vec<f64> = one.iter().map(|_| ys[0]).chain(two.iter().map(|_| ys[1])).collect();
                best = best.min(least(&runs, &ys, &machine));
            }
        }
        let found = plan.summary.total_time;
        assert!((found - best).abs() < 1e-9, "case {k}: {found} s, not {best} s");
        assert_eq!(plan.summary.fly_cuts, 4);
    }
}

#[test]
fn the_search_is_as_good_as_every_order_of_rows_and_single_contours() {
    for seed in 0..6_u32 {
        let mut b = Builder::new();
        let far = f64::from(seed * 7 % 5);
        for k in 0..3 {
            b.cut(circle(p(20.0 + 8.0 * f64::from(k), 20.0 + far), 2.0), None);
        }
        b.cut(slot(p(60.0 + far * 9.0, 30.0), 10.0, 2.0), None);
        b.cut(rectangle(p(10.0, 60.0 + far * 3.0), p(20.0, 12.0)), None);
        let (_, _, plan) = search_of_exact_cost(&b.sheet, &flying(20.0, 0.2), seed.into());
        assert_eq!(plan.summary.fly_cuts, 2);
    }
}
