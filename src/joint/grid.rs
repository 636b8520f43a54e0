//! The places of the joints of a contour.
//!
//! Places are tried on a grid along the contour. For each of several beginnings, evenly spaced places are
//! moved to the nearest place with room; the beginning with the shortest longest stretch is taken. Then joints are added
//! where a stretch is still too long or joints are missing, as long as there is room.

use super::outcome::Outcome;
use super::room::Room;
use crate::machine::JointRule;
use crate::order::{real, sort_by};

/// Places of the grid in the length of a joint, and the largest number of places on a contour.
const FINE: f64 = 2.0;
const MOST_PLACES: f64 = 4096.0;
/// Number of beginnings that are tried for evenly spaced joints.
const BEGINNINGS: u32 = 12;
/// A stretch between joints is at least this long, in lengths of a joint.
const LEAST_STRETCH: f64 = 2.0;
/// Rounding of lengths, mm.
const SLACK: f64 = 1e-6;

/// The places that are tried on a contour, and what is known of them.
pub(super) struct Grid<'a> {
    pub(super) room: Room<'a>,
    /// Distance of the places, mm.
    step: f64,
    /// By place: whether there is room, if that is known.
    known: Vec<Option<bool>>,
}

impl<'a> Grid<'a> {
    pub(super) fn new(room: Room<'a>) -> Self {
        let count = (FINE * room.whole / room.gap).ceil().clamp(16.0, MOST_PLACES);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most MOST_PLACES")]
        let known = vec![None; count as usize];
        Self { step: room.whole / count, known, room }
    }

    fn at(&self, place: usize) -> f64 {
        (place as f64 + 0.5) * self.step
    }

    /// The place nearest to `at` mm.
    fn place(&self, at: f64) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the contour")]
        let place = (at.rem_euclid(self.room.whole) / self.step) as usize;
        place.min(self.known.len() - 1)
    }

    fn has_room(&mut self, place: usize) -> bool {
        let at = self.at(place);
        let room = &self.room;
        *self.known[place].get_or_insert_with(|| room.is_off_corners(at) && room.is_off_others(at))
    }

    /// The place with room that is nearest to `at` mm, at most `most` mm away.
    fn nearest(&mut self, at: f64, most: f64) -> Option<usize> {
        let (count, first) = (self.known.len(), self.place(at));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most MOST_PLACES")]
        let reach = (most / self.step).ceil().min(count as f64 * 0.5) as usize;
        (0..=reach).find_map(|k| {
            let both = [(first + k) % count, (first + count - k) % count];
            both.into_iter().find(|&place| self.has_room(place))
        })
    }

    /// A place with room near `at`, about `most` mm away at most. On a very long contour the places of the grid are far apart,
    /// so that it is looked for in steps of half a joint as well.
    fn near(&mut self, at: f64, most: f64) -> Option<f64> {
        let (whole, step) = (self.room.whole, self.room.gap / FINE);
        let on_grid = self.nearest(at, most).map(|place| self.at(place));
        on_grid.filter(|&place| self.room.apart(place, at) <= most + self.room.gap).or_else(|| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "clearance is limited"
            )]
            let steps = (most / step).ceil() as u32;
            let both = |k| [f64::from(k) * step, -f64::from(k) * step];
            let aside = (1..=steps).flat_map(both).map(|by| (at + by).rem_euclid(whole));
            aside.into_iter().find(|&place| self.room.is_off_corners(place) && self.room.is_off_others(place))
        })
    }

    /// Whether a joint keeps its distance from others. A joint alone has the rest of the contour as its stretch.
    fn is_apart(&self, at: f64, others: &[f64]) -> bool {
        let least = (1.0 + LEAST_STRETCH) * self.room.gap - SLACK;
        self.room.whole >= least && others.iter().all(|&o| self.room.apart(at, o) >= least)
    }

    /// Lengths between neighbouring joints, each with the place of the joint before it; `places` are in order.
    fn stretches<'p>(&'p self, places: &'p [f64]) -> impl Iterator<Item = (f64, f64)> + 'p {
        let next = places.iter().cycle().skip(1);
        places.iter().zip(next).map(|(&a, &b)| {
            let ahead = (b - a).rem_euclid(self.room.whole);
            (a, if ahead > 0.0 { ahead } else { self.room.whole } - self.room.gap)
        })
    }

    /// Evenly spread joints by a rule, in order.
    pub(super) fn spread(&mut self, rule: &JointRule, outcome: &mut Outcome) -> Vec<f64> {
        let Room { whole, gap, .. } = self.room;
        let spacing = rule.spacing.unwrap_or(f64::INFINITY);
        let by_spacing = (whole / (spacing + gap)).ceil();
        // No more than half of a contour stays uncut, whatever is asked for.
        let most = (whole / (gap * (1.0 + LEAST_STRETCH))).floor();
        let wanted = f64::from(rule.count).max(by_spacing).max(1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most the grid's places"
        )]
        let count = wanted.min(most) as u32;
        let mut best: (f64, Vec<f64>) = (f64::INFINITY, Vec::new());
        for beginning in 0..BEGINNINGS {
            let pitch = whole / f64::from(count.max(1));
            let offset = pitch * (f64::from(beginning) + 0.5) / f64::from(BEGINNINGS);
            let mut places: Vec<f64> = Vec::new();
            for k in 0..count {
                let wished = offset + pitch * f64::from(k);
                if let Some(place) = self.nearest(wished, 0.5 * pitch) {
                    let at = self.at(place);
                    if self.is_apart(at, &places) {
                        places.push(at);
                    }
                }
            }
            sort_by(&mut places, |&a| [real(a), 0, 0]);
            let longest = self.stretches(&places).map(|s| s.1).fold(0.0, f64::max);
            let fewer = f64::from(count) - places.len() as f64;
            let score = if places.is_empty() { f64::INFINITY } else { longest + fewer * whole };
            // Beginnings that differ by rounding only are the same.
            if score < best.0 - SLACK || best.1.is_empty() {
                best = (score, places);
            }
        }
        let mut places = best.1;
        self.fill(&mut places, rule.count.max(1), spacing);
        let longest = self.stretches(&places).map(|s| s.1).fold(0.0, f64::max);
        outcome.too_long = (longest > spacing + SLACK).then_some([longest, spacing]);
        outcome.found = u32::try_from(places.len()).unwrap_or(u32::MAX);
        outcome.wanted = rule.count.max(1);
        places
    }

    /// Adds joints in the longest stretches while there are fewer than `least` or a stretch is longer than `spacing`.
    fn fill(&mut self, places: &mut Vec<f64>, least: u32, spacing: f64) {
        while places.len() < self.known.len() {
            let missing = (places.len() as f64) < f64::from(least);
            let whole = self.room.whole;
            let mut longest: Vec<(f64, f64)> = match places.as_slice() {
                [] => vec![(0.0, whole)],
                some => self.stretches(some).filter(|s| missing || s.1 > spacing + SLACK).collect(),
            };
            sort_by(&mut longest, |s| [real(-s.1), real(s.0), 0]);
            let half_gap = 0.5 * self.room.gap;
            let added =
                longest.into_iter().find_map(|(from, length)| self.between(from + half_gap, length, places));
            let Some(at) = added else { return };
            places.push(at);
            sort_by(places, |&a| [real(a), 0, 0]);
        }
    }

    /// The place with room for one more joint that is nearest to the middle of a stretch.
    fn between(&mut self, from: f64, length: f64, others: &[f64]) -> Option<f64> {
        let (count, first) = (self.known.len(), self.place(from + 0.5 * length));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most the grid's places"
        )]
        let reach = (0.5 * length / self.step).ceil() as usize;
        (0..=reach.min(count / 2)).find_map(|k| {
            let both = [(first + k) % count, (first + count - k) % count];
            let mut fits = |&place: &usize| self.is_apart(self.at(place), others) && self.has_room(place);
            both.into_iter().find(|p| fits(p)).map(|place| self.at(place))
        })
    }

    /// Joints at the places of a person, moved out of corners where necessary, in order.
    pub(super) fn by_hand(&mut self, wished: &[f64], outcome: &mut Outcome) -> Vec<f64> {
        let mut places: Vec<f64> = Vec::new();
        let most = self.room.clearance + 2.0 * self.room.gap;
        for &at in wished {
            let point = self.room.path.at(at.rem_euclid(self.room.whole)).unwrap_or_default();
            let exact = self.room.is_off_corners(at) && self.room.is_off_others(at);
            let place = if exact { Some(at) } else { self.near(at, most) };
            match place.filter(|&at| self.is_apart(at, &places)) {
                Some(found) => {
                    places.push(found);
                    let by = self.room.apart(found, at);
                    if by > SLACK {
                        outcome.moved.push((point, by));
                    }
                }
                None => outcome.left_out.push(point),
            }
        }
        sort_by(&mut places, |&a| [real(a), 0, 0]);
        outcome.wanted = u32::try_from(wished.len()).unwrap_or(u32::MAX);
        outcome.found = u32::try_from(places.len()).unwrap_or(u32::MAX);
        places
    }
}
