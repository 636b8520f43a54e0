//! Plans with chains, heat and corners that Shapely has replayed: fixtures name the moves of each plan by their hash, with what the
//! scripts `chains.py`, `heat.py` and `corners.py` of `tests/oracle` found in it. As long as Kerfway makes the same plans, that holds.
//!
//! After a change that is meant to change such plans, `KERFWAY_BLESS=1 cargo test --features png --test it levers_replay` writes them to
//! `target/chains`, `target/heat` and `target/corners`, and the scripts replay them and write the fixtures.

use crate::testkit::replayed::{SMALL, drawings, findings, searched};
use kerfway::machine::{Chains, CornerKind, Corners, Heat, Levers, Profile, preset};
use std::collections::BTreeMap;

/// Number of seeded nests.
const NESTS: u64 = 100;

#[derive(serde::Deserialize)]
struct Replayed {
    /// SHA-256 of the moves as they are written.
    moves: String,
    /// Number of chains, of waits, or of loops.
    count: u32,
    /// Of them those that begin on a kerf, or corners that are rounded.
    #[serde(default)]
    others: u32,
    /// Faults that the replay found.
    faults: Vec<String>,
}

/// Plans all small drawings; returns how much was found in all of them.
fn replayed(judged: &str, moves: u64, machine: impl Fn(usize) -> Profile) -> (u32, u32) {
    let plans: BTreeMap<String, String> = drawings(SMALL, NESTS)
        .into_iter()
        .enumerate()
        .filter_map(|(k, (name, bytes))| Some((name.clone(), searched(&name, bytes, machine(k), moves)?)))
        .collect();
    let mut all = (0, 0);
    for (name, hash, found) in findings::<Replayed>(&plans, judged) {
        assert_eq!(hash, found.moves, "{name} is another plan than the one that was replayed");
        assert_eq!(found.faults, Vec::<String>::new(), "{name}");
        all = (all.0 + found.count, all.1 + found.others);
    }
    all
}

fn is_blessing() -> bool {
    std::env::var_os("KERFWAY_BLESS").is_some()
}

#[test]
fn chains_cut_into_no_part_and_keep_their_clearance() {
    let found = replayed("chains", 20_000, |k| {
        let chains = Chains {
            reach: [30.0, 60.0][k % 2],
            clearance: [0.5, 1.0, 2.0][k % 3],
            edge_starts: k.is_multiple_of(2),
        };
        Profile {
            levers: Levers { chains: Some(chains), ..Levers::default() },
            kerf_width: [0.0, 0.3][k / 2 % 2],
            ..preset("fibre-6kw-thick").unwrap()
        }
    });
    assert!(is_blessing() || found.0 > 200 && found.1 > 30, "{found:?}");
}

#[test]
fn cuts_near_each_other_are_apart_in_time() {
    let found = replayed("heat", 2_000, |k| {
        let heat = Heat {
            distance: [5.0, 12.0, 25.0][k % 3],
            seconds: [1.0, 4.0][k % 2],
            charge: None,
            small_holes: None,
        };
        // The replay adds up times with corners at full speed, and arcs at what their acceleration allows.
        Profile {
            levers: Levers { heat: Some(heat), ..Levers::default() },
            junction_deviation: None,
            ..preset("fibre-3kw-thin").unwrap()
        }
    });
    assert!(is_blessing() || found.0 > 100, "{found:?}");
}

#[test]
fn loops_cut_into_no_part_and_arcs_stay_within_their_deviation() {
    let found = replayed("corners", 5_000, |k| {
        let kinds = [CornerKind::Loop, CornerKind::Round, CornerKind::Loop];
        let corners = Corners {
            outer: kinds[k % 3],
            hole: kinds[(k + 1) % 3],
            loop_radius: [0.5, 1.0, 1.5, 3.0][k % 4],
            clearance: [0.2, 1.0][k % 2],
            round_radius: [0.5, 2.0][k / 2 % 2],
            deviation: [0.05, 0.2][k / 3 % 2],
        };
        Profile {
            levers: Levers { corners: Some(corners), ..Levers::default() },
            sharp_corner: [None, Some(kerfway::machine::SharpCorner { angle: 1.6, time: 1.0 })][k % 2],
            kerf_width: [0.0, 0.2][k / 2 % 2],
            ..preset("fibre-3kw-thin").unwrap()
        }
    });
    assert!(is_blessing() || found.0 > 300 && found.1 > 300, "{found:?}");
}
