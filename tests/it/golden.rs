//! Golden plans: the same seed and moves give the same bytes natively, under Node and in a browser.
//!
//! `tests/golden/cases.json` lists the cases, and `tests/golden/NAME.json` is the expected plan. The package and
//! browser tests read the same files. `KERFWAY_BLESS=1 cargo test --test it golden` writes them again, after a change that
//! is meant to change plans. `tests/golden/quotes.json` has the hash of each plan's quote, which must be the same, too; `dev-quotes.json` those of
//! every real drawing of `tests/fixtures/dxf-dev`. `outputs.json` has the hash of each program and drawing that is written of the plans.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kerfway::job::{Job, LoadOptions, OutputKind, PlanOptions};
use kerfway::plan::document::Document;
use kerfway::quote::{Material, quote};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

#[derive(serde::Deserialize)]
struct Case {
    name: String,
    drawing: String,
    load: LoadOptions,
    plan: PlanOptions,
}

fn at(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests").join(path)
}

fn cases() -> Vec<Case> {
    serde_json::from_str(&fs::read_to_string(at("golden/cases.json")).unwrap()).unwrap()
}

/// Plans a case in slices of `work` moves.
fn planned(case: &Case, work: u64) -> String {
    searched(case, work).output(OutputKind::Json).unwrap()
}

fn searched(case: &Case, work: u64) -> Job {
    let jobs: Vec<Job> = (0..case.plan.workers.unwrap_or(1)).map(|member| started(case, member)).collect();
    crate::testkit::multi_search::planned(jobs, work)
}

fn started(case: &Case, member: u32) -> Job {
    let bytes = fs::read(at("fixtures").join(&case.drawing)).unwrap();
    let name = case.drawing.rsplit('/').next().unwrap();
    let mut job = Job::load(bytes, name, &case.load).unwrap();
    job.start(&PlanOptions { member, ..case.plan.clone() }).unwrap();
    job
}

#[test]
fn plans_are_the_bytes_expected() {
    for case in cases() {
        let file = at("golden").join(format!("{}.json", case.name));
        let plan = planned(&case, u64::MAX);
        if std::env::var_os("KERFWAY_BLESS").is_some() {
            fs::write(&file, &plan).unwrap();
        }
        assert!(plan == fs::read_to_string(&file).unwrap(), "{} differs from {}", case.name, file.display());
    }
}

#[test]
fn quotes_have_the_hashes_expected() {
    let material = Material { name: Some("Mild steel".into()), thickness: Some(3.0), density: Some(7.85) };
    let hash = |case: &Case| {
        // From the text, as a server does that was sent a plan.
        let document = Document::read(&planned(case, u64::MAX)).unwrap();
        quote(&document, &material.clone().into()).unwrap().hash
    };
    let hashes: BTreeMap<String, String> = cases().iter().map(|c| (c.name.clone(), hash(c))).collect();
    let file = at("golden/quotes.json");
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        fs::write(&file, serde_json::to_string_pretty(&hashes).unwrap() + "\n").unwrap();
    }
    let expected: BTreeMap<String, String> =
        serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    assert_eq!(hashes, expected);
}

/// The names of the formats that `outputs.json` has.
const FORMATS: [&str; 5] = ["gcode", "svg", "dxf", "lbrn2", "rd"];

#[test]
fn outputs_are_the_bytes_expected() {
    // Without the version in the comments of programs. A Ruida file is no text. Where a format cannot hold the plan: why not.
    let written = |job: &Job, format: &str| {
        let bytes = match job.output_bytes(format.parse().unwrap()) {
            Ok(bytes) => bytes,
            Err(refusal) => return refusal.to_string(),
        };
        let text = String::from_utf8(bytes).map(|text| text.replace(env!("CARGO_PKG_VERSION"), ""));
        hex(&Sha256::digest(text.map_or_else(|bytes| bytes.into_bytes(), String::into_bytes)))
    };
    let of_case = |mut case: Case| {
        // Where the job lies does not matter here.
        case.plan.allow_off_bed = true;
        let job = searched(&case, u64::MAX);
        (case.name.clone(), FORMATS.map(|format| (format.to_owned(), written(&job, format))).into())
    };
    let outputs: BTreeMap<String, BTreeMap<String, String>> = cases().into_iter().map(of_case).collect();
    let file = at("golden/outputs.json");
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        fs::write(&file, serde_json::to_string_pretty(&outputs).unwrap() + "\n").unwrap();
    }
    let expected: BTreeMap<String, BTreeMap<String, String>> =
        serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    assert_eq!(outputs, expected);
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

/// How every real drawing is quoted, and the hashes expected.
#[derive(serde::Serialize, serde::Deserialize)]
struct DevQuotes {
    plan: serde_json::Value,
    material: serde_json::Value,
    hashes: BTreeMap<String, String>,
}

#[test]
fn quotes_of_real_drawings_have_the_hashes_expected() {
    let file = at("golden/dev-quotes.json");
    let mut expected: DevQuotes = serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    let plan: PlanOptions = serde_json::from_value(expected.plan.clone()).unwrap();
    let material: Material = serde_json::from_value(expected.material.clone()).unwrap();
    let hash = |name: &String| {
        let bytes = fs::read(at("fixtures/dxf-dev").join(name)).unwrap();
        let mut job = Job::load(bytes, name, &LoadOptions::default()).unwrap();
        job.start(&plan).unwrap();
        let planned = crate::testkit::multi_search::planned(vec![job], u64::MAX);
        (name.clone(), planned.quote(&material.clone().into()).unwrap().hash)
    };
    let hashes: BTreeMap<String, String> = expected.hashes.keys().map(hash).collect();
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        expected.hashes = hashes.clone();
        fs::write(&file, serde_json::to_string_pretty(&expected).unwrap() + "\n").unwrap();
    }
    assert_eq!(hashes, expected.hashes);
}

#[test]
fn slices_of_any_size_give_the_same_plan() {
    for case in cases() {
        let whole = planned(&case, u64::MAX);
        // Millions of moves in slices of one would take minutes.
        let slices: &[u64] = if case.plan.workers.is_some() { &[4097] } else { &[1, 7, 1000] };
        for &work in slices {
            assert!(planned(&case, work) == whole, "{} in slices of {work} moves", case.name);
        }
    }
}

#[test]
fn another_seed_may_give_another_plan_but_never_one_that_fails_its_check() {
    for mut case in cases() {
        for seed in 100..105 {
            case.plan.seed = seed;
            // Writing checks the plan; `planned` unwraps.
            assert!(planned(&case, 4096).contains(&format!("\"seed\":{seed}")));
        }
    }
}

#[test]
fn every_method_plans_the_bytes_expected() {
    let hashes = crate::testkit::methods::hashes();
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        fs::write(at("golden/methods.json"), serde_json::to_string_pretty(&hashes).unwrap() + "\n").unwrap();
        return;
    }
    let expected: BTreeMap<String, String> = serde_json::from_str(crate::testkit::methods::EXPECTED).unwrap();
    assert_eq!(hashes, expected);
}
