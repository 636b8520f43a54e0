//! Plans near tipped pieces that Shapely has replayed: `tests/fixtures/tips.json` names the moves of each plan by their hash, with what
//! `tests/oracle/tips.py` found. As long as Kerfway makes the same plans, its findings hold.
//!
//! After a change that is meant to change ways past tipped pieces, `KERFWAY_BLESS=1 cargo test --test it tips::replay` writes the
//! plans to `target/tips`, and `python tests/oracle/tips.py` replays them and writes the fixture.

use super::{all_tip, ignored, tipping};
use crate::testkit::joints::with_joints;
use crate::testkit::replayed::{SMALL, drawings, findings, nearest_next};
use kerfway::job::{Job, LoadOptions, PlanOptions, problem_of};
use kerfway::machine::{JointRule, Profile, Slats, Tips};
use std::collections::BTreeMap;

/// Number of seeded nests.
const NESTS: u64 = 20;

#[derive(serde::Deserialize)]
struct Replayed {
    /// SHA-256 of the moves as they are written.
    moves: String,
    /// Contours whose pieces may tip.
    tips: Vec<u32>,
    /// Moves with the head down that cross a free piece.
    surely: Vec<usize>,
    /// Moves with the head lifted, and to way points.
    lifted: u32,
    way_points: u32,
    faults: Vec<String>,
}

/// Lifts from 0.02 s to 3 s; slats unknown, along an axis or slanted; every fifth drawing has some micro-joints.
fn machine(k: usize, avoid: bool) -> Profile {
    let slats =
        [None, Some(Slats { pitch: 30.0, angle: 0.0 }), Some(Slats { pitch: 20.0, angle: 0.7 })][k % 3];
    let tips = match slats {
        None => all_tip(),
        Some(_) => Tips { slats, nozzle_radius: 5.0, margin: 1.0, cross_over: 6.0, ..Tips::default() },
    };
    let machine = tipping([0.02, 0.2, 3.0][k / 3 % 3], if avoid { tips } else { ignored(tips) });
    let machine = match k % 5 {
        0 => with_joints(machine, vec![JointRule { size_max: Some([40.0, 40.0]), ..JointRule::default() }]),
        _ => machine,
    };
    match avoid {
        true => machine,
        false => Profile { levers: kerfway::machine::Levers { lift: None, ..machine.levers }, ..machine },
    }
}

#[test]
fn plans_are_those_that_shapely_replayed() {
    let (mut plans, mut tips) = (BTreeMap::new(), BTreeMap::new());
    for (k, (name, bytes)) in drawings(SMALL, NESTS).into_iter().enumerate() {
        for (suffix, avoid) in [("avoid", true), ("ignore", false)] {
            let (name, machine) = (format!("{name} {suffix}"), machine(k, avoid));
            let options = PlanOptions { allow_off_bed: true, ..PlanOptions::default() };
            let Some(plan) = nearest_next(&name, bytes.clone(), machine.clone(), options) else { continue };
            let job = Job::load(bytes.clone(), &name, &LoadOptions::default()).unwrap();
            let zones = problem_of(job.sheet(), &machine).zones.unwrap();
            // Without those of neighbours that cut sides of it: Shapely finds these for itself.
            let shape = |c: &u32| job.sheet().contours[*c as usize].rest_of;
            let is_own =
                |c: &u32, first: &u32| c == first || shape(c).is_some_and(|s| shape(first) == Some(s));
            let of = |cut_by: &[u32]| -> Vec<u32> {
                cut_by.iter().filter(|&c| is_own(c, &cut_by[0])).copied().collect()
            };
            let mut own: Vec<u32> = zones.pieces().iter().flat_map(|p| of(&p.cut_by)).collect();
            own.sort_unstable();
            tips.insert(name.clone(), own);
            plans.insert(name, plan);
        }
    }
    let (mut crossed, mut lifted, mut around) = (0, 0, 0);
    for (name, hash, found) in findings::<Replayed>(&plans, "tips") {
        assert_eq!(hash, found.moves, "{name} is another plan than the one that was replayed");
        assert_eq!(found.faults, Vec::<String>::new(), "{name}");
        assert_eq!(found.tips, tips[&name], "{name}");
        if name.ends_with(" avoid") {
            assert_eq!(found.surely, Vec::<usize>::new(), "{name}");
        }
        crossed += found.surely.len();
        (lifted, around) = (lifted + found.lifted, around + found.way_points);
    }
    if std::env::var_os("KERFWAY_BLESS").is_none() {
        assert!(
            crossed > 200 && lifted > 100 && around > 20,
            "{crossed} crossed, {lifted} lifted, {around} around"
        );
    }
}
