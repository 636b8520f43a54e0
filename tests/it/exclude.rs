//! Contours left out one by one: as if they had not been drawn, but for the ids of the others.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::dxf_text::{Entity, Scene};
use kerfway::finding::{Code, Finding, Severity};
use kerfway::geometry::DVec2;
use kerfway::job::{Job, JobError, LayerChoice, LoadOptions, OutputKind, PlanOptions};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::{Contour, Operation};

/// Ids of the drawing of [`entities`].
const RING: u32 = 0;
const PART_IN_RING: u32 = 1;
const LINE: u32 = 3;
const CROSSING: [u32; 2] = [4, 5];
const TOUCHING: [u32; 2] = [6, 7];

fn square(x: f64, y: f64, side: f64) -> Entity {
    let corner = |dx: f64, dy: f64| (DVec2::new(x + dx * side, y + dy * side), 0.0);
    Entity::Polyline(vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)], true)
}

/// A ring in a ring with a hole, a line by itself, two squares that cross, two that share a side.
fn entities() -> Vec<Entity> {
    vec![
        square(0.0, 0.0, 60.0),
        Entity::Circle(DVec2::new(30.0, 30.0), 20.0),
        Entity::Circle(DVec2::new(30.0, 30.0), 5.0),
        Entity::Line(DVec2::new(70.0, 0.0), DVec2::new(90.0, 10.0)),
        square(100.0, 0.0, 30.0),
        square(120.0, 10.0, 40.0),
        square(0.0, 100.0, 30.0),
        square(30.0, 100.0, 30.0),
    ]
}

fn job(entities: &[Entity], exclude: &[u32]) -> Job {
    let entities = entities.iter().map(|e| (e.clone(), "CUT".into())).collect();
    let options = LoadOptions { exclude: exclude.to_vec(), ..LoadOptions::default() };
    Job::load(Scene { entities, units: 4 }.dxf().into_bytes(), "a.dxf", &options).unwrap()
}

fn planned(mut job: Job) -> (Job, Plan) {
    job.start(&PlanOptions { seed: 1, moves: Some(20_000), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(20_000);
    let plan = job.plan().unwrap();
    (job, plan)
}

/// Contour of every cut, in order.
fn order(plan: &Plan) -> Vec<u32> {
    let contour = |m: &Move| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None };
    plan.moves.iter().filter_map(contour).collect()
}

/// Findings about contours. Findings of the cleaning are about the drawing, whichever contour is affected.
fn told(findings: &[Finding]) -> Vec<(Code, &str)> {
    let of_drawing = [Code::ContourExcluded, Code::DuplicateRemoved];
    findings.iter().filter(|f| !of_drawing.contains(&f.code)).map(|f| (f.code, f.message.as_str())).collect()
}

#[test]
fn skipping_a_contour_equals_a_drawing_without_it() {
    let all = entities();
    for out in 0..all.len() {
        let mut others = all.clone();
        others.remove(out);
        let out = u32::try_from(out).unwrap();
        let (left_out, drawn) = (planned(job(&all, &[out])).0, planned(job(&others, &[])).0);
        // Ids behind it are one less in the drawing without it.
        let id = |i: u32| if i < out { i } else { i + 1 };
        let expected = drawn.sheet().contours.iter().zip(0..).map(|(c, i)| {
            let first_shape = id(c.first_shape);
            (id(i), Contour { inside: c.inside.map(id), first_shape, ..c.clone() })
        });
        let worked = (0..).zip(left_out.sheet().contours.iter().cloned()).filter(|(_, c)| c.is_processed());
        assert_eq!(worked.collect::<Vec<_>>(), expected.collect::<Vec<_>>(), "without {out}");
        let parts = drawn
            .sheet()
            .parts
            .iter()
            .map(|p| (id(p.outer), p.holes.iter().map(|&h| id(h)).collect::<Vec<_>>(), p.inside));
        let found = left_out.sheet().parts.iter().map(|p| (p.outer, p.holes.clone(), p.inside));
        assert_eq!(found.collect::<Vec<_>>(), parts.collect::<Vec<_>>(), "without {out}");
        assert_eq!(told(&left_out.sheet().findings), told(&drawn.sheet().findings), "without {out}");
        assert_eq!(left_out.run().unwrap().baselines, drawn.run().unwrap().baselines, "without {out}");
        assert_eq!(left_out.sheet().bounds, drawn.sheet().bounds);
        let best = |job: &Job| job.plan().unwrap().summary;
        let (a, b) = (best(&left_out), best(&drawn));
        // The same best path of seven contours, whatever the random numbers; and a bound that it keeps.
        assert!((a.total_time - b.total_time).abs() < 1e-6, "{} and {} s", a.total_time, b.total_time);
        assert!(a.lower_bound <= a.total_time);
    }
}

#[test]
fn a_skipped_contour_keeps_its_id_and_is_shown_but_not_cut() {
    let (job, plan) = planned(job(&entities(), &[RING, LINE]));
    let sheet = job.sheet();
    assert_eq!(sheet.contours[RING as usize].operation, Operation::Ignore);
    assert_eq!((sheet.ignored.len(), sheet.layers.iter().map(|l| l.contours).sum::<u32>()), (2, 6));
    assert_eq!(sheet.contours[PART_IN_RING as usize].inside, None, "a hole of a ring is a part by itself");
    let found: Vec<_> = sheet.findings.iter().filter(|f| f.code == Code::ContourExcluded).collect();
    assert_eq!(
        (found[0].message.as_str(), found[0].severity, found[0].count),
        ("2 contours left out by choice.", Severity::Info, 2)
    );
    assert!(!sheet.findings.iter().any(|f| f.code == Code::OpenContour), "the open line is left out");
    let mut cut = order(&plan);
    cut.sort_unstable();
    assert_eq!(cut, [1, 2, 4, 5, 6, 7]);
    let json = job.output(OutputKind::Json).unwrap();
    assert!(
        json.contains(r#""exclude":[0,3]"#)
            && json.contains(r#""id":0,"closed":true,"layer":"CUT","operation":"ignore""#)
    );
    // A plan that cuts it all the same does not pass.
    let (_, all) = planned(self::job(&entities(), &[]));
    let wrong = plan::check(sheet, &job.run().unwrap().machine, &all).unwrap_err();
    assert!(wrong.iter().any(|v| matches!(v, Violation::Operation { contour: RING, .. })));
}

#[test]
fn a_crossing_ends_when_either_contour_is_removed() {
    let crosses =
        |exclude: &[u32]| job(&entities(), exclude).sheet().findings.iter().any(|f| f.code == Code::Crossing);
    assert!(crosses(&[]));
    assert_eq!(CROSSING.map(|c| crosses(&[c])), [false, false]);
}

#[test]
fn a_side_shared_with_a_skipped_contour_is_cut_with_the_other() {
    let whole = |exclude: &[u32]| {
        let job = job(&entities(), exclude);
        TOUCHING
            .map(|c| (job.sheet().contours[c as usize].path.closed, job.sheet().contours[c as usize].length))
    };
    assert_eq!(whole(&[]).map(|(closed, _)| closed), [true, false], "the second one lost a side");
    assert_eq!(whole(&[TOUCHING[0]])[1], (true, 120.0));
    assert_eq!(whole(&[TOUCHING[1]])[0], (true, 120.0));
    assert!(!whole(&[RING])[1].0, "another contour left out gives nothing back");
}

#[test]
fn skipping_unknown_or_all_contours_is_refused_in_a_sentence() {
    let text = |options: &LoadOptions| {
        let entities = entities().into_iter().map(|e| (e, "CUT".into())).collect();
        Job::load(Scene { entities, units: 4 }.dxf().into_bytes(), "a.dxf", options)
            .err()
            .unwrap()
            .to_string()
    };
    let told = text(&LoadOptions { exclude: vec![1, 8], ..LoadOptions::default() });
    assert_eq!(told, "Contour 8 is listed in the options, but there are only 8 contours, counted from 0.");
    let mut none = job(&entities(), &(0..8).collect::<Vec<_>>());
    assert!(matches!(none.start(&PlanOptions::default()), Err(JobError::NothingToCut(_))));
}

/// The search looked for a way to the skipped square, which has no place to go to, and broke down: an open line in two passes is
/// entered and left at one end, so that all costs are in a table.
#[test]
fn open_lines_in_two_passes_beside_a_skipped_square_are_planned() {
    let line = |x, y| Entity::Line(DVec2::new(x, y), DVec2::new(x + 20.0, y + 5.0));
    let mut all = [(0.0, 0.0), (40.0, 0.0), (0.0, 30.0), (40.0, 30.0)].map(|(x, y)| line(x, y)).to_vec();
    all.push(square(100.0, 0.0, 10.0));
    let entities = all.into_iter().map(|e| (e, "CUT".into())).collect();
    let dxf = Scene { entities, units: 4 }.dxf().into_bytes();
    let layer = LayerChoice { passes: Some(2), ..LayerChoice::new("CUT", Operation::Cut) };
    let load = |exclude: Vec<u32>| {
        let options = LoadOptions { exclude, layers: vec![layer.clone()], ..LoadOptions::default() };
        Job::load(dxf.clone(), "a.dxf", &options).unwrap()
    };
    let closed = load(Vec::new()).sheet().contours.iter().position(|c| c.path.closed).unwrap();
    let (_, plan) = planned(load(vec![u32::try_from(closed).unwrap()]));
    let mut lines = order(&plan);
    lines.sort_unstable();
    lines.dedup();
    assert_eq!(lines.len(), 4);
}
