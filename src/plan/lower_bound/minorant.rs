//! Linear lower bounds of the seconds between two pieces.
//!
//! Air time f is a function of the displacement x between two points. On the displacements that occur between two pieces it
//! is at least a0 + e . x for suitable a0 and e:
//! * a lifted head only adds to it, and the chords below are those with the head down;
//! * by distance (`vector`): seconds over a distance are concave, so on an interval of distances they lie above their
//!   chord, and a distance |x| is at least u . x for any unit vector u;
//! * by axis: the slower axis alone is no more than all of it, and |x| >= +-x. A straight move takes at least as long
//!   as the same move with each axis on its own.
//!
//! The sum of such a bound and of charges that change linearly along both pieces is linear in both points, so that its
//! minimum is at ends of pieces: the knots. So the continuous problem has a table of numbers between knots, each the minimum
//! of a0 + e . x over the pieces that meet there. The loss shrinks with the square of the lengths of the pieces.

use super::net::Piece;
use crate::geometry::DVec2;
use crate::machine::{AirTime, Profile, Travel};

/// Prices pairs of pieces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minorant {
    air: AirTime,
    head_down: AirTime,
    by_distance: bool,
}

impl Minorant {
    pub(super) fn new(machine: &Profile) -> Self {
        Self {
            air: AirTime::new(machine),
            head_down: AirTime::head_down(machine),
            by_distance: machine.travel == Travel::Vector,
        }
    }

    pub(super) fn air(&self) -> &AirTime {
        &self.air
    }

    /// Lower bounds of the seconds from the ends of `p` to the ends of `q`, as `[p end][q end]`, such that the seconds
    /// between inner points are at least the linear interpolation of these numbers.
    pub(super) fn corners(&self, p: &Piece, q: &Piece) -> [[f64; 2]; 2] {
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

/// The largest loss at a corner.
fn loss(exact: &[[f64; 2]; 2], values: &[[f64; 2]; 2]) -> f64 {
    exact.iter().flatten().zip(values.iter().flatten()).map(|(e, v)| e - v).fold(0.0, f64::max)
}
