//! Plans of random stops, made without a reader or a solver, and checks over many of them.
#![allow(
    dead_code,
    clippy::cast_possible_truncation,
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "each test takes the plans it needs, of a few contours each"
)]

use super::plans::{Stop, machine, plan_of, real};
use glam::DVec2;
use kerfway::geometry::{Arc, Path, Segment, math};
use kerfway::machine::Profile;
use kerfway::plan::{Leads, Move, Plan};
use kerfway::sheet::{Operation, Sheet};
use rand::{Rng, RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::f64::consts::{PI, TAU};

/// Checks random plans, one for each seed, and plans of real drawings, whose names are printed first.
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
            let back = Move::air(stretch[0].start());
            moves.extend([step.clone(), back, rest]);
            continue;
        }
        let at = rng.random_range(0..path.len());
        if !rng.random_bool(0.5) || path[at].length() < 1e-3 {
            moves.push(step.clone());
            continue;
        }
        let stretch = |path: Vec<Segment>| Move::Cut {
            contour: *contour,
            with: vec![],
            path,
            mark: false,
            leads: Leads::default(),
            turns: vec![],
        };
        let (cut, f) = (&path[at], rng.random_range(0.2..0.8));
        let first: Vec<Segment> = path[..at].iter().copied().chain([cut.piece(0.0, f)]).collect();
        let rest: Vec<Segment> =
            [cut.piece(f, 1.0)].into_iter().chain(path[at + 1..].iter().copied()).collect();
        let to = rest[0].start();
        moves.extend([stretch(first), Move::PreCut { contour: *contour, to, ahead: vec![] }]);
        unfinished = Some(stretch(rest));
    }
    // No cut came after it, so it is finished before the head returns.
    if let Some(rest) = unfinished {
        let Move::Cut { path, .. } = &rest else { unreachable!() };
        let back = Move::air(path[0].start());
        let home = moves.len() - 1;
        moves.splice(home..home, [back, rest]);
    }
    let mut summary = plan.summary.clone();
    summary.pre_cuts = moves.iter().filter(|m| matches!(m, Move::PreCut { .. })).count() as u32;
    let mut head = machine().home();
    summary.air_length = 0.0;
    for step in &moves {
        match step {
            Move::Air { to, .. } => {
                summary.air_length += head.distance(*to);
                head = *to;
            }
            Move::Cut { path, .. } | Move::Joint { path, .. } | Move::Fly { path } | Move::Chain { path } => {
                head = path[path.len() - 1].end();
            }
            Move::Pierce
            | Move::MovingStart
            | Move::PreCut { .. }
            | Move::Macro { .. }
            | Move::Height { .. }
            | Move::Wait { .. } => {}
        }
    }
    Plan { moves, summary, bridges: Vec::new() }
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
