//! Grids: outlines of straight sides, such as square holes in rows and columns. All sides that lie on one line are cut in one straight
//! run, over which the beam goes on and off; then the head goes to the next line. A piece comes loose with the last of its sides.
//!
//! Lines of one direction are cut one after the other, there and back; then those of the next direction. The ways differ in the
//! direction that comes first and in the corner at which they begin.

use super::work::{Flown, Work, apart, sort_by_two};
use crate::geometry::{DVec2, Segment, Union, math};
use crate::problem::sub_path::{Span, Stroke};
use std::f64::consts::PI;

/// Most sides of an outline that is cut side by side: beyond it, runs are short and corners flat.
const SIDES: usize = 8;
/// Directions that differ by less are one, rad: what six decimals of a drawing leave of a short side.
const PARALLEL: f64 = 1e-5;
/// Largest distance of sides from one line, mm, as in rows.
const ON_LINE: f64 = 1e-3;
/// Least way with the beam off between two sides of a run, mm: nearer ones touch.
const APART: f64 = 1e-3;
/// Most sides of a group for which more than one way is offered: more would take memory and save a move of a few mm.
const SEVERAL_WAYS: usize = 1000;

/// A side of an outline.
#[derive(Clone, Copy)]
struct Side {
    contour: u32,
    segment: Segment,
    /// Its ends on the contour, mm from the stored start; the end of the contour is 0.
    from: f64,
    to: f64,
    /// Its direction, a number for all that are parallel.
    class: usize,
    /// Its distance from the origin across its direction, mm.
    line: f64,
    /// Its ends along its direction, the lesser first, mm.
    ends: [f64; 2],
    /// Whether it is stored from the lesser to the greater.
    forwards: bool,
}

/// Sides in one straight motion, each forwards along its direction or all backwards.
type Run = Vec<Side>;

/// The grids that save seconds.
pub(super) fn grids(work: &Work, contours: &[u32]) -> Vec<Flown> {
    let runs = runs(work, contours);
    // Contours that have sides in one run belong together.
    let place = |c: u32| contours.binary_search(&c).ok().and_then(|k| u32::try_from(k).ok());
    let mut together = Union::new(contours.len());
    let mut joined = vec![false; contours.len()];
    for run in &runs {
        let mut members = run.iter().filter_map(|s| place(s.contour));
        let Some(first) = members.next() else { continue };
        for member in members {
            (joined[first as usize], joined[member as usize]) = (true, true);
            together.join(first, member);
        }
    }
    let of = together.numbered();
    let mut clusters: Vec<(Vec<u32>, Vec<Run>)> = vec![(Vec::new(), Vec::new()); contours.len()];
    for (k, &contour) in contours.iter().enumerate().filter(|(k, _)| joined[*k]) {
        clusters[of[k] as usize].0.push(contour);
    }
    for run in runs {
        if let Some(k) = run.first().and_then(|s| place(s.contour)).map(|k| k as usize).filter(|&k| joined[k])
        {
            clusters[of[k] as usize].1.push(run);
        }
    }
    clusters
        .into_iter()
        .filter(|c| !c.0.is_empty())
        .filter_map(|(contours, runs)| grid(work, contours, &runs))
        .collect()
}

/// All runs: sides on one line with ways of at most the lever's reach between them.
fn runs(work: &Work, contours: &[u32]) -> Vec<Run> {
    let mut sides: Vec<(f64, Side)> = contours.iter().flat_map(|&c| sides_of(work, c)).collect();
    sort_by_two(&mut sides, |(angle, _)| [*angle, 0.0]);
    let (mut class, mut direction, mut last) = (0, DVec2::X, f64::NEG_INFINITY);
    let mut all: Vec<Side> = Vec::with_capacity(sides.len());
    for (angle, mut side) in sides {
        if angle - last > PARALLEL {
            (class, direction) = (class + usize::from(!all.is_empty()), math::unit(angle));
        }
        last = angle;
        let (a, b) = (side.segment.start(), side.segment.end());
        let ends = [a.dot(direction), b.dot(direction)];
        side.forwards = ends[0] < ends[1];
        side.ends = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        (side.class, side.line) = (class, (0.5 * (a + b)).dot(direction.perp()));
        all.push(side);
    }
    let mut runs = Vec::new();
    for parallel in all.chunk_by(|a, b| a.class == b.class) {
        let mut parallel = parallel.to_vec();
        sort_by_two(&mut parallel, |s| [s.line, s.ends[0]]);
        for line in parallel.chunk_by(|a, b| b.line - a.line <= ON_LINE) {
            let mut line = line.to_vec();
            sort_by_two(&mut line, |s| [s.ends[0], 0.0]);
            let goes_on = |a: &Side, b: &Side| {
                let way = b.ends[0] - a.ends[1];
                way >= APART && work.lever.reaches(way)
            };
            runs.extend(line.chunk_by(goes_on).map(<[Side]>::to_vec));
        }
    }
    runs
}

/// The sides of an outline that has nothing but straight sides, each with its angle in a half turn.
fn sides_of(work: &Work, contour: u32) -> Vec<(f64, Side)> {
    let Some(path) = work.contour(contour).map(|c| &c.path) else { return Vec::new() };
    let straight = path.segments.iter().all(|s| matches!(s, Segment::Line(_)) && s.length() > APART);
    if !straight || !(3..=SIDES).contains(&path.segments.len()) {
        return Vec::new();
    }
    let mut from = 0.0;
    let last = path.segments.len() - 1;
    let side = |(k, segment): (usize, &Segment)| {
        let to = from + segment.length();
        let t = segment.tangent(0.0);
        let angle = math::atan2(t.y, t.x).rem_euclid(PI);
        // A direction is near 0 or near half a turn by rounding.
        let angle = if PI - angle < PARALLEL { angle - PI } else { angle };
        let ends = (from, if k == last { 0.0 } else { to });
        from = to;
        let side = Side {
            contour,
            segment: *segment,
            from: ends.0,
            to: ends.1,
            class: 0,
            line: 0.0,
            ends: [0.0; 2],
            forwards: true,
        };
        (angle, side)
    };
    path.segments.iter().enumerate().map(side).collect()
}

/// A group of the contours of a grid.
fn grid(work: &Work, contours: Vec<u32>, runs: &[Run]) -> Option<Flown> {
    let box_of = |s: &Side| work.contour(s.contour);
    let neighbours = runs.iter().flat_map(|r| r.windows(2));
    let hop =
        neighbours.filter_map(|w| Some(apart(box_of(&w[0])?, box_of(&w[1])?))).fold(f64::INFINITY, f64::min);
    let mut classes: Vec<Vec<&Run>> = Vec::new();
    for run in runs {
        let class = |c: &&mut Vec<&Run>| {
            c.first().and_then(|r| r.first()).map(|s| s.class) == run.first().map(|s| s.class)
        };
        match classes.iter_mut().find(class) {
            Some(of) => of.push(run),
            None => classes.push(vec![run]),
        }
    }
    let few = runs.iter().map(Vec::len).sum::<usize>() <= SEVERAL_WAYS;
    let starts = [(false, false), (false, true), (true, false), (true, true)];
    let mut ways = Vec::new();
    for last_first in [false, true].into_iter().take(if few { 2 } else { 1 }) {
        for &(far, backwards) in starts.iter().take(if few { 4 } else { 1 }) {
            let there = motions(&classes, last_first, far, backwards);
            let back: Vec<(&Run, bool)> = there.iter().rev().map(|(run, back)| (*run, !back)).collect();
            ways.push(work.way(strokes(&there))?);
            ways.push(work.way(strokes(&back))?);
        }
    }
    work.flown(contours, ways, hop)
}

/// The runs in order, each with whether it is run backwards: those of each direction there and back, from the far line or the near one.
fn motions<'r>(
    classes: &[Vec<&'r Run>],
    last_first: bool,
    far: bool,
    backwards: bool,
) -> Vec<(&'r Run, bool)> {
    let mut order: Vec<&Vec<&Run>> = classes.iter().collect();
    if last_first {
        order.reverse();
    }
    let mut out: Vec<(&Run, bool)> = Vec::new();
    let mut head: Option<DVec2> = None;
    for class in order {
        let mut class = class.clone();
        // From the side on which the head is.
        let distance = |run: &Run, from: DVec2| run.first().map_or(0.0, |s| s.segment.start().distance(from));
        let from_far = match (head, class.first().zip(class.last())) {
            (Some(at), Some((first, last))) => distance(last, at) < distance(first, at),
            _ => far,
        };
        if from_far {
            class.reverse();
        }
        for run in class {
            let ends = [false, true].map(|back| start(run, back));
            let back = match head {
                Some(at) => ends[1].distance(at) < ends[0].distance(at),
                None => backwards,
            };
            head = Some(start(run, !back));
            out.push((run, back));
        }
    }
    out
}

/// Where a run begins.
fn start(run: &Run, back: bool) -> DVec2 {
    let side = if back { run.last() } else { run.first() };
    side.map_or(DVec2::ZERO, |s| if s.forwards == back { s.segment.end() } else { s.segment.start() })
}

fn strokes(motions: &[(&Run, bool)]) -> Vec<Stroke> {
    let mut strokes = Vec::new();
    for (k, (run, back)) in motions.iter().enumerate() {
        if k > 0 {
            strokes.push(Stroke::Air(start(run, *back)));
        }
        strokes.push(Stroke::MovingStart);
        let mut head: Option<DVec2> = None;
        let mut cut = |side: &Side| {
            let reversed = side.forwards == *back;
            let segment = if reversed { side.segment.reversed() } else { side.segment };
            let (along, until) = if reversed { (side.to, side.from) } else { (side.from, side.to) };
            if let Some(from) = head.replace(segment.end()) {
                strokes.push(Stroke::Fly(vec![Segment::line(from, segment.start())]));
            }
            let (contour, length) = (side.contour, segment.length());
            let spans = vec![Span { contour, along, until, reversed, length, elements: 1 }];
            strokes.push(Stroke::Cut { spans, path: vec![segment], overcut: 0 });
        };
        if *back { run.iter().rev().for_each(&mut cut) } else { run.iter().for_each(&mut cut) }
    }
    strokes
}
