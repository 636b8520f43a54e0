//! Plans with leads that Shapely has replayed: `tests/fixtures/leads.json` names the moves of each plan by their hash, with what
//! `tests/oracle/leads.py` found in it. As long as Kerfway makes the same plans, its findings hold.
//!
//! After a change that is meant to change leads, `KERFWAY_BLESS=1 cargo test --test it leads::replay` writes the plans to
//! `target/leads`, and `python tests/oracle/leads.py` replays them and writes the fixture.

use crate::testkit::leads::{leads, with_leads};
use crate::testkit::replayed::{drawings, findings, nearest_next};
use kerfway::job::PlanOptions;
use kerfway::machine::{LeadKind, preset};
use std::collections::BTreeMap;

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

/// The plan of a drawing by the nearest next entry; every third drawing has another kind of lead and another overcut, every
/// second a kerf. `None` for a drawing without anything to cut.
fn planned(k: usize, name: &str, bytes: Vec<u8>) -> Option<String> {
    let kind = [LeadKind::Arc, LeadKind::LineArc, LeadKind::Line][k % 3];
    let mut machine = with_leads(preset("fibre-3kw-thin")?, leads(kind, 0.5, [0.0, 0.4, -0.2][k / 3 % 3]));
    machine.kerf_width = [0.0, 0.2][k % 2];
    nearest_next(name, bytes, machine, PlanOptions::default())
}

#[test]
fn plans_are_those_that_shapely_replayed() {
    let plans: BTreeMap<String, String> = drawings(usize::MAX, NESTS)
        .into_iter()
        .enumerate()
        .filter_map(|(k, (name, bytes))| Some((name.clone(), planned(k, &name, bytes)?)))
        .collect();
    for (name, hash, found) in findings::<Replayed>(&plans, "leads") {
        assert_eq!(hash, found.moves, "{name} is another plan than the one that was replayed");
        assert_eq!(found.faults, Vec::<String>::new(), "{name}");
        assert!(found.tangent < 0.1 && found.overcut < 1e-3, "{name}: {} {}", found.tangent, found.overcut);
        assert!(found.with_lead + found.told >= found.closed, "{name}: a contour without a lead is not told");
        if name.starts_with("sheet_") {
            assert!(f64::from(found.with_lead) >= 0.95 * f64::from(found.closed), "{name}");
        }
    }
}
