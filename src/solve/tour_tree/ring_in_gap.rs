//! A ring in a gap of the tour: most of the time of a search goes into pricing its places.

use super::boxes::BoundingBox;
use super::index::index;
use super::ring::GATES;
use super::travel::Travel;
use crate::geometry::DVec2;

/// A ring between two stops, for pricing many of its places.
pub(super) struct RingInGap<'s> {
    pub(super) travel: &'s Travel<'s>,
    pub(super) points: &'s [DVec2],
    /// Extra seconds by place; empty if no place has any.
    pub(super) extra: &'s [f64],
    /// Where the head comes from.
    pub(super) from: DVec2,
    /// Where it goes; nowhere from the last stop of a path without return.
    pub(super) to: Option<DVec2>,
}

impl RingInGap<'_> {
    /// A lower bound of the seconds of any place in a box.
    #[inline(always)]
    pub(super) fn at_least(&self, b: &BoundingBox) -> f64 {
        let there = self.travel.air(DVec2::ZERO, b.outside(self.from));
        match self.to {
            Some(to) => there + self.travel.air(DVec2::ZERO, b.outside(to)),
            None => there,
        }
    }

    /// Makes place `at` the best if it costs less, and returns whether it does.
    #[inline(always)]
    pub(super) fn try_at(&self, at: usize, best: &mut (u32, f64)) -> bool {
        let place = self.points[at];
        let mut seconds = self.travel.air(self.from, place);
        if let Some(to) = self.to {
            seconds += self.travel.air(place, to);
        }
        if let Some(extra) = self.extra.get(at) {
            seconds += extra;
        }
        let better = seconds < best.1;
        if better {
            *best = (index(at), seconds);
        }
        better
    }

    /// Looks for a better place near the best, by halving steps to both sides.
    pub(super) fn better_near(&self, best: &mut (u32, f64)) {
        // The number of places is a power of two.
        let count = self.points.len();
        let mut step = count / GATES / 2;
        while step >= 1 {
            let at = best.0 as usize;
            let (ahead, back) = ((at + step) & (count - 1), (at + count - step) & (count - 1));
            for at in [ahead, back] {
                if self.try_at(at, best) {
                    break;
                }
            }
            step /= 2;
        }
    }
}
