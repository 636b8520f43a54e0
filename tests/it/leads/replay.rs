//! Plans with leads that Shapely has replayed: `tests/fixtures/leads.json` names the moves of each plan by their hash, with what
//! `tests/oracle/leads.py` found in it. As long as Kerfway makes the same plans, its findings hold.
//!
//! After a change that is meant to change leads, `KERFWAY_BLESS=1 cargo test --test it leads::replay` writes the plans to
//! `target/leads`, and `python tests/oracle/leads.py` replays them and writes the fixture.

use crate::testkit::leads::{leads, with_leads};
use crate::testkit::sheets::{machine, nested_sheet};
use crate::testkit::{files, fixtures, name};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions, problem_of};
use kerfway::machine::{LeadKind, preset};
use kerfway::{output, plan, solve};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::Path;

/// Number of seeded nests.
const NESTS: u64 = 100;

#[derive(serde::Deserialize)]
struct Replayed {
    /// SHA-256 of the moves as they are written.
    moves: String,
    /// Closed contours that are cut, those with leads, and those that the plan tells of.
    closed: u32,
    with_lead: u32,
    told: u32,
    /// Faults that the replay found.
    faults: Vec<String>,
    /// Largest angle of an arc to what it joins, degrees; largest error of an overcut or gap, mm.
    tangent: f64,
    overcut: f64,
}

fn drawings() -> Vec<(String, Vec<u8>)> {
    let folders = ["dxf-dev", "sheets"].map(|f| files(&fixtures().join(f), "dxf")).concat();
    let mut all: Vec<_> = folders.iter().map(|p| (name(p), std::fs::read(p).unwrap())).collect();
    for seed in 0..NESTS {
        let sheet = nested_sheet(12, seed);
        let machine = machine("co2-100w");
        let problem = problem_of(&sheet, &machine);
        let plain = plan::from_solution(&sheet, &problem, &solve::greedy(&problem));
        all.push((format!("nest-{seed:03}"), output::dxf(&plain, &sheet).into_bytes()));
    }
    all
}

/// The plan of a drawing by the nearest next entry; every third drawing has another kind of lead and another overcut, every
/// second a kerf. `None` for a drawing without anything to cut.
fn planned(k: usize, name: &str, bytes: Vec<u8>) -> Option<String> {
    let mut job = Job::load(bytes, name, &LoadOptions::default()).ok()?;
    let kind = [LeadKind::Arc, LeadKind::LineArc, LeadKind::Line][k % 3];
    let mut machine = with_leads(preset("fibre-3kw-thin")?, leads(kind, 0.5, [0.0, 0.4, -0.2][k / 3 % 3]));
    machine.kerf_width = [0.0, 0.2][k % 2];
    let machine = MachineChoice::Profile(Box::new(machine));
    let method = Some("greedy".to_owned());
    job.start(&PlanOptions { machine, method, moves: Some(1), ..PlanOptions::default() }).ok()?;
    job.run_mut().unwrap().step(1);
    Some(job.output(OutputKind::Json).unwrap_or_else(|e| panic!("{name}: {e}")))
}

#[test]
fn plans_are_those_that_shapely_replayed() {
    let plans: BTreeMap<String, String> = drawings()
        .into_iter()
        .enumerate()
        .filter_map(|(k, (name, bytes))| Some((name.clone(), planned(k, &name, bytes)?)))
        .collect();
    if std::env::var_os("KERFWAY_BLESS").is_some() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/leads");
        std::fs::create_dir_all(&folder).unwrap();
        for (name, plan) in &plans {
            std::fs::write(folder.join(format!("{name}.json")), plan).unwrap();
        }
        return;
    }
    let text = std::fs::read_to_string(fixtures().join("leads.json")).unwrap();
    let replayed: BTreeMap<String, Replayed> = serde_json::from_str(&text).unwrap();
    assert_eq!(plans.keys().collect::<Vec<_>>(), replayed.keys().collect::<Vec<_>>());
    for (name, plan) in &plans {
        let moves = plan.split("\"moves\":[").nth(1).unwrap().split("],\"findings\":[").next().unwrap();
        let hash: String = Sha256::digest(moves).iter().map(|b| format!("{b:02x}")).collect();
        let found = &replayed[name];
        assert_eq!(hash, found.moves, "{name} is another plan than the one that was replayed");
        assert_eq!(found.faults, Vec::<String>::new(), "{name}");
        assert!(found.tangent < 0.1 && found.overcut < 1e-3, "{name}: {} {}", found.tangent, found.overcut);
        assert!(found.with_lead + found.told >= found.closed, "{name}: a contour without a lead is not told");
        if name.starts_with("sheet_") {
            assert!(f64::from(found.with_lead) >= 0.95 * f64::from(found.closed), "{name}");
        }
    }
}
