//! Checks skeleton cuts: they come after everything else, keep their distance from parts, and leave joints.
//!
//! Distances are those of chords: arcs are divided until no chord is farther than a micrometre from its arc, and the distance of
//! two straight lines is that of an end of one from the other, unless they cross.

use super::textbook::{air_time, is_lifted};
use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment};
use crate::machine::{Profile, cut_time};
use crate::order::sort_by;
use crate::plan::model::{Move, Plan};
use crate::sheet::{Contour, Operation, Sheet};

/// Largest distance of a chord from its arc, mm.
const CHORD: f64 = 1e-3;
/// Distances are compared with this tolerance, mm: chords, and the rounding of coordinates.
const SLACK: f64 = 2.0 * CHORD;
/// Relative difference within which sums agree.
const RELATIVE: f64 = 1e-9;

pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    let contour = |m: &Move| match m {
        Move::Cut { contour, .. } => sheet.contours.get(*contour as usize),
        _ => None,
    };
    let is_skeleton = |m: &Move| contour(m).is_some_and(|c| c.skeleton);
    sums(sheet, machine, plan, is_skeleton, found);
    let Some(first) = plan.moves.iter().position(is_skeleton) else { return };
    let parts = Chords::new(sheet);
    for (step, m) in plan.moves.iter().enumerate().skip(first) {
        let (Move::Cut { contour, path, .. }, Some(known)) = (m, contour(m)) else { continue };
        if !known.skeleton {
            found.push(Violation::Rank { earlier: first_contour(plan, first), later: *contour });
            continue;
        }
        let (Some(skeleton), [Segment::Line(line)]) = (&machine.skeleton, path.as_slice()) else {
            found.push(Violation::Beam { step, what: "makes a skeleton cut that nobody asked for" });
            continue;
        };
        let way = line.end - line.start;
        if way.x.abs().min(way.y.abs()) > SLACK {
            found.push(Violation::Beam {
                step,
                what: "makes a skeleton cut that is neither upright nor level",
            });
        }
        if skeleton.joint_spacing.is_some_and(|most| way.length() > most + SLACK) {
            found.push(Violation::Beam { step, what: "makes a long skeleton cut without a joint" });
        }
        if let Some(at) = parts.nearer(line.start, line.end, skeleton.clearance - SLACK) {
            found.push(Violation::Skeleton { step, at });
        }
    }
}

fn first_contour(plan: &Plan, step: usize) -> u32 {
    match plan.moves.get(step) {
        Some(Move::Cut { contour, .. }) => *contour,
        _ => 0,
    }
}

/// Adds up the skeleton cuts: the moves after the last other cut, up to the last cut.
fn sums(
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    is_skeleton: impl Fn(&Move) -> bool,
    found: &mut Vec<Violation>,
) {
    let is_cut = |m: &Move| matches!(m, Move::Cut { .. });
    let last = plan.moves.iter().rposition(is_cut).map_or(0, |k| k + 1);
    let begin = plan.moves.iter().rposition(|m| is_cut(m) && !is_skeleton(m)).map_or(0, |k| k + 1);
    let (before, tail) = plan.moves.split_at(begin.min(last));
    let mut head = before.iter().rev().find_map(Move::end).unwrap_or(machine.home());
    let (mut length, mut seconds, mut height) = (0.0, 0.0, 0.0_f64);
    for m in before {
        if let Move::Height { z } = m {
            height = *z;
        }
    }
    let mut lines: Vec<u32> = Vec::new();
    for m in tail.iter().take(last - begin.min(last)) {
        match m {
            Move::Air { to, way } => {
                let moved = *to - head;
                seconds += air_time(machine, moved, is_lifted(machine, moved, *way));
            }
            Move::Pierce => seconds += machine.pierce_time,
            Move::Height { z } => {
                seconds += machine.z_speed.map_or(0.0, |speed| (z - height).abs() / speed);
                height = *z;
            }
            Move::Cut { contour, path, .. } => {
                lines.push(sheet_line(sheet, *contour));
                length += path.iter().map(Segment::length).sum::<f64>();
                seconds += machine.beam_on_delay
                    + machine.beam_off_delay
                    + cut_time(machine, &sheet.process_by_id(*contour, machine), path);
            }
            _ => {}
        }
        head = m.end().unwrap_or(head);
    }
    // A line that is cut in several passes counts once.
    sort_by(&mut lines, |&line| [line.into(), 0, 0]);
    lines.dedup();
    let s = &plan.summary;
    let sums = [
        ("the number of skeleton cuts", f64::from(s.skeleton_cuts), lines.len() as f64),
        ("the length of skeleton cuts", s.skeleton_length, length),
        ("the time of skeleton cuts", s.skeleton_time, seconds),
    ];
    // The time is a difference of times of the whole job.
    let slack = RELATIVE * (1.0 + s.total_time);
    for (what, says, again) in sums {
        let same = (says - again).abs() <= slack + RELATIVE * again.abs();
        if !same {
            found.push(Violation::Sum { what, says, found: again });
        }
    }
}

/// The contour whose line a pass runs along: its last pass.
fn sheet_line(sheet: &Sheet, contour: u32) -> u32 {
    let next = |c: &u32| sheet.contours.get(*c as usize).and_then(|c| c.next_pass);
    std::iter::successors(Some(contour), next).take(1 + sheet.contours.len()).last().unwrap_or(contour)
}

/// The outlines of everything that is worked and no skeleton cut, as chords.
struct Chords {
    all: Vec<(DVec2, DVec2)>,
    index: BoxIndex,
    /// Those of each closed outline.
    closed: Vec<(Aabb, std::ops::Range<usize>)>,
}

impl Chords {
    fn new(sheet: &Sheet) -> Self {
        let mut all = Vec::new();
        let mut closed = Vec::new();
        let worked = |c: &&Contour| c.operation != Operation::Ignore && !c.skeleton && c.next_pass.is_none();
        for contour in sheet.contours.iter().filter(worked) {
            for path in [Some(&contour.path), contour.outline.as_ref()].into_iter().flatten() {
                let first = all.len();
                path.segments.iter().for_each(|s| chords(s, &mut all));
                if path.closed {
                    closed.push((path.bounds(), first..all.len()));
                }
            }
        }
        let index = BoxIndex::new(all.iter().map(|&(a, b)| Aabb::of(a).with(b)));
        Self { all, index, closed }
    }

    /// A place where a straight line is nearer to an outline than `least`, or inside one.
    fn nearer(&self, a: DVec2, b: DVec2, least: f64) -> Option<DVec2> {
        let mut place = None;
        self.index.visit(Aabb::of(a).with(b).grown(least.max(0.0)), |k| {
            if let Some(&(c, d)) = self.all.get(k)
                && apart(a, b, c, d) < least
            {
                place = Some(c);
            }
            place.is_none()
        });
        place.or_else(|| {
            let around = |(bounds, of): &&(Aabb, std::ops::Range<usize>)| {
                bounds.contains(a) && self.all.get(of.clone()).is_some_and(|chords| is_inside(chords, a))
            };
            self.closed.iter().find(around).map(|_| a)
        })
    }
}

/// Adds the chords of an element.
fn chords(segment: &Segment, all: &mut Vec<(DVec2, DVec2)>) {
    let pieces = match segment {
        Segment::Line(_) => 1.0,
        Segment::Arc(arc) => {
            // The sagitta of a chord of angle `t` is r (1 - cos(t / 2)), at most r t^2 / 8.
            let widest = (8.0 * CHORD / arc.radius().max(CHORD)).sqrt();
            (arc.sweep.abs() / widest).ceil().max(1.0)
        }
    };
    let mut k = 0.0;
    while k < pieces {
        all.push((segment.at(k / pieces), segment.at((k + 1.0) / pieces)));
        k += 1.0;
    }
}

/// Distance of two straight lines.
fn apart(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> f64 {
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let ends = [to_line(a, c, d), to_line(b, c, d), to_line(c, a, b), to_line(d, a, b)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

/// Distance of a point from a straight line.
fn to_line(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let t = (p - a).dot(along) / along.length_squared();
    let t = if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + t * along)
}

/// Whether a ray to the right crosses the chords an odd number of times.
fn is_inside(chords: &[(DVec2, DVec2)], p: DVec2) -> bool {
    let crosses = |&&(a, b): &&(DVec2, DVec2)| {
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    };
    !chords.iter().filter(crosses).count().is_multiple_of(2)
}
