//! Faults planted in the leads of a sound plan: the checker finds each.

use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, circle, machine, p, rectangle};
use kerfway::geometry::{Affine, Arc, DVec2, Segment};
use kerfway::job::problem_of;
use kerfway::machine::{LeadKind, Profile};
use kerfway::plan::{self, Leads, Move, Plan, Violation};
use kerfway::sheet::Sheet;
use kerfway::solve;

fn sound(overcut: f64) -> (Sheet, Profile, Plan) {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(60.0, 40.0)), None);
    b.cut(circle(p(70.0, 70.0), 8.0), Some(plate));
    b.cut(rectangle(p(115.0, 50.0), p(20.0, 40.0)), None);
    let sheet = oriented(b.sheet);
    let machine = with_leads(machine("co2-100w"), leads(LeadKind::Arc, 1.0, overcut));
    let problem = problem_of(&sheet, &machine);
    let plan = plan::from_solution(&sheet, &problem, &solve::greedy(&problem));
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    assert!(plan.summary.lead_length > 6.0);
    (sheet, machine, plan)
}

/// What the checker says of the leads after a change of one cut.
fn after(
    overcut: f64,
    contour: u32,
    change: impl FnOnce(&mut Vec<Segment>, &mut Leads),
) -> Vec<&'static str> {
    let (sheet, machine, mut plan) = sound(overcut);
    let cut = plan.moves.iter_mut().find_map(|m| match m {
        Move::Cut { contour: c, path, leads, .. } if *c == contour => Some((path, leads)),
        _ => None,
    });
    let (path, leads) = cut.unwrap();
    change(path, leads);
    let found = plan::check(&sheet, &machine, &plan).unwrap_err();
    found
        .into_iter()
        .filter_map(|v| if let Violation::Lead { what, .. } = v { Some(what) } else { None })
        .collect()
}

#[test]
fn a_lead_in_the_part_is_found() {
    let found = after(0.0, 0, |path, _| {
        // The mirror image of the lead-in, across the tangent of the contour.
        let (Segment::Arc(arc), joint) = (path[0], path[0].end()) else { panic!() };
        let across = (arc.center - joint).normalize();
        let mirrored = |p: DVec2| p - across * (2.0 * (p - joint).dot(across));
        let start = mirrored(arc.start);
        path[0] = Segment::Arc(Arc { start, end: joint, center: mirrored(arc.center), sweep: -arc.sweep });
    });
    assert_eq!(found, ["does not lie in the scrap"]);
}

#[test]
fn an_arc_at_an_angle_is_found() {
    let found = after(0.0, 1, |path, leads| {
        let joint = path[0].end();
        let by = Affine::rotation(0.2_f64.to_radians());
        let turned = by.segment(&path[0]).unwrap();
        path[0] = Affine::translation(joint - turned.end()).segment(&turned).unwrap();
        assert_eq!(leads.lead_in, 1);
    });
    assert_eq!(found, ["has an arc that is not tangent"]);
}

#[test]
fn a_wrong_overcut_is_found() {
    let found = after(0.5, 2, |path, leads| {
        let at = path.len() - leads.lead_out - 1;
        path[at] = path[at].piece(0.0, 0.9);
    });
    assert!(found.contains(&"has the wrong length"), "{found:?}");
}

#[test]
fn a_gap_that_no_rule_asks_for_is_found() {
    let (sheet, machine, mut plan) = sound(-0.4);
    assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()));
    for m in &mut plan.moves {
        if let Move::Cut { path, leads, .. } = m {
            let last = path.len() - leads.lead_out - 1;
            path[last] = path[last].piece(0.0, 0.95);
        }
    }
    let found = plan::check(&sheet, &machine, &plan).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Partly { .. })), "{found:?}");
}

#[test]
fn leads_without_a_rule_are_found() {
    let (sheet, machine, plan) = sound(0.0);
    let found = plan::check(&sheet, &Profile { leads: None, ..machine }, &plan).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Lead { what: "is one that no rule asks for", .. })));
}

#[test]
fn a_lead_too_near_to_a_neighbour_is_found() {
    let (sheet, machine, plan) = sound(0.0);
    let mut wider = machine.clone();
    wider.leads.as_mut().unwrap().clearance = 20.0;
    let found = plan::check(&sheet, &wider, &plan).unwrap_err();
    assert!(
        found.iter().any(|v| matches!(v, Violation::Lead { what: "is too near to another cut", .. })),
        "{found:?}"
    );
}
