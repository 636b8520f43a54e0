//! What a check says: the figures of the program, and its problems.

use super::contours::{self, Cut};
use super::problem::{Problem, Problems};
use super::program::{Event, Program};
use crate::finding::Severity;
use crate::geometry::{Aabb, DVec2, Segment};
use crate::machine::dialect::Dialect;
use crate::machine::{Levers, Process, Profile, cut_time};
use crate::plan::{AirMoves, Way};
use serde::Serialize;

/// What a program does, and what is wrong with it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ProgramCheck"))]
pub struct Check {
    /// Whether the program may be run: it has no problem of severity error.
    pub passed: bool,
    /// Name of the dialect by whose rules it was read.
    pub dialect: String,
    /// Name of the machine.
    pub machine: String,
    /// Number of lines.
    pub lines: u32,
    /// Number of different contours.
    pub contours: u32,
    /// How often each contour is cut; 0 if they differ or there are none.
    pub passes: u32,
    /// Number of parts: closed contours inside an even number of others.
    pub parts: u32,
    /// Number of piercings at rest.
    pub pierces: u32,
    /// Length of cuts, mm.
    pub cut_length: f64,
    /// Length of rapids, mm.
    pub air_length: f64,
    /// Seconds on this machine.
    pub seconds: f64,
    /// Box of everything cut, mm: xmin, ymin, xmax, ymax; `None` if nothing is cut.
    pub bounds: Option<[f64; 4]>,
    /// Whether the head stays on the bed; `None` if the machine's bed is not known.
    pub fits_bed: Option<bool>,
    /// Whether the beam is off on every rapid.
    pub dark_rapids: bool,
    /// What is wrong, one entry for each kind.
    pub problems: Vec<Problem>,
}

/// The figures of a program.
#[derive(Debug)]
pub(super) struct Figures {
    pub(super) lines: u32,
    pub(super) stretches: u32,
    /// Line and number of cuts of each different contour.
    pub(super) repeats: Vec<(u32, u32)>,
    pub(super) parts: u32,
    pub(super) pierces: u32,
    pub(super) cut_length: f64,
    /// Number of motions of cuts, and what they turn from one to the next, rad.
    pub(super) motions: f64,
    pub(super) turns: f64,
    /// Length of motions at cutting speed with the beam off, mm.
    pub(super) dark_length: f64,
    air_length: f64,
    pub(super) seconds: f64,
    /// Speed of the fastest motion that is no mark, and of the fastest that is one, mm/s.
    pub(super) top_speed: f64,
    pub(super) top_mark: f64,
    /// How often the beam stays on from one contour, or one pass, to the next without a rest.
    pub(super) runs_on: u32,
    pub(super) bounds: Aabb,
    pub(super) fits_bed: Option<bool>,
    dark_rapids: bool,
    pub(super) dark_at_end: bool,
    pub(super) lifts: u32,
    pub(super) tail: Vec<String>,
}

/// Off the bed by more than this is off the bed, mm: coordinates are rounded.
const BED_SLACK: f64 = 0.01;

pub(super) fn figures(program: &Program, cuts: &[Cut], profile: &Profile) -> Figures {
    let mut reach = Aabb::EMPTY;
    let (mut air_length, mut dark_length, mut pierces, mut dark_rapids) = (0.0, 0.0, 0, true);
    let (mut first, mut marks, mut top_speed, mut top_mark) = (true, false, 0.0_f64, 0.0_f64);
    let (mut is_lit, mut runs_on) = (false, 0);
    for event in &program.events {
        match event {
            Event::Move { rapid, path, power, feed, .. } => {
                let fastest = if marks { &mut top_mark } else { &mut top_speed };
                *fastest = fastest.max(if *rapid { 0.0 } else { *feed });
                is_lit = power.lit > 0.0;
                // Where the head comes from is not known.
                reach = if first { reach.with(path.end()) } else { reach.union(path.bounds()) };
                air_length += if *rapid && !first { path.length() } else { 0.0 };
                dark_length += if *rapid || power.lit > 0.0 { 0.0 } else { path.length() };
                dark_rapids &= !(*rapid && power.lit > 0.0);
                first = false;
            }
            Event::Height { power, .. } => {
                dark_rapids &= power.lit <= 0.0;
                is_lit = false;
            }
            Event::Dwell { seconds, power, .. } => {
                pierces += u32::from(*seconds > 0.0 && power.lit > 0.0);
                is_lit &= *seconds <= 0.0;
            }
            Event::Contour { mark } => {
                marks = *mark;
                runs_on += u32::from(is_lit);
                is_lit = false;
            }
        }
    }
    Figures {
        lines: program.lines,
        stretches: u32::try_from(cuts.len()).unwrap_or(u32::MAX),
        repeats: contours::repeats(cuts),
        parts: contours::parts(cuts),
        pierces,
        cut_length: cuts.iter().map(Cut::length).sum(),
        motions: cuts.iter().map(|c| c.path.len() as f64).sum(),
        turns: cuts.iter().map(Cut::turns).sum(),
        dark_length,
        air_length,
        seconds: seconds(program, profile),
        top_speed,
        top_mark,
        runs_on,
        bounds: cuts.iter().flat_map(|c| &c.path).fold(Aabb::EMPTY, |b, s| b.union(s.bounds())),
        fits_bed: fits(&reach, profile, program.begins_relative),
        dark_rapids,
        dark_at_end: program.dark_at_end,
        lifts: program.lifts,
        tail: program.tail.clone(),
    }
}

/// Whether the head stays on the bed. Where a relative program begins is not known: only its size is compared then.
fn fits(reach: &Aabb, profile: &Profile, relative: bool) -> Option<bool> {
    profile.bed().map(|bed| {
        let bed = bed.grown(BED_SLACK);
        let fits = if relative { reach.size().cmple(bed.size()).all() } else { bed.contains_box(reach) };
        reach.is_empty() || fits
    })
}

/// Seconds of the program on the machine. Each run of the same speed is a run of the planner.
fn seconds(program: &Program, profile: &Profile) -> f64 {
    // A program says itself where the head is lifted: elsewhere it stays down, however far it goes, as it does over joints.
    let down = Profile { levers: Levers { lift: None, ..profile.levers }, ..profile.clone() };
    let [lifted_air, down] = [profile, &down].map(AirMoves::new);
    let mut marks = false;
    let mut total = 0.0;
    let mut run: Vec<Segment> = Vec::new();
    let mut speed = 0.0;
    // Where the first motion comes from is known in relative coordinates only.
    let mut first = !program.begins_relative;
    // Where a move with the head lifted began.
    let mut lifted_from: Option<DVec2> = None;
    let lifts = profile.levers.lift.is_some_and(|lift| !lift.at_rest);
    let finish = |run: &mut Vec<Segment>, speed: f64, marks: bool| {
        let process = Process { speed, ..if marks { profile.mark } else { profile.cut } };
        let seconds = if run.is_empty() || speed <= 0.0 { 0.0 } else { cut_time(profile, &process, run) };
        run.clear();
        seconds
    };
    for event in &program.events {
        match event {
            Event::Move { rapid: false, path, feed, .. } => {
                if (feed - speed).abs() > 1e-9 {
                    total += finish(&mut run, speed, marks);
                }
                speed = *feed;
                run.push(*path);
                first = false;
            }
            Event::Move { path, lifted, .. } => {
                total += finish(&mut run, speed, marks);
                let from = lifted_from.unwrap_or(path.start());
                let is_lifted = *lifted || lifted_from.is_some();
                // On the way up the move has only begun.
                lifted_from = (*lifted && lifts).then_some(from);
                total += match is_lifted {
                    _ if first || lifted_from.is_some() => 0.0,
                    true => lifted_air.seconds(from, path.end(), Way::Lifted),
                    false => down.seconds(from, path.end(), Way::Plain),
                };
                first = false;
            }
            Event::Height { distance, .. } => {
                total += finish(&mut run, speed, marks) + profile.height_seconds(*distance);
            }
            Event::Dwell { seconds, .. } => total += finish(&mut run, speed, marks) + seconds,
            // A run goes on from one contour to the next where the head does not stop.
            Event::Contour { mark } if *mark == marks => {}
            Event::Contour { mark } => {
                total += finish(&mut run, speed, marks);
                marks = *mark;
            }
        }
    }
    total + finish(&mut run, speed, marks)
}

pub(super) fn report(figures: Figures, problems: Problems, profile: &Profile, dialect: &Dialect) -> Check {
    let passes = figures.repeats.first().map_or(0, |(_, n)| *n);
    let even = figures.repeats.iter().all(|(_, n)| *n == passes);
    let b = figures.bounds;
    Check {
        passed: problems.0.iter().all(|p| p.severity != Severity::Error),
        dialect: dialect.name.clone(),
        machine: profile.name.clone(),
        lines: figures.lines,
        contours: u32::try_from(figures.repeats.len()).unwrap_or(u32::MAX),
        passes: if even { passes } else { 0 },
        parts: figures.parts,
        pierces: figures.pierces,
        cut_length: figures.cut_length,
        air_length: figures.air_length,
        seconds: figures.seconds,
        bounds: (!b.is_empty()).then_some([b.min.x, b.min.y, b.max.x, b.max.y]),
        fits_bed: figures.fits_bed,
        dark_rapids: figures.dark_rapids,
        problems: problems.0,
    }
}
