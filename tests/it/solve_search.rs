//! Searches on whole sheets: feasible, checked, never worse, the same in slices of any size.

use crate::testkit::sheets::{assert_feasible, machine, nested_sheet};
use kerfway::job::problem_of;
use kerfway::plan;
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Solution, Status};

fn checked(sheet: &Sheet, machine_name: &str, solution: &Solution) -> f64 {
    let machine = machine(machine_name);
    let problem = problem_of(sheet, &machine);
    assert_feasible(&problem, solution);
    let plan = plan::from_solution(sheet, &problem, solution);
    assert_eq!(plan::check(sheet, &machine, &plan), Ok(()));
    // What the search minimises and what does not depend on it are the whole job.
    let fixed: f64 = problem.items.iter().map(|item| item.fixed).sum();
    let total = plan.summary.total_time;
    assert!(
        (fixed + solution.cost - total).abs() <= 1e-9 * total,
        "{machine_name}: {fixed} {solution:?} {total}"
    );
    total
}

#[test]
fn every_method_makes_checked_plans_on_every_machine() {
    for contours in [1, 2, 3, 20, 150] {
        let sheet = nested_sheet(contours, 7);
        for profile in kerfway::machine::presets() {
            let problem = problem_of(&sheet, &profile);
            for method in solve::methods() {
                let mut search = method.start(&problem, 1, None);
                let first = checked(&sheet, &profile.name, search.best());
                search.step(20_000);
                assert!(checked(&sheet, &profile.name, search.best()) <= first + 1e-9);
            }
        }
    }
}

#[test]
fn slices_of_any_size_give_the_same() {
    let sheet = nested_sheet(200, 3);
    for (machine, method) in
        ["co2-100w", "length-partial"].into_iter().flat_map(|m| solve::methods().iter().map(move |s| (m, s)))
    {
        let problem = problem_of(&sheet, &crate::testkit::sheets::machine(machine));
        for total in [1_000, 50_000, 600_000] {
            let mut whole = method.start(&problem, 5, None);
            whole.step(total);
            for slice in [1_000, 333, 17_001] {
                let mut sliced = method.start(&problem, 5, None);
                let mut left = total;
                while left > 0 {
                    let step = sliced.step(left.min(slice));
                    if step.status == Status::Exhausted {
                        break;
                    }
                    assert_eq!(step.done, left.min(slice));
                    left -= step.done;
                }
                assert_eq!(sliced.best(), whole.best(), "{total} in slices of {slice}");
            }
        }
    }
}

/// Some sheets are up to 3 % shorter run another way round. While later cycles were as cold free of nesting as within it, they
/// seldom turned: seeds 3 and 4 ended at 2,181 and 2,208 mm.
#[test]
fn a_path_is_reversed_if_that_is_shorter() {
    let problem = problem_of(&nested_sheet(120, 3), &machine("length"));
    for seed in 1..=4 {
        let mut search = solve::methods()[0].start(&problem, seed, None);
        search.step(4_000_000);
        assert_feasible(&problem, search.best());
        let cost = search.best().cost;
        assert!(cost < 2170.0, "seed {seed}: {cost}");
    }
}
