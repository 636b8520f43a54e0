//! Proofs on machines whose axes have limits of their own: in the best paths both axes of many legs take the same, and what was lost there shrank only
//! with the length of pieces, so that nothing but squares was ever proven optimal.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::{Builder, XorShift, circle, machine, p, polygon};
use kerfway::geometry::{DVec2, math};
use kerfway::job::problem_of;
use kerfway::machine::{Profile, Travel};
use kerfway::plan::{Certified, LowerBound, MixedLegs, WalkCertificate};
use kerfway::problem::Problem;
use kerfway::solve::{self, Solution};

/// Circles and polygons in rows, each a little off its place.
fn scattered(count: u32, rng: &mut XorShift, machine: &Profile) -> Problem {
    let mut builder = Builder::new();
    for k in 0..count {
        let row = f64::from(k / 4);
        let center =
            p(41.0 * f64::from(k % 4) + rng.between(0.0, 18.0), 37.0 * row + rng.between(20.0, 36.0));
        let radius = rng.between(2.0, 8.0);
        let corner = |i: u32| center + math::unit(radius + f64::from(i)) * radius;
        let shape = if k % 3 == 0 {
            polygon(&(0..6).map(corner).collect::<Vec<DVec2>>())
        } else {
            circle(center, radius)
        };
        builder.cut(shape, None);
    }
    problem_of(&builder.sheet, machine)
}

/// Straight moves within the limits of both axes, and each axis for itself.
fn machines() -> Vec<Profile> {
    let co2 = machine("co2-100w");
    vec![
        Profile { travel: Travel::PerAxis, ..co2.clone() },
        Profile { return_home: false, ..co2.clone() },
        co2,
        machine("fibre-3kw-thin"),
    ]
}

/// A machine without ramps, on which many paths take the same.
fn at_once() -> Profile {
    let mut machine = machine("length-chebyshev");
    machine.rapid.speed = [300.0, 200.0];
    machine
}

fn searched(problem: &Problem) -> Solution {
    let mut search = solve::methods()[0].start(problem, 1, None);
    search.step(300_000);
    search.best().clone()
}

/// The bound with this path known after so much work, and whether nothing is left to do.
fn bound(problem: &Problem, path: &Solution, work: u64) -> (LowerBound, bool) {
    let mut bound = LowerBound::new(problem);
    bound.knows(problem, path);
    let ends = (0..work / 2_000_000).any(|_| !bound.improve(2_000_000, path.cost));
    (bound, ends)
}

#[test]
fn jobs_on_machines_with_two_axes_are_proven_optimal() {
    let mut rng = XorShift::new(11);
    for machine in machines() {
        for count in [6, 8] {
            let problem = scattered(count, &mut rng, &machine);
            let path = searched(&problem);
            let (bound, ends) = bound(&problem, &path, 60_000_000);
            let (name, value) = (&machine.name, bound.value());
            let near = value <= path.cost && value > path.cost * (1.0 - 1e-6);
            assert!(ends && near, "{name}, {count}: {value} of {}", path.cost);
            let certificate = bound.certificate(&problem, 0.0).unwrap();
            assert!(
                !certificate.mixtures.is_empty()
                    && certificate.check(&problem).unwrap() > value * (1.0 - 1e-4),
                "{name}, {count}"
            );
        }
    }
}

/// The bound finds the best entries of the order that it is told of, and says where they are.
#[test]
fn a_better_path_of_the_bound_is_told_stop_by_stop() {
    let mut rng = XorShift::new(13);
    for machine in machines() {
        let problem = scattered(9, &mut rng, &machine);
        // The path of a search that has hardly begun.
        let mut search = solve::methods()[0].start(&problem, 1, None);
        search.step(500);
        let path = search.best().clone();
        let (bound, _) = bound(&problem, &path, 2_000_000);
        let found = bound.better_than(path.cost, &problem).unwrap();
        let name = &machine.name;
        assert!(
            found.cost < path.cost && found.cost >= bound.value(),
            "{name}: {} of {}",
            found.cost,
            path.cost
        );
        assert!(
            (found.cost - bound.known()).abs() < 1e-9 * found.cost,
            "{name}: {} is told as {}",
            bound.known(),
            found.cost
        );
        let mut contours: Vec<u32> =
            found.stops.iter().map(|s| problem.nodes[s.node as usize].item).collect();
        contours.sort_unstable();
        assert_eq!(contours, (0..9).collect::<Vec<u32>>(), "{name}");
        assert!(bound.better_than(found.cost, &problem).is_none(), "{name}");
    }
}

/// Whatever the mixtures are, no more is proven than a path takes.
#[test]
fn any_mixtures_prove_no_more_than_a_path_takes() {
    let mut rng = XorShift::new(12);
    let (mut more, mut less) = (0, 0);
    for machine in machines().into_iter().chain([at_once()]) {
        let problem = scattered(5, &mut rng, &machine);
        let path = searched(&problem);
        let good = bound(&problem, &path, 6_000_000).0.certificate(&problem, 0.0).unwrap();
        let before = good.adds_up_to(&problem).unwrap();
        let count = good.charges.len();
        for _ in 0..40 {
            let mut mixtures = Vec::new();
            for a in 0..count {
                for b in a + 1..count {
                    if rng.below(3) > 0 {
                        let part = |rng: &mut XorShift| u32::try_from(rng.below((1 << 20) + 1)).unwrap();
                        mixtures.push(MixedLegs {
                            items: [a, b],
                            speed: part(&mut rng),
                            ramps: part(&mut rng),
                        });
                    }
                }
            }
            let changed = WalkCertificate { mixtures, all_orders: false, ..good.clone() };
            let proven = changed.adds_up_to(&problem).unwrap();
            let stated = WalkCertificate { bound: i64::try_from(proven).unwrap(), ..changed };
            assert!(stated.check(&problem).unwrap() <= path.cost, "{}", machine.name);
            more += i32::from(proven > before);
            less += i32::from(proven < before);
        }
    }
    assert!(less > 80 && more > 10, "mixtures decide what is proven: {more} {less}");
}
