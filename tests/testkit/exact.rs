//! Every method against the exact optimum of a small problem, and plans of nearest next.

use super::sheets::assert_feasible;
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::plan::{self, Plan};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;
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

/// Runs the default method on a small sheet: it ends at the exact cost or below, and its plan passes the checker. Returns the
/// problem, the exact cost and the plan.
pub fn search_of_exact_cost(sheet: &Sheet, machine: &Profile, seed: u64) -> (Problem, f64, Plan) {
    let problem = problem_of(sheet, machine);
    let least = solve::exact(&problem).unwrap().cost;
    let plan = {
        let mut search = solve::start(solve::methods()[0], &problem, seed, None);
        search.step(50_000);
        let found = search.best();
        assert!(found.cost <= least + 1e-9, "seed {seed}: {} s, not {least} s", found.cost);
        plan::from_solution(sheet, &problem, found)
    };
    assert_eq!(plan::check(sheet, machine, &plan), Ok(()));
    (problem, least, plan)
}

/// The plan of nearest next.
pub fn planned(sheet: &Sheet, machine: &Profile) -> Plan {
    let problem = problem_of(sheet, machine);
    plan::from_solution(sheet, &problem, &solve::greedy(&problem))
}
