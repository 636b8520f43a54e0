//! Checks sharp corners: there is a pause in each one that is cut through, and nowhere else.
//!
//! The cuts before and after a pause are joined here, because all other checks treat them as one cut. Angles are computed
//! by arc tangent (the planner compares cosines).

use super::groups::Groups;
use super::tolerance::JOIN;
use super::violation::Violation;
use crate::geometry::{Segment, math};
use crate::machine::{MARGIN, PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Leads, Move, Turn};
use std::borrow::Cow;
use std::f64::consts::PI;

/// The moves of a plan with their indices, where cuts that are only interrupted by a pause in a sharp corner are one move.
pub(super) fn joined<'p>(
    moves: &'p [Move],
    machine: &Profile,
    groups: &Groups,
    found: &mut Vec<Violation>,
) -> Vec<(usize, Cow<'p, Move>)> {
    let limit = machine.sharp_corner.map(|c| c.angle);
    let is_sharp = |a: &Segment, b: &Segment| limit.is_some_and(|limit| angle(a, b) < limit - 2.0 * MARGIN);
    let mut out: Vec<(usize, Cow<Move>)> = Vec::with_capacity(moves.len());
    let mut paused = None;
    let astray = |step| Violation::Beam { step, what: "pauses where no sharp corner is cut through" };
    for (step, m) in moves.iter().enumerate() {
        let pause = paused.take();
        match m {
            Move::Macro { at, .. } => {
                let here = matches!(out.last().map(|o| o.1.as_ref()), Some(Move::Cut { path, mark: false, .. })
                    if path.last().is_some_and(|s| s.end().distance(*at) <= JOIN));
                if !here || pause.is_some() {
                    found.push(astray(step));
                }
                paused = Some((step, *at));
            }
            Move::Cut { contour, with, path, mark: false, leads, turns } => {
                // In a loop, or along an arc, no corner is cut through.
                let is_turned = |p: &[Segment]| turns.iter().any(|t| t.at.distance(p[1].start()) <= JOIN);
                for pair in path.windows(2).filter(|p| is_sharp(&p[0], &p[1]) && !is_turned(p)) {
                    found.push(Violation::NoMacro { step, contour: *contour, at: pair[1].start() });
                }
                let corner = match (out.last().map(|o| o.1.as_ref()), path.first()) {
                    (Some(before @ Move::Cut { path, mark: false, .. }), Some(next)) => {
                        // Otherwise the beam goes off between them, as it does between two passes of a cut that is not pierced.
                        path.last().zip(Some(next)).filter(|_| {
                            !PLANS_ALL_LEVERS
                                || goes_on(before, *contour, groups)
                                    && (pause.is_some() || groups.sheet.is_cut_once(*contour, machine))
                        })
                    }
                    _ => None,
                };
                if let Some((step, _)) = pause
                    && corner.is_none_or(|(a, b)| limit.is_none_or(|limit| angle(a, b) > limit))
                {
                    found.push(astray(step));
                }
                if let Some((a, b)) = corner
                    && pause.is_none()
                    && is_sharp(a, b)
                {
                    found.push(Violation::NoMacro { step, contour: *contour, at: b.start() });
                }
                if let (Some(_), Some((_, before))) = (pause, out.last_mut())
                    && goes_on(before, *contour, groups)
                {
                    append(before.to_mut(), *contour, with, (path, turns), leads);
                    continue;
                }
                out.push((step, Cow::Borrowed(m)));
            }
            _ => {
                if let Some((step, _)) = pause {
                    found.push(astray(step));
                }
                out.push((step, Cow::Borrowed(m)));
            }
        }
    }
    if let Some((step, _)) = paused {
        found.push(astray(step));
    }
    out
}

/// The angle between two elements where they meet: pi is straight.
fn angle(a: &Segment, b: &Segment) -> f64 {
    let (back, on) = (-a.tangent(1.0), b.tangent(0.0));
    // Elements without a length have no direction.
    if back.length_squared() < 0.5 || on.length_squared() < 0.5 {
        return PI;
    }
    math::atan2(back.perp_dot(on), back.dot(on)).abs()
}

/// Whether a cut may continue along a contour.
fn goes_on(before: &Move, next: u32, groups: &Groups) -> bool {
    matches!(before, Move::Cut { contour, mark: false, .. } if *contour == next || groups.same(*contour, next))
}

fn append(before: &mut Move, next: u32, also: &[u32], (run, then): (&[Segment], &[Turn]), more: &Leads) {
    if let Move::Cut { contour, with, path, leads, turns, .. } = before {
        *leads = leads.and(*more);
        turns.extend_from_slice(then);
        path.extend_from_slice(run);
        for &other in std::iter::once(&next).chain(also) {
            if other != *contour && !with.contains(&other) {
                with.push(other);
            }
        }
    }
}
