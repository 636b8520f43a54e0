//! Joints together with what else a machine can do: levers, pre-cuts, and the seconds of a quote.

use crate::testkit::dxf_text::{Entity, Scene};
use crate::testkit::exact::planned;
use crate::testkit::joints::{rule, with_joints};
use crate::testkit::leads::oriented;
use crate::testkit::sheets::{Builder, circle, machine, p, rectangle};
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::joint::{Planner, Refusal};
use kerfway::machine::{JointKind, JointRule, LeadSide, Levers, MovingPierce, Profile, SharedCuts};
use kerfway::plan::{self, Move, Violation};
use kerfway::sheet::Sheet;

fn plate() -> Sheet {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(10.0, 10.0), p(60.0, 40.0)), None);
    b.cut(circle(p(25.0, 25.0), 4.0), Some(plate));
    oriented(b.sheet)
}

/// What is pierced moving is cut again at its end, which would cut a joint through.
#[test]
fn contours_with_joints_are_pierced_at_rest_where_others_begin_moving() {
    for kind in [JointKind::Stop, JointKind::Flying] {
        for overcut in [0.0, 0.5] {
            let levers = Levers { moving_pierce: Some(MovingPierce { overcut }), ..Levers::default() };
            let outer = JointRule { side: Some(LeadSide::Outer), ..rule(2, kind) };
            let machine = with_joints(Profile { levers, ..machine("fibre-3kw-thin") }, vec![outer]);
            let plan = planned(&plate(), &machine);
            assert_eq!(plan::check(&plate(), &machine, &plan), Ok(()), "{kind:?} {overcut}");
            assert_eq!((plan.summary.joints, plan.summary.moving_starts), (2, 1), "{kind:?} {overcut}");
            let mut wrong = plan.clone();
            let at = wrong.moves.iter().position(|m| *m == Move::Pierce).unwrap();
            wrong.moves[at] = Move::MovingStart;
            let found = plan::check(&plate(), &machine, &wrong).unwrap_err();
            let says = |v: &Violation| v.to_string().contains("has to be pierced at rest");
            assert!(found.iter().any(says), "{found:?}");
        }
    }
}

/// A rule that asks for joints where none fits leaves the contour as it is, but for the start.
#[test]
fn a_contour_without_room_is_cut_whole() {
    let levers = Levers { moving_pierce: Some(MovingPierce { overcut: 0.5 }), ..Levers::default() };
    let wide = JointRule { width: 90.0, ..rule(1, JointKind::Stop) };
    let machine = with_joints(Profile { levers, ..machine("fibre-3kw-thin") }, vec![wide]);
    let plan = planned(&plate(), &machine);
    assert_eq!(plan::check(&plate(), &machine, &plan), Ok(()));
    assert_eq!((plan.summary.joints, plan.summary.pierces), (0, 2));
}

#[test]
fn pierce_groups_have_no_joints_and_what_has_is_not_left_unfinished() {
    let mut b = Builder::new();
    b.cut(rectangle(p(0.0, 0.0), p(60.0, 40.0)), None);
    b.cut(rectangle(p(60.0, 0.0), p(60.0, 40.0)), None);
    b.cut(rectangle(p(0.0, 60.0), p(60.0, 40.0)), None);
    let sheet = oriented(b.sheet);
    let machine = with_joints(machine("fibre-6kw-plate"), vec![rule(2, JointKind::Stop)]);
    assert!(machine.pre_cut_time.is_some());
    let planner = Planner::new(&sheet, &machine).unwrap();
    let refused = [0, 1, 2].map(|c| planner.refused(c));
    let grouped = sheet.cut_as_one(true).iter().flat_map(|g| &g.contours).count();
    if grouped > 0 {
        assert_eq!(refused, [Some(Refusal::Group), Some(Refusal::Group), None]);
    }
    let plan = planned(&sheet, &machine);
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    assert!(!plan.moves.iter().any(|m| matches!(m, Move::PreCut { contour: 2, .. })));
}

/// Contours that share cuts have no joints, also where each of them is cut by itself because that is quicker. The plan was refused there.
#[test]
fn contours_that_share_cuts_and_are_cut_one_by_one_pass_without_joints() {
    let lines = [
        [7.0, 3.0, 7.0, -3.0],
        [7.0, 3.0, 11.0, -1.0],
        [7.0, 0.0, 11.5, 0.0],
        [7.0, -3.0, 10.0, -3.0],
        [10.0, -3.0, 12.0, -5.0],
        [8.5, -1.5, 10.0, -3.0],
    ];
    let line = |[a, b, c, d]: [f64; 4]| Entity::Line(DVec2::new(a, b) * 25.4, DVec2::new(c, d) * 25.4);
    let entities = lines.map(|l| (line(l), "CUT".into())).to_vec();
    let mut job =
        Job::load(Scene { entities, units: 4 }.dxf().into_bytes(), "a.dxf", &LoadOptions::default()).unwrap();
    let levers = Levers { common_cuts: Some(SharedCuts::default()), ..Levers::default() };
    let rule = JointRule { spacing: Some(20.0), ..rule(1, JointKind::Stop) };
    let machine = with_joints(Profile { levers, bed: None, ..machine("co2-100w") }, vec![rule]);
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, seed: 1, moves: Some(1000), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(1000);
    let plan = job.plan().unwrap();
    let is_shared = |m: &Move| matches!(m, Move::Cut { with, .. } if !with.is_empty());
    assert!(plan.summary.joints == 0 && !plan.moves.iter().any(is_shared), "{:?}", plan.moves);
}
