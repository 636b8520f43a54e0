//! Linear lower bounds of the seconds between two pieces.
//!
//! Air time f is a function of the displacement x between two points. On the displacements that occur between two pieces it
//! is at least a0 + e . x for suitable a0 and e:
//! * a lifted head only adds to it, and the chords below are those with the head down;
//! * by distance (`vector`): seconds over a distance are concave, so on an interval of distances they lie above their
//!   chord, and a distance |x| is at least u . x for any unit vector u;
//! * by axis: the slower axis alone is no more than all of it, and |x| >= +-x. A straight move takes at least as long
//!   as the same move with each axis on its own;
//! * by speed and ramps (`limits.rs`), where a straight move keeps to the speed of one axis and the acceleration of the other: the seconds lie
//!   above their tangent plane but for what they are curved downwards, and each of both is at least any mixture of those of x and y.
//!
//! Where both axes take the same, the mixture that lies closest may slope, although the path is level there. So mixtures may be given
//! (`level`); any of them is a lower bound. Such a mixture comes first wherever the closest function is below it at some end: if all functions are
//! the mixtures or above them, no path takes less than the mixtures do, and these are level.
//!
//! The sum of such a bound and of charges that change linearly along both pieces is linear in both points, so that its
//! minimum is at ends of pieces: the knots. So the continuous problem has a table of numbers between knots, each the minimum
//! of a0 + e . x over the pieces that meet there. The loss shrinks with the square of the lengths of the pieces.

use super::limits::Limits;
use super::net::Piece;
use crate::geometry::DVec2;
use crate::machine::{AirTime, Profile, Travel};

/// Prices pairs of pieces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minorant {
    air: AirTime,
    head_down: AirTime,
    by_distance: bool,
    /// How fast each axis is; the core wasm does without it.
    pub(super) limits: Option<Limits>,
}

/// The core wasm does without planes and given mixtures, as without all orders (`rounds/enumerations.rs`).
const HAS_PLANES: bool = cfg!(feature = "research");
/// A given mixture stands back where it loses this many times more than the closest function at an end of a piece: on large pieces no leg is level. With
/// 8, a proof of 28 contours on `co2-100w` took 18 s instead of 5.5; without a limit, one on `fibre-3kw-thin` came to no end.
const WORSE: f64 = 30.0;
/// How much x counts in the time at top speed and in the ramps, in the planes that are tried everywhere: one axis limits each.
const APART: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

/// Least seconds of moves that planes are for: of shorter ones the slopes grow without end.
const SHORTEST: f64 = 1e-6;

impl Minorant {
    pub(super) fn new(machine: &Profile) -> Self {
        Self {
            air: AirTime::new(machine),
            head_down: AirTime::head_down(machine),
            by_distance: machine.travel == Travel::Vector,
            limits: if HAS_PLANES { Limits::new(machine) } else { None },
        }
    }

    pub(super) fn air(&self) -> &AirTime {
        &self.air
    }

    /// Lower bounds of the seconds from the ends of `p` to the ends of `q`, as `[p end][q end]`, such that the seconds
    /// between inner points are at least the linear interpolation of these numbers. `mixture`: how much x counts, if it is given.
    pub(super) fn corners(&self, p: &Piece, q: &Piece, mixture: Option<[f64; 2]>) -> [[f64; 2]; 2] {
        let exact = [0, 1].map(|i| [0, 1].map(|j| self.air.seconds(p.ends[i], q.ends[j])));
        if p.knots[0] == p.knots[1] && q.knots[0] == q.knots[1] && p.off + q.off <= 0.0 {
            return exact;
        }
        let off = p.off + q.off;
        let middle = 0.5 * ((q.ends[0] + q.ends[1]) - (p.ends[0] + p.ends[1]));
        // Displacements differ from the middle one by no more than this.
        let reach = 0.5 * ((p.ends[1] - p.ends[0]).abs() + (q.ends[1] - q.ends[0]).abs()) + off;
        let away = middle.abs();
        let (near, far) = ((away - reach).max(DVec2::ZERO), away + reach);
        let added = self.air.lift_adds(near.length());
        let floor = self.air.seconds(DVec2::ZERO, near);
        let mut best = [[floor; 2]; 2];
        let mut least = loss(&exact, &best);
        let mut offer = |a0: f64, e: DVec2| {
            let a0 = a0 + added - e.length() * off;
            let values = [0, 1].map(|i| [0, 1].map(|j| a0 + e.dot(q.ends[j] - p.ends[i])));
            let lost = loss(&exact, &values);
            if lost < least {
                (best, least) = (values, lost);
            }
        };
        if self.by_distance {
            let unit = middle.normalize_or_zero();
            let (a0, slope) = self.chord(DVec2::X, near.length(), far.length());
            offer(a0, slope * unit);
        } else {
            let way = DVec2::new(1.0_f64.copysign(middle.x), 1.0_f64.copysign(middle.y));
            let (x0, x1) = self.chord(DVec2::X, near.x, far.x);
            let (y0, y1) = self.chord(DVec2::Y, near.y, far.y);
            offer(x0, DVec2::new(x1 * way.x, 0.0));
            offer(y0, DVec2::new(0.0, y1 * way.y));
            offer(0.5 * (x0 + y0), DVec2::new(0.5 * x1 * way.x, 0.5 * y1 * way.y));
            if HAS_PLANES && let Some(limits) = &self.limits {
                let planes = APART.into_iter().filter(|_| !limits.each_axis);
                let tried = planes.filter_map(|shares| plane(limits, shares, away, reach));
                tried.for_each(|(a0, e)| offer(a0, e * way));
                let given = mixture.and_then(|shares| {
                    let [x, y] = [shares[0], 1.0 - shares[0]];
                    let by_axis = || (x * x0 + y * y0, DVec2::new(x * x1, y * y1));
                    if limits.each_axis { Some(by_axis()) } else { plane(limits, shares, away, reach) }
                });
                if let Some((a0, e)) = given {
                    let (a0, e) = (a0 + added - e.length() * off, e * way);
                    let values = [0, 1].map(|i| [0, 1].map(|j| a0 + e.dot(q.ends[j] - p.ends[i])));
                    let below = best.as_flattened().iter().zip(values.as_flattened()).any(|(b, v)| b < v);
                    if below && loss(&exact, &values) < WORSE * least {
                        best = values;
                    }
                }
            }
        }
        best
    }

    /// The chord of the seconds with the head down over the distance along an axis, between two distances: its value at 0 and its slope.
    fn chord(&self, axis: DVec2, near: f64, far: f64) -> (f64, f64) {
        let (low, high) = (
            self.head_down.seconds(DVec2::ZERO, axis * near),
            self.head_down.seconds(DVec2::ZERO, axis * far),
        );
        let slope = if far > near { (high - low) / (far - near) } else { 0.0 };
        (low - slope * near, slope)
    }
}

/// A plane below the seconds of a straight move whose distances along the axes differ from `away` by no more than `reach`: its value at 0 and its
/// slopes. `shares`: how much x counts in the time at top speed and in the ramps. `None` where a distance may be next to nothing.
fn plane(limits: &Limits, shares: [f64; 2], away: DVec2, reach: DVec2) -> Option<(f64, DVec2)> {
    let mixed = |per: DVec2, share: f64| per * DVec2::new(share, 1.0 - share);
    let slopes = [mixed(limits.per_speed, shares[0]), mixed(limits.per_accel, shares[1])];
    let [run, ramp2] = slopes.map(|slope| slope.dot(away));
    let [about, about2] = slopes.map(|slope| slope.dot(reach));
    let (least, least2) = (run - about, ramp2 - about2);
    if least < SHORTEST || least2 < SHORTEST * SHORTEST {
        return None;
    }
    // The seconds are run + ramp2 / run or, for short moves, 2 sqrt(ramp2). Within reach they are curved downwards by no more than this.
    let long = about * about2 / (least * least).max(least2);
    let short = 0.25 * about2 * about2 / (least2 * least2.sqrt());
    let curved = if ramp2 + about2 <= least * least {
        long
    } else if least2 >= (run + about) * (run + about) {
        short
    } else {
        long.max(short)
    };
    let (seconds, by) = limits.seconds(run, ramp2);
    let slope = by[0] * slopes[0] + by[1] * slopes[1];
    Some((seconds - curved - slope.dot(away), slope))
}

/// The largest loss at a corner.
fn loss(exact: &[[f64; 2]; 2], values: &[[f64; 2]; 2]) -> f64 {
    exact.iter().flatten().zip(values.iter().flatten()).map(|(e, v)| e - v).fold(0.0, f64::max)
}
