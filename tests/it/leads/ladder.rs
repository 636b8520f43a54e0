//! Which leads contours get: where there is room, where there is little, and where there is none.

use crate::testkit::leads::{one_rule, oriented, shape};
use crate::testkit::sheets::{Builder, circle, line, p, rectangle};
use kerfway::finding::{Code, Finding};
use kerfway::geometry::{DVec2, Segment};
use kerfway::job::problem_of;
use kerfway::lead::{Fit, Outcome, findings};
use kerfway::machine::{LeadKind, LeadPosition, LeadRule, Profile};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;

fn rule(kind: LeadKind) -> LeadRule {
    LeadRule { lead_in: shape(kind), ..LeadRule::default() }
}

fn problem(sheet: &Sheet, machine: &Profile) -> Problem {
    problem_of(&oriented(sheet.clone()), machine)
}

fn outcome(problem: &Problem, contour: usize) -> &Outcome {
    &problem.items[contour].leads.as_ref().unwrap().outcome
}

/// Where the lead-ins of a contour begin.
fn begins(problem: &Problem, contour: usize) -> Vec<DVec2> {
    problem.items[contour].nodes.clone().map(|n| problem.nodes[n as usize].entry).collect()
}

fn told(problem: &Problem) -> Vec<Finding> {
    findings((0..).zip(&problem.items).filter_map(|(id, i)| Some((id, &i.leads.as_ref()?.outcome))))
}

/// Squares of 20 mm in rows and columns, `gap` mm apart, away from the edges of the bed.
fn squares(count: usize, gap: f64) -> Sheet {
    let mut b = Builder::new();
    for k in 0..count * count {
        let at = DVec2::new((k % count) as f64, (k / count) as f64) * (20.0 + gap);
        b.cut(rectangle(at + p(50.0, 50.0), p(20.0, 20.0)), None);
    }
    b.sheet
}

#[test]
fn every_entry_has_its_lead_where_there_is_room() {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(40.0, 40.0)), None);
    b.cut(circle(p(70.0, 70.0), 8.0), Some(plate));
    let problem = problem(&b.sheet, &one_rule("co2-100w", 1.0, rule(LeadKind::Arc)));
    for contour in 0..2 {
        assert_eq!(
            (outcome(&problem, contour).lead_in, problem.items[contour].nodes.len()),
            (Fit::Wanted, 8)
        );
        for node in problem.items[contour].nodes.clone() {
            let (lead, seconds) = problem.items[contour].lead(node).unwrap();
            let [Segment::Arc(arc)] = lead.lead_in[..] else { panic!("an arc") };
            assert!((arc.radius() - 1.5).abs() < 1e-9 && seconds >= 0.0);
            assert_eq!(arc.start, problem.nodes[node as usize].entry);
        }
    }
    for at in begins(&problem, 0) {
        let outside = (at - p(70.0, 70.0)).abs() - p(20.0, 20.0);
        assert!((outside.max_element() - 1.5).abs() < 1e-9, "{at}: in the scrap, a radius away");
    }
    for at in begins(&problem, 1) {
        assert!(at.distance(p(70.0, 70.0)) < 8.0 - 1.0);
    }
    assert_eq!(told(&problem), []);
}

#[test]
fn marks_open_contours_and_contours_without_a_rule_have_none() {
    let mut b = Builder::new();
    b.cut(line(p(50.0, 5.0), p(90.0, 9.0)), None);
    b.mark(circle(p(120.0, 50.0), 9.0), None);
    b.cut(circle(p(160.0, 50.0), 9.0), None);
    let only_small = LeadRule { diameter_below: Some(10.0), ..rule(LeadKind::Line) };
    let problem = problem(&b.sheet, &one_rule("co2-100w", 1.0, only_small));
    assert!(problem.items.iter().all(|i| i.leads.is_none()));
}

#[test]
fn entries_towards_a_near_neighbour_are_left_out() {
    // Two squares, 2 mm apart: a lead of 3 mm does not fit between them.
    let problem = problem(&squares(2, 2.0), &one_rule("co2-100w", 0.5, rule(LeadKind::Line)));
    for contour in 0..4 {
        assert_eq!(outcome(&problem, contour).lead_in, Fit::Wanted);
        let count = problem.items[contour].nodes.len();
        assert!(count < 8, "{count} entries");
    }
    assert_eq!(told(&problem), []);
}

#[test]
fn a_lead_without_room_is_shortened_and_told_with_its_place() {
    let sheet = squares(3, 1.4);
    let problem = problem(&sheet, &one_rule("co2-100w", 0.5, rule(LeadKind::Line)));
    let middle = outcome(&problem, 4);
    assert_eq!(middle.lead_in, Fit::Shortened);
    assert!(middle.length[1] > 0.3 && middle.length[1] < 2.2, "{:?}", middle.length);
    let all = told(&problem);
    let finding = all.iter().find(|f| f.message.starts_with("Contour 4 ")).unwrap();
    assert_eq!(finding.code, Code::LeadAdjusted);
    let off =
        sheet.contours[4].path.segments.iter().map(|s| s.nearest(finding.at.unwrap()).1).fold(1.0, f64::min);
    assert!(off < 1e-12, "the place is on the contour");
    assert!(finding.message.starts_with("Contour 4 has a lead-in of "), "{}", finding.message);
}

#[test]
fn a_contour_without_any_room_is_pierced_on_its_outline_and_told() {
    let problem = problem(&squares(3, 0.3), &one_rule("co2-100w", 0.5, rule(LeadKind::Arc)));
    assert_eq!(outcome(&problem, 4).lead_in, Fit::None);
    let lead = problem.items[4].lead(problem.items[4].nodes.start).unwrap().0;
    assert!(lead.lead_in.is_empty());
    assert!(told(&problem).iter().any(|f| f.code == Code::LeadMissing && f.at.is_some()));
}

#[test]
fn an_arc_in_a_narrow_gap_becomes_a_line() {
    // Between bars 2.2 mm apart there is room for a line of 1.5 mm with the clearance, for no arc at right angles to it.
    let mut b = Builder::new();
    b.cut(rectangle(p(50.0, 50.0), p(1.0, 20.0)), None);
    for x in [48.0, 52.0] {
        b.cut(rectangle(p(x, 40.0), p(1.0, 40.0)), None);
    }
    let arc = LeadRule {
        lead_in: kerfway::machine::LeadShape { radius: 6.0, ..shape(LeadKind::Arc) },
        ..LeadRule::default()
    };
    let problem = problem(&b.sheet, &one_rule("co2-100w", 0.4, arc));
    let fit = outcome(&problem, 0).lead_in;
    assert!(fit >= Fit::Turned && fit < Fit::None, "{fit:?}");
}

#[test]
fn small_holes_begin_at_their_centres() {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(60.0, 40.0)), None);
    b.cut(circle(p(70.0, 70.0), 1.2), Some(plate));
    let problem = problem(&b.sheet, &one_rule("fibre-3kw-thin", 0.3, rule(LeadKind::Center)));
    assert_eq!(outcome(&problem, 1).lead_in, Fit::Wanted);
    assert!(begins(&problem, 1).iter().all(|at| at.distance(p(70.0, 70.0)) < 1e-9));
    // Outside a part there is no centre: a line instead.
    let lead = problem.items[0].lead(problem.items[0].nodes.start).unwrap().0;
    assert!((lead.lead_in[0].length() - 3.0).abs() < 1e-9);
}

#[test]
fn a_lead_in_a_hole_takes_no_more_than_its_share() {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(60.0, 40.0)), None);
    b.cut(circle(p(70.0, 70.0), 4.0), Some(plate));
    let problem =
        problem(&b.sheet, &one_rule("co2-100w", 0.3, LeadRule { max_share: 0.25, ..rule(LeadKind::Line) }));
    for at in begins(&problem, 1) {
        assert!((at.distance(p(70.0, 70.0)) - 3.0).abs() < 1e-9);
    }
    assert_eq!(told(&problem), []);
}

#[test]
fn corners_and_sides_are_where_the_rule_says() {
    let sheet = squares(1, 0.0);
    let of = |position| {
        let machine = one_rule("co2-100w", 0.5, LeadRule { position, ..rule(LeadKind::Line) });
        let problem = problem(&sheet, &machine);
        let item = &problem.items[0];
        item.nodes.clone().map(|n| problem.nodes[n as usize].along).collect::<Vec<_>>()
    };
    assert_eq!(of(LeadPosition::Corner), [0.0, 20.0, 40.0, 60.0]);
    assert_eq!(of(LeadPosition::Side), [10.0, 30.0, 50.0, 70.0]);
    assert_eq!(of(LeadPosition::Any).len(), 8);
}

#[test]
fn a_wanted_position_without_room_is_left_for_another() {
    // Bars end at the middle of each side, so that only the corners are free.
    let mut b = Builder::new();
    b.cut(rectangle(p(50.0, 50.0), p(20.0, 20.0)), None);
    for (corner, size) in [
        (p(56.0, 71.0), p(8.0, 3.0)),
        (p(56.0, 46.0), p(8.0, 3.0)),
        (p(71.0, 56.0), p(3.0, 8.0)),
        (p(46.0, 56.0), p(3.0, 8.0)),
    ] {
        b.cut(rectangle(corner, size), None);
    }
    let machine =
        one_rule("co2-100w", 0.5, LeadRule { position: LeadPosition::Side, ..rule(LeadKind::Line) });
    let problem = problem(&b.sheet, &machine);
    assert_eq!(outcome(&problem, 0).lead_in, Fit::Moved);
    assert!(told(&problem).iter().any(|f| f.message.contains("another position")));
}

#[test]
fn leads_stay_on_the_bed() {
    let mut b = Builder::new();
    b.cut(rectangle(p(0.0, 0.0), p(20.0, 20.0)), None);
    let problem = problem(&b.sheet, &one_rule("co2-100w", 0.5, rule(LeadKind::Line)));
    assert_eq!(outcome(&problem, 0).lead_in, Fit::Wanted);
    assert!(begins(&problem, 0).iter().all(|at| at.min_element() >= 0.0), "{:?}", begins(&problem, 0));
}

#[test]
fn parts_that_share_a_side_get_no_lead_into_each_other() {
    // The closed square has the shared side; the other one is open, with its outline.
    let mut b = Builder::new();
    b.cut(rectangle(p(50.0, 50.0), p(20.0, 20.0)), None);
    let whole = rectangle(p(70.0, 50.0), p(20.0, 20.0));
    let rest = kerfway::geometry::Path::new(whole.segments[..3].to_vec(), false);
    let open = b.cut(rest, None);
    b.sheet.contours[open as usize].outline = Some(whole);
    let problem = problem(&b.sheet, &one_rule("co2-100w", 0.5, rule(LeadKind::Line)));
    let inside = |at: &DVec2| (70.0..90.0).contains(&at.x) && (50.0..70.0).contains(&at.y);
    assert!(!begins(&problem, 0).iter().any(inside));
    assert!(problem.items[open as usize].leads.is_none());
}

/// Moved, turned by right angles and mirrored, a sheet has the same leads.
#[test]
fn leads_move_with_their_sheet() {
    use kerfway::geometry::{Affine, Path};
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(50.0, 50.0), p(60.0, 40.0)), None);
    b.cut(circle(p(70.0, 70.0), 3.0), Some(plate));
    b.cut(rectangle(p(112.0, 50.0), p(20.0, 40.0)), None);
    let machine = Profile { bed: None, ..one_rule("co2-100w", 0.5, rule(LeadKind::LineArc)) };
    let lengths = |sheet: &Sheet| {
        let problem = problem(sheet, &machine);
        let of = |k: usize| {
            let item = &problem.items[k];
            let mut all: Vec<f64> = item
                .nodes
                .clone()
                .map(|n| item.lead(n).unwrap().0.lead_in.iter().map(Segment::length).sum())
                .collect();
            all.sort_by(f64::total_cmp);
            (outcome(&problem, k).lead_in, all)
        };
        (0..3).map(of).collect::<Vec<_>>()
    };
    let before = lengths(&b.sheet);
    let turn = Affine { x: DVec2::Y, y: DVec2::NEG_X, ..Affine::translation(p(300.0, 7.0)) };
    let mirror = Affine { x: DVec2::NEG_X, ..Affine::translation(p(-5.0, 0.0)) };
    for by in [Affine::translation(p(31.0, -12.0)), turn, mirror] {
        let mut sheet = b.sheet.clone();
        for c in &mut sheet.contours {
            c.path = Path::new(c.path.segments.iter().map(|s| by.segment(s).unwrap()).collect(), true);
            c.bounds = c.path.bounds();
        }
        let after = lengths(&sheet);
        for ((fit, a), (other, b)) in before.iter().zip(&after) {
            assert_eq!((fit, a.len()), (other, b.len()));
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }
}
