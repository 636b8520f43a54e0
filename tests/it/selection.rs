//! What a person decides for a selection of contours: kept together as a group, a number of micro-joints, another lead.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kerfway::finding::Code;
use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Joints, LeadKind, LeadRule, LeadShape, Leads, Profile, preset};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::{ContourChoice, HandJoint, Operation, Sheet};
use std::iter::successors;

const MOVES: u64 = 60_000;

/// A nested sheet of 100 contours with holes and parts in holes.
fn sheet(load: LoadOptions) -> Result<Job, String> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/sheets/sheet_100.dxf");
    let ignore = |name: &str| LayerChoice::new(name, Operation::Ignore);
    let load = LoadOptions { layers: vec![ignore("SHEET"), ignore("MARK")], ..load };
    Job::load(std::fs::read(file).unwrap(), "sheet_100.dxf", &load).map_err(|e| e.to_string())
}

fn planned_on(machine: Profile, load: LoadOptions) -> (Job, Plan) {
    let mut job = sheet(load).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, seed: 1, moves: Some(MOVES), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(MOVES);
    let plan = job.plan().unwrap();
    assert_eq!(plan::check(job.beam_sheet(), &job.run().unwrap().machine, &plan), Ok(()));
    (job, plan)
}

fn planned(load: LoadOptions) -> (Job, Plan) {
    planned_on(preset("co2-100w").unwrap(), load)
}

fn order(plan: &Plan) -> Vec<u32> {
    let contour = |m: &Move| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None };
    plan.moves.iter().filter_map(contour).collect()
}

fn is_inside(sheet: &Sheet, contour: u32, outer: u32) -> bool {
    successors(Some(contour), |&c| sheet.contours[c as usize].inside).any(|c| c == outer)
}

/// Outer contours of parts that lie in no other part, far apart from each other in the list.
fn far_parts(sheet: &Sheet) -> Vec<u32> {
    let outer: Vec<u32> = sheet.parts.iter().filter(|p| p.inside.is_none()).map(|p| p.outer).collect();
    vec![outer[0], outer[outer.len() / 2], outer[outer.len() - 1]]
}

/// Fails unless the contours of a group, with everything inside them, follow each other.
fn assert_together(sheet: &Sheet, order: &[u32], group: &[u32]) {
    let is_in = |c: u32| group.iter().any(|&o| is_inside(sheet, c, o));
    let places: Vec<usize> = (0..order.len()).filter(|&k| is_in(order[k])).collect();
    assert!(places.len() >= group.len());
    assert_eq!(places.last().unwrap() - places[0] + 1, places.len(), "{group:?} in {order:?}");
}

#[test]
fn a_group_is_cut_without_anything_else_in_between() {
    let (free_job, free) = planned(LoadOptions::default());
    let group = far_parts(free_job.sheet());
    for part_by_part in [false, true] {
        let load = LoadOptions { together: vec![group.clone()], part_by_part, ..LoadOptions::default() };
        let (job, plan) = planned(load);
        assert_together(job.sheet(), &order(&plan), &group);
        if part_by_part {
            for part in job.sheet().parts.iter().filter(|p| p.inside.is_none()) {
                assert_together(job.sheet(), &order(&plan), &[part.outer]);
            }
        } else {
            let torn = plan::check(job.sheet(), &job.run().unwrap().machine, &free).unwrap_err();
            assert!(
                !torn.is_empty() && torn.iter().all(|v| matches!(v, Violation::Apart { .. })),
                "{torn:?}"
            );
        }
    }
}

#[test]
fn groups_have_an_order_of_their_own_if_a_sequence_says_so_and_pins_move_them() {
    let all = far_parts(planned(LoadOptions::default()).0.sheet());
    let sequence = vec![all[2], all[0], all[1]];
    let load = LoadOptions {
        together: vec![all.clone()],
        sequences: vec![sequence.clone()],
        first: all.clone(),
        ..LoadOptions::default()
    };
    let (job, plan) = planned(load);
    let order = order(&plan);
    assert_together(job.sheet(), &order, &all);
    let own: Vec<u32> = order.iter().copied().filter(|c| all.contains(c)).collect();
    assert_eq!(own, sequence);
    assert!(is_inside(job.sheet(), order[0], sequence[0]), "the group comes first");
}

#[test]
fn a_group_on_a_machine_that_leaves_contours_unfinished_is_cut_in_one_go() {
    let mut machine = preset("fibre-3kw-thin").unwrap();
    machine.pre_cut_time = Some(0.2);
    let group = far_parts(planned(LoadOptions::default()).0.sheet());
    let (job, plan) =
        planned_on(machine, LoadOptions { together: vec![group.clone()], ..LoadOptions::default() });
    assert_together(job.sheet(), &order(&plan), &group);
    assert_eq!(plan.summary.pre_cuts, 0);
}

#[test]
fn groups_that_are_not_possible_are_refused_in_a_sentence() {
    let job = sheet(LoadOptions::default()).unwrap();
    let part = job.sheet().parts.iter().find(|p| !p.holes.is_empty()).unwrap().clone();
    let other = far_parts(job.sheet()).into_iter().find(|&c| c != part.outer).unwrap();
    let (hole, outer) = (part.holes[0], part.outer);
    let told = |load: LoadOptions| sheet(load).err().unwrap_or_default();
    let groups = |together| LoadOptions { together, ..LoadOptions::default() };
    assert_eq!(told(groups(vec![vec![hole, other]])), "", "a hole without its part");
    assert_eq!(
        told(groups(vec![vec![outer], vec![hole, other]])),
        format!(
            "The option \"together\" is not possible: contour {hole} lies inside contour {outer}, which is in another group."
        )
    );
    assert!(told(groups(vec![vec![3, 4], vec![4]])).contains("\"together\" names contour 4 twice"));
    assert!(told(groups(vec![vec![4000]])).starts_with("Contour 4000 is listed"));
    let by_part = LoadOptions { part_by_part: true, ..groups(vec![vec![hole, other]]) };
    assert!(told(by_part).contains("which is not in its group"));
    let mixed = LoadOptions { sequences: vec![vec![outer, other]], ..groups(vec![vec![outer]]) };
    assert!(told(mixed).contains("are in one sequence, but not in the same group"));
}

fn joints_of(plan: &Plan, contour: u32) -> usize {
    // A cut of several stretches begins at one of its joints.
    let stretches = plan.moves.iter().filter(|m| matches!(m, Move::Cut { contour: c, .. } if *c == contour));
    let joints = plan.moves.iter().filter(|m| matches!(m, Move::Joint { contour: c, .. } if *c == contour));
    assert!(stretches.count() <= joints.clone().count() + 1);
    joints.count()
}

#[test]
fn a_number_of_joints_is_chosen_for_single_contours_with_and_without_rules_of_the_machine() {
    let parts = far_parts(planned(LoadOptions::default()).0.sheet());
    let choice = |contour, joints| ContourChoice { contour, joints: Some(joints), lead: None, corners: None };
    let contours = vec![choice(parts[0], 3), choice(parts[1], 0)];
    let load = LoadOptions { contours: contours.clone(), ..LoadOptions::default() };
    let (_, plan) = planned(load.clone());
    assert_eq!(plan.summary.joints, 3, "no machine rule, so nothing else has joints");
    assert!((2..=3).contains(&joints_of(&plan, parts[0])), "one of them may be where the cut begins");

    let mut machine = preset("co2-100w").unwrap();
    machine.joints = serde_json::from_str::<Joints>(r#"{"rules": [{"side": "outer", "count": 1}]}"#).ok();
    let (job, with_rule) = planned_on(machine.clone(), load);
    assert_eq!(joints_of(&with_rule, parts[1]), 0);
    let cut = with_rule.moves.iter().filter_map(|m| match m {
        Move::Cut { contour, path, .. } if *contour == parts[1] => Some(path),
        _ => None,
    });
    let whole: f64 = cut.flatten().map(kerfway::geometry::Segment::length).sum();
    assert!((whole - job.sheet().contours[parts[1] as usize].length).abs() < 1e-6, "cut all around");
    // Joints by hand go before the number.
    let joints = vec![HandJoint { contour: parts[0], at: 0.3 }];
    let (_, by_hand) = planned(LoadOptions { contours, joints, ..LoadOptions::default() });
    assert_eq!(by_hand.summary.joints, 1);
    // The checker finds joints that nobody asks for, and misses those that are asked for.
    let (plain_job, plain) = planned(LoadOptions::default());
    let found = plan::check(job.sheet(), &plain_job.run().unwrap().machine, &plain).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Joint { contour, .. } if *contour == parts[0])));
    let found = plan::check(plain_job.sheet(), &plain_job.run().unwrap().machine, &plan).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Joint { contour, .. } if *contour == parts[0])));
}

/// The number of elements of the lead-in and of the lead-out of a contour.
fn leads_of(plan: &Plan, contour: u32) -> [usize; 2] {
    let cut = plan.moves.iter().find_map(|m| match m {
        Move::Cut { contour: c, path, leads, .. } if *c == contour => {
            let [lead_in, _, _, lead_out] = leads.divide(path);
            Some([lead_in.len(), lead_out.len()])
        }
        _ => None,
    });
    cut.unwrap()
}

#[test]
fn a_lead_is_chosen_for_single_contours_with_and_without_rules_of_the_machine() {
    let parts = far_parts(planned(LoadOptions::default()).0.sheet());
    let choice = |contour, kind| ContourChoice { contour, joints: None, lead: Some(kind), corners: None };
    let contours = vec![choice(parts[0], LeadKind::LineArc), choice(parts[1], LeadKind::None)];
    let load = LoadOptions { contours, ..LoadOptions::default() };
    let (_, plan) = planned(load.clone());
    assert_eq!((leads_of(&plan, parts[0]), leads_of(&plan, parts[1])), ([2, 0], [0, 0]));
    assert_eq!(leads_of(&plan, parts[2]), [0, 0], "no machine rule, so nothing else has a lead");

    let mut machine = preset("co2-100w").unwrap();
    let line = LeadShape { kind: LeadKind::Line, length: 1.0, ..LeadShape::default() };
    let rule = LeadRule { lead_in: line, lead_out: line, overcut: 0.2, ..LeadRule::default() };
    machine.leads = Some(Leads { clearance: 0.2, rules: vec![rule] });
    let (job, with_rule) = planned_on(machine.clone(), load);
    assert_eq!(leads_of(&with_rule, parts[0])[0], 2, "line and arc instead of a line");
    assert_eq!(leads_of(&with_rule, parts[1]), [0, 0]);
    assert_eq!(leads_of(&with_rule, parts[2]), [1, 1]);
    let missing =
        |job: &Job| job.run().unwrap().findings.iter().filter(|f| f.code == Code::LeadMissing).count();
    let (all_job, all) = planned_on(machine, LoadOptions::default());
    assert!(missing(&job) <= missing(&all_job), "a lead that is not wanted is not missed");
    let found = plan::check(job.sheet(), &all_job.run().unwrap().machine, &all).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Lead { contour, .. } if *contour == parts[1])));
}
