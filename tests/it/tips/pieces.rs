//! Which pieces may tip, by hand.

use super::{all_tip, tipping};
use crate::testkit::sheets::{Builder, circle, p, rectangle};
use kerfway::job::problem_of;
use kerfway::machine::{JointRule, Joints, Profile, Slats, Tips};
use kerfway::sheet::Sheet;

/// The contours whose pieces may tip.
fn tips(sheet: &Sheet, machine: &Profile) -> Vec<u32> {
    machine.validate().unwrap();
    let problem = problem_of(sheet, machine);
    problem.zones.unwrap().pieces().iter().flat_map(|p| p.cut_by.clone()).collect()
}

/// A plate of 400 x 300 mm (0) with a hole of 60 x 20 mm (1) and one of 8 mm (2); a strip of 600 x 30 mm along x (3); a square
/// of 40 mm (4).
fn sheet() -> Sheet {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(0.0, 0.0), p(400.0, 300.0)), None);
    b.cut(rectangle(p(50.0, 50.0), p(60.0, 20.0)), Some(plate));
    b.cut(circle(p(200.0, 200.0), 4.0), Some(plate));
    b.cut(rectangle(p(0.0, 320.0), p(600.0, 30.0)), None);
    b.cut(rectangle(p(420.0, 0.0), p(40.0, 40.0)), None);
    b.mark(rectangle(p(10.0, 10.0), p(60.0, 60.0)), Some(plate));
    b.sheet
}

#[test]
fn size_slats_joints_and_holes_decide_what_tips() {
    let sheet = sheet();
    let of = |tips_: Tips| tips(&sheet, &tipping(0.2, tips_));
    let guess = Tips::default();
    // Below 50 mm both ways drops: the small hole and the square. The plate is larger than 150 mm both ways.
    assert_eq!(of(guess), [1, 3]);
    // Slats along x every 70 mm: the slot falls between them, and the strip lies along them.
    let along = Slats { pitch: 70.0, angle: 0.0 };
    assert_eq!(of(Tips { slats: Some(along), ..guess }), [3]);
    // Slats along y: the strip lies over many of them.
    let across = Slats { angle: std::f64::consts::FRAC_PI_2, ..along };
    assert_eq!(of(Tips { slats: Some(across), ..guess }), [0; 0]);
    assert_eq!(of(Tips { slats: Some(across), drops_below: Some(10.0), ..guess }), [1, 4]);
    // At 30 degrees the plate of 400 x 300 is 460 mm wide across the slats; the limit is above that.
    let slanted = Slats { angle: std::f64::consts::FRAC_PI_6, ..along };
    let across_slats = 400.0 * 0.5 + 300.0 * 0.75_f64.sqrt();
    let limit = |by: f64| Tips { slats: Some(slanted), tips_below: across_slats + by, ..guess };
    assert!(of(limit(0.01)).contains(&0) && !of(limit(-0.01)).contains(&0));
    // What is cut out of holes up to 60 mm may be crossed; a part of that size may not.
    assert_eq!(of(Tips { cross_over: 60.0, ..all_tip() }), [3, 4]);
    assert_eq!(of(Tips { cross_over: 59.9, ..all_tip() }), [1, 3, 4]);
}

#[test]
fn a_piece_with_micro_joints_stays() {
    let sheet = sheet();
    let machine = Profile {
        joints: Some(Joints {
            rules: vec![JointRule { size_max: Some([100.0, 100.0]), ..JointRule::default() }],
        }),
        ..tipping(0.2, all_tip())
    };
    assert_eq!(tips(&sheet, &machine), [3]);
}

#[test]
fn what_a_machine_cannot_do_is_refused() {
    let machine = tipping(0.2, all_tip());
    let mut no_lift = machine.clone();
    no_lift.levers.lift = None;
    assert_eq!(
        no_lift.validate().unwrap_err().to_string(),
        "The machine's levers.tips avoids risky moves, but there is no levers.lift. Give the lift, or set risky_moves to \"ignore\"."
    );
    no_lift.levers.tips = no_lift.levers.tips.map(super::ignored);
    no_lift.validate().unwrap();
    let leaves = Profile { pre_cut_time: Some(1.0), ..machine.clone() }.validate().unwrap_err().to_string();
    assert!(leaves.contains("levers.tips") && leaves.contains("pre_cut_time"), "{leaves}");
    let mut wide = machine;
    wide.levers.tips = Some(Tips { nozzle_radius: 900.0, ..all_tip() });
    assert!(wide.validate().unwrap_err().to_string().contains("\"levers.tips.nozzle_radius\" is 900"));
}
