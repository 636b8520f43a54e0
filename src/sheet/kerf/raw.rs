//! The pieces of which an offset is made: every element moved to its right, and what joins them at corners.
//!
//! Where an outline turns left, the moved elements part. Whatever is at the right distance between them lies on an arc around
//! the corner. But corners stay corners where the way is clear: the ends go on straight until they meet. That is no nearer to
//! the part, it is what a machine does best, and parts laid out one kerf apart have the same lines then up to the corner in
//! which four of them meet. Where an outline turns right, the moved elements cross each other.

use super::super::element::{ROUNDING, with_start};
use super::room::apart;
use crate::geometry::{Arc, BoxIndex, DVec2, Path, Segment, math};

/// Stretches meet within this, mm: a hundred times the rounding of a place on the largest sheet.
pub(super) const MEETS: f64 = 1e-7;
/// Corners reach as far as this from the drawn corner at most, in halves of the kerf; sharper ones are rounded. It is what
/// SVG and PDF writers take for their joins, and lets triangles of 30 degrees (3.86) lie point to point.
pub(super) const LONGEST_CORNER: f64 = 4.0;

/// A piece, and the drawn element it runs beside; none for what joins two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Raw {
    pub(super) segment: Segment,
    pub(super) of: Option<usize>,
}

/// All pieces of an outline moved to its right by `by` mm, in its order. `free`: whether the beam may go there.
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
            clear &= j == k || j == (k + 1) % n || apart(s, &drawn[j]).0 >= by + ROUNDING;
            clear
        });
        clear
    };
    for k in 0..n {
        let next = (k + 1) % n;
        let (at, turns) = (drawn[k].end(), [drawn[k].tangent(1.0), drawn[next].tangent(0.0)]);
        let [from, to] = turns.map(|t| at - t.perp() * by);
        // Arcs that were joined over a rounding end beside where their tangents say.
        let from = sides[k].map_or(from, |s| s.end());
        let to = sides[next].map_or(to, |s| s.start());
        let turn = math::turn(turns[0], turns[1]);
        if n == 1 || from.distance(to) <= MEETS {
            // One direction: joined bit for bit.
            if let (Some(_), Some(b), true) = (sides[k], sides[next], n > 1) {
                sides[next] = Some(with_start(b, from));
            }
        } else if turn > 0.0 {
            let tip = tip(at, turns, turn, by).filter(|tip| {
                [Segment::line(from, *tip), Segment::line(*tip, to)].iter().all(|s| clear(k, s))
            });
            match tip {
                Some(tip) => {
                    joins[k].extend(extended(&mut sides[k], from, tip, true));
                    joins[k].extend(extended(&mut sides[next], to, tip, false));
                }
                None => joins[k].push(Segment::Arc(Arc::new(from, to, at, true))),
            }
        }
    }
    let sides = sides.into_iter().enumerate().map(|(k, s)| s.map(|segment| Raw { segment, of: Some(k) }));
    let joins = joins.into_iter().map(|j| j.into_iter().map(|segment| Raw { segment, of: None }));
    sides.zip(joins).flat_map(|(side, join)| side.into_iter().chain(join)).collect()
}

/// An element moved to its right; none where an arc bends too much for that.
fn beside(s: &Segment, by: f64) -> Option<Segment> {
    match *s {
        Segment::Line(l) => {
            let aside = s.tangent(0.0).perp() * -by;
            Some(Segment::line(l.start + aside, l.end + aside))
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

/// Where the tangents of two moved elements meet, if that is not too far from the corner.
fn tip(corner: DVec2, [a, b]: [DVec2; 2], turn: f64, by: f64) -> Option<DVec2> {
    let reach = 1.0 / math::cos(0.5 * turn);
    let out = -(a.perp() + b.perp()).normalize_or_zero();
    (reach > 0.0 && reach <= LONGEST_CORNER).then(|| corner + out * (by * reach))
}

/// Lets a moved line end (or start) at a corner; of an arc the way there comes back.
fn extended(side: &mut Option<Segment>, end: DVec2, tip: DVec2, at_end: bool) -> Option<Segment> {
    match side {
        Some(Segment::Line(l)) => {
            *(if at_end { &mut l.end } else { &mut l.start }) = tip;
            None
        }
        _ => Some(if at_end { Segment::line(end, tip) } else { Segment::line(tip, end) }),
    }
}
