//! The search with joints against the exact optimum of small problems.

use crate::testkit::exact::{MOST_ITEMS, assert_methods_reach};
use crate::testkit::joints::{rule, with_joints};
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{assert_passes, machine, nested_sheet};
use kerfway::job::problem_of;
use kerfway::machine::{JointKind, JointRule, LeadKind};
use kerfway::plan::{self, LowerBound, Move};
use kerfway::solve::{self, Solution};

/// Up to six contours, with and without leads, both kinds of joints: the search finds the optimum over orders and entries.
#[test]
fn small_sheets_with_joints_are_solved_exactly() {
    let (mut compared, mut begun) = (0, 0);
    for seed in 0..30_u64 {
        let k = usize::try_from(seed).unwrap();
        let sheet = oriented(nested_sheet(1 + k % 6, seed));
        let name = ["length", "length-chebyshev", "co2-100w", "fibre-3kw-thin"][k % 4];
        let kind = [JointKind::Stop, JointKind::Flying][k / 2 % 2];
        let rule = JointRule { spacing: [None, Some(40.0)][k % 2], ..rule([1, 2, 3][k % 3], kind) };
        let mut machine = with_joints(machine(name), vec![rule]);
        if k % 3 == 2 {
            machine = with_leads(machine, leads(LeadKind::Arc, 0.5, [0.0, 0.5, -0.3][k / 3 % 3]));
        }
        machine.return_home = seed % 3 != 0;
        let problem = problem_of(&sheet, &machine);
        if problem.items.len() > MOST_ITEMS {
            continue;
        }
        let best = solve::exact(&problem).unwrap();
        assert_passes(&sheet, &machine, &problem, &Solution::new(&problem, best.stops.clone()));
        assert_methods_reach(&problem, seed, best.cost, |found| {
            assert_passes(&sheet, &machine, &problem, found)
        });
        let mut bound = LowerBound::new(&problem);
        bound.improve(20_000_000, best.cost);
        assert!(bound.value() <= best.cost + 1e-9 * best.cost.max(1.0), "seed {seed}");
        let plan = plan::from_solution(&sheet, &problem, &Solution::new(&problem, best.stops));
        compared += usize::from(plan.summary.joints > 0);
        let left = plan.moves.iter().filter(|m| matches!(m, Move::Joint { .. })).count();
        begun += plan.summary.joints as usize - left;
    }
    assert!(compared >= 20, "{compared} sheets had joints");
    assert!(begun >= 20, "{begun} contours began at a joint");
}

/// Beginning at a joint saves a piercing, so on a machine that pierces slowly every contour does.
#[test]
fn contours_begin_at_joints_where_piercing_is_slow() {
    let sheet = oriented(nested_sheet(6, 3));
    let mut machine = with_joints(machine("co2-100w"), vec![rule(2, JointKind::Stop)]);
    machine.pierce_time = 5.0;
    let problem = problem_of(&sheet, &machine);
    let best = solve::exact(&problem).unwrap();
    let plan = plan::from_solution(&sheet, &problem, &Solution::new(&problem, best.stops));
    let joints = |c: usize| problem.items[c].joints.as_ref().map_or(0, |j| j.joints.len());
    let pierces: usize =
        (0..sheet.contours.len()).filter(|&c| !sheet.contours[c].is_mark()).map(|c| joints(c).max(1)).sum();
    assert!(plan.summary.joints >= 6);
    assert_eq!(plan.summary.pierces as usize, pierces);
}
