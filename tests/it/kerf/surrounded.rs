//! Parts whose whole outline lies one kerf from their neighbours, which would cut all of it for them.

use super::made::{KERF, bulged, machine, started};
use crate::testkit::leads::{one_rule, shape};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::finding::Code;
use kerfway::geometry::{DVec2, Path, Segment};
use kerfway::job::Job;
use kerfway::machine::{JointRule, Joints, LeadKind, LeadRule, Profile};
use kerfway::plan::Move;
use kerfway::sheet::Operation;

/// Four parts around a fifth, drawn last, which has a hole.
fn surrounded() -> Vec<Vec<DVec2>> {
    let (inner, long) = (20.0, 30.0);
    let beyond = inner + KERF;
    let mut parts = vec![
        rectangle([100.0, 90.0 - KERF, long, 10.0]),
        rectangle([100.0 + beyond, 100.0, 10.0, long]),
        rectangle([100.0 - (long - inner), 100.0 + beyond, long, 10.0]),
        rectangle([90.0 - KERF, 100.0 - (long - inner), 10.0, long]),
    ];
    parts.push(rectangle([100.0, 100.0, inner, inner]));
    parts.push(rectangle([108.0, 108.0, 4.0, 4.0]));
    parts
}

fn with_leads() -> Profile {
    let rule = LeadRule { lead_in: shape(LeadKind::Line), ..LeadRule::default() };
    Profile { kerf_width: KERF, ..one_rule("co2-100w", 0.5, rule) }
}

/// The contours of the cuts, in order.
fn cut_in_order(job: &Job) -> Vec<usize> {
    let contour = |m: &Move| if let Move::Cut { contour, .. } = m { Some(*contour as usize) } else { None };
    job.plan().unwrap().moves.iter().filter_map(contour).collect()
}

/// Where the beam is on within a box.
fn cuts_within(job: &Job, [min, max]: [DVec2; 2]) -> usize {
    let within = |p: DVec2| p.cmpgt(min).all() && p.cmplt(max).all();
    let plan = job.plan().unwrap();
    let cuts =
        plan.moves.iter().filter_map(|m| if let Move::Cut { path, .. } = m { Some(path) } else { None });
    cuts.flatten().filter(|s| [0.0, 0.25, 0.5, 0.75, 1.0].iter().any(|f| within(s.at(*f)))).count()
}

#[test]
fn a_part_between_its_neighbours_cuts_a_side_itself_after_what_lies_in_it() {
    let mut parts = surrounded();
    for turn in 0..parts.len() {
        parts.rotate_left(1);
        let job = started(drawing(&parts), machine(KERF));
        let sheet = job.beam_sheet();
        assert!(sheet.contours.iter().all(|c| c.operation == Operation::Cut && c.length > 1.0), "{turn}");
        assert!(sheet.contours.iter().take(6).all(|c| c.boundary().is_some()), "{turn}");
        let middle = (0..6).find(|&c| (sheet.contours[c].area - 400.0).abs() < 1.0).unwrap();
        let hole = (0..6).find(|&c| (sheet.contours[c].area - 16.0).abs() < 1.0).unwrap();
        let order: Vec<usize> = cut_in_order(&job);
        let at = |id: usize| order.iter().position(|&c| c == id).unwrap();
        assert!(at(hole) < at(middle), "{turn}: {order:?}");
        // Every line is cut once, whoever cuts it.
        let all: f64 = sheet.contours.iter().map(|c| c.length).sum();
        let [long, short] = [30.0, 10.0].map(|side| side + KERF);
        let wanted = 4.0 * 2.0 * (long + short) - 4.0 * (short - KERF) + 4.0 * (4.0 - KERF);
        assert!((all - wanted).abs() < 1e-6, "{turn}: {all} {wanted}");
    }
}

#[test]
fn a_lead_is_not_made_in_a_part_whose_sides_its_neighbours_cut() {
    let mut parts = surrounded();
    parts.pop();
    for _ in 0..parts.len() {
        parts.rotate_left(1);
        let job = started(drawing(&parts), with_leads());
        let inside = [DVec2::splat(100.1), DVec2::splat(119.9)];
        assert_eq!(cuts_within(&job, inside), 0);
    }
    // A part that fills the hole of another one, and a disc.
    let plate = |hole: [f64; 4], part: [f64; 4]| {
        drawing(&[rectangle([0.0, 0.0, 90.0, 90.0]), rectangle(hole), rectangle(part)])
    };
    let filled =
        plate([20.0, 20.0, 40.0, 40.0], [20.0 + KERF, 20.0 + KERF, 40.0 - 2.0 * KERF, 40.0 - 2.0 * KERF]);
    let sheet: &[[f64; 3]] = &[[0.0, 0.0, 0.0], [90.0, 0.0, 0.0], [90.0, 90.0, 0.0], [0.0, 90.0, 0.0]];
    let disc = bulged(&[sheet], &[[40.0, 40.0, 20.0], [40.0, 40.0, 20.0 - KERF]]);
    for bytes in [filled, disc] {
        let job = started(bytes, with_leads());
        assert_eq!(cuts_within(&job, [DVec2::splat(28.0), DVec2::splat(52.0)]), 0);
        let sheet = job.beam_sheet();
        assert_eq!(
            sheet.contours.iter().filter(|c| c.operation == Operation::Cut && c.boundary().is_some()).count(),
            3
        );
    }
}

#[test]
fn a_part_whose_sides_its_neighbours_cut_has_no_joints_and_says_so() {
    let mut parts = surrounded();
    parts.pop();
    let rule = JointRule { count: 2, ..JointRule::default() };
    let job =
        started(drawing(&parts), Profile { joints: Some(Joints { rules: vec![rule] }), ..machine(KERF) });
    let findings = &job.run().unwrap().findings;
    let missing: u32 = findings.iter().filter(|f| f.code == Code::JointMissing).map(|f| f.count).sum();
    let closed = job.beam_sheet().contours.iter().filter(|c| c.path.closed).count();
    assert_eq!(missing as usize, 5 - closed, "{findings:?}");
    // None is on a side of the part in the middle.
    let middle = Path::new(
        [[0, 1], [1, 2], [2, 3], [3, 0]]
            .map(|[a, b]: [usize; 2]| {
                let corners = rectangle([100.0 - 0.5 * KERF, 100.0 - 0.5 * KERF, 20.0 + KERF, 20.0 + KERF]);
                Segment::line(corners[a], corners[b])
            })
            .to_vec(),
        true,
    );
    let plan = job.plan().unwrap();
    for m in &plan.moves {
        if let Move::Joint { path, .. } = m {
            assert!(path.iter().all(|s| middle.nearest(s.at(0.5)).unwrap().1.distance(s.at(0.5)) > 0.1));
        }
    }
}

/// Black squares of a chess board first, so that others have cut all sides of every white one inside.
#[test]
fn every_part_of_a_chess_board_keeps_a_side() {
    let side = 10.0;
    let square = |k: usize| {
        let at = |v: usize| 100.0 + v as f64 * (side + KERF);
        rectangle([at(k % 6), at(k / 6), side, side])
    };
    let black = |k: &usize| (k % 6 + k / 6).is_multiple_of(2);
    let order: Vec<usize> = (0..36).filter(black).chain((0..36).filter(|k| !black(k))).collect();
    let job = started(drawing(&order.into_iter().map(square).collect::<Vec<_>>()), machine(KERF));
    let sheet = job.beam_sheet();
    assert!(sheet.contours.iter().all(|c| c.operation == Operation::Cut));
    assert!(sheet.contours.iter().take(36).all(|c| c.boundary().is_some() && (c.area - 100.0).abs() < 1e-9));
    let all: f64 = sheet.contours.iter().map(|c| c.length).sum();
    assert!((all - 2.0 * 7.0 * 6.0 * (side + KERF)).abs() < 1e-6, "{all}");
}
