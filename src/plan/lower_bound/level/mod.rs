//! The best entries of a known order on a machine whose axes have limits of their own, and how much each axis counts in its legs.
//!
//! The air time is that of the slower axis. In a good path many legs are balanced: both axes take the same, so that no stop gains by a step along its
//! contour. A straight function below the seconds of such a leg is a mixture of both axes (`minorant.rs`). The one that lies closest to this leg alone
//! may slope where the path as a whole is level. The right mixtures are those of the dual solution: with them, no stop of the best path gains
//! to first order, so that what is lost shrinks with the square of the length of pieces.
//!
//! They are found by smoothing. "The greater of two" is replaced by a soft maximum at a temperature that falls, and the stops move along their contours by
//! Newton's method (`descent.rs`). Where they come to rest, the weights of the soft maximum are the mixtures.

mod choice;
mod descent;
mod soft;
mod stop;

use super::known_path::Entry;
use super::mixtures::Mixtures;
use super::rounds::legs;
use super::walks::{Ground, Visit};
use descent::Line;
use stop::Stop;

/// The first temperature, s: entries are already good, and a higher one would lead to other ones.
const HOT: f64 = 1e-6;
/// The last temperature, s. What balanced legs differ by is about this.
const COLD: f64 = 1e-10;
/// What becomes of the temperature in each round.
const COOLING: f64 = 0.3;

/// A path with its best entries.
#[derive(Debug)]
pub(super) struct Level {
    /// Its travel, s.
    pub(super) seconds: f64,
    /// How much each axis counts in its legs.
    pub(super) mixtures: Mixtures,
    /// Its stops.
    pub(super) entries: Vec<Entry>,
}

/// Finds the best entries of a path near the knots of a walk. `None` on machines whose air time depends on distances alone.
pub(super) fn level(ground: &Ground, walk: &[Visit]) -> Option<Level> {
    let limits = ground.prices.minorant.limits?;
    let legs = legs(walk, ground);
    // An open path ends at its last stop, and the leg to its end costs nothing.
    let legs = if ground.first == 1 { &legs[..] } else { legs.split_last()?.1 };
    let first = legs.first()?[0];
    let mut stops = vec![Stop::new(&ground.items[first.item], [first.knot; 2])];
    for (k, [_, arrival]) in legs.iter().enumerate() {
        let leaves = legs.get(k + 1).map_or(*arrival, |next| next[0]);
        stops.push(Stop::new(&ground.items[arrival.item], [arrival.knot, leaves.knot]));
    }
    let air = ground.prices.minorant.air();
    choice::choose(&mut stops, air);
    let mut line = Line { limits, stops, temperature: HOT };
    line.descend();
    while line.temperature > COLD {
        line.temperature *= COOLING;
        line.descend();
    }
    let mut mixtures = Mixtures::default();
    for ([from, to], way) in legs.iter().zip(line.ways()) {
        mixtures.add([from.item, to.item], soft::leg(&limits, way, line.temperature).mixture);
    }
    let of_legs: f64 = line.stops.windows(2).map(|s| air.seconds(s[0].places()[1], s[1].places()[0])).sum();
    let entry = |(visit, stop): (&Visit, &Stop)| Entry {
        contour: visit.item - ground.first,
        along: stop.along(),
        places: stop.places(),
    };
    // The first stop is home.
    let entries = walk.iter().zip(&line.stops[1..]).map(entry).collect();
    Some(Level { seconds: of_legs + line.extra(), mixtures, entries })
}
