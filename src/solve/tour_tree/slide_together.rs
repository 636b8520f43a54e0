//! Exact entries of all stops together, after each has slid on its own.
//!
//! On a machine whose axes take different times, only the slower axis of a leg counts, so that its seconds have edges. A
//! stop at such an edge gains nothing by sliding alone, where it would gain with its neighbours. Here each stop has seven
//! places, its own and three at equal steps on each side, and a dynamic programme along the route takes the best of all
//! choices. The steps are halved where nothing is gained.

use super::config::CONFIG;
use super::slide::Slide;
use super::space::Space;
use crate::geometry::DVec2;

/// Places of a stop, in steps from its own, which is kept unless another is better. With two on each side the tour of
/// twelve circles ended 0.00005 s above the one with three, and four or five were no better.
const STEPS: [f64; 7] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0];

/// A place of a stop.
#[derive(Clone, Copy)]
struct Place {
    along: f64,
    entry: DVec2,
    exit: DVec2,
    /// Least seconds of the route up to the place, with what the run from it takes beyond the fixed seconds.
    seconds: f64,
    /// Which place of the stop before these seconds come from.
    before: usize,
}

/// Where a route begins, and whether it also ends there.
#[derive(Clone, Copy)]
pub(super) struct Base {
    pub(super) at: DVec2,
    pub(super) closed: bool,
}

/// Slides all stops of a route together until the steps are too short to matter.
pub(super) fn slide_together(space: &Space, base: Base, stops: &mut [Slide]) {
    let mut step = stops.iter().filter_map(Slide::reach).fold(0.0, f64::max);
    let mut best = f64::INFINITY;
    for _ in 0..CONFIG.entry.most_together / stops.len().max(1) {
        if step < CONFIG.entry.least_step {
            return;
        }
        let seconds = best_choice(space, base, stops, step);
        if seconds > best * (1.0 - CONFIG.entry.pass_least_gain) {
            step *= 0.5;
        }
        best = seconds;
    }
}

/// Moves each stop to its place in the best of all choices and returns the seconds of the route.
fn best_choice(space: &Space, base: Base, stops: &mut [Slide], step: f64) -> f64 {
    let start = Place { along: 0.0, entry: base.at, exit: base.at, seconds: 0.0, before: 0 };
    let mut reached = vec![vec![start]];
    for stop in stops.iter() {
        let mut places = places(stop, step);
        for place in &mut places {
            let (seconds, before) = arrival(space, reached.last(), Some(place.entry));
            (place.seconds, place.before) = (seconds + stop.extra(place.along), before);
        }
        reached.push(places);
    }
    let (seconds, mut at) = arrival(space, reached.last(), base.closed.then_some(base.at));
    for (stop, places) in stops.iter_mut().zip(reached.iter().skip(1)).rev() {
        let Some(place) = places.get(at) else { break };
        stop.go(place.along, place.entry);
        at = place.before;
    }
    seconds
}

/// Least seconds of the route up to a point from one of these places, or up to the best of them, and which it is: the first
/// of equals.
fn arrival(space: &Space, from: Option<&Vec<Place>>, to: Option<DVec2>) -> (f64, usize) {
    let mut least = (f64::INFINITY, 0);
    for (k, place) in from.into_iter().flatten().enumerate() {
        let seconds = place.seconds + to.map_or(0.0, |to| space.travel.air(place.exit, to));
        if seconds < least.0 {
            least = (seconds, k);
        }
    }
    least
}

/// The places of a stop: only its own where it does not slide.
fn places(stop: &Slide, step: f64) -> Vec<Place> {
    let own = Place { along: stop.stop.along, entry: stop.entry, exit: stop.exit, seconds: 0.0, before: 0 };
    let Some(reach) = stop.reach() else { return vec![own] };
    let near = STEPS.iter().filter_map(|steps| stop.at(own.along + steps * step.min(reach)));
    near.map(|(along, entry)| Place { along, entry, exit: entry, ..own }).collect()
}
