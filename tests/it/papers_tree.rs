//! The partition-tree and what it is compared with: plans pass the checker, slices and seeds repeat, parameters.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::sheets::{
    Builder, assert_passes, circle, line, machine, nested_sheet, p, paper, rectangle,
};
use kerfway::job::problem_of;
use kerfway::machine::Profile;
use kerfway::sheet::Sheet;
use kerfway::solve::{Insight, papers};
use kerfway::solve::{Solution, Status};

/// Every method of the paper, with each of its forms.
const METHODS: [(&str, &str); 12] = [
    ("pfr", "{}"),
    ("pfr", r#"{"preset": "as-published"}"#),
    ("gtsp-lk", r#"{"gtsp_moves": 100}"#),
    ("gtsp-lk", r#"{"preset": "as-published", "gtsp_moves": 100}"#),
    ("partition-tree", r#"{"preset": "as-published", "gtsp_moves": 100}"#),
    ("partition-tree", r#"{"neighbourhood": "all", "gtsp_moves": 100}"#),
    ("partition-tree", r#"{"gtsp_moves": 100}"#),
    ("partition-tree", r#"{"gtsp_moves": 100, "start": "single"}"#),
    ("partition-tree", r#"{"gtsp_moves": 100, "start": "each", "stall": 3}"#),
    ("partition-tree", r#"{"gtsp_moves": 100, "stall": 0, "first": "all"}"#),
    ("partition-tree", r#"{"stall": 0, "first": "none", "repartition": "partitions"}"#),
    ("partition-tree", r#"{"stall": 0, "first": "none", "repartition": "sequences"}"#),
];

/// Plate: piercing and leaving cost seconds.
fn plate(closed: bool) -> Profile {
    Profile { pierce_time: 1.0, pre_cut_time: Some(0.2), return_home: closed, ..machine("co2-100w") }
}

/// Parts close together: rectangles 4 mm apart with holes and parts in the holes, nothing but cuts.
fn close_sheet(columns: u32, lines: u32) -> Sheet {
    let mut b = Builder::new();
    for k in 0..columns * lines {
        let corner = p(f64::from(k % columns) * 304.0, f64::from(k / columns) * 204.0);
        let outer = b.cut(rectangle(corner, p(300.0, 200.0)), None);
        let hole = b.cut(rectangle(corner + p(20.0, 20.0), p(100.0, 160.0)), Some(outer));
        b.cut(circle(corner + p(70.0, 60.0), 20.0), Some(hole));
        b.cut(circle(corner + p(200.0, 100.0), 30.0), Some(outer));
    }
    b.sheet
}

/// Holes, slots, marks, open cuts, parts in parts; worked by layer, by part and as one.
fn sheets() -> Vec<Sheet> {
    let mut by_part = nested_sheet(25, 4);
    by_part.part_by_part = true;
    let mut single = Builder::new();
    single.cut(circle(p(5.0, 5.0), 2.0), None);
    let mut open = Builder::new();
    open.cut(line(p(1.0, 1.0), p(3.0, 1.0)), None);
    vec![close_sheet(3, 3), nested_sheet(40, 3), by_part, single.sheet, open.sheet, Builder::new().sheet]
}

#[test]
fn every_best_is_allowed_and_passes_the_checker() {
    let mut left = 0;
    for sheet in sheets() {
        for closed in [true, false] {
            for machine in [plate(closed), machine("length"), machine("length-partial")] {
                let problem = problem_of(&sheet, &machine);
                for (method, parameters) in METHODS {
                    let mut search = paper(method, parameters, &problem, 1);
                    assert_passes(&sheet, &machine, &problem, search.best());
                    while search.step(20_000).status == Status::Running {
                        assert_passes(&sheet, &machine, &problem, search.best());
                    }
                    assert_passes(&sheet, &machine, &problem, search.best());
                    let items = problem.items.iter().filter(|i| !i.nodes.is_empty()).count();
                    left += search.best().stops.len() - items;
                }
            }
        }
    }
    assert!(left > 100, "only {left} times was anything left unfinished");
}

#[test]
fn slices_give_the_same_bits() {
    let sheet = close_sheet(3, 2);
    let problem = problem_of(&sheet, &plate(true));
    for (method, parameters) in METHODS {
        let run = |slice: u64| -> (Solution, Insight, u64) {
            let mut search = paper(method, parameters, &problem, 1);
            while search.step(slice).status == Status::Running {}
            (search.best().clone(), search.insight().unwrap(), search.telemetry().best_at)
        };
        let whole = run(u64::MAX);
        for slice in [7, 400, 20_000] {
            assert_eq!(run(slice), whole, "{method} {parameters}");
        }
    }
}

#[test]
fn the_tree_improves_on_its_construction_and_on_a_tour_where_parts_are_close() {
    // Rows of parts of different widths, so that no corners meet, with a hole each.
    let mut b = Builder::new();
    for row in 0..4 {
        let mut x = 0.0;
        for k in 0..5 {
            let width = 300.0 + 70.0 * f64::from((3 * k + 2 * row) % 5);
            let corner = p(x, f64::from(row) * 304.0);
            let outer = b.cut(rectangle(corner, p(width, 300.0)), None);
            b.cut(circle(corner + p(width / 2.0, 100.0), 30.0), Some(outer));
            x += width + 4.0;
        }
    }
    let problem = problem_of(&b.sheet, &plate(true));
    let cost = |method: &str, parameters: &str| {
        let mut search = paper(method, parameters, &problem, 1);
        while search.step(100_000).status == Status::Running {}
        let values =
            search.insight().unwrap().curves.into_iter().map(|c| (c.name, c.value)).collect::<Vec<_>>();
        (search.best().cost, values)
    };
    let (tree, values) = cost("partition-tree", "{}");
    let (pfr, tour) = (cost("pfr", "{}").0, cost("gtsp-lk", "{}").0);
    assert!(tree < pfr && tree < tour, "{tree} {pfr} {tour}");
    let value = |name: &str| values.iter().find(|v| v.0 == name).unwrap().1;
    // Restoring feasibility costs, improving what was repaired gains.
    assert!(value("best with precedence left out, s") <= value("repaired, s") + 1e-9);
    assert!(value("repaired and improved, s") <= value("repaired, s") + 1e-9);
    assert!(tree <= value("repaired and improved, s") + 1e-9);
    assert!(value("pre-cuts") >= 4.0 && value("partitions") >= 5.0, "{values:?}");
}

#[test]
fn parameters_have_the_papers_values_and_only_their_own_names() {
    let card = papers::cards().into_iter().find(|c| c.info.name == "partition-tree").unwrap();
    assert_eq!(card.parameters["stall"], 10);
    assert_eq!(card.parameters["start"], "pfr");
    assert_eq!(card.parameters["repartition"], "both");
    for card in
        papers::cards().into_iter().filter(|c| ["partition-tree", "pfr", "gtsp-lk"].contains(&c.info.name))
    {
        assert_eq!(card.parameters["nodes"], "entries", "{}", card.info.name);
        assert_eq!(card.presets["as-published"]["nodes"], "element-ends", "{}", card.info.name);
    }
    assert!(papers::method("partition-tree", r#"{"start": "middle"}"#).is_err());
    assert!(papers::method("pfr", r#"{"stall": 1}"#).is_err());
}
