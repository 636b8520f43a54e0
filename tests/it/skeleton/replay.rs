//! Skeleton cuts and remainders that Shapely has judged: `tests/fixtures/skeleton.json` names the moves of each plan by their
//! hash, with what `tests/oracle/skeleton.py` found in it.
//!
//! After a change that is meant to change skeleton cuts, `KERFWAY_BLESS=1 cargo test --test it skeleton::replay` writes the plans to
//! `target/skeleton`, and `python tests/oracle/skeleton.py` judges them and writes the fixture.

use super::grid;
use crate::testkit::replayed::{drawings, findings};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{Profile, Skeleton, preset};
use std::collections::BTreeMap;

/// Number of seeded nests.
const NESTS: u64 = 100;
/// Larger drawings would take Shapely minutes, bytes.
const MOST_BYTES: usize = 1_000_000;

#[derive(serde::Deserialize)]
struct Judged {
    /// SHA-256 of the moves as they are written.
    moves: String,
    /// Number of skeleton cuts.
    cuts: u32,
    /// Whether a strip is kept.
    strip: bool,
    /// Faults that were found.
    faults: Vec<String>,
}

/// The plan of a drawing by the nearest next entry, with the drawing of the remainder. The bed is 30 mm larger than the job and
/// has a strip on its right; every second drawing has a kerf, every third joints, every fourth keeps a strip.
fn planned(k: usize, name: &str, bytes: Vec<u8>) -> Option<String> {
    let mut job = Job::load(bytes, name, &LoadOptions::default()).ok()?;
    let [x0, y0, x1, y1] = job.report().bounds;
    let (width, height) = (x1 - x0, y1 - y0);
    let skeleton = Skeleton {
        clearance: [2.0, 0.5, 4.0][k % 3],
        joint_spacing: [None, Some(60.0), None][k % 3],
        remainder: [None, None, None, Some(20.0)][k % 4],
        ..grid((width / 5.0).clamp(10.0, 1e5), (height / 4.0).clamp(10.0, 1e5))
    };
    let machine = Profile {
        skeleton: Some(skeleton),
        bed: Some([x0 - 30.0, y0 - 30.0, x1 + 30.0 + 0.3 * width, y1 + 30.0]),
        home: [x0 - 30.0, y0 - 30.0],
        kerf_width: [0.0, 0.2][k % 2],
        pre_cut_time: None,
        ..preset("fibre-3kw-thin")?
    };
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions {
        machine,
        method: Some("greedy".into()),
        moves: Some(1),
        ..PlanOptions::default()
    })
    .ok()?;
    job.run_mut().unwrap().step(1);
    let plan = job.output(OutputKind::Json).unwrap_or_else(|e| panic!("{name}: {e}"));
    let remainder = job.output(OutputKind::Remainder).unwrap();
    let text = serde_json::to_string(&remainder).unwrap();
    Some(format!("{},\"remainder\":{text}}}", plan.trim_end().strip_suffix('}').unwrap()))
}

#[test]
fn skeleton_cuts_are_those_that_shapely_judged() {
    let plans: BTreeMap<String, String> = drawings(MOST_BYTES, NESTS)
        .into_iter()
        .enumerate()
        .filter_map(|(k, (name, bytes))| Some((name.clone(), planned(k, &name, bytes)?)))
        .collect();
    let (mut cuts, mut strips) = (0, 0);
    for (name, hash, found) in findings::<Judged>(&plans, "skeleton") {
        assert_eq!(hash, found.moves, "{name} is another plan than the one that was judged");
        assert_eq!(found.faults, Vec::<String>::new(), "{name}");
        cuts += found.cuts;
        strips += u32::from(found.strip);
    }
    assert!(std::env::var_os("KERFWAY_BLESS").is_some() || (cuts > 500 && strips > 10), "{cuts} {strips}");
}
