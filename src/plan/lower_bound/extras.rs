//! What a stop costs beyond the cheapest one of its item: the head brakes and speeds up again there, except in a corner, where it is slow
//! anyway.
//!
//! A stop has two legs, one that comes and one that goes, and each of them pays half. Between two knots the seconds are replaced by a straight
//! function below them, as those of legs are (`minorant.rs`), so that the sum of both is least at knots, too.

use crate::machine::ClosedRun;
use crate::problem::Item;

/// The core wasm does without them, as without cuts (`charges.rs`): they would cost a first visit 3 kB.
pub(super) const HAS_EXTRAS: bool = cfg!(feature = "research");

/// Whether the extra seconds of an item's stops are part of its legs. Stops of a contour that is left share what they cost, and those of pierce
/// groups have seconds of their own.
pub(super) fn counts_extras(item: &Item) -> bool {
    HAS_EXTRAS && !item.may_be_left() && !item.is_pierce_group()
}

/// A run whose stops differ, and its kinks.
type Uneven = (ClosedRun, Vec<f64>);

/// The extra seconds of stops along a track; nothing where they do not differ.
#[derive(Clone, Debug)]
pub(super) struct Extras(#[cfg(feature = "research")] Option<Box<Uneven>>);

impl Extras {
    #[cfg(feature = "research")]
    pub(super) fn new(item: &Item) -> Self {
        let run = item.uneven().filter(|_| counts_extras(item));
        Self(run.map(|run| Box::new((run.clone(), run.kinks()))))
    }

    #[cfg(not(feature = "research"))]
    pub(super) fn new(_: &Item) -> Self {
        Self()
    }

    fn uneven(&self) -> Option<&Uneven> {
        #[cfg(feature = "research")]
        return self.0.as_deref();
        #[cfg(not(feature = "research"))]
        None
    }

    /// Half of the extra seconds of a stop at an arc length.
    pub(super) fn half(&self, along: f64) -> f64 {
        self.uneven().map_or(0.0, |(run, _)| 0.5 * run.extra(along))
    }

    /// Where the extra seconds may not be concave, see [`ClosedRun::kinks`].
    #[cfg(feature = "research")]
    pub(super) fn kinks(&self) -> &[f64] {
        self.uneven().map_or(&[], |(_, kinks)| kinks)
    }

    /// The values at its ends of a straight function that is nowhere above [`Extras::half`] between two arc lengths. `to` may be beyond the end
    /// of a track of this `length`, by a lap at most.
    pub(super) fn below(&self, from: f64, to: f64, length: f64) -> [f64; 2] {
        let Some((run, kinks)) = self.uneven() else { return [0.0; 2] };
        let ends = [from, to].map(|s| self.half(run.on_path(s)));
        let between = [0.0, length].into_iter().flat_map(|lap| {
            let at = |s: f64| kinks.partition_point(|&kink| kink < s - lap);
            kinks[at(from)..at(to)].iter().map(move |kink| (kink + lap, *kink))
        });
        // It is above its chords between kinks, so that the chord of the whole need only be lowered to the kinks.
        let above = |(along, kink): (f64, f64)| {
            ends[0] + (ends[1] - ends[0]) * ((along - from) / (to - from)) - self.half(kink)
        };
        let lower = between.map(above).fold(0.0, f64::max);
        let ends = ends.map(|seconds| seconds - lower);
        // No stop has less than none.
        if ends.iter().any(|&seconds| seconds < 0.0) { [0.0; 2] } else { ends }
    }
}
