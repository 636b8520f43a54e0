//! Entries that are nearly the best ones, from those of a walk, whose knots may be far apart: each stop has seven places, and a dynamic programme along
//! the path takes the best of all choices. Steps are halved in each round.

use super::stop::{Place, Stop};
use crate::machine::AirTime;

/// The first step, as a share of the contour, so that three steps to both sides come nearly around it; the last one is a millionth of it.
const FIRST: f64 = 1.0 / 8.0;
const ROUNDS: usize = 18;
/// Places of a stop, in steps from its own.
const STEPS: [f64; 7] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0];

/// Slides all stops to places that are good for all of them.
pub(super) fn choose(stops: &mut [Stop], air: &AirTime) {
    let mut step = FIRST;
    for _ in 0..ROUNDS {
        round(stops, air, step);
        step *= 0.5;
    }
}

/// A place, the least seconds up to it, and which place of the stop before it is best.
type Reached = (Place, f64, usize);

fn round(stops: &mut [Stop], air: &AirTime, step: f64) {
    let mut all: Vec<Vec<Reached>> = Vec::with_capacity(stops.len());
    for stop in stops.iter() {
        let reach = |place: Place| {
            let (seconds, before) = all.last().map_or((0.0, 0), |from| arrival(from, &place, air));
            (place, seconds + place.extra, before)
        };
        let reached = stop.places_beside(&STEPS.map(|steps| step * steps)).into_iter().map(reach).collect();
        all.push(reached);
    }
    let last = all.last().into_iter().flatten().enumerate().min_by(|a, b| a.1.1.total_cmp(&b.1.1));
    let mut best = last.map_or(0, |(k, _)| k);
    for (stop, places) in stops.iter_mut().zip(&all).rev() {
        let (place, _, before) = places[best];
        stop.put(place.along);
        best = before;
    }
}

/// The least seconds up to a place, and from which of the places before it.
fn arrival(from: &[Reached], to: &Place, air: &AirTime) -> (f64, usize) {
    let seconds = from.iter().map(|(place, seconds, _)| seconds + air.seconds(place.leaves, to.arrives));
    let least = seconds.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    least.map_or((f64::INFINITY, 0), |(k, seconds)| (seconds, k))
}
