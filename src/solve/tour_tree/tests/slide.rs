//! Entries where axes take different times: none nearby are faster.

use super::{TourTree, circles};
use crate::geometry::DVec2;
use crate::geometry::math::unit;
use crate::machine::{self, AirTime};
use crate::problem::Problem;
use crate::solve::{Search, Solver};

/// Least seconds of the order found, entered within half a millimetre of the entries found, 0.004 mm apart.
fn least_nearby(problem: &Problem, search: &dyn Search) -> f64 {
    let air = AirTime::new(&problem.machine);
    let nearby = |along: f64| (-125..=125).map(move |k| along + 0.004 * f64::from(k));
    let mut reached = vec![(0.0, problem.home)];
    for stop in &search.best().stops {
        let center = problem.nodes[stop.node as usize].entry - DVec2::new(10.0, 0.0);
        let places = nearby(stop.along).map(|along| center + unit(along / 10.0) * 10.0);
        let after =
            |p: DVec2| reached.iter().map(|&(s, q)| s + air.seconds(q, p)).fold(f64::INFINITY, f64::min);
        reached = places.map(|p| (after(p), p)).collect();
    }
    reached.iter().map(|&(s, p)| s + air.seconds(p, problem.home)).fold(f64::INFINITY, f64::min)
}

#[test]
fn no_entries_nearby_are_faster_where_axes_take_different_times() {
    for name in ["co2-100w", "fibre-3kw-thin", "length-chebyshev", "length"] {
        for seed in 0..12 {
            let centre = |k: u32| f64::from(20 + (k * 97 + seed * 31) % 290);
            let centers: Vec<DVec2> =
                (0..12).map(|k| DVec2::new(centre(k), 0.7 * centre(7 * k + 3))).collect();
            let problem = Problem { machine: machine::preset(name).unwrap(), ..circles(&centers) };
            let mut search = TourTree.start(&problem, 1, None);
            search.step(50_000);
            let (found, least) = (search.best().cost, least_nearby(&problem, search.as_ref()));
            assert!(found < least * (1.0 + 1e-4), "{name}: {found}, and {least} nearby");
        }
    }
}
