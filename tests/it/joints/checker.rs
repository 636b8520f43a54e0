//! Faults planted in the joints of a sound plan: the checker finds each.

use crate::testkit::joints::{rule, with_joints};
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, circle, machine, p, rectangle};
use kerfway::geometry::Segment;
use kerfway::job::problem_of;
use kerfway::machine::{JointKind, JointRule, LeadKind, Profile};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::Sheet;
use kerfway::solve;

fn sound(kind: JointKind) -> (Sheet, Profile, Plan) {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(60.0, 40.0)), None);
    b.cut(circle(p(70.0, 70.0), 8.0), Some(plate));
    let sheet = oriented(b.sheet);
    let machine = with_leads(machine("co2-100w"), leads(LeadKind::Arc, 1.0, 0.5));
    let machine = with_joints(machine, vec![JointRule { spacing: Some(60.0), ..rule(3, kind) }]);
    let problem = problem_of(&sheet, &machine);
    let plan = plan::from_solution(&sheet, &problem, &solve::greedy(&problem));
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    assert!(plan.summary.joints >= 6);
    (sheet, machine, plan)
}

fn faults(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Vec<String> {
    plan::check(sheet, machine, plan).unwrap_err().iter().map(ToString::to_string).collect()
}

fn of_joints(found: &[String]) -> bool {
    found.iter().any(|f| f.contains("a micro-joint of contour"))
}

#[test]
fn plans_with_other_rules_are_found() {
    for kind in [JointKind::Stop, JointKind::Flying] {
        let (sheet, machine, plan) = sound(kind);
        let other = match kind {
            JointKind::Stop => JointKind::Flying,
            JointKind::Flying => JointKind::Stop,
        };
        let rules = [
            ("has the wrong length", JointRule { width: 0.6, ..rule(3, kind) }),
            ("is of the wrong kind", rule(3, other)),
            ("is too near to a corner", JointRule { corner_clearance: 19.0, ..rule(3, kind) }),
            ("is missing, although there is room", rule(9, kind)),
            ("is missing, although there is room", JointRule { spacing: Some(20.0), ..rule(3, kind) }),
            ("is one that nothing asks for", JointRule { size_max: Some([1.0, 1.0]), ..rule(3, kind) }),
        ];
        for (fault, rule) in rules {
            let found = faults(&sheet, &with_joints(machine.clone(), vec![rule]), &plan);
            assert!(found.iter().any(|f| f.contains(fault)), "{fault}: {found:?}");
        }
        let none = Profile { joints: None, ..machine };
        assert!(of_joints(&faults(&sheet, &none, &plan)));
    }
}

#[test]
fn a_joint_that_is_cut_through_is_found() {
    for kind in [JointKind::Stop, JointKind::Flying] {
        let (sheet, machine, mut plan) = sound(kind);
        let at = plan.moves.iter().position(|m| matches!(m, Move::Joint { .. })).unwrap();
        let Move::Joint { path: joint, .. } = plan.moves[at].clone() else { panic!() };
        let Move::Cut { path, .. } = &mut plan.moves[at - 1] else { panic!() };
        path.extend(joint);
        plan.moves.remove(at);
        assert!(plan::check(&sheet, &machine, &plan).is_err());
        // Half of it is cut.
        let (sheet, machine, mut plan) = sound(kind);
        let Move::Joint { path: joint, .. } = &mut plan.moves[at] else { panic!() };
        let half = joint[0].piece(0.0, 0.5);
        joint[0] = joint[0].piece(0.5, 1.0);
        let Move::Cut { path, .. } = &mut plan.moves[at - 1] else { panic!() };
        path.push(half);
        let found = faults(&sheet, &machine, &plan);
        assert!(found.iter().any(|f| f.contains("has the wrong length")), "{found:?}");
    }
}

#[test]
fn piercings_fit_the_kind_of_joint() {
    let (sheet, machine, plan) = sound(JointKind::Stop);
    let at = plan.moves.iter().position(|m| matches!(m, Move::Joint { .. })).unwrap();
    let mut without = plan.clone();
    assert_eq!(without.moves.remove(at + 1), Move::Pierce);
    assert!(faults(&sheet, &machine, &without).iter().any(|f| f.contains("as a joint asks for")));
    let (sheet, machine, mut plan) = sound(JointKind::Flying);
    plan.moves.insert(at + 1, Move::Pierce);
    assert!(faults(&sheet, &machine, &plan).iter().any(|f| f.contains("as a joint asks for")));
}

#[test]
fn what_lies_between_joint_and_cut_is_found() {
    let (sheet, machine, mut plan) = sound(JointKind::Stop);
    let at = plan.moves.iter().position(|m| matches!(m, Move::Joint { .. })).unwrap();
    let to = plan.moves[..at]
        .iter()
        .rev()
        .find_map(|m| if let Move::Air { to, .. } = m { Some(*to) } else { None });
    plan.moves.insert(at + 1, Move::air(to.unwrap()));
    assert!(faults(&sheet, &machine, &plan).iter().any(|f| f.contains("does not cut on after a joint")));
}

#[test]
fn sums_are_checked() {
    let (sheet, machine, plan) = sound(JointKind::Stop);
    for change in [|p: &mut Plan| p.summary.joints -= 1, |p: &mut Plan| p.summary.joint_time *= 1.01] {
        let mut wrong = plan.clone();
        change(&mut wrong);
        let found = plan::check(&sheet, &machine, &wrong).unwrap_err();
        assert!(matches!(found.as_slice(), [Violation::Sum { .. }]), "{found:?}");
    }
}

#[test]
fn a_joint_off_the_contour_is_found() {
    let (sheet, machine, mut plan) = sound(JointKind::Stop);
    for m in &mut plan.moves {
        if let Move::Joint { path, .. } = m {
            let (a, b) = (path[0].start(), path[path.len() - 1].end());
            let off = (a + b) * 0.5 + (b - a).perp() * 0.1;
            *path = vec![Segment::line(a, off), Segment::line(off, b)];
        }
    }
    assert!(faults(&sheet, &machine, &plan).iter().any(|f| f.contains("leaves contour")));
}

/// The gap that the overcut leaves was taken for a joint in a corner, and the plan was refused.
#[test]
fn a_gap_that_is_as_wide_as_a_joint_is_no_joint() {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(60.0, 40.0)), None);
    b.cut(rectangle(p(70.0, 60.0), p(20.0, 20.0)), Some(plate));
    let sheet = oriented(b.sheet);
    for (width, joints) in [(2.0, 4), (1.5, 4)] {
        let rule = JointRule { width, ..rule(2, JointKind::Stop) };
        let machine = with_leads(machine("co2-100w"), leads(LeadKind::None, 1.0, -2.0));
        let machine = with_joints(machine, vec![rule]);
        let problem = problem_of(&sheet, &machine);
        let plan = plan::from_solution(&sheet, &problem, &solve::greedy(&problem));
        assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()), "{width}");
        assert_eq!(plan.summary.joints, joints, "{width}");
        // One joint fewer or more than there are is found.
        for wrong in [joints - 1, joints + 3] {
            let mut plan = plan.clone();
            plan.summary.joints = wrong;
            let found = faults(&sheet, &machine, &plan);
            assert!(found.iter().any(|f| f.contains("the number of joints")), "{width}, {wrong}: {found:?}");
        }
    }
}
