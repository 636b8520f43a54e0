//! Contours that stand closer to each other than they are long. The numbers between the ends of their long pieces are below 0 at first, so that
//! they say nothing about how long a leg is: bounds that measured their steps by them proved nothing on sheets of slots.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::{Builder, machine, p, slot};
use kerfway::job::problem_of;
use kerfway::plan::StopBound;
use kerfway::problem::Problem;
use kerfway::solve;

/// Twelve rows of twelve slots of 24 x 4 mm, 1 mm apart along a row and 6 mm between rows. They may be left unfinished.
fn slots() -> Problem {
    let mut builder = Builder::new();
    for k in 0..144 {
        let at = p(25.0 * f64::from(k % 12), 10.0 * f64::from(k / 12));
        builder.cut(slot(p(20.0, 10.0) + at, 20.0, 2.0), None);
    }
    problem_of(&builder.sheet, &machine("length-partial"))
}

/// The share of a search's best path that is proven.
fn proven(problem: &Problem, bound: f64) -> f64 {
    let mut search = solve::methods()[0].start(problem, 1, None);
    search.step(300_000);
    bound / search.best().cost
}

#[test]
fn stops_prove_some_of_a_sheet_of_slots_that_may_be_left() {
    let problem = slots();
    let mut bound = StopBound::new(&problem).unwrap();
    bound.improve(1_000_000_000);
    let share = proven(&problem, bound.value());
    assert!(share > 0.3 && share <= 1.0, "{share}");
}
