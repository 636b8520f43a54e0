//! The search with leads against the exact optimum of small problems.

use crate::testkit::exact::{MOST_ITEMS, assert_methods_reach};
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{assert_passes, machine, nested_sheet};
use kerfway::job::problem_of;
use kerfway::lead::Fit;
use kerfway::machine::LeadKind;
use kerfway::plan::LowerBound;
use kerfway::problem::Item;
use kerfway::solve::{self, Solution};

/// Up to six contours, every kind of lead: the search decides order, entries and leads together and finds the optimum.
#[test]
fn small_sheets_with_leads_are_solved_exactly() {
    let kinds = [LeadKind::Line, LeadKind::Arc, LeadKind::LineArc];
    let mut compared = 0;
    for seed in 0..30_u64 {
        let k = usize::try_from(seed).unwrap();
        let sheet = oriented(nested_sheet(1 + k % 6, seed));
        let name = ["length", "length-chebyshev", "co2-100w", "fibre-3kw-thin"][k % 4];
        let overcut = [0.0, 0.5, -0.3][k % 3];
        let mut machine = with_leads(machine(name), leads(kinds[k % 3], 0.5, overcut));
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
        assert!(
            bound.value() <= best.cost + 1e-9 * best.cost.max(1.0),
            "seed {seed}: {} {}",
            bound.value(),
            best.cost
        );
        let has_lead = |i: &Item| i.leads.as_ref().is_some_and(|l| l.outcome.lead_in == Fit::Wanted);
        compared += usize::from(problem.items.iter().any(has_lead));
    }
    assert!(compared >= 20, "{compared} sheets had leads");
}
