//! The ring of places along a closed contour, and what each place costs beyond the fixed seconds of the item.
//!
//! A ring has [`GATES`] * 2^k places. They are evenly spaced, except that where the seconds of the run depend on the place
//! of entry, the place nearest to a corner is put exactly on it: the beam is slow there anyway, which saves up to a whole
//! stop, and on a machine that reaches its speed within a fraction of a millimetre a place beside the corner saves nothing.

use super::config::CONFIG;
use super::index::index;
use crate::geometry::{DVec2, Path, Segment};
use crate::problem::Item;

/// Coarse places of a ring, each with its own neighbour list: enough to tell the sides of a contour apart. A power of two.
pub(super) const GATES: usize = 16;

/// Places in order around a closed contour.
pub(super) struct Ring<'p> {
    item: &'p Item,
    track: &'p Path,
    /// Number of places.
    pub(super) count: usize,
    /// Distance of places, mm; neighbours that were put on corners may be up to twice as far apart.
    pub(super) spacing: f64,
}

/// The places of a ring with their extra seconds.
pub(super) struct Prices {
    /// Arc length of each place from the track's start, mm.
    pub(super) along: Vec<f64>,
    /// Extra seconds by place.
    pub(super) extra: Vec<f64>,
    /// Places that cost less than both their neighbours; of those between two gates, the cheapest.
    pub(super) corners: Vec<u32>,
}

impl<'p> Ring<'p> {
    /// The ring of an item; `None` unless it has a closed track with a length.
    pub(super) fn new(item: &'p Item) -> Option<Self> {
        let track = item.track.as_ref().filter(|t| t.closed)?;
        let length: f64 = track.segments.iter().map(Segment::length).sum();
        if length <= 0.0 || !length.is_finite() {
            return None;
        }
        let mut count = GATES;
        while count < CONFIG.entry.most_places && length > CONFIG.entry.spacing * count as f64 {
            count *= 2;
        }
        Some(Self { item, track, count, spacing: length / count as f64 })
    }

    /// The points of the places in order, at the arc lengths of `prices` or else evenly spaced.
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

    /// Puts places on corners and prices each place.
    pub(super) fn prices(&self) -> Prices {
        let mut along: Vec<f64> = (0..self.count).map(|k| self.spacing * k as f64).collect();
        let Some(run) = self.item.uneven() else {
            return Prices { extra: vec![0.0; along.len()], along, corners: Vec::new() };
        };
        // The slowest joint of the stretch around each place: no other joint there can cost less than the place.
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

/// The nearest whole number of a value that is not negative.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast from float saturates")]
pub(super) fn nearest(x: f64) -> usize {
    x.round() as usize
}
