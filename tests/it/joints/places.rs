//! Where joints are: by rule and by hand, never in corners or shared cuts, and what is said where they do not fit.

use crate::testkit::exact::planned;
use crate::testkit::joints::{rule, with_joints};
use crate::testkit::leads::oriented;
use crate::testkit::sheets::{Builder, circle, machine, p, polygon, rectangle};
use kerfway::finding::{Code, Finding};
use kerfway::geometry::DVec2;
use kerfway::joint::{ContourJoints, Planner, Refusal, findings};
use kerfway::machine::{JointKind, JointRule, LeadSide, Profile};
use kerfway::plan;
use kerfway::sheet::{HandJoint, Sheet};

fn joints(sheet: &Sheet, machine: &Profile, contour: u32) -> ContourJoints {
    Planner::new(sheet, machine).unwrap().joints(contour).unwrap()
}

fn told(sheet: &Sheet, machine: &Profile) -> Vec<Finding> {
    let planner = Planner::new(sheet, machine).unwrap();
    let all: Vec<(u32, ContourJoints)> =
        (0..).take(sheet.contours.len()).filter_map(|c| Some((c, planner.joints(c)?))).collect();
    findings(sheet, &planner, all.iter().map(|(c, j)| (*c, &j.outcome)))
}

fn plate() -> Sheet {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(10.0, 10.0), p(100.0, 60.0)), None);
    b.cut(circle(p(50.0, 40.0), 10.0), Some(plate));
    oriented(b.sheet)
}

#[test]
fn count_spacing_width_and_corners_are_kept() {
    let sheet = plate();
    for (count, spacing, width, clearance) in
        [(1, None, 0.5, 2.0), (4, None, 1.0, 5.0), (2, Some(40.0), 0.3, 10.0), (0, Some(90.0), 2.0, 0.0)]
    {
        let rule = JointRule { count, spacing, width, corner_clearance: clearance, ..JointRule::default() };
        let mut machine = with_joints(machine("co2-100w"), vec![rule]);
        machine.kerf_width = 0.2;
        for contour in [0, 1] {
            let found = joints(&sheet, &machine, contour);
            let whole = sheet.contours[contour as usize].length;
            let gap = width + 0.2;
            let least = f64::from(count).max(spacing.map_or(0.0, |s| (whole / (s + gap)).ceil()));
            assert!(found.joints.len() as f64 >= least, "{count} {spacing:?}: {found:?}");
            let corners = [0.0, 100.0, 160.0, 260.0, 320.0];
            let next = found.joints.iter().cycle().skip(1);
            for (joint, next) in found.joints.iter().zip(next) {
                assert!(((joint.to - joint.from).rem_euclid(whole) - gap).abs() < 1e-9);
                let stretch = (next.from - joint.to).rem_euclid(whole);
                assert!(spacing.is_none_or(|s| stretch <= s + 1e-6), "{stretch} of {spacing:?}");
                let far = |c: f64| (joint.from - c).abs().min((joint.to - c).abs()) >= clearance - 1e-6;
                assert!(contour == 1 || corners.into_iter().all(far), "{joint:?}");
            }
            assert_eq!(found.outcome.too_long, None);
        }
        assert!(told(&sheet, &machine).is_empty());
    }
}

#[test]
fn evenly_spread_joints_are_about_equally_far_apart() {
    let found = joints(&plate(), &with_joints(machine("co2-100w"), vec![rule(4, JointKind::Stop)]), 1);
    let whole = std::f64::consts::TAU * 10.0;
    let next = found.joints.iter().cycle().skip(1);
    for (a, b) in found.joints.iter().zip(next) {
        let pitch = (b.from - a.from).rem_euclid(whole);
        assert!((pitch - whole / 4.0).abs() < 0.5, "{pitch}");
    }
}

#[test]
fn sides_and_sizes_choose_the_contours() {
    let sheet = plate();
    let of = |rule: JointRule| {
        let machine = with_joints(machine("co2-100w"), vec![rule]);
        let planner = Planner::new(&sheet, &machine).unwrap();
        [0, 1].map(|c| planner.joints(c).is_some())
    };
    let rule = rule(1, JointKind::Stop);
    assert_eq!(of(JointRule { side: Some(LeadSide::Outer), ..rule }), [true, false]);
    assert_eq!(of(JointRule { side: Some(LeadSide::Hole), ..rule }), [false, true]);
    assert_eq!(of(JointRule { size_max: Some([50.0, 50.0]), ..rule }), [false, true]);
    assert_eq!(of(JointRule { size_min: Some([50.0, 50.0]), ..rule }), [true, false]);
    assert_eq!(of(JointRule { count: 0, ..rule }), [false, false]);
}

/// Where a joint does not fit in the rule's number: a triangle of 6 mm with 2 mm from its corners has room for a few.
#[test]
fn what_does_not_fit_is_told_with_its_place() {
    let mut b = Builder::new();
    b.cut(polygon(&[p(10.0, 10.0), p(16.0, 10.0), p(13.0, 15.0)]), None);
    b.cut(rectangle(p(30.0, 10.0), p(3.0, 3.0)), None);
    let sheet = oriented(b.sheet);
    let rule = JointRule { count: 8, corner_clearance: 2.0, ..JointRule::default() };
    let machine = with_joints(machine("co2-100w"), vec![rule]);
    let told = told(&sheet, &machine);
    let codes: Vec<Code> = told.iter().map(|f| f.code).collect();
    assert_eq!(codes, [Code::JointAdjusted, Code::JointMissing], "{told:?}");
    assert!(told[0].message.starts_with("Contour 0 has "), "{}", told[0].message);
    assert!(told[1].message.starts_with("Contour 1 has 0 of 8 micro-joints"), "{}", told[1].message);
    assert!(told.iter().all(|f| f.at.is_some()));
}

#[test]
fn a_side_next_to_another_cut_has_no_joint() {
    let mut b = Builder::new();
    b.cut(rectangle(p(0.0, 0.0), p(60.0, 40.0)), None);
    b.cut(rectangle(p(60.0, 0.0), p(60.0, 40.0)), None);
    let sheet = oriented(b.sheet);
    let rule = JointRule { count: 1, spacing: Some(20.0), corner_clearance: 1.0, ..JointRule::default() };
    let machine = with_joints(machine("co2-100w"), vec![rule]);
    for contour in [0, 1] {
        let found = joints(&sheet, &machine, contour);
        assert!(found.joints.len() >= 5);
        for joint in &found.joints {
            let at = sheet.contours[contour as usize].path.at(joint.from).unwrap();
            assert!((at.x - 60.0).abs() > 0.2, "{at}");
        }
        // The shared side is 40 mm long, which is more than the rule allows without a joint.
        assert!(found.outcome.too_long.is_some_and(|[longest, _]| longest > 40.0));
    }
}

/// A plate with a slot whose sides are nearer to each other than half a joint: the beam would cut a joint there from the
/// other side.
#[test]
fn no_joint_is_in_a_narrow_slot_of_its_own_contour() {
    let slot = [
        p(0.0, 0.0),
        p(60.0, 0.0),
        p(60.0, 40.0),
        p(30.1, 40.0),
        p(30.1, 5.0),
        p(30.0, 5.0),
        p(30.0, 40.0),
        p(0.0, 40.0),
    ];
    let mut b = Builder::new();
    b.cut(polygon(&slot), None);
    let sheet = oriented(b.sheet);
    let rule = JointRule { count: 1, spacing: Some(12.0), corner_clearance: 1.0, ..JointRule::default() };
    let found = joints(&sheet, &with_joints(machine("co2-100w"), vec![rule]), 0);
    assert!(found.joints.len() >= 8, "{}", found.joints.len());
    for joint in &found.joints {
        let at = sheet.contours[0].path.at(joint.from).unwrap();
        assert!((at.x - 30.05).abs() > 0.2 || at.y < 0.1, "{at}");
    }
    assert!(found.outcome.too_long.is_some_and(|[longest, _]| longest > 60.0));
}

#[test]
fn joints_by_hand_replace_those_of_rules() {
    let mut sheet = plate();
    let hand = |contour, at| HandJoint { contour, at };
    // The middle of the lower side, 0.3 mm from a corner, and twice nearly the same place on the hole.
    sheet.joints = vec![hand(0, 50.0 / 320.0), hand(0, 100.3 / 320.0), hand(1, 0.25), hand(1, 0.252)];
    let machine = with_joints(machine("co2-100w"), vec![rule(7, JointKind::Flying)]);
    let found = joints(&sheet, &machine, 0);
    let middles: Vec<DVec2> =
        found.joints.iter().map(|j| sheet.contours[0].path.at(j.from + 0.25).unwrap()).collect();
    assert!(middles[0].distance(p(60.0, 10.0)) < 1e-9, "{middles:?}");
    // Out of the corner at (110, 10), on one of its sides.
    assert!((1.25..1.6).contains(&middles[1].distance(p(110.0, 10.0))), "{middles:?}");
    assert_eq!((found.kind, found.joints.len()), (JointKind::Flying, 2));
    assert_eq!(joints(&sheet, &machine, 1).joints.len(), 1, "there is one already");
    let told = told(&sheet, &machine);
    let [moved, left_out] = told.as_slice() else { panic!("{told:?}") };
    assert!(moved.message.contains(" of contour 0 was moved by "), "{}", moved.message);
    assert!(left_out.message.contains(" of contour 1 was left out"), "{}", left_out.message);
    // Without rules, joints by hand have the defaults.
    let found = joints(&sheet, &Profile { joints: None, ..machine }, 0);
    assert_eq!(found.kind, JointKind::Stop);
}

#[test]
fn a_joint_by_hand_in_a_corner_of_a_contour_of_60_m_is_moved_by_a_few_millimetres_only() {
    let mut b = Builder::new();
    b.cut(rectangle(p(0.0, 0.0), p(20_000.0, 10_000.0)), None);
    let mut sheet = oriented(b.sheet);
    sheet.joints = vec![HandJoint { contour: 0, at: 0.0 }];
    let machine = with_joints(machine("co2-100w"), vec![rule(1, JointKind::Stop)]);
    let found = joints(&sheet, &machine, 0);
    let [joint] = found.joints.as_slice() else { panic!("{found:?}") };
    let clearance = machine.joints.as_ref().unwrap().rules[0].corner_clearance;
    let from_corner = joint.from.min(60_000.0 - joint.to);
    assert!((clearance..clearance + 0.5).contains(&from_corner), "{joint:?}");
    assert_eq!(found.outcome.moved.len(), 1);
}

#[test]
fn contours_that_cannot_have_joints_are_refused() {
    let mut sheet = plate();
    sheet.contours[1].self_crossing = true;
    let mut machine = with_joints(machine("co2-100w"), vec![rule(2, JointKind::Stop)]);
    let refused = |sheet: &Sheet, machine: &Profile, c| Planner::new(sheet, machine).unwrap().refused(c);
    assert_eq!(refused(&sheet, &machine, 0), None);
    assert_eq!(refused(&sheet, &machine, 1), Some(Refusal::CrossesItself));
    machine.cut.passes = 2;
    assert_eq!(refused(&sheet, &machine, 0), Some(Refusal::Passes));
    assert!(told(&sheet, &machine).iter().all(|f| f.code == Code::JointMissing));
}

/// A contour of which a joint is more than a third got one all the same, and then no plan passed the check.
#[test]
fn a_contour_that_is_too_short_for_a_joint_is_planned_without_one() {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(10.0, 10.0), p(100.0, 60.0)), None);
    // 1.26 mm and 3.77 mm around; a joint leaves 0.7 mm uncut.
    b.cut(circle(p(50.0, 40.0), 0.2), Some(plate));
    b.cut(circle(p(80.0, 40.0), 0.6), Some(plate));
    let mut sheet = oriented(b.sheet);
    let mut machine = with_joints(machine("co2-100w"), vec![rule(2, JointKind::Stop)]);
    machine.kerf_width = 0.2;
    let counts = |sheet: &Sheet| [0, 1, 2].map(|c| joints(sheet, &machine, c).joints.len());
    assert_eq!(counts(&sheet), [2, 0, 1]);
    let missing = told(&sheet, &machine);
    assert_eq!(missing[0].code, Code::JointMissing);
    assert_eq!(
        missing[0].message,
        "Contour 1 has 0 of 2 micro-joints: there is no room for more. Allow narrower joints or less distance from corners."
    );
    assert_eq!(missing[0].at, Some(sheet.contours[1].path.start().unwrap()));
    let plan = planned(&sheet, &machine);
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    assert_eq!(plan.summary.joints, 3);
    // By hand it is the same.
    sheet.joints = vec![HandJoint { contour: 1, at: 0.25 }];
    assert_eq!(counts(&sheet), [2, 0, 1]);
    let left_out = told(&sheet, &machine);
    assert!(
        left_out.iter().any(|f| f.message.starts_with("A micro-joint of contour 1 was left out")),
        "{left_out:?}"
    );
    assert_eq!(plan::check(&sheet, &machine, &planned(&sheet, &machine)), Ok(()));
}
