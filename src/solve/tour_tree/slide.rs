//! A stop that slides along its track to where its two legs and its extra seconds cost least together.
//!
//! Between two corners the sum of both legs has one minimum within the spacing of a ring, because air time grows with
//! distance; a golden section search on each element near the place finds it. The extra seconds of the run are priced
//! exactly at each point that is tried.

use super::config::CONFIG;
use super::space::Space;
use crate::geometry::{DVec2, Path, Segment};
use crate::problem::{Item, LeavePoint};
use crate::solve::Stop;

/// The inverse of the golden ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

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
            space.travel.air(from, p) + on + self.extra(along)
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
        self.go(best.1, best.2);
    }

    /// Puts the stop at a point of its track.
    pub(super) fn go(&mut self, along: f64, entry: DVec2) {
        if self.track.is_none() {
            return;
        }
        (self.stop.along, self.stop.until) = (along, along);
        (self.entry, self.exit) = (entry, entry);
    }

    /// How far the stop may slide to both sides, mm; none where it does not slide.
    pub(super) fn reach(&self) -> Option<f64> {
        self.track.as_ref().map(|(_, _, reach)| *reach)
    }

    /// Seconds that a run from a place takes beyond the fixed ones.
    pub(super) fn extra(&self, along: f64) -> f64 {
        self.item.extra(self.stop.node, along)
    }

    /// The point of the track after `along` mm, which may be before its start or past its end.
    pub(super) fn at(&self, along: f64) -> Option<(f64, DVec2)> {
        let (track, starts, _) = self.track.as_ref()?;
        let along = along.rem_euclid(*starts.last()?);
        let k = starts.partition_point(|&s| s <= along).saturating_sub(1).min(track.segments.len() - 1);
        let (g, from) = (track.segments.get(k)?, starts.get(k)?);
        Some((along, g.at((along - from) / g.length().max(f64::MIN_POSITIVE))))
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
