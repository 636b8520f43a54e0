//! Every method against the exact optimum of a small problem.

use super::sheets::assert_feasible;
use kerfway::problem::Problem;
use kerfway::solve::{self, Solution};

/// More items take the exact solver too long.
pub const MOST_ITEMS: usize = 8;

/// Runs every method on a problem whose optimum is known: none but nearest next ends above it, and none finds less, except by
/// sliding entries off their nodes. `also` is what else holds for a solution.
pub fn assert_methods_reach(problem: &Problem, seed: u64, least: f64, also: impl Fn(&Solution)) {
    for method in solve::methods() {
        let mut search = method.start(problem, seed, None);
        search.step(400_000);
        assert_feasible(problem, search.best());
        also(search.best());
        let found = search.best().cost;
        match method.info().name {
            "greedy" => assert!(found >= least - 1e-9),
            // Slides entries off their nodes: may only be better.
            name => assert!(found <= least + 1e-9, "{name}, seed {seed}: {found}, least {least}"),
        }
    }
}
