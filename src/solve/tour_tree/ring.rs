//! The ring of places along a closed contour, with what the run costs on top by place.
//!
//! [`GATES`] * 2^k places, at most [`SPACING`] apart. They are evenly spaced, but where the run has a price by place of
//! entry the place nearest to a corner is put on it: being slow there anyway saves up to a whole stop, and a
//! fraction of a millimetre beside the corner, on a machine that takes no more than that to reach its speed, saves
//! nothing any more.

use super::index::index;
use crate::geometry::{DVec2, Path, Segment};
use crate::problem::Item;

/// Coarse places of a ring: as many as tell its sides apart; neighbour lists are kept for each.
pub(super) const GATES: usize = 16;
/// Largest distance of places on a ring, mm: half of it, seen across a gap of 5 mm, is 0.3 % of the gap.
const SPACING: f64 = 0.8;
/// Most places of one ring: more is slower where large parts lie close together, and finds nothing shorter.
const MOST: usize = 2048;

/// Places in order around a closed contour.
pub(super) struct Ring<'p> {
    item: &'p Item,
    track: &'p Path,
    /// How many there are.
    pub(super) count: usize,
    /// Distance of places, mm; of two neighbours up to twice that where they were put on corners.
    pub(super) spacing: f64,
}

/// What places of a ring cost on top.
pub(super) struct Prices {
    /// Arc length of each from the track's start, mm.
    pub(super) along: Vec<f64>,
    /// Seconds on top by place.
    pub(super) extra: Vec<f64>,
    /// Places that cost less than both their neighbours, the cheapest between each two gates.
    pub(super) corners: Vec<u32>,
}

impl<'p> Ring<'p> {
    /// The ring of an item; none where it has no closed track with a length.
    pub(super) fn new(item: &'p Item) -> Option<Self> {
        let track = item.track.as_ref().filter(|t| t.closed)?;
        let length: f64 = track.segments.iter().map(Segment::length).sum();
        if length <= 0.0 || !length.is_finite() {
            return None;
        }
        let mut count = GATES;
        while count < MOST && length > SPACING * count as f64 {
            count *= 2;
        }
        Some(Self { item, track, count, spacing: length / count as f64 })
    }

    /// The places; where along the track each of them is, in order, from the prices or from here.
    pub(super) fn points(&self, prices: Option<&Prices>) -> impl Iterator<Item = DVec2> {
        let lengths: Vec<f64> = self.track.segments.iter().map(Segment::length).collect();
        let (mut element, mut before) = (0, 0.0);
        (0..self.count).map(move |k| {
            let at = prices.map_or(self.spacing * k as f64, |p| p.along[k]);
            while element + 1 < lengths.len() && before + lengths[element] < at {
                before += lengths[element];
                element += 1;
            }
            let f = if lengths[element] > 0.0 { (at - before) / lengths[element] } else { 0.0 };
            self.track.segments[element].at(f)
        })
    }

    /// Puts places on corners and gives the price of each place.
    pub(super) fn prices(&self) -> Prices {
        let mut along: Vec<f64> = (0..self.count).map(|k| self.spacing * k as f64).collect();
        let Some(run) = self.item.uneven() else {
            return Prices { extra: vec![0.0; along.len()], along, corners: Vec::new() };
        };
        // The slowest joint of the stretch around each place: the only one that may be worth more than the place.
        let mut slowest = vec![(f64::INFINITY, 0.0); along.len()];
        for (joint, speed2) in run.joints() {
            let k = nearest(joint / self.spacing).min(along.len() - 1);
            if speed2 < slowest[k].0 {
                slowest[k] = (speed2, joint);
            }
        }
        let price = |(at, (speed2, joint)): (&mut f64, (f64, f64))| {
            let here = run.extra(*at);
            let there = if speed2.is_finite() { run.extra(joint) } else { here };
            if there < here {
                *at = joint;
            }
            there.min(here)
        };
        let extra: Vec<f64> = along.iter_mut().zip(slowest).map(price).collect();
        let corners = corners(&extra);
        Prices { along, extra, corners }
    }
}

fn corners(extra: &[f64]) -> Vec<u32> {
    let n = extra.len();
    let is_corner = |k: &usize| extra[*k] < extra[(k + 1) % n] && extra[*k] < extra[(k + n - 1) % n];
    let sector = (n / GATES).max(1);
    (0..n)
        .step_by(sector)
        .filter_map(|from| {
            (from..from + sector).filter(is_corner).min_by(|&a, &b| extra[a].total_cmp(&extra[b]))
        })
        .map(index)
        .collect()
}

/// The nearest whole number; places along tracks are small and not negative.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast from float saturates")]
pub(super) fn nearest(x: f64) -> usize {
    x.round() as usize
}
