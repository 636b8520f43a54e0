//! What a stop costs beyond the cheapest one of its item: the head brakes and speeds up again there, except in a corner, where it is slow
//! anyway.
//!
//! A stop has two legs, one that comes and one that goes, and each of them pays half. Between two knots the seconds are replaced by a straight
//! function below them, as those of legs are (`minorant.rs`), so that the sum of both is least at knots, too.

use crate::machine::ClosedRun;

/// The extra seconds of stops along a track.
#[derive(Clone, Debug)]
pub(super) struct Extras {
    run: ClosedRun,
    kinks: Vec<f64>,
}

impl Extras {
    pub(super) fn new(run: &ClosedRun) -> Self {
        Self { kinks: run.kinks(), run: run.clone() }
    }

    /// Half of the extra seconds of a stop at an arc length.
    pub(super) fn half(&self, along: f64) -> f64 {
        0.5 * self.run.extra(along)
    }

    /// The values at its ends of a straight function that is nowhere above [`Extras::half`] between two arc lengths. `to` may be beyond the end
    /// of a track of this `length`, by a lap at most.
    pub(super) fn below(&self, from: f64, to: f64, length: f64) -> [f64; 2] {
        let ends = [from, to].map(|s| self.half(self.run.on_path(s)));
        let between = [0.0, length].into_iter().flat_map(|lap| {
            let at = |s: f64| self.kinks.partition_point(|&kink| kink < s - lap);
            self.kinks[at(from)..at(to).max(at(from))].iter().map(move |kink| (kink + lap, *kink))
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
