//! The bed: a program stays on it or is not written, and a placement or a quarter turn changes coordinates and nothing else.
#![allow(clippy::float_cmp, reason = "places that are exact, and sums that must not change at all")]

use crate::testkit::gcode::{self, Program};
use crate::testkit::{files, fixtures, name};
use glam::DVec2;
use kerfway::finding::{Code, Severity};
use kerfway::geometry::Segment;
use kerfway::job::{
    BestPath, Job, JobError, LoadOptions, MachineChoice, OutputKind, Place, PlanOptions, WarmPath,
};
use kerfway::machine::{Anchor, Axes, Profile, Start, preset};
use kerfway::plan::document::{Document, Move};

const MOVES: u64 = 3000;

/// Two rectangles and a circle in one of them, between (`x`, `y`) and (`x` + 100, `y` + 40) mm.
fn drawing(x: f64, y: f64) -> Vec<u8> {
    let rectangle = |x0: f64, y0: f64, w: f64, h: f64| {
        let corners = [(x0, y0), (x0 + w, y0), (x0 + w, y0 + h), (x0, y0 + h)];
        let points: String = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
        format!("0\nLWPOLYLINE\n8\nCUT\n90\n4\n70\n1\n{points}")
    };
    let circle = format!("0\nCIRCLE\n8\nCUT\n10\n{}\n20\n{}\n40\n8\n", x + 20.0, y + 20.0);
    let entities = [rectangle(x, y, 40.0, 40.0), circle, rectangle(x + 60.0, y + 5.0, 40.0, 30.0)].concat();
    format!("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n")
        .into_bytes()
}

/// A machine with equal axes and a bed of 300 x 200 mm.
fn machine() -> Profile {
    let bed = Some([0.0, 0.0, 300.0, 200.0]);
    let rapid = Axes { speed: [300.0; 2], accel: Some([2000.0; 2]) };
    Profile { bed, rapid, ..preset("co2-100w").unwrap() }
}

fn options(machine: Profile) -> PlanOptions {
    PlanOptions {
        machine: MachineChoice::Profile(Box::new(machine)),
        seed: 1,
        moves: Some(MOVES),
        ..PlanOptions::default()
    }
}

fn planned(bytes: Vec<u8>, load: &LoadOptions, options: &PlanOptions) -> Job {
    let mut job = Job::load(bytes, "job.dxf", load).unwrap();
    job.start(options).unwrap();
    job.run_mut().unwrap().step(MOVES);
    job
}

fn document(job: &Job) -> Document {
    Document::read(&job.output(OutputKind::Json).unwrap()).unwrap()
}

fn program(job: &Job) -> Program {
    gcode::run(&job.output(OutputKind::Gcode).unwrap()).unwrap()
}

/// The sentence with which a program is refused. The plan is written all the same, and has the finding.
fn refused(job: &Job) -> String {
    let Err(JobError::OffBed(sentence)) = job.output(OutputKind::Gcode) else {
        panic!("a program was written")
    };
    let findings = document(job).findings;
    let off: Vec<_> = findings.iter().filter(|f| f.code == Code::OffBed).collect();
    assert_eq!(off.len(), 1);
    assert_eq!((off[0].severity, &off[0].message), (Severity::Error, &sentence));
    sentence
}

#[test]
fn negative_coordinates_are_refused_in_one_sentence() {
    let job = planned(drawing(-30.0, 10.0), &LoadOptions::default(), &options(machine()));
    assert!(refused(&job).starts_with("The job reaches from x -30 to 70 and y 10 to 50 mm, beyond the bed"));
}

#[test]
fn a_job_off_the_bed_is_refused_in_one_sentence() {
    let job = planned(drawing(250.0, 10.0), &LoadOptions::default(), &options(machine()));
    assert!(refused(&job).starts_with("The job reaches from x 250 to 350 and y 10 to 50 mm, beyond the bed"));
    let there = planned(
        drawing(250.0, 10.0),
        &LoadOptions::default(),
        &PlanOptions { allow_off_bed: true, ..options(machine()) },
    );
    assert!(there.output(OutputKind::Gcode).unwrap().contains("X350"));
    assert!(there.run().unwrap().findings.iter().any(|f| f.code == Code::OffBed), "it is still reported");
}

#[test]
fn a_job_larger_than_the_bed_is_refused_and_a_turn_that_helps_is_named() {
    let narrow = Profile { bed: Some([0.0, 0.0, 60.0, 200.0]), ..machine() };
    let job = planned(drawing(0.0, 0.0), &LoadOptions::default(), &options(narrow.clone()));
    assert_eq!(
        refused(&job),
        "The job of 100 x 40 mm is larger than the bed of 60 x 200 mm. It fits after a quarter turn."
    );
    let turned = LoadOptions { turn: 90, ..LoadOptions::default() };
    let place = Some(Place { point: None, from: None, at: [10.0, 10.0] });
    let job = planned(drawing(0.0, 0.0), &turned, &PlanOptions { place, ..options(narrow) });
    assert_eq!(job.placed_plan().unwrap().summary.bounds, [10.0, 10.0, 50.0, 110.0]);
    assert!(job.output(OutputKind::Gcode).is_ok());
    let tiny = Profile { bed: Some([0.0, 0.0, 50.0, 20.0]), ..machine() };
    let job = planned(drawing(0.0, 0.0), &LoadOptions::default(), &options(tiny));
    assert!(refused(&job).ends_with("Choose a larger machine, or divide the drawing."));
}

#[test]
fn every_point_of_the_job_can_be_placed() {
    for (k, point) in Anchor::NAMES.iter().enumerate() {
        let point: Anchor = serde_json::from_str(&format!("\"{point}\"")).unwrap();
        let place = Some(Place { point: Some(point), from: None, at: [150.0, 100.0] });
        let job = planned(
            drawing(-500.0, 700.0),
            &LoadOptions::default(),
            &PlanOptions { place, ..options(machine()) },
        );
        let [x0, y0, x1, y1] = job.placed_plan().unwrap().summary.bounds;
        assert_eq!([[x0, 0.5 * (x0 + x1), x1][k % 3], [y0, 0.5 * (y0 + y1), y1][k / 3]], [150.0, 100.0]);
        assert!(job.output(OutputKind::Gcode).is_ok(), "{point:?}");
    }
    let place = Some(Place { point: None, from: Some([20.0, 20.0]), at: [100.0, 50.0] });
    let job =
        planned(drawing(0.0, 0.0), &LoadOptions::default(), &PlanOptions { place, ..options(machine()) });
    assert_eq!(job.placed_plan().unwrap().summary.bounds, [80.0, 30.0, 180.0, 70.0]);
}

#[test]
fn a_point_given_twice_or_too_far_away_is_refused() {
    let start = |place| {
        let mut job = Job::load(drawing(0.0, 0.0), "job.dxf", &LoadOptions::default()).unwrap();
        let options = PlanOptions { place: Some(place), ..options(machine()) };
        job.start(&options).map(|_| ()).unwrap_err().to_string()
    };
    let both = Place { point: Some(Anchor::Center), from: Some([0.0, 0.0]), at: [0.0, 0.0] };
    assert!(start(both).contains("both \"point\" and \"from\""));
    let far = Place { point: None, from: None, at: [0.0, f64::NAN] };
    assert!(start(far).starts_with("The option \"place.at\" is NaN. Give a number from"));
}

/// The moves with every place moved by `shift`.
fn shifted(moves: &[Move], shift: DVec2) -> Vec<Vec<DVec2>> {
    let places = |step: &Move| match step {
        Move::Air { to, .. } | Move::PreCut { to, .. } => vec![DVec2::from(*to) + shift],
        Move::Macro { at, .. } => vec![DVec2::from(*at) + shift],
        Move::Cut { path, .. } => {
            use kerfway::plan::document::Element;
            path.iter()
                .map(|e| match e {
                    Element::Line { line } => DVec2::from(*line) + shift,
                    Element::Arc { arc, .. } => DVec2::from(*arc) + shift,
                })
                .collect()
        }
        _ => vec![],
    };
    moves.iter().map(places).collect()
}

/// Where the plan of a placed job is, against the plan as drawn on a machine whose home is moved the other way.
#[test]
fn a_placement_changes_coordinates_and_nothing_else() {
    for file in
        ["sheets/sheet_100.dxf", "dxf-dev/skymakerolof_dxf__issue53.dxf", "dxf-dev/mozman_ezdxf__forms.dxf"]
    {
        let bytes = std::fs::read(fixtures().join(file)).unwrap();
        // A shift that binary fractions hold, so that the home seen from the drawing is the same bit for bit.
        let shift = DVec2::new(128.0, -64.25);
        let home = DVec2::new(16.0, 8.0);
        let bed = None;
        let seen = Profile { home: (home - shift).to_array(), bed, ..machine() };
        let given = Profile { home: home.to_array(), bed, ..machine() };
        let drawn = planned(bytes.clone(), &LoadOptions::default(), &options(seen));
        let place = Some(Place { point: None, from: Some([0.0, 0.0]), at: shift.to_array() });
        let placed = planned(bytes, &LoadOptions::default(), &PlanOptions { place, ..options(given) });
        let (a, b) = (document(&drawn), document(&placed));
        assert_eq!(b.placement.unwrap().shift, shift.to_array());
        assert_eq!(shifted(&a.moves, shift), shifted(&b.moves, DVec2::ZERO), "{file}");
        let mut sums = b.summary.clone();
        sums.bounds = a.summary.bounds;
        assert_eq!(a.summary, sums, "{file}: times, lengths and numbers are the same, bit for bit");
        let (a, b) = (program(&drawn), program(&placed));
        assert_eq!(a.motions().count(), b.motions().count());
        for (m, n) in a.motions().zip(b.motions()) {
            // Each is rounded to 0.001 mm by itself.
            assert!((m.path.to + shift).distance(n.path.to) <= 0.002, "{file}: {m:?} {n:?}");
            assert_eq!((m.rapid, m.beam, m.feed), (n.rapid, n.beam, n.feed));
        }
    }
}

fn warm(job: &Job) -> WarmPath {
    let (path, _) = BestPath::of(job.run().unwrap(), job.beam_sheet());
    WarmPath { contours: path.contours, along: path.along, until: path.until, reversed: path.reversed }
}

#[test]
fn quarter_turns_change_coordinates_and_nothing_else() {
    for file in
        ["sheets/sheet_100.dxf", "dxf-dev/skymakerolof_dxf__issue53.dxf", "dxf-dev/mozman_ezdxf__forms.dxf"]
    {
        let bytes = std::fs::read(fixtures().join(file)).unwrap();
        let free = Profile { bed: None, ..machine() };
        let drawn = planned(bytes.clone(), &LoadOptions::default(), &options(free.clone()));
        let best = document(&drawn);
        for turn in [90, 180, 270] {
            let load = LoadOptions { turn, ..LoadOptions::default() };
            let mut job = Job::load(bytes.clone(), "job.dxf", &load).unwrap();
            for (a, b) in drawn.sheet().contours.iter().zip(&job.sheet().contours) {
                assert_eq!(
                    (a.layer, a.operation, a.inside, a.depth),
                    (b.layer, b.operation, b.inside, b.depth)
                );
                for (s, t) in a.path.segments.iter().zip(&b.path.segments) {
                    assert_eq!(turned(s.start(), turn), t.start(), "{file}");
                    assert!((s.length() - t.length()).abs() <= 1e-9 * s.length());
                }
            }
            // The path of the drawing as it is, on the turned drawing: the same seconds.
            job.start(&PlanOptions { warm: Some(warm(&drawn)), moves: Some(0), ..options(free.clone()) })
                .unwrap();
            let plan = job.placed_plan().unwrap();
            let off = (plan.summary.total_time - best.summary.total_time).abs();
            assert!(off <= 1e-9 * best.summary.total_time, "{file} turned by {turn}: {off} s");
            let plain = drawn.plan().unwrap();
            assert_eq!(plan.moves.len(), plain.moves.len());
            for (a, b) in plain.moves.iter().zip(&plan.moves) {
                use kerfway::plan::Move;
                if let (Move::Cut { path: a, .. }, Move::Cut { path: b, .. }) = (a, b) {
                    for (s, t) in a.iter().zip(b) {
                        assert!(turned(s.end(), turn).distance(t.end()) < 1e-9);
                        assert_eq!(matches!(s, Segment::Arc(_)), matches!(t, Segment::Arc(_)));
                    }
                }
            }
        }
    }
}

/// The place after a turn, with zeros without a sign.
fn turned(p: DVec2, degrees: u32) -> DVec2 {
    let q = match degrees {
        90 => DVec2::new(-p.y, p.x),
        180 => -p,
        _ => DVec2::new(p.y, -p.x),
    };
    q + DVec2::ZERO
}

#[test]
fn a_turn_that_is_no_quarter_is_refused() {
    let load = LoadOptions { turn: 45, ..LoadOptions::default() };
    let sentence = Job::load(drawing(0.0, 0.0), "job.dxf", &load).err().unwrap().to_string();
    assert!(sentence.starts_with("The option \"turn\" is 45."), "{sentence}");
    assert!(sentence.ends_with("quarter turns are 0, 90, 180 or 270."), "{sentence}");
}

/// A job from where the head stands is written in increments, and the head comes back to where it stood.
#[test]
fn a_job_that_starts_where_the_head_stands_has_the_same_motions_from_there() {
    let bytes = std::fs::read(fixtures().join("sheets/sheet_100.dxf")).unwrap();
    let free = Profile { home: [7.0, 9.0], bed: Some([0.0, 0.0, 5000.0, 5000.0]), ..machine() };
    let place = Some(Place { point: Some(Anchor::Center), from: None, at: [0.0, 0.0] });
    let placing = PlanOptions { place, start: Start::Current, ..options(free) };
    let job = planned(bytes, &LoadOptions::default(), &placing);
    let text = job.output(OutputKind::Gcode).unwrap();
    assert!(
        text.contains("G21 G91 G91.1 G17 G94\n")
            && text.ends_with("\nM2\n")
            && text.contains("\nG90\n; checksum "),
        "{text}"
    );
    let read = gcode::run(&text).unwrap();
    let plan = job.placed_plan().unwrap();
    assert_eq!(document(&job).machine.home, [0.0, 0.0]);
    let ends: Vec<DVec2> = read.motions().filter(|m| m.rapid).map(|m| m.path.to).collect();
    let air: Vec<DVec2> = plan
        .moves
        .iter()
        .filter_map(|m| if let kerfway::plan::Move::Air { to, .. } = m { Some(*to) } else { None })
        .collect();
    assert_eq!(ends.len(), air.len());
    for (a, b) in ends.iter().zip(&air) {
        assert!(a.distance(*b) <= 0.0015, "{a} is not {b}: increments must not add up their rounding");
    }
    assert!(ends.last().unwrap().length() < 1e-9, "the head comes back");
}

/// Only the size of the job was compared with the bed, so that a drawing far from its origin left it.
#[test]
fn a_job_far_from_where_the_head_stands_is_refused() {
    let current = PlanOptions { start: Start::Current, ..options(machine()) };
    let job = planned(drawing(900.0, 0.0), &LoadOptions::default(), &current);
    let sentence = refused(&job);
    assert!(
        sentence
            .starts_with("From where the head stands, the job reaches over 1000 x 40 mm, more than the bed"),
        "{sentence}"
    );
    let place = Some(Place { point: None, from: None, at: [0.0, 0.0] });
    planned(drawing(900.0, 0.0), &LoadOptions::default(), &PlanOptions { place, ..current })
        .output(OutputKind::Gcode)
        .unwrap();
}

/// Every real drawing, as drawn and at the corner of the bed, on two presets: its program stays on the bed, or there is none.
#[test]
fn programs_of_real_drawings_stay_on_the_bed_or_are_not_written() {
    let (mut written, mut not) = (0, 0);
    for file in files(&fixtures().join("dxf-dev"), "dxf") {
        let Ok(mut job) = Job::load(std::fs::read(&file).unwrap(), &name(&file), &LoadOptions::default())
        else {
            continue;
        };
        for machine in ["co2-100w", "diode-hobby"] {
            let profile = preset(machine).unwrap();
            let [x0, y0, x1, y1] = profile.bed.unwrap();
            for place in [None, Some(Place { point: None, from: None, at: [x0, y0] })] {
                let size = job.sheet().bounds.size();
                let choice = MachineChoice::Preset(machine.into());
                if job.start(&PlanOptions { machine: choice, place, ..PlanOptions::default() }).is_err() {
                    continue;
                }
                let Ok(text) = job.output(OutputKind::Gcode) else {
                    not += 1;
                    refused(&job);
                    assert!(place.is_none() || size.x > x1 - x0 || size.y > y1 - y0, "{}", name(&file));
                    continue;
                };
                written += 1;
                for m in gcode::run(&text).unwrap().motions() {
                    let to = m.path.to;
                    assert!((x0..=x1).contains(&to.x) && (y0..=y1).contains(&to.y), "{}: {m:?}", name(&file));
                }
            }
        }
    }
    assert!(written >= 30 && not >= 5, "{written} written, {not} not");
}
