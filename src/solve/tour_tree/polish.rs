//! Exact entries: each stop slides along its track to where its two legs and its extra seconds cost least together.
//!
//! All stops slide in rounds until a round gains nothing worth while. Between two corners the sum of both legs has one
//! minimum within the spacing of a ring, because air time grows with distance; a golden section search on each element
//! near the place finds it. The extra seconds of the run are priced exactly at each point that is tried.

use super::config::CONFIG;
use super::snapshot::TourSnapshot;
use super::space::Space;
use super::tour::Tour;
use crate::geometry::{DVec2, Path, Segment};
use crate::problem::{Item, LeavePoint};
use crate::solve::{Solution, Stop};

/// The inverse of the golden ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The solution of a tour, with entries at its places.
pub(super) fn unpolished(tour: &Tour, snapshot: &TourSnapshot) -> Solution {
    Solution::new(tour.space.problem, stops(tour, snapshot))
}

/// The stops of a tour, with entries at its places.
pub(super) fn stops(tour: &Tour, snapshot: &TourSnapshot) -> Vec<Stop> {
    // Home is a stop only where it is an item of the problem.
    let first = usize::from(tour.space.problem.table().is_none());
    snapshot.order[first..].iter().map(|&item| tour.space.stop(item, snapshot.at[item as usize])).collect()
}

/// The solution of a tour, with exact entries.
pub(super) fn polished(tour: &Tour, snapshot: &TourSnapshot) -> Solution {
    let space = &tour.space;
    if space.travel.by_table() {
        return unpolished(tour, snapshot);
    }
    let mut stops: Vec<Slide> =
        snapshot.order[1..].iter().map(|&item| Slide::new(space, item, snapshot.at[item as usize])).collect();
    let mut cost = f64::INFINITY;
    for _ in 0..CONFIG.entry.slide_rounds {
        for k in 0..stops.len() {
            let from = if k == 0 { space.problem.home } else { stops[k - 1].exit };
            let to = match stops.get(k + 1) {
                Some(next) => Some(next.entry),
                None => space.problem.closed.then_some(space.problem.home),
            };
            stops[k].slide(space, from, to);
        }
        let now = Solution::new(space.problem, stops.iter().map(|s| s.stop).collect()).cost;
        if now > cost * (1.0 - CONFIG.entry.slide_least_gain) {
            break;
        }
        cost = now;
    }
    Solution::new(space.problem, stops.iter().map(|s| s.stop).collect())
}

/// A stop that slides.
#[derive(Clone)]
pub(super) struct Slide<'p> {
    pub(super) stop: Stop,
    pub(super) entry: DVec2,
    pub(super) exit: DVec2,
    item: &'p Item,
    /// Track, arc lengths of the ends of its elements, and how far to look on both sides, mm.
    track: Option<(&'p Path, Vec<f64>, f64)>,
}

impl<'p> Slide<'p> {
    pub(super) fn new(space: &Space<'p>, item: u32, at: u32) -> Self {
        let (entry, exit) = (space.places(item).at(at).point, space.exit(item, at).point);
        let it = &space.problem.items[item as usize];
        let track = it.track.as_ref().filter(|_| space.is_ring(item));
        let track = track.map(|track| {
            let mut starts = vec![0.0];
            for g in &track.segments {
                starts.push(starts[starts.len() - 1] + g.length());
            }
            (track, starts, space.reach(item))
        });
        Self { stop: space.stop(item, at), entry, exit, item: it, track }
    }

    /// A place where a pierce group is left, which does not slide.
    pub(super) fn fixed(space: &Space<'p>, item: u32, place: &LeavePoint) -> Self {
        let it = &space.problem.items[item as usize];
        let stop = Stop::whole(it.nodes.start, place.along);
        let [exit, entry] = place.ends;
        Self { stop, entry, exit, item: it, track: None }
    }

    /// Moves the stop to the best point between the places next to its own; the head comes from `from` and goes `to`.
    pub(super) fn slide(&mut self, space: &Space, from: DVec2, to: Option<DVec2>) {
        let Some((track, starts, reach)) = &self.track else { return };
        let price = |along: f64, p: DVec2| {
            let on = to.map_or(0.0, |to| space.travel.air(p, to));
            space.travel.air(from, p) + on + self.item.extra(self.stop.node, along)
        };
        let length = starts[starts.len() - 1];
        let mut best = (price(self.stop.along, self.entry), self.stop.along, self.entry);
        let (low, high) = (self.stop.along - reach, self.stop.along + reach);
        // The window may extend past either end of the track.
        for shift in [-length, 0.0, length] {
            let (low, high) = ((low + shift).max(0.0), (high + shift).min(length));
            let first = starts.partition_point(|&s| s <= low).saturating_sub(1);
            for (g, span) in track.segments.iter().zip(starts.windows(2)).skip(first) {
                let (low, high) = (low.max(span[0]), high.min(span[1]));
                if low > high {
                    break;
                }
                for (along, p) in least(g, span, low, high, &price) {
                    let seconds = price(along, p);
                    if seconds < best.0 {
                        best = (seconds, along, p);
                    }
                }
            }
        }
        (_, self.stop.along, self.entry) = best;
        self.stop.until = self.stop.along;
        self.exit = self.entry;
    }
}

/// Candidates for the least price on one element between two arc lengths: both ends and the result of the golden section
/// search.
fn least(
    g: &Segment,
    span: &[f64],
    low: f64,
    high: f64,
    price: &impl Fn(f64, DVec2) -> f64,
) -> [(f64, DVec2); 3] {
    let length = (span[1] - span[0]).max(f64::MIN_POSITIVE);
    let point = |along: f64| g.at((along - span[0]) / length);
    let (mut a, mut b) = (low, high);
    let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_c, mut at_d) = (price(c, point(c)), price(d, point(d)));
    for _ in 0..CONFIG.entry.golden_steps {
        if at_c < at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - GOLDEN * (b - a);
            at_c = price(c, point(c));
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + GOLDEN * (b - a);
            at_d = price(d, point(d));
        }
    }
    let middle = 0.5 * (a + b);
    [low, middle, high].map(|along| (along, point(along)))
}
