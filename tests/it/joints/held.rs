//! Plans with micro-joints that Shapely has cut: `tests/fixtures/joints.json` names the moves of each plan by their hash, with what
//! `tests/oracle/joints.py` found when everything was cut. As long as Kerfway makes the same plans, its findings hold.
//!
//! After a change that is meant to change joints, `KERFWAY_BLESS=1 cargo test --test it joints::held` writes the plans to
//! `target/joints`, and `python tests/oracle/joints.py` cuts them and writes the fixture.

use crate::testkit::joints::with_joints;
use crate::testkit::leads::{leads, with_leads};
use crate::testkit::replayed::{SMALL, drawings, findings, nearest_next};
use kerfway::job::PlanOptions;
use kerfway::machine::{JointKind, JointRule, LeadKind, preset};
use std::collections::BTreeMap;

/// Number of seeded nests.
const NESTS: u64 = 20;

#[derive(serde::Deserialize)]
struct Held {
    /// SHA-256 of the moves as they are written.
    moves: String,
    /// Parts, those that the sheet still holds after all cuts, and those that cannot have the joints that were asked for.
    parts: u32,
    held: u32,
    told: u32,
    /// Joints that a move leaves.
    joints: u32,
    faults: Vec<String>,
}

/// The plan of a drawing by the nearest next entry, with and without joints on outlines and holes; every third has leads.
fn planned(k: usize, name: &str, bytes: Vec<u8>, joints: bool) -> Option<String> {
    let mut machine = preset("fibre-3kw-thin")?;
    if joints {
        let kind = [JointKind::Stop, JointKind::Flying][k % 2];
        let spacing = [None, Some(120.0)][k / 2 % 2];
        machine = with_joints(machine, vec![JointRule { width: 0.4, spacing, kind, ..JointRule::default() }]);
    }
    if k.is_multiple_of(3) {
        machine = with_leads(machine, leads(LeadKind::Arc, 0.5, 0.4));
    }
    machine.kerf_width = 0.2;
    nearest_next(name, bytes, machine, PlanOptions { allow_off_bed: true, ..PlanOptions::default() })
}

#[test]
fn the_sheet_holds_every_part_with_joints_and_none_without() {
    let mut plans: BTreeMap<String, String> = BTreeMap::new();
    for (k, (name, bytes)) in drawings(SMALL, NESTS).into_iter().enumerate() {
        for (suffix, joints) in [("with", true), ("without", false)] {
            let Some(plan) = planned(k, &name, bytes.clone(), joints) else { continue };
            plans.insert(format!("{name} {suffix}"), plan);
        }
    }
    let found = findings::<Held>(&plans, "joints");
    if found.is_empty() {
        return;
    }
    let (mut parts, mut joints) = (0, 0);
    for (name, hash, found) in &found {
        assert_eq!(*hash, found.moves, "{name} is another plan than the one that was cut");
        assert_eq!(found.faults, Vec::<String>::new(), "{name}");
        if name.ends_with(" with") {
            assert!(found.held + found.told >= found.parts, "{name}: {} of {}", found.held, found.parts);
            (parts, joints) = (parts + found.held, joints + found.joints);
        } else {
            assert_eq!((found.held, found.joints), (0, 0), "{name}");
        }
    }
    assert!(parts > 200 && joints > 400, "{parts} parts, {joints} joints");
}
