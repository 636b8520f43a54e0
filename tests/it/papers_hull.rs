//! RLSGA with what it is compared with, and Yang's genetic algorithm: plans pass the checker, slices and seeds repeat.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::{
    Builder, assert_passes, circle, line, machine, nested_sheet, p, paper, rectangle,
};
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::sheet::Sheet;
use kerfway::solve::{Insight, papers};
use kerfway::solve::{Solution, Status};

/// Every method of these papers, made small.
const METHODS: [(&str, &str); 6] = [
    ("rlsga", SMALL),
    ("sga", SMALL),
    ("hull-pso", SMALL),
    ("ofa", SMALL),
    ("woa", SMALL),
    ("dual-coding-ga", SMALL),
];
const SMALL: &str = r#"{"population": 12, "generations": 15}"#;

/// Holes, slots, marks, open cuts, parts in parts; worked by layer and as one.
fn sheets() -> Vec<Sheet> {
    let mut ranked = nested_sheet(30, 2);
    ranked.layers[1].rank = 3;
    let mut by_part = nested_sheet(25, 4);
    by_part.part_by_part = true;
    let mut single = Builder::new();
    single.cut(circle(p(5.0, 5.0), 2.0), None);
    let mut open = Builder::new();
    open.cut(line(p(1.0, 1.0), p(3.0, 1.0)), None);
    let mut two = Builder::new();
    let outer = two.cut(rectangle(p(0.0, 0.0), p(20.0, 10.0)), None);
    two.cut(circle(p(5.0, 5.0), 2.0), Some(outer));
    vec![nested_sheet(40, 3), ranked, by_part, single.sheet, open.sheet, two.sheet, Builder::new().sheet]
}

#[test]
fn every_best_is_allowed_and_passes_the_checker() {
    let mut left = 0;
    for (sheet, name) in
        sheets().iter().flat_map(|s| ["length-partial", "length", "co2-100w"].map(|m| (s, m)))
    {
        for closed in [true, false] {
            let machine = Profile { return_home: closed, ..machine(name) };
            let problem = problem_of(sheet, &machine);
            for (method, parameters) in METHODS {
                let mut search = paper(method, parameters, &problem, 1);
                assert_passes(sheet, &machine, &problem, search.best());
                let mut last = search.best().clone();
                loop {
                    let step = search.step(2_000);
                    assert!(step.improved || *search.best() == last, "{method}");
                    if step.improved {
                        last = search.best().clone();
                        assert_passes(sheet, &machine, &problem, &last);
                        left +=
                            last.stops.len() - problem.items.iter().filter(|i| !i.nodes.is_empty()).count();
                    }
                    if step.status == Status::Exhausted {
                        break;
                    }
                }
            }
        }
    }
    assert!(left > 10, "only {left} times was anything left unfinished");
}

#[test]
fn slices_and_seeds_give_the_same_bits() {
    let sheet = nested_sheet(12, 6);
    let problem = problem_of(&sheet, &machine("length-partial"));
    for (method, parameters) in METHODS {
        let run = |slice: u64, seed: u64, moves: u64| -> (Solution, Insight, u64) {
            let mut search = paper(method, parameters, &problem, seed);
            (0..moves / slice).for_each(|_| {
                search.step(slice);
            });
            let telemetry = search.telemetry();
            (search.best().clone(), search.insight().unwrap(), telemetry.best_at)
        };
        let whole = run(20_000, 1, 20_000);
        for slice in [1, 7, 400] {
            assert_eq!(
                run(slice, 1, 20_000 / slice * slice),
                run(20_000 / slice * slice, 1, 20_000 / slice * slice),
                "{method}"
            );
        }
        assert_eq!(run(20_000, 1, 20_000), whole, "{method}");
        assert_ne!(run(20_000, 2, 20_000).0, whole.0, "{method}");
    }
}

#[test]
fn parameters_have_the_papers_values_and_only_their_own_names() {
    let card = papers::cards().into_iter().find(|c| c.info.name == "rlsga").unwrap();
    for (name, value) in [
        ("crossover", 0.6),
        ("mutation", 0.1),
        ("migration", 0.1),
        ("alpha", 0.9),
        ("gamma", 0.9),
        ("epsilon", 0.1),
    ] {
        assert_eq!(card.parameters[name].as_f64(), Some(value), "{name}");
    }
    assert_eq!(card.parameters["generations"], 1000);
    assert!(papers::method("rlsga", r#"{"delta": 1}"#).is_err());
}
