//! Chains and starts on kerfs where moves avoid pieces that may have tipped: no cut through waste passes one, and none begins beside one.

use super::search::every_order;
use super::{all_tip, ignored, tipping};
use crate::chains::squares;
use crate::testkit::leads::oriented;
use crate::testkit::searches::{searched, slices_of_any_size_find_the_same};
use crate::testkit::sheets::{Builder, XorShift, circle, machine, p, rectangle};
use kerfway::job::problem_of;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{Chains, Profile, Start, Tips};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move};
use kerfway::sheet::{Pin, Sheet};

/// Thick plate, joined through waste, with these pieces that tip.
fn joining(tips: Tips) -> Profile {
    let tipping = tipping(0.4, tips);
    let mut machine =
        Profile { z_speed: tipping.z_speed, levers: tipping.levers, ..machine("fibre-6kw-thick") };
    machine.levers.chains = Some(Chains { reach: 30.0, clearance: 1.0, edge_starts: true });
    machine.validate().unwrap();
    machine
}

/// The same with the head down and nothing avoided.
fn down(tips: Tips) -> Profile {
    let mut machine = joining(ignored(tips));
    machine.levers.lift = None;
    machine
}

/// Squares with a side of 20 mm tip, larger parts stay. The nozzle passes nearer than parts lie apart.
fn small_tip() -> Tips {
    Tips { drops_below: Some(0.0), tips_below: 21.0, nozzle_radius: 3.0, margin: 1.0, ..Tips::default() }
}

/// Three to five rectangles and discs in two rows, of which some tip.
fn mixed(seed: u64) -> Sheet {
    let mut rng = XorShift::new(700 + seed);
    let mut b = Builder::new();
    for k in 0..3 + seed % 3 {
        let at = p(20.0 + 34.0 * (k % 3) as f64 + rng.between(0.0, 3.0), 20.0 + 33.0 * (k / 3) as f64);
        let size = p(rng.between(14.0, 29.0), rng.between(14.0, 29.0));
        match rng.below(4) {
            0 => b.cut(circle(at + size / 2.0, size.x.min(size.y) / 2.0), None),
            _ => b.cut(rectangle(at, size), None),
        };
    }
    oriented(b.sheet)
}

#[test]
fn chains_past_tipped_pieces_are_as_good_as_every_order_and_entry() {
    let (mut chains, mut on_kerfs, mut bent, mut later, mut few) = (0, 0, 0, 0.0, 0);
    for seed in 0..24 {
        let sheet = mixed(seed);
        let machine = joining(small_tip());
        let problem = problem_of(&sheet, &machine);
        let (found, plan) = searched(&sheet, &machine, 100_000, seed);
        if problem.nodes.len() <= 120 {
            few += 1;
            let least = every_order(&problem);
            assert!(found.cost <= least + 1e-9, "seed {seed}: {} s, not {least} s", found.cost);
        }
        let fixed: f64 = problem.items.iter().map(|i| i.fixed).sum();
        let s = &plan.summary;
        assert!((s.total_time - fixed - found.cost).abs() < 1e-6, "seed {seed}: {} s", s.total_time);
        assert_eq!(s.crossings, 0);
        let (_, without) = searched(&sheet, &down(small_tip()), 100_000, seed);
        assert!(without.summary.total_time < s.total_time + 1e-6, "seed {seed}");
        later += s.total_time - without.summary.total_time;
        (chains, on_kerfs, bent) = (chains + s.chains, on_kerfs + s.edge_starts, bent + s.lifts + s.detours);
    }
    assert!(
        few > 8 && chains > 24 && on_kerfs > 4 && bent > 2 && later > 1.0,
        "{few} {chains} {on_kerfs} {bent} {later}"
    );
}

#[test]
fn the_checker_finds_chains_past_tipped_pieces() {
    let ask = |sheet: &Sheet| {
        let (ignoring, avoiding) = (down(all_tip()), joining(all_tip()));
        let (_, plan) = searched(sheet, &ignoring, 50_000, 1);
        let found = plan::check(sheet, &avoiding, &plan).err().unwrap_or_default();
        (plan.summary, found, searched(sheet, &avoiding, 50_000, 1).1.summary)
    };
    // A row: a second start on the kerf of a square would be beside it.
    let row = oriented(squares(4, 1, 8.0).sheet);
    let (ignored, found, avoided) = ask(&row);
    assert!(ignored.edge_starts > 0 && avoided.edge_starts == 0, "{ignored:?} {avoided:?}");
    assert!(avoided.pierces > ignored.pierces && avoided.chains > 0, "{avoided:?}");
    assert!(says_tipped(&found, "begins on a kerf beside a piece that may have tipped"), "{found:?}");
    // Three corners that face each other: after the square in the corner, the way between the others passes it.
    let mut corner = squares(2, 2, 8.0);
    corner.sheet.contours.truncate(3);
    corner.sheet.contours[0].pin = Pin::First;
    let (ignored, found, avoided) = ask(&oriented(corner.sheet));
    assert_eq!((ignored.pierces, avoided.pierces), (1, 2), "{ignored:?} {avoided:?}");
    assert!(says_tipped(&found, "cuts through waste past a piece that may have tipped"), "{found:?}");
}

fn says_tipped(found: &[plan::Violation], wanted: &str) -> bool {
    found.iter().any(|v| matches!(v, plan::Violation::Tipped { what, .. } if *what == wanted))
}

/// Squares with a disc in each, 8 mm apart.
fn nest() -> Sheet {
    let mut b = squares(5, 4, 8.0);
    for k in 0..20 {
        b.cut(circle(p(f64::from(k % 5), f64::from(k / 5)) * 28.0 + p(20.0, 20.0), 4.0), Some(k));
    }
    oriented(b.sheet)
}

#[test]
fn nests_are_joined_past_what_tips_out_of_their_holes() {
    let sheet = nest();
    let machine = joining(Tips { tips_below: 15.0, ..all_tip() });
    let (found, plan) = searched(&sheet, &machine, 100_000, 1);
    // Discs of 8 mm tip, and squares stay: most of these are joined, or begin on a kerf.
    let chain = |m: &&Move| matches!(m, Move::Chain { .. });
    let chains = plan.moves.iter().filter(chain).count();
    assert!(chains > 14 && plan.summary.edge_starts > 2, "{:?}", plan.summary);
    assert_eq!(plan.summary.pierces as usize, 40 - chains);
    let problem = problem_of(&sheet, &machine);
    let fixed: f64 = problem.items.iter().map(|i| i.fixed).sum();
    assert!((plan.summary.total_time - fixed - found.cost).abs() < 1e-6, "{} s", plan.summary.total_time);
    // Without chains it takes longer by most of these piercings.
    let mut pierced = machine;
    pierced.levers.chains = None;
    let (_, without) = searched(&sheet, &pierced, 100_000, 1);
    assert!(without.summary.total_time - plan.summary.total_time > 10.0, "{:?}", without.summary);
    slices_of_any_size_find_the_same(&problem);
}

#[test]
fn programs_have_lifts_and_chains() {
    let mut written = 0;
    for dialect in dialects().into_iter().filter(|d| d.pierce.is_some()) {
        let machine = joining(Tips { tips_below: 15.0, ..all_tip() });
        let name = DialectChoice::named(&dialect.name);
        let profile = Profile { dialect: name, z_speed: Some(2000.0), ..machine };
        let sheet = nest();
        let (_, plan) = searched(&sheet, &profile, 20_000, 1);
        assert!(plan.summary.chains > 9 && plan.summary.lifts > 0, "{:?}", plan.summary);
        // A dialect without heights or waits refuses them.
        let text = output::gcode(&plan, &SheetFacts::of(&sheet), &profile, "plan.dxf", Start::Absolute);
        let Ok(text) = text else { continue };
        let check = output::check_against(&text, &profile, &plan).unwrap();
        assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
        written += 1;
    }
    assert!(written >= 6, "{written}");
}
