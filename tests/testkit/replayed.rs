//! Plans that Shapely judges: a fixture names the moves of each by their hash, with what was found in them.

use super::sheets::{machine, nested_sheet};
use super::{files, fixtures, name};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions, problem_of};
use kerfway::machine::Profile;
use kerfway::{output, plan, solve};
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::Path;

/// Bytes of drawings that take Shapely seconds where others take minutes.
pub const SMALL: usize = 200_000;

/// The drawings of every replay: real ones and sheets of fewer than `most` bytes, and seeded nests.
pub fn drawings(most: usize, count: u64) -> Vec<(String, Vec<u8>)> {
    let folders = ["dxf-dev", "sheets"].map(|f| files(&fixtures().join(f), "dxf")).concat();
    let mut all: Vec<_> = folders
        .iter()
        .map(|p| (name(p), std::fs::read(p).unwrap()))
        .filter(|(_, bytes)| bytes.len() < most)
        .collect();
    all.extend(nests(count));
    all
}

/// Seeded nests as drawings.
fn nests(count: u64) -> impl Iterator<Item = (String, Vec<u8>)> {
    (0..count).map(|seed| {
        let sheet = nested_sheet(12, seed);
        let machine = machine("co2-100w");
        let problem = problem_of(&sheet, &machine);
        let plain = plan::from_solution(&sheet, &problem, &solve::greedy(&problem));
        (format!("nest-{seed:03}"), output::dxf(&plain, &output::SheetFacts::of(&sheet)).into_bytes())
    })
}

/// The plan document of a drawing by the nearest next entry. `None` for a drawing without anything to cut.
pub fn nearest_next(name: &str, bytes: Vec<u8>, machine: Profile, options: PlanOptions) -> Option<String> {
    let method = Some("greedy".to_owned());
    document(name, bytes, machine, PlanOptions { method, moves: Some(1), ..options })
}

/// The same by the default method, after some moves.
pub fn searched(name: &str, bytes: Vec<u8>, machine: Profile, moves: u64) -> Option<String> {
    let options = PlanOptions { seed: 1, allow_off_bed: true, moves: Some(moves), ..PlanOptions::default() };
    document(name, bytes, machine, options)
}

fn document(name: &str, bytes: Vec<u8>, machine: Profile, options: PlanOptions) -> Option<String> {
    let mut job = Job::load(bytes, name, &LoadOptions::default()).ok()?;
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, ..options }).ok()?;
    job.run_mut().unwrap().step(u64::MAX);
    Some(job.output(OutputKind::Json).unwrap_or_else(|e| panic!("{name}: {e}")))
}

/// What was found in each plan, by its name, with the hash of its moves now: `judged` in `tests/fixtures`. With
/// `KERFWAY_BLESS` the plans are written to `target/JUDGED` instead, for the script that judges them, and there is nothing.
pub fn findings<T: DeserializeOwned>(
    plans: &BTreeMap<String, String>,
    judged: &str,
) -> Vec<(String, String, T)> {
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target").join(judged);
        std::fs::create_dir_all(&folder).unwrap();
        for (name, plan) in plans {
            std::fs::write(folder.join(format!("{name}.json")), plan).unwrap();
        }
        return Vec::new();
    }
    let text = std::fs::read_to_string(fixtures().join(format!("{judged}.json"))).unwrap();
    let found: BTreeMap<String, T> = serde_json::from_str(&text).unwrap();
    assert_eq!(plans.keys().collect::<Vec<_>>(), found.keys().collect::<Vec<_>>());
    plans.iter().zip(found).map(|((_, plan), (name, found))| (name, hash_of_moves(plan), found)).collect()
}

/// SHA-256 of the moves of a plan as they are written.
fn hash_of_moves(plan: &str) -> String {
    let moves = plan.split("\"moves\":[").nth(1).unwrap().split("],\"findings\":[").next().unwrap();
    Sha256::digest(moves).iter().map(|b| format!("{b:02x}")).collect()
}
