//! What the checker says of wrong plans where cuts heat each other.

use super::{charged, heated, waiting};
use crate::testkit::exact::planned;
use crate::testkit::joints::with_joints;
use crate::testkit::sheets::{Builder, circle, nested_sheet, p};
use kerfway::machine::{Heat, JointRule, Levers, MovingPierce, Profile, ProfileError};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::Sheet;

/// The violations other than sums of the seconds.
fn found(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Vec<Violation> {
    let all = plan::check(sheet, machine, plan).err().unwrap_or_default();
    let is_sum = |v: &Violation| matches!(v, Violation::Sum { what, .. } if !what.contains("hot pairs"));
    all.into_iter().filter(|v| !is_sum(v)).collect()
}

/// Circles of 10 mm in a row, with 10 mm between them.
fn row() -> Sheet {
    let mut b = Builder::new();
    for k in 0..5 {
        b.cut(circle(p(50.0 + 20.0 * f64::from(k), 50.0), 5.0), None);
    }
    b.sheet
}

#[test]
fn cuts_that_begin_too_soon_are_found() {
    let sheet = row();
    let machine = heated(waiting(12.0, 3.0));
    let plan = planned(&sheet, &machine);
    assert_eq!(found(&sheet, &machine, &plan), []);
    // Nearest next has to wait before all circles but the first: after the cut and the move there are 3 s in all.
    let waits: Vec<usize> =
        (0..plan.moves.len()).filter(|&k| matches!(plan.moves[k], Move::Wait { .. })).collect();
    assert_eq!((waits.len(), plan.summary.waits), (4, 4));
    assert!((plan.summary.wait_time / 4.0 - 2.9).abs() < 0.1, "{}", plan.summary.wait_time);
    for &k in &waits {
        let Move::Wait { seconds } = plan.moves[k] else { unreachable!() };
        let mut other = plan.clone();
        other.moves.remove(k);
        assert!(matches!(found(&sheet, &machine, &other)[..], [Violation::Hot { .. }]), "{k}");
        other.moves.insert(k, Move::Wait { seconds: seconds - 1e-3 });
        assert!(matches!(found(&sheet, &machine, &other)[..], [Violation::Hot { .. }]), "{k}");
        other.moves[k] = Move::Wait { seconds: seconds + 1e-3 };
        assert!(
            matches!(found(&sheet, &machine, &other)[..], [Violation::NeedlessWait { step }] if step == k),
            "{k}"
        );
        other.moves[k] = Move::Wait { seconds: -1.0 };
        assert!(found(&sheet, &machine, &other).contains(&Violation::NotFinite { step: k }));
    }
    // Nobody waits on a machine that does not mind heat, or that has a charge for it.
    for levers in [Levers::default(), Levers { heat: Some(charged(12.0, 3.0, 1.0)), ..Levers::default() }] {
        let other = Profile { levers, ..machine.clone() };
        let violations = found(&sheet, &other, &plan);
        assert_eq!(violations.len(), 4, "{violations:?}");
        assert!(violations.iter().all(|v| matches!(v, Violation::NeedlessWait { .. })));
    }
    // A wait at the end is for nothing.
    let mut other = plan.clone();
    other.moves.push(Move::Wait { seconds: 1.0 });
    assert_eq!(found(&sheet, &machine, &other), [Violation::NeedlessWait { step: other.moves.len() - 1 }]);
}

#[test]
#[allow(clippy::float_cmp, reason = "one of the distances of the list")]
fn pairs_are_counted_again() {
    let sheet = row();
    // The lines of neighbours are 10 mm apart, of the next but one 30.
    for (distance, pairs) in [(9.999, 0), (10.0, 0), (10.001, 4), (29.9, 4), (30.1, 7), (200.0, 10)] {
        let machine = heated(charged(distance, 100.0, 1.0));
        let mut plan = planned(&sheet, &machine);
        assert_eq!((plan.summary.hot_pairs, plan.summary.waits), (pairs, 0), "{distance}");
        assert_eq!(found(&sheet, &machine, &plan), []);
        plan.summary.hot_pairs += 1;
        // At just the distance it is too close to call.
        let is_found = matches!(found(&sheet, &machine, &plan)[..], [Violation::Sum { .. }]);
        assert!(is_found || distance == 10.0, "{distance}");
    }
    // So few seconds that the next circle is cold when the head arrives.
    assert_eq!(planned(&sheet, &heated(charged(12.0, 0.001, 1.0))).summary.hot_pairs, 0);
}

#[test]
fn plans_of_nested_sheets_pass() {
    let joints = vec![JointRule { width: 0.3, count: 2, ..JointRule::default() }];
    for seed in 0..6 {
        let sheet = nested_sheet(30, seed);
        for heat in
            [waiting(15.0, 2.0), waiting(100.0, 0.5), charged(15.0, 2.0, 1.0), charged(100.0, 30.0, 0.1)]
        {
            let plain = heated(heat);
            let moving = Levers { moving_pierce: Some(MovingPierce { overcut: 0.5 }), ..plain.levers };
            let moving = Profile { levers: moving, ..plain.clone() };
            let held = with_joints(plain.clone(), joints.clone());
            for machine in [plain, moving, held] {
                let plan = planned(&sheet, &machine);
                assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()), "{seed} {heat:?}");
                assert!(plan.summary.waits + plan.summary.hot_pairs > 0);
            }
        }
    }
}

#[test]
fn machines_that_cannot_mind_heat_are_refused() {
    let machine = heated(waiting(10.0, 1.0));
    let fly = Levers { fly: Some(kerfway::machine::Fly { reach: 10.0, overcut: 0.0 }), ..machine.levers };
    assert_eq!(Profile { levers: fly, ..machine.clone() }.validate(), Err(ProfileError::HeatWithFly));
    let left = Profile { pre_cut_time: Some(1.0), ..machine.clone() };
    assert_eq!(left.validate(), Err(ProfileError::HeatWithPreCuts));
    for wrong in [
        waiting(-1.0, 1.0),
        waiting(1.0, f64::NAN),
        charged(1.0, 1.0, 1e9),
        Heat {
            small_holes: Some(kerfway::machine::SmallHoles { thickness: 0.0, ratio: 1.0 }),
            ..waiting(1.0, 1.0)
        },
    ] {
        let levers = Levers { heat: Some(wrong), ..machine.levers };
        assert!(matches!(Profile { levers, ..machine.clone() }.validate(), Err(ProfileError::Value { .. })));
    }
}
