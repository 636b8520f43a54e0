//! A plan by every method there is, as a hash of its JSON: the native tests and those in wasm expect the same.

use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions, SliceEnd};
use kerfway::solve;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// The hashes expected.
pub const EXPECTED: &str = include_str!("../golden/methods.json");

pub const DRAWING: &[u8] = include_bytes!("../fixtures/qu-du-43/qu_du_43.dxf");
/// Moves in which every method has improved its first path and none takes long.
const MOVES: u64 = 30_000;
/// No divisor of the moves, so that the last slice is a short one.
const SLICE: u64 = 777;

/// SHA-256 of the plan document by the name of the method.
pub fn hashes() -> BTreeMap<String, String> {
    let own = solve::methods().iter().map(|m| m.info().name);
    let papers = solve::papers::cards().into_iter().map(|card| card.info.name);
    own.chain(papers).map(|name| (name.to_owned(), hash(name))).collect()
}

fn hash(method: &str) -> String {
    let mut job = Job::load(DRAWING.to_vec(), "qu_du_43.dxf", &LoadOptions::default()).unwrap();
    let options = PlanOptions {
        machine: MachineChoice::Preset("length".into()),
        method: Some(method.to_owned()),
        seed: 1,
        moves: Some(MOVES),
        ..PlanOptions::default()
    };
    job.start(&options).unwrap();
    while job.run_mut().unwrap().step(SLICE).end == SliceEnd::Running {}
    let plan = job.output(OutputKind::Json).unwrap();
    Sha256::digest(plan).iter().map(|b| format!("{b:02x}")).collect()
}
