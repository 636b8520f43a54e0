//! Bounds of contours with corners on machines that must brake: a stop in the middle of a side takes longer than one in a corner. No bound knew
//! that, so that 1 to 2 % of the air of such jobs were never proven, however few contours there were.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::lower_bound::bound;
use crate::testkit::sheets::{Builder, XorShift, machine, p, polygon};
use kerfway::geometry::{DVec2, math};
use kerfway::job::problem_of;
use kerfway::machine::{Profile, SharpCorner};
use kerfway::plan::{Certified, FlowBound, LowerBound};
use kerfway::problem::Problem;
use kerfway::solve;

/// Triangles to hexagons, turned at random, on places of a grid.
fn polygons(count: u32, rng: &mut XorShift, machine: &Profile) -> Problem {
    let mut builder = Builder::new();
    for k in 0..count {
        let center = p(30.0 * f64::from(k % 4) + rng.between(0.0, 6.0), 30.0 * f64::from(k / 4) + 20.0);
        let (sides, turn) = (3 + k % 4, rng.between(0.0, 6.0));
        let corner = |i: u32| {
            center + math::unit(turn + std::f64::consts::TAU * f64::from(i) / f64::from(sides)) * 9.0
        };
        let corners: Vec<DVec2> = (0..sides).map(corner).collect();
        builder.cut(polygon(&corners), None);
    }
    problem_of(&builder.sheet, machine)
}

fn best(problem: &Problem, moves: u64) -> f64 {
    let mut search = solve::methods()[0].start(problem, 1, None);
    search.step(moves);
    search.best().cost
}

#[test]
fn jobs_of_parts_with_corners_are_proven_optimal() {
    let mut rng = XorShift::new(3);
    for name in ["co2-100w", "fibre-3kw-thin", "co2-ruida", "k40"] {
        for (count, closed, waits) in
            [(6, true, false), (9, false, false), (8, true, true), (12, true, false)]
        {
            let mut machine = machine(name);
            machine.return_home = closed;
            // Slow machines pass corners at full speed if they may cut them.
            machine.junction_deviation =
                machine.junction_deviation.map(|d| if name == "k40" { 0.0 } else { d });
            machine.sharp_corner = waits.then_some(SharpCorner { angle: 1.7, time: 0.2 });
            let problem = polygons(count, &mut rng, &machine);
            assert!(problem.items.iter().all(|i| i.uneven().is_some()), "{name}");
            let best = best(&problem, 300_000);
            let proven = bound(&problem, best, 3_000_000_000, 2_000_000);
            assert!((-1e-9..1e-6 * best).contains(&(best - proven)), "{name}, {count}: {proven} of {best}");
        }
    }
}

/// With certificates, which know of the extra seconds as well.
#[test]
fn certificates_prove_more_where_stops_differ() {
    let problem = polygons(10, &mut XorShift::new(8), &machine("fibre-3kw-thin"));
    let mut even = problem.clone();
    even.items.iter_mut().for_each(|i| i.run = None);
    let best = best(&problem, 300_000);
    let by_flows = |problem: &Problem| {
        let mut bound = FlowBound::new(problem).unwrap();
        bound.improve(300_000_000);
        bound.certificate().unwrap()
    };
    let by_walks = |problem: &Problem| {
        let mut bound = LowerBound::new(problem);
        bound.improve(300_000_000, best);
        bound.certificate(problem, 0.0).unwrap()
    };
    let (with, without) = (by_flows(&problem), by_flows(&even));
    let [with, without] = [with.check(&problem).unwrap(), without.check(&even).unwrap()];
    assert!(with <= best && with > 1.002 * without, "flows: {with}, {without} without, of {best}");
    let (with, without) = (by_walks(&problem), by_walks(&even));
    let [with, without] = [with.check(&problem).unwrap(), without.check(&even).unwrap()];
    assert!(
        with <= best && best - with < 0.1 * (best - without),
        "walks: {with}, {without} without, of {best}"
    );
}
