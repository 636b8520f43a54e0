//! What the default search finds.

use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::plan::{self, Plan};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Solution};

/// The best path of a sheet after some moves, and its plan, checked.
pub fn searched(sheet: &Sheet, machine: &Profile, moves: u64, seed: u64) -> (Solution, Plan) {
    let problem = problem_of(sheet, machine);
    let mut search = solve::start(solve::methods()[0], &problem, seed, None);
    search.step(moves);
    let plan = plan::from_solution(sheet, &problem, search.best());
    assert_eq!(plan::check(sheet, machine, &plan), Ok(()));
    (search.best().clone(), plan)
}

/// Asserts that a search of 150,000 moves finds the same in slices of any size.
pub fn slices_of_any_size_find_the_same(problem: &Problem) {
    let in_slices = |slice: u64| {
        let mut search = solve::start(solve::methods()[0], problem, 7, None);
        for _ in 0..150_000 / slice {
            search.step(slice);
        }
        search.best().clone()
    };
    let whole = in_slices(150_000);
    assert_eq!(in_slices(1_000), whole);
    assert_eq!(in_slices(30_000), whole);
}
