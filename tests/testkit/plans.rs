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
use kerfway::geometry::{Arc, Path, Segment, math};
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Axes, Dialect, Process, Profile, Travel, preset};
use kerfway::output;
use kerfway::plan::document::{Budget, Document, Input, Move as Step, Options, SCHEMA, contours};
use kerfway::plan::{Move, Plan, Summary};
use kerfway::sheet::{Contour, LayerUse, Operation, Pin, Sheet, SheetOptions};
use rand::{Rng, RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
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
        cut: Process { speed: 25.0, accel: Some(1000.0), power: 0.8 },
        mark: Process { speed: 100.0, accel: Some(1000.0), power: 0.2 },
        junction_deviation: Some(0.02),
        pierce_time: 0.5,
        pre_cut_length: 0.0,
        sharp_corner: None,
        kerf_width: 0.0,
        pre_cut_time: None,
        beam_on_delay: 0.0,
        beam_off_delay: 0.0,
        dialect: Dialect::GrblM4,
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
        moves.push(Move::Air { to: from });
        if !mark {
            moves.push(Move::Pierce);
        }
        moves.push(Move::Cut { contour: id as u32, with: vec![], path: stop.path.segments.clone(), mark });
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
            pin: Pin::None,
            first_shape: id as u32,
            path: stop.path,
        });
    }
    if profile.return_home {
        summary.air_length += at.distance(profile.home());
        moves.push(Move::Air { to: profile.home() });
    }
    let layers = layers
        .iter()
        .map(|(name, color)| LayerUse {
            name: (*name).into(),
            color: *color,
            operation: Operation::Cut,
            suggestion: None,
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
        common_cuts: kerfway::sheet::CommonCuts::Best,
        outline: None,
        bounds,
        findings: vec![],
    };
    (sheet, Plan { moves, summary })
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

/// A drawing in inches by its header, without shapes: what a document needs besides sheet and plan.
pub(crate) fn drawing() -> Drawing {
    Drawing {
        version: Some("AC1015".into()),
        units: Units {
            unit: Unit::In,
            source: UnitsSource::Header,
            reason: "The file says inches.".into(),
            doubtful: false,
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
        budget: Budget { moves: Some(1000), seconds: None, done: 1000, workers: None },
        input: Input {
            sha256: "0123456789abcdef".repeat(4),
            name: "plate.dxf".into(),
            units: drawing.units.unit,
            units_source: drawing.units.source,
        },
        options: Options::of(&ReadOptions::default(), &SheetOptions::default()),
        summary: plan.summary.clone(),
        placement: None,
        contours: contours(sheet, &machine, DVec2::ZERO),
        machine,
        moves: plan.moves.iter().map(Step::from).collect(),
        findings: drawing.findings.iter().chain(&sheet.findings).cloned().collect(),
    })
}

/// Real drawings, read, arranged and planned for a while on a CO2 laser: name, and the job that holds them. Every other
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

/// Checks plans made at random, from that many seeds, and plans of real drawings; what is checked is told first.
pub(crate) fn each(seeds: u64, check: impl Fn(&Sheet, &Plan, &Profile)) {
    for seed in 0..seeds {
        let (sheet, plan) = random(seed);
        check(&sheet, &plan, &machine());
    }
    for (name, job) in real() {
        println!("{name}");
        check(job.sheet(), &job.plan().unwrap(), &job.run().unwrap().machine);
    }
}

/// The plan with every third contour or so left unfinished after a stretch, with a pre-cut, for the one after it.
fn left_for_others(plan: &Plan, rng: &mut impl Rng) -> Plan {
    let mut moves: Vec<Move> = Vec::new();
    let mut unfinished: Option<Move> = None;
    for step in &plan.moves {
        let Move::Cut { contour, path, mark: false, .. } = step else {
            moves.push(step.clone());
            continue;
        };
        if let Some(rest) = unfinished.take() {
            let Move::Cut { path: stretch, .. } = &rest else { continue };
            let back = Move::Air { to: stretch[0].start() };
            moves.extend([step.clone(), back, rest]);
            continue;
        }
        let at = rng.random_range(0..path.len());
        if !rng.random_bool(0.5) || path[at].length() < 1e-3 {
            moves.push(step.clone());
            continue;
        }
        let stretch = |path: Vec<Segment>| Move::Cut { contour: *contour, with: vec![], path, mark: false };
        let (cut, f) = (&path[at], rng.random_range(0.2..0.8));
        let first: Vec<Segment> = path[..at].iter().copied().chain([cut.piece(0.0, f)]).collect();
        let rest: Vec<Segment> =
            [cut.piece(f, 1.0)].into_iter().chain(path[at + 1..].iter().copied()).collect();
        let to = rest[0].start();
        moves.extend([stretch(first), Move::PreCut { contour: *contour, to, ahead: vec![] }]);
        unfinished = Some(stretch(rest));
    }
    // No cut came after it: it goes on before the way home.
    if let Some(rest) = unfinished {
        let Move::Cut { path, .. } = &rest else { unreachable!() };
        let back = Move::Air { to: path[0].start() };
        let home = moves.len() - 1;
        moves.splice(home..home, [back, rest]);
    }
    let mut summary = plan.summary.clone();
    summary.pre_cuts = moves.iter().filter(|m| matches!(m, Move::PreCut { .. })).count() as u32;
    let mut head = machine().home();
    summary.air_length = 0.0;
    for step in &moves {
        match step {
            Move::Air { to } => {
                summary.air_length += head.distance(*to);
                head = *to;
            }
            Move::Cut { path, .. } => head = path[path.len() - 1].end(),
            Move::Pierce | Move::PreCut { .. } | Move::Macro { .. } => {}
        }
    }
    Plan { moves, summary }
}

/// A plan of random stops: chains of lines and arcs of every sweep, direction and size, circles, and contours far
/// smaller than a machine's grid. Every other plan leaves contours unfinished.
pub(crate) fn random(seed: u64) -> (Sheet, Plan) {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let stops = (0..rng.random_range(1..12))
        .map(|_| Stop {
            layer: rng.random_range(0..2),
            operation: if rng.random_bool(0.2) { Operation::Mark } else { Operation::Cut },
            path: random_path(&mut rng),
        })
        .collect();
    let (sheet, plan) = plan_of(stops, &[("0", 7), ("B", 3)], &machine());
    let plan = if seed.is_multiple_of(2) { plan } else { left_for_others(&plan, &mut rng) };
    (sheet, plan)
}

fn random_path(rng: &mut impl Rng) -> Path {
    let mut at = DVec2::new(rng.random_range(-500.0..500.0), rng.random_range(-500.0..500.0));
    if rng.random_bool(0.25) {
        let sweep = if rng.random_bool(0.5) { TAU } else { -TAU };
        let radius = random_size(rng);
        let from = rng.random_range(-PI..PI);
        let circle = Arc::from_angles(at, radius, from, sweep);
        return Path::new(vec![Segment::Arc(circle)], true);
    }
    let mut segments = Vec::new();
    for _ in 0..rng.random_range(1..9) {
        let size = random_size(rng);
        let heading = math::unit(rng.random_range(-PI..PI));
        let segment = if rng.random_bool(0.5) {
            Segment::line(at, at + heading * size.min(1e3))
        } else {
            Segment::Arc(random_arc(rng, at, heading, size))
        };
        at = segment.end();
        segments.push(segment);
    }
    Path::new(segments, false)
}

/// An arc from `start` with a radius `radius`; the sweep is spread over all magnitudes, the length held under 10 m.
fn random_arc(rng: &mut impl Rng, start: DVec2, heading: DVec2, radius: f64) -> Arc {
    let sweep = match rng.random_range(0..4) {
        0 => rng.random_range(0.0..TAU),
        1 => PI + rng.random_range(-1e-6..1e-6),
        2 => TAU - math::pow(10.0, rng.random_range(-12.0..-1.0)),
        _ => math::pow(10.0, rng.random_range(-9.0..0.0)),
    };
    let sweep = sweep.min(1e4 / radius).max(1e-12);
    let sweep = if rng.random_bool(0.5) { sweep } else { -sweep };
    let center = start + heading * radius;
    Arc { start, end: center + math::rotate(start - center, sweep), center, sweep }
}

/// From a micrometre to a hundred metres, every magnitude alike.
fn random_size(rng: &mut impl Rng) -> f64 {
    math::pow(10.0, rng.random_range(-3.0..5.0))
}
