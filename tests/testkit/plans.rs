//! Plans made by hand: known geometry, known order, no reader and no solver involved.
#![allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "each test takes the plans it needs, of a few contours each"
)]

use glam::DVec2;
use kerfway::drawing::{Drawing, ReadOptions, Unit, Units, UnitsSource};
use kerfway::finding::{Code, Finding, Severity};
use kerfway::geometry::{Arc, Path, Segment};
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::dialect::DialectChoice;
use kerfway::machine::{Axes, Process, Profile, Travel, preset};
use kerfway::output;
use kerfway::plan::document::{Budget, Document, Input, Move as Step, Options, SCHEMA, contours};
use kerfway::plan::{Leads, Move, Plan, Summary};
use kerfway::sheet::{Contour, LayerUse, Operation, Pin, Sheet, SheetOptions};
use std::f64::consts::{PI, TAU};

/// A CO2 laser: 1500 mm/min to cut at 80 %, 6000 mm/min to mark at 20 %, 0.5 s to pierce.
pub(crate) fn machine() -> Profile {
    Profile {
        version: 1,
        name: "test".into(),
        title: "Test (100 W)".into(),
        home: [0.0, 0.0],
        bed: None,
        return_home: true,
        travel: Travel::Straight,
        rapid: Axes { speed: [400.0; 2], accel: Some([4000.0; 2]) },
        cut: Process::new(25.0, Some(1000.0), 0.8),
        mark: Process::new(100.0, Some(1000.0), 0.2),
        junction_deviation: Some(0.02),
        pierce_time: 0.5,
        pre_cut_length: 0.0,
        sharp_corner: None,
        kerf_width: 0.0,
        z_speed: None,
        materials: Vec::new(),
        leads: None,
        levers: kerfway::machine::Levers::default(),
        joints: None,
        skeleton: None,
        pre_cut_time: None,
        beam_on_delay: 0.0,
        beam_off_delay: 0.0,
        takes: kerfway::machine::Takes::Gcode,
        dialect: DialectChoice::named("grbl-m4"),
        max_s: 1000.0,
    }
}

/// A contour to be planned: layer index, mark or cut, path as it is run.
pub(crate) struct Stop {
    pub(crate) layer: u32,
    pub(crate) operation: Operation,
    pub(crate) path: Path,
}

/// The sheet and plan that run `stops` in this order from home (and back, if the machine returns), each cut pierced.
pub(crate) fn plan_of(stops: Vec<Stop>, layers: &[(&str, i16)], profile: &Profile) -> (Sheet, Plan) {
    let bounds = stops.iter().fold(kerfway::geometry::Aabb::EMPTY, |b, s| b.union(s.path.bounds()));
    let mut summary = Summary {
        contours: stops.len() as u32,
        bounds: if bounds.is_empty() {
            [0.0; 4]
        } else {
            [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y]
        },
        total_time: 12.5,
        ..Summary::default()
    };
    let (mut moves, mut contours) = (Vec::new(), Vec::new());
    let mut at = profile.home();
    for (id, stop) in stops.into_iter().enumerate() {
        let (from, to) = (stop.path.start().unwrap(), stop.path.end().unwrap());
        let mark = stop.operation == Operation::Mark;
        summary.air_length += at.distance(from);
        summary.cut_length += stop.path.length();
        summary.pierces += u32::from(!mark);
        summary.open_contours += u32::from(!stop.path.closed);
        moves.push(Move::air(from));
        if !mark {
            moves.push(Move::Pierce);
        }
        moves.push(Move::Cut {
            contour: id as u32,
            with: vec![],
            path: stop.path.segments.clone(),
            mark,
            leads: Leads::default(),
            turns: vec![],
        });
        at = to;
        contours.push(Contour {
            outline: None,
            drawn: None,
            layer: stop.layer,
            operation: stop.operation,
            inside: None,
            depth: 0,
            length: stop.path.length(),
            area: if stop.path.closed { stop.path.area().abs() } else { 0.0 },
            bounds: stop.path.bounds(),
            self_crossing: false,
            pass: 0,
            next_pass: None,
            turn: None,
            together: None,
            pin: Pin::None,
            first_shape: id as u32,
            rest_of: None,
            skeleton: false,
            bridged: None,
            path: stop.path,
        });
    }
    if profile.return_home {
        summary.air_length += at.distance(profile.home());
        moves.push(Move::air(profile.home()));
    }
    let layers = layers
        .iter()
        .map(|(name, color)| LayerUse {
            name: (*name).into(),
            color: *color,
            operation: Operation::Cut,
            suggestion: None,
            settings: kerfway::machine::Settings::NONE,
            rank: 0,
            contours: 0,
        })
        .collect();
    let sheet = Sheet {
        contours,
        parts: vec![],
        layers,
        ignored: vec![],
        part_by_part: false,
        groups: Vec::new(),
        pass_order: kerfway::sheet::PassOrder::Contour,
        common_cuts: kerfway::sheet::CommonCuts::Best,
        joints: Vec::new(),
        bridged: std::sync::Arc::default(),
        choices: Vec::new(),
        joined_within: 0.0,
        outline: None,
        bounds,
        findings: vec![],
    };
    (sheet, Plan { moves, summary, bridges: Vec::new() })
}

/// Three stops: a marked open line, a circle of radius 5 inside a 40 x 30 plate with one round corner, the plate.
pub(crate) fn small() -> (Sheet, Plan) {
    let p = |x: f64, y: f64| DVec2::new(x, y);
    let line = |a, b| Segment::line(a, b);
    let mark = Path::new(vec![line(p(12.0, 11.0), p(38.0, 11.0))], false);
    // A hole is run clockwise, entered at its left.
    let hole = Path::new(vec![Segment::Arc(Arc::from_angles(p(30.0, 25.0), 5.0, PI, -TAU))], true);
    let corner = Arc::from_angles(p(46.0, 36.0), 4.0, 0.0, PI / 2.0);
    let plate = Path::new(
        vec![
            line(p(10.0, 10.0), p(50.0, 10.0)),
            line(p(50.0, 10.0), corner.start),
            Segment::Arc(corner),
            line(corner.end, p(10.0, 40.0)),
            line(p(10.0, 40.0), p(10.0, 10.0)),
        ],
        true,
    );
    let stop = |layer, operation, path| Stop { layer, operation, path };
    let stops =
        vec![stop(1, Operation::Mark, mark), stop(0, Operation::Cut, hole), stop(0, Operation::Cut, plate)];
    let (mut sheet, plan) = plan_of(stops, &[("Cut 3mm", 1), ("Gravur <\u{df}>", 5)], &machine());
    sheet.contours[1].inside = Some(2);
    sheet.findings.push(
        Finding::new(Code::GapClosed, Severity::Warning, "A gap of 0.02 mm was closed.")
            .at(p(10.0, 40.0))
            .on_layer("Cut 3mm"),
    );
    (sheet, plan)
}

/// A drawing in inches by its header, without shapes: which a document needs in addition to sheet and plan.
pub(crate) fn drawing() -> Drawing {
    Drawing {
        version: Some("AC1015".into()),
        units: Units {
            unit: Unit::In,
            dpi: None,
            scale: 1.0,
            source: UnitsSource::Header,
            reason: "The file says inches.".into(),
            doubtful: false,
            confidence: 1.0,
        },
        layers: vec![],
        shapes: vec![],
        entities: vec![],
        findings: vec![
            Finding::new(Code::UnsupportedEntity, Severity::Info, "2 texts are not cut.")
                .on_layer("Notes")
                .times(2),
        ],
    }
}

/// The document of a plan: default options, seed 1, a budget of 1,000 moves.
pub(crate) fn document(sheet: &Sheet, plan: &Plan) -> String {
    let (drawing, machine) = (drawing(), machine());
    output::json_text(&Document {
        schema: SCHEMA.into(),
        units: Unit::Mm,
        method: "greedy".into(),
        parameters: None,
        seed: 1,
        budget: Budget { moves: Some(1000), seconds: None, done: 1000, workers: None, from_path: false },
        input: Input {
            sha256: "0123456789abcdef".repeat(4),
            name: "plate.dxf".into(),
            units: drawing.units.unit,
            units_source: drawing.units.source,
            dpi: None,
            units_doubt: drawing.units.doubt(),
        },
        options: Options::of(&ReadOptions::default(), &SheetOptions::default()),
        summary: plan.summary.clone(),
        material: None,
        placement: None,
        contours: contours(sheet, &machine, &plan.moves, DVec2::ZERO),
        machine,
        bridges: Vec::new(),
        moves: plan.moves.iter().map(Step::from).collect(),
        findings: drawing.findings.iter().chain(&sheet.findings).cloned().collect(),
    })
}

/// Real drawings, read, arranged and planned for a while on a CO2 laser: their names and jobs. Every other
/// one is planned by length, on a machine that leaves contours unfinished for half a millimetre.
pub(crate) fn real() -> Vec<(String, Job)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/dxf-dev");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e.eq_ignore_ascii_case("dxf")));
    files.sort();
    let mut turn = false;
    let jobs = files.into_iter().filter_map(|file| {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        // Drawings without an outline are refused in words, which other tests look at.
        let mut job = Job::load(std::fs::read(&file).unwrap(), &name, &LoadOptions::default()).ok()?;
        job.start(&PlanOptions { moves: Some(300), ..PlanOptions::default() }).ok()?;
        job.run_mut().unwrap().step(300);
        turn = !turn;
        if turn {
            let profile = Profile { pre_cut_time: Some(0.5), ..preset("length").unwrap() };
            let machine = MachineChoice::Profile(Box::new(profile));
            job.start(&PlanOptions { machine, moves: Some(60_000), ..PlanOptions::default() }).ok()?;
            job.run_mut().unwrap().step(60_000);
        }
        Some((name, job))
    });
    let jobs: Vec<_> = jobs.collect();
    let left: u32 = jobs.iter().map(|(_, job)| job.plan().unwrap().summary.pre_cuts).sum();
    assert!(left > 5, "only {left} times was a contour left unfinished");
    assert!(jobs.len() >= 15, "only {} drawings could be planned", jobs.len());
    jobs
}
