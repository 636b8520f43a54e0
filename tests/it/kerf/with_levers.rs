//! Parts one kerf apart with leads, joints and moving starts, where the machine may cut them as one without pre-cuts: plans that did
//! not pass their own check.

use super::made::{machine, started};
use crate::testkit::leads::{one_rule, shape};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use crate::testkit::sheets::p;
use kerfway::finding::{Code, Finding};
use kerfway::machine::{
    JointRule, Joints, LeadKind, LeadRule, LeadShape, LeadSide, Levers, MovingPierce, Profile, SharedCuts,
};
use kerfway::plan::Move;

fn together(levers: Levers) -> Levers {
    Levers { common_cuts: Some(SharedCuts::default()), ..levers }
}

/// Joints are asked for, but not where parts may be cut as one, and each is cut by itself all the same, as moving starts cost
/// nothing. The checker missed the piercing at rest that joints need.
#[test]
fn parts_that_could_be_cut_as_one_begin_moving_where_joints_are_asked_for() {
    let at = |k: usize| [20.0 + 61.0 * (k % 2) as f64, 20.0 + 41.0 * (k / 2) as f64];
    let parts: Vec<_> = (0..4)
        .map(at)
        .flat_map(|[x, y]| [rectangle([x, y, 60.0, 40.0]), rectangle([x + 20.0, y + 10.0, 12.0, 12.0])])
        .collect();
    let rule = JointRule { count: 4, width: 0.2, side: Some(LeadSide::Outer), ..JointRule::default() };
    let levers = together(Levers { moving_pierce: Some(MovingPierce { overcut: 0.0 }), ..Levers::default() });
    let job = started(
        drawing(&parts),
        Profile { levers, joints: Some(Joints { rules: vec![rule] }), ..machine(1.0) },
    );
    let plan = job.plan().unwrap();
    assert_eq!(job.beam_sheet().groups.len(), 1);
    assert!(plan.moves.contains(&Move::MovingStart) && plan.summary.joints == 0);
}

/// The lead of a group was measured at four points, the last a quarter of its length from the node, and crossed a corner that
/// a contour at the node has 0.3 mm before it.
#[test]
fn a_lead_to_a_node_keeps_away_from_a_corner_just_before_it() {
    let bytes = include_bytes!("../../fixtures/regressions/lead-past-a-corner.dxf").to_vec();
    let lead_in = LeadShape {
        length: 6.0,
        radius: 3.0,
        angle: std::f64::consts::FRAC_PI_4,
        ..shape(LeadKind::LineArc)
    };
    let leads = one_rule("co2-100w", 0.5, LeadRule { lead_in, overcut: 0.5, ..LeadRule::default() });
    let job = started(bytes, Profile { kerf_width: 0.2, levers: together(Levers::default()), ..leads });
    let plan = job.plan().unwrap();
    let as_one = |m: &Move| matches!(m, Move::Cut { with, .. } if with.len() > 5);
    assert!(plan.moves.iter().any(as_one));
}

/// The planner takes a turn of more than 10 degrees for a corner, the checker one of more than 10.1: at a corner between, it
/// missed a joint that the planner had not made there.
#[test]
fn a_joint_is_not_missed_at_a_corner_of_ten_degrees_and_a_little() {
    // It turns by 10.015 degrees at its right end.
    let hole = [
        [45.653233951, 59.640652231],
        [46.386939821, 61.416655977],
        [47.595606041, 63.730158622],
        [49.680554183, 62.704257096],
        [49.400817965, 59.640652231],
        [49.654771638, 56.614932017],
        [47.595606041, 55.315708016],
        [46.502782519, 58.03486675],
    ];
    let plate = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [50.0, 120.0], [0.0, 100.0]];
    let outline = |points: &[[f64; 2]]| points.iter().map(|[x, y]| p(*x, *y)).collect::<Vec<_>>();
    for width in [0.3, 0.4, 0.5, 0.6] {
        let rule = JointRule { count: 2, width, side: Some(LeadSide::Hole), ..JointRule::default() };
        let made = Profile { joints: Some(Joints { rules: vec![rule] }), ..machine(0.2) };
        let job = started(drawing(&[outline(&hole), outline(&plate)]), made);
        let missing = |f: &&Finding| f.code == Code::JointMissing;
        let run = job.run().unwrap();
        assert_eq!(run.findings.iter().filter(missing).count(), 1, "{width}");
    }
}
