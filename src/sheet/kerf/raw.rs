//! The raw pieces of an offset: every element offset to its right, and the joins at the corners.
//!
//! Where an outline turns left, the offset elements diverge. The points at the right distance between them lie on an
//! arc around the corner. Where there is room, the corner is kept sharp instead: both ends continue straight until they
//! meet. This is no nearer to the part, it suits the machine best, and parts that lie one kerf apart then have the same
//! lines up to the corner where four of them meet. Arcs that turn by a few degrees only go on as arcs until they meet: short
//! lines between them would be lost in the rounding of programs, and the machine would slow down for the corners that are
//! left. Where an outline turns right, the offset elements cross each other.

use super::super::element::{ROUNDING, with_start};
use crate::geometry::{Arc, BoxIndex, DVec2, Path, Segment, distance, intersect, math};

/// Stretches meet within this distance, mm: a hundred times the rounding of a place on the largest sheet.
pub(super) const MEETING_DISTANCE: f64 = 1e-7;
/// Largest distance of a sharp corner of the line from the drawn corner, in halves of the kerf; other corners are
/// rounded. SVG and PDF writers use the same limit for their joins, and it allows triangles of 30 degrees (3.86) point
/// to point.
pub(super) const MITER_LIMIT: f64 = 4.0;

/// Shortest join between arcs, mm: programs, which are rounded to 0.001 mm, turn shorter elements by some degrees. On
/// machines with 5,000 mm/s2 this made programs of outlines of many arcs up to 9 % longer than planned.
const SHORTEST_JOIN: f64 = 0.02;

/// A raw piece, and the drawn element it runs beside; `None` for a join.
#[derive(Clone, Copy, Debug)]
pub(super) struct Raw {
    pub(super) segment: Segment,
    pub(super) of: Option<usize>,
}

/// All raw pieces of an outline offset to its right by `by` mm, in the outline's order. `free` says whether the beam
/// may go there.
pub(super) fn pieces(
    outline: &Path,
    by: f64,
    index: &BoxIndex,
    free: &impl Fn(&Segment) -> bool,
) -> Vec<Raw> {
    let drawn = &outline.segments;
    let n = drawn.len();
    let mut sides: Vec<Option<Segment>> = drawn.iter().map(|s| beside(s, by)).collect();
    let mut joins: Vec<Vec<Segment>> = vec![Vec::new(); n];
    let clear = |k: usize, s: &Segment| {
        let mut clear = free(s);
        index.visit(s.bounds().grown(by), |j| {
            clear &= j == k || j == (k + 1) % n || distance(s, &drawn[j]).0 >= by + ROUNDING;
            clear
        });
        clear
    };
    for k in 0..n {
        let next = (k + 1) % n;
        let (at, turns) = (drawn[k].end(), [drawn[k].tangent(1.0), drawn[next].tangent(0.0)]);
        let [from, to] = turns.map(|t| at - t.perp() * by);
        // Arcs that were joined within rounding end slightly beside where their tangents meet.
        let from = sides[k].map_or(from, |s| s.end());
        let to = sides[next].map_or(to, |s| s.start());
        let turn = math::turn(turns[0], turns[1]);
        if n == 1 || from.distance(to) <= MEETING_DISTANCE {
            // Both elements have one direction, so they are joined bit for bit.
            if let (Some(_), Some(b), true) = (sides[k], sides[next], n > 1) {
                sides[next] = Some(with_start(b, from));
            }
        } else if turn > 0.0 {
            let tip = miter_tip(at, turns, turn, by).filter(|tip| {
                [Segment::line(from, *tip), Segment::line(*tip, to)].iter().all(|s| clear(k, s))
            });
            match tip {
                Some(tip) => match meeting(sides[k], sides[next]) {
                    Some((a, b)) => (sides[k], sides[next]) = (Some(a), Some(b)),
                    None => {
                        joins[k].extend(extended(&mut sides[k], from, tip, true));
                        joins[k].extend(extended(&mut sides[next], to, tip, false));
                    }
                },
                None => joins[k].push(Segment::Arc(Arc::new(from, to, at, true))),
            }
        }
    }
    let sides = sides.into_iter().enumerate().map(|(k, s)| s.map(|segment| Raw { segment, of: Some(k) }));
    let joins = joins.into_iter().map(|j| j.into_iter().map(|segment| Raw { segment, of: None }));
    sides.zip(joins).flat_map(|(side, join)| side.into_iter().chain(join)).collect()
}

/// An element offset to its right; `None` where an arc's radius is too small for that.
fn beside(s: &Segment, by: f64) -> Option<Segment> {
    match *s {
        Segment::Line(l) => {
            let offset = s.tangent(0.0).perp() * -by;
            Some(Segment::line(l.start + offset, l.end + offset))
        }
        Segment::Arc(a) => {
            let to = |p: DVec2| {
                let (v, r) = (p - a.center, p.distance(a.center));
                a.center + v * ((r + if a.ccw() { by } else { -by }) / r)
            };
            let moved = Arc { start: to(a.start), end: to(a.end), ..a };
            (a.ccw() || a.radius() - by > ROUNDING).then_some(Segment::Arc(moved))
        }
    }
}

/// The place where the tangents of two offset elements meet, if it is not too far from the corner.
fn miter_tip(corner: DVec2, [a, b]: [DVec2; 2], turn: f64, by: f64) -> Option<DVec2> {
    let reach = 1.0 / math::cos(0.5 * turn);
    let out = -(a.perp() + b.perp()).normalize_or_zero();
    (reach > 0.0 && reach <= MITER_LIMIT).then(|| corner + out * (by * reach))
}

/// Extends an offset line to a corner at its end (or start). For an arc, returns the line that leads there.
fn extended(side: &mut Option<Segment>, end: DVec2, tip: DVec2, at_end: bool) -> Option<Segment> {
    match side {
        Some(Segment::Line(l)) => {
            *(if at_end { &mut l.end } else { &mut l.start }) = tip;
            None
        }
        _ => Some(if at_end { Segment::line(end, tip) } else { Segment::line(tip, end) }),
    }
}

/// Two offset elements, one of them an arc, prolonged to where they meet beyond a short gap between them. On its own line or
/// circle an element is nowhere nearer to the corner than at its end.
fn meeting(a: Option<Segment>, b: Option<Segment>) -> Option<(Segment, Segment)> {
    let (a, b) = (a?, b?);
    let gap = a.end().distance(b.start());
    if gap > SHORTEST_JOIN || matches!((a, b), (Segment::Line(_), Segment::Line(_))) {
        return None;
    }
    let [beyond, before] = [prolongation(&a, gap)?, prolongation(&b.reversed(), gap)?];
    let met = intersect(&beyond, &before, MEETING_DISTANCE).points;
    let met = met.first()?;
    let tip = beyond.at(met.a);
    Some((prolonged(a, &beyond, met.a, tip), prolonged(b.reversed(), &before, met.b, tip).reversed()))
}

/// The next `length` mm of the line or circle of an element, beyond its end; `None` on a circle that is small for that.
fn prolongation(s: &Segment, length: f64) -> Option<Segment> {
    let end = s.end();
    match s {
        Segment::Line(_) => Some(Segment::line(end, end + s.tangent(1.0) * length)),
        Segment::Arc(a) => {
            let sweep = (length / a.radius()).copysign(a.sweep);
            let to = a.center + math::rotate(end - a.center, sweep);
            (length < 0.5 * a.radius()).then_some(Segment::Arc(Arc { start: end, end: to, sweep, ..*a }))
        }
    }
}

/// An element with a fraction of its prolongation, which ends at `tip`.
fn prolonged(s: Segment, more: &Segment, fraction: f64, tip: DVec2) -> Segment {
    match (s, more) {
        (Segment::Arc(a), Segment::Arc(more)) => {
            Segment::Arc(Arc { end: tip, sweep: a.sweep + more.sweep * fraction, ..a })
        }
        _ => Segment::line(s.start(), tip),
    }
}
