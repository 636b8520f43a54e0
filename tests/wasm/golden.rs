//! Plans in wasm are the bytes that the native build writes: the golden plans of one search, and a hash for every method.

use crate::methods;
use kerfway::job::{Job, LoadOptions, OutputKind, PlanOptions, SliceEnd};
use std::collections::BTreeMap;
use wasm_bindgen_test::wasm_bindgen_test;

#[derive(serde::Deserialize)]
struct Case {
    name: String,
    drawing: String,
    load: LoadOptions,
    plan: PlanOptions,
}

const CASES: &str = include_str!("../golden/cases.json");
const DRAWINGS: &[(&str, &[u8])] = &[
    (
        "dxf-dev/peej_lumberjack-keyboard__lumberjack-polaris.dxf",
        include_bytes!("../fixtures/dxf-dev/peej_lumberjack-keyboard__lumberjack-polaris.dxf"),
    ),
    (
        "dxf-dev/gdsestimating_dxf-parser__arcs-as-splines.dxf",
        include_bytes!("../fixtures/dxf-dev/gdsestimating_dxf-parser__arcs-as-splines.dxf"),
    ),
    ("dxf-dev/mozman_ezdxf__forms.dxf", include_bytes!("../fixtures/dxf-dev/mozman_ezdxf__forms.dxf")),
    ("sheets/sheet_100.dxf", include_bytes!("../fixtures/sheets/sheet_100.dxf")),
    ("plate/shared-sides.dxf", include_bytes!("../fixtures/plate/shared-sides.dxf")),
    ("plate/one-kerf-apart.dxf", include_bytes!("../fixtures/plate/one-kerf-apart.dxf")),
];
const PLANS: &[(&str, &str)] = &[
    ("keyboard", include_str!("../golden/keyboard.json")),
    ("splines-per-axis", include_str!("../golden/splines-per-axis.json")),
    ("forms-thick", include_str!("../golden/forms-thick.json")),
    ("left-unfinished", include_str!("../golden/left-unfinished.json")),
    ("paper-lpspso", include_str!("../golden/paper-lpspso.json")),
    ("paper-rlsga", include_str!("../golden/paper-rlsga.json")),
    ("shared-sides", include_str!("../golden/shared-sides.json")),
    ("one-kerf-apart", include_str!("../golden/one-kerf-apart.json")),
    ("partition-tree-pauses", include_str!("../golden/partition-tree-pauses.json")),
    ("tips-avoided", include_str!("../golden/tips-avoided.json")),
    ("corners-not-stopped-in", include_str!("../golden/corners-not-stopped-in.json")),
    ("heat-charged", include_str!("../golden/heat-charged.json")),
    ("bridges", include_str!("../golden/bridges.json")),
    ("bridges-cut-later", include_str!("../golden/bridges-cut-later.json")),
];

fn named<T: Copy>(list: &[(&str, T)], name: &str) -> T {
    list.iter().find(|(n, _)| *n == name).unwrap_or_else(|| panic!("{name} is not listed here")).1
}

#[wasm_bindgen_test]
fn golden_plans_are_the_same_bytes_in_wasm() {
    let cases: Vec<Case> = serde_json::from_str(CASES).unwrap();
    // Several workers meet in JavaScript: tests/package/golden.test.mjs has that case.
    for case in cases.iter().filter(|c| c.plan.workers.is_none()) {
        let file = case.drawing.rsplit('/').next().unwrap();
        let mut job = Job::load(named(DRAWINGS, &case.drawing).to_vec(), file, &case.load).unwrap();
        job.start(&case.plan).unwrap();
        while job.run_mut().unwrap().step(7777).end == SliceEnd::Running {}
        assert!(job.output(OutputKind::Json).unwrap() == named(PLANS, &case.name), "{} differs", case.name);
    }
}

#[wasm_bindgen_test]
fn every_method_plans_the_same_bytes_in_wasm() {
    let expected: BTreeMap<String, String> = serde_json::from_str(methods::EXPECTED).unwrap();
    assert_eq!(methods::hashes(), expected);
}
