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

/// Larger drawings would take Shapely minutes.
const MOST_BYTES: usize = 200_000;

/// Real drawings, the sheet of 100 contours and seeded nests, all small.
pub fn small_drawings(count: u64) -> Vec<(String, Vec<u8>)> {
    let mut all: Vec<_> = files(&fixtures().join("dxf-dev"), "dxf")
        .iter()
        .chain([&fixtures().join("sheets/sheet_100.dxf")])
        .map(|p| (name(p), std::fs::read(p).unwrap()))
        .filter(|(_, bytes)| bytes.len() < MOST_BYTES)
        .collect();
    all.extend(nests(count));
    all
}

/// Seeded nests as drawings.
pub fn nests(count: u64) -> impl Iterator<Item = (String, Vec<u8>)> {
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
    let mut job = Job::load(bytes, name, &LoadOptions::default()).ok()?;
    let machine = MachineChoice::Profile(Box::new(machine));
    let method = Some("greedy".to_owned());
    job.start(&PlanOptions { machine, method, moves: Some(1), ..options }).ok()?;
    job.run_mut().unwrap().step(1);
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
