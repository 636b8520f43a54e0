//! Rows: contours whose outermost places on one side lie on a line, where each contour runs along that line. The head comes in along
//! the line, goes once around the contour, and leaves along the line again, so that nothing slows it down but the contour itself.
//! Round holes, slots in a line and equal outlines with a straight side on the line are such rows.
//!
//! Each row has four ways: on either side of its contours, in either direction. Where the contours are on a line, or near enough to each other,
//! on one of their sides alone, it has two.

use super::work::{Flown, Work, apart, sort_by_two};
use crate::geometry::{BoxIndex, DVec2, Path, Segment, math};
use crate::order::{real, sort_by};
use crate::problem::sub_path::{Span, Stroke, SubPath};
use rustc_hash::FxHashSet;
use std::f64::consts::FRAC_PI_2;

/// Largest distance of the outermost places from one line, mm: over 1 mm, the bend is below the one at which controllers slow down.
const ON_LINE: f64 = 1e-3;
/// Cosine above which a contour runs along the row: controllers take such a bend for straight.
const ALONG: f64 = 0.999_999;
/// Places nearer than this to the outermost one are outermost too, mm.
const OUTERMOST: f64 = 1e-7;
/// Largest number of directions of rows that are tried besides those of the axes, each with the one across it.
const DIRECTIONS: usize = 2;
/// Directions of neighbours are counted in steps of this angle, rad.
const STEP: f64 = 1e-3;
/// Largest number of angles that are counted: on nested sheets every pair of neighbours has its own, and none is a row's.
const MOST_ANGLES: usize = 100;

/// Rows that save seconds within this save the same.
const SAME_TIME: f64 = 1e-9;

/// A contour around which the head runs from a place where it runs along the row.
#[derive(Clone)]
struct Loop {
    contour: u32,
    /// The place on the contour, mm from its stored start.
    along: f64,
    /// The place along the row and across it, mm.
    at: DVec2,
    path: Path,
    /// Runs against the stored direction.
    reversed: bool,
}

/// The rows that save seconds, in the direction in which all together save most.
pub(super) fn rows(work: &Work, contours: &[u32]) -> Vec<Flown> {
    let mut best: (f64, Vec<Flown>) = (0.0, Vec::new());
    for u in directions(work, contours) {
        let found = from_both_sides(work, contours, u);
        let saved = found.iter().map(|r| r.saved).sum::<f64>();
        if saved > best.0 {
            best = (saved, found);
        }
    }
    best.1
}

/// The directions of the axes, those in which contours most often have their nearest neighbour, and those across them.
fn directions(work: &Work, contours: &[u32]) -> Vec<DVec2> {
    let boxes: Vec<_> = contours.iter().filter_map(|&c| work.contour(c)).map(|c| c.bounds).collect();
    let index = BoxIndex::new(boxes.iter().copied());
    // The number of steps of each angle.
    let mut angles: Vec<(u32, f64)> = Vec::new();
    for (k, b) in boxes.iter().enumerate() {
        let mut reach = 0.5 * b.size().max_element();
        let nearest = loop {
            let others =
                index.query(b.grown(reach)).into_iter().filter(|&o| o != k).filter_map(|o| boxes.get(o));
            let away = others.map(|o| o.center() - b.center());
            let nearest = away.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
            if nearest.is_some() || reach > work.lever.reach {
                break nearest;
            }
            reach *= 2.0;
        };
        let Some(v) = nearest.filter(|v| *v != DVec2::ZERO) else { continue };
        let angle = math::atan2(v.y, v.x).rem_euclid(FRAC_PI_2);
        match angles.iter().position(|(_, a)| (*a - angle).abs() < STEP) {
            Some(k) => angles[k].0 += 1,
            None if angles.len() < MOST_ANGLES => angles.push((1, angle)),
            None => {}
        }
    }
    sort_by(&mut angles, |(count, angle)| [u64::from(u32::MAX - count), real(*angle), 0]);
    let slanted = angles.iter().map(|a| a.1).filter(|a| *a > STEP && *a < FRAC_PI_2 - STEP);
    let first = [DVec2::X, DVec2::Y].into_iter();
    first.chain(slanted.take(DIRECTIONS).flat_map(|a| [a, a + FRAC_PI_2]).map(math::unit)).collect()
}

/// The rows on the right of a direction and those on the left of it; of those that share contours, the one that saves most.
fn from_both_sides(work: &Work, contours: &[u32], u: DVec2) -> Vec<Flown> {
    let mut found = rows_along(work, contours, u);
    found.extend(rows_along(work, contours, -u));
    let mut order: Vec<(usize, f64)> = found.iter().map(|row| row.saved).enumerate().collect();
    sort_by(&mut order, |(_, saved)| [real(-(saved / SAME_TIME).round()), 0, 0]);
    let mut taken = FxHashSet::default();
    let mut chosen = vec![false; found.len()];
    for (k, _) in order {
        if found[k].contours.iter().all(|c| !taken.contains(c)) {
            taken.extend(found[k].contours.iter().copied());
            chosen[k] = true;
        }
    }
    found.into_iter().zip(chosen).filter_map(|(row, is_chosen)| is_chosen.then_some(row)).collect()
}

/// The rows of contours whose outermost places on the right of a direction lie on a line.
fn rows_along(work: &Work, contours: &[u32], u: DVec2) -> Vec<Flown> {
    // With the contours on the left of the row's direction.
    let mut loops: Vec<Loop> =
        contours.iter().filter_map(|&c| around(c, &work.contour(c)?.path, u)).collect();
    sort_by_two(&mut loops, |l| [l.at.y, 0.0]);
    let mut rows = Vec::new();
    let mut rest = loops.as_slice();
    while let Some(first) = rest.first() {
        let on_line = rest.iter().take_while(|l| l.at.y - first.at.y <= ON_LINE).count();
        let (line, after) = rest.split_at(on_line);
        rest = after;
        let mut line = line.to_vec();
        sort_by_two(&mut line, |l| [l.at.x, 0.0]);
        for row in line.chunk_by(|a, b| follows(work, a, b)).filter(|row| row.len() > 1) {
            rows.extend(row_of(work, row, u));
        }
    }
    rows
}

/// Whether the head runs on from one contour to the next. On either side of the contours it is another way.
fn follows(work: &Work, a: &Loop, b: &Loop) -> bool {
    let way = b.at.x - a.at.x;
    way >= 0.0 && work.lever.reaches(way)
}

/// One row as a group.
fn row_of(work: &Work, row: &[Loop], u: DVec2) -> Option<Flown> {
    let contours: Vec<u32> = row.iter().map(|l| l.contour).collect();
    let of = |l: &Loop| work.contour(l.contour);
    let hop =
        row.windows(2).filter_map(|w| Some(apart(of(&w[0])?, of(&w[1])?))).fold(f64::INFINITY, f64::min);
    let mut ways: Vec<SubPath> = both_ways(work, row)?.into();
    // On the other side, the contours are on the right of the direction: on the left of the opposite one.
    let other: Option<Vec<Loop>> = row.iter().rev().map(|l| around(l.contour, &of(l)?.path, -u)).collect();
    if let Some(other) = other
        && other.windows(2).all(|w| (w[0].at.y - w[1].at.y).abs() <= ON_LINE && follows(work, &w[0], &w[1]))
    {
        ways.extend(both_ways(work, &other).into_iter().flatten());
    }
    work.flown(contours, ways, hop)
}

/// The way along a row, and the way back.
fn both_ways(work: &Work, row: &[Loop]) -> Option<[SubPath; 2]> {
    let back: Vec<Loop> = row
        .iter()
        .rev()
        .map(|l| Loop { path: l.path.reversed(), reversed: !l.reversed, ..l.clone() })
        .collect();
    Some([work.way(strokes(work, row))?, work.way(strokes(work, &back))?])
}

fn strokes(work: &Work, row: &[Loop]) -> Vec<Stroke> {
    let mut strokes = vec![Stroke::MovingStart];
    let mut head: Option<DVec2> = None;
    for l in row {
        let length = l.path.length();
        let again = work.lever.cut_again(length);
        // Half of the overcut lies before the place on the line and half after it, so that neither bend slows the head down.
        let before = 0.5 * again;
        let along = if l.reversed { l.along + before } else { l.along - before }.rem_euclid(length);
        let whole = if again > 0.0 { l.path.starting_at(length - before) } else { l.path.clone() };
        let mut path = whole.segments.clone();
        let elements = path.len();
        if again > 0.0 {
            path.extend(whole.between(0.0, again));
        }
        let Some((first, last)) = path.first().zip(path.last()) else { continue };
        if let Some(from) = head.replace(last.end()) {
            strokes.push(Stroke::Fly(vec![Segment::line(from, first.start())]));
        }
        let span = Span { contour: l.contour, along, until: along, reversed: l.reversed, length, elements };
        strokes.push(Stroke::Cut { spans: vec![span], overcut: path.len() - elements, path });
    }
    strokes
}

/// A contour as a loop that begins and ends along `u`, at its outermost place to the right of that direction; `None` if it does not
/// run along `u` there.
fn around(contour: u32, path: &Path, u: DVec2) -> Option<Loop> {
    let out = -u.perp();
    let mut best: Option<(f64, f64)> = None;
    let mut begins = 0.0;
    let mut offer = |reach: f64, along: f64| {
        if best.is_none_or(|(farthest, _)| reach > farthest + OUTERMOST) {
            best = Some((reach, along));
        }
    };
    // Places within elements come first, so that they win over corners that are as far out.
    for s in &path.segments {
        let length = s.length();
        match s {
            Segment::Line(l) if ((l.end - l.start).dot(out)).abs() <= OUTERMOST => {
                offer(l.start.dot(out), begins + 0.5 * length);
            }
            Segment::Arc(a) => {
                if let Some(f) = a.fraction_of(out) {
                    offer(a.center.dot(out) + a.radius(), begins + f * length);
                }
            }
            Segment::Line(_) => {}
        }
        begins += length;
    }
    begins = 0.0;
    for s in &path.segments {
        offer(s.start().dot(out), begins);
        begins += s.length();
    }
    let (_, along) = best?;
    let whole = path.starting_at(along);
    let (first, last) = (whole.segments.first()?.tangent(0.0), whole.segments.last()?.tangent(1.0));
    let (first, last) = (first.dot(u), last.dot(u));
    let reversed = first < 0.0;
    let runs_along = first.abs() > ALONG && last.abs() > ALONG && (last < 0.0) == reversed;
    let path = if reversed { whole.reversed() } else { whole };
    let at = path.start()?;
    runs_along.then(|| Loop { contour, along, at: DVec2::new(at.dot(u), at.dot(-out)), path, reversed })
}
