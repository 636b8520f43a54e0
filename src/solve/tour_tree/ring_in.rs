//! A ring between two stops.

use super::boxes::Boxed;
use super::index::index;
use super::ring::GATES;
use super::travel::Gap;
use super::travel::{Place, Travel};
use crate::geometry::DVec2;

/// A ring between two stops, for pricing many of its places: where most of the time of a search goes.
pub(super) struct RingIn<'s> {
    pub(super) travel: &'s Travel<'s>,
    pub(super) places: &'s [Place],
    /// Seconds on top by place; empty where there are none.
    pub(super) extra: &'s [f64],
    pub(super) gap: Gap,
}

impl RingIn<'_> {
    /// No place in a box takes less.
    #[inline(always)]
    pub(super) fn at_least(&self, b: &Boxed) -> f64 {
        let there = self.travel.seconds_here(DVec2::ZERO, b.outside(self.gap.from));
        match self.gap.to {
            Some(to) => there + self.travel.seconds_here(DVec2::ZERO, b.outside(to)),
            None => there,
        }
    }

    /// Takes place `at` over, if it costs less.
    #[inline(always)]
    pub(super) fn try_at(&self, at: usize, best: &mut (u32, f64)) -> bool {
        let place = self.places[at];
        let mut seconds = self.travel.seconds_here(self.gap.from, place);
        if let Some(to) = self.gap.to {
            seconds += self.travel.seconds_here(place, to);
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

    /// Halving steps to both sides.
    pub(super) fn better_near(&self, best: &mut (u32, f64)) {
        // A power of two.
        let count = self.places.len();
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
