//! Seconds along a closed contour by the place where it is entered.
//!
//! However a closed contour is entered, the head stops there twice, at the start and at the end. What that costs
//! depends on the place: at a sharp corner the head is slow anyway, in the middle of a side it brakes from full
//! speed and has to come back to it. The fastest run without any stop is worked out once, by the rules of
//! `lookahead.rs` carried round the loop. A stop lowers its profile only where the ramps from rest lie under it:
//! they are followed out from the stop, forwards and back, until they meet it, so a place is priced by the few
//! elements around it. Squares of speeds change by at most 2 a d over a distance d in either direction, so the
//! profile with the stop is the least of the profile without it and both ramps, and the price is exact.
//!
//! In a sharp corner ([`super::SharpCorner`]) the head stops anyway, and waits; a run that is entered there does not cut it
//! through, and saves the wait.
//!
//! The slowest place of the loop tells how little a stop can cost: that much is part of every run, and the extra
//! seconds of a place are what it costs above that; never less than 0. With a sharp corner, a stop costs less than nothing:
//! it saves the wait.

use super::lookahead::{Run, corner_speed2};
use super::profile::Profile;
use super::ramp::seconds;
use crate::geometry::Segment;

/// Places nearer than this to an element's end are that end, mm: as in `geometry/path.rs`.
const SNAP: f64 = 1e-9;

/// The runs along a closed contour, from rest to rest at any of its places.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedRun {
    /// Infinite: speeds change at once.
    accel: f64,
    length: f64,
    /// Seconds without any stop but those in sharp corners.
    through: f64,
    /// Seconds that a stop costs at least; negative where it may save a wait in a sharp corner.
    stop: f64,
    /// Seconds of that wait.
    wait: f64,
    /// The same speed everywhere.
    even: bool,
    pieces: Vec<Piece>,
}

/// One element of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    /// Arc length at its start, mm.
    start: f64,
    length: f64,
    /// Square of the highest speed along it.
    top2: f64,
    /// Square of the speed at its start, without any stop.
    speed2: f64,
    /// Seconds along it, without any stop.
    seconds: f64,
    /// It starts at a sharp corner.
    sharp: bool,
}

impl ClosedRun {
    /// The runs of a closed path that is marked, or cut; `None` where stopping costs nothing, without an acceleration and
    /// sharp corners, and on a path without length.
    pub fn new(profile: &Profile, mark: bool, path: &[Segment]) -> Option<Self> {
        let process = profile.process(mark);
        let accel = process.accel.unwrap_or(f64::INFINITY);
        let mut runs = Vec::with_capacity(path.len());
        let (mut pieces, mut length) = (Vec::with_capacity(path.len()), 0.0);
        for element in path {
            let run = Run::new(profile, process.speed, accel, element);
            let start = length;
            length += run.length;
            if run.length > 0.0 {
                pieces.push(Piece {
                    start,
                    length: run.length,
                    top2: run.top2,
                    speed2: f64::INFINITY,
                    seconds: run.length / process.speed,
                    sharp: false,
                });
                runs.push(run);
            }
        }
        let n = pieces.len();
        let mut before = runs.last()?;
        for (piece, run) in pieces.iter_mut().zip(&runs) {
            piece.sharp = !mark && profile.is_sharp(before.leaves, run.enters);
            if piece.sharp {
                piece.speed2 = 0.0;
            } else if accel.is_finite() {
                piece.speed2 = corner_speed2(profile, accel, before, run);
            }
            before = run;
        }
        let sharp = pieces.iter().filter(|p| p.sharp).count();
        let wait = profile.macro_seconds();
        let saved = if sharp > 0 { wait } else { 0.0 };
        if accel.is_infinite() {
            let through = pieces.iter().map(|p| p.seconds).sum::<f64>() + sharp as f64 * wait;
            let run = Self { accel, length, through, stop: -saved, wait, even: false, pieces };
            return (sharp > 0).then_some(run);
        }
        // The slowest corner is run at its own limit: both passes may start there.
        let slowest = (0..n).fold(0, |s, i| if pieces[i].speed2 < pieces[s].speed2 { i } else { s });
        let least2 = pieces[slowest].speed2;
        let even = pieces.iter().all(|p| p.speed2.max(p.top2) <= least2);
        for i in (0..n).map(|k| (slowest + k) % n) {
            let (piece, next) = (pieces[i], &mut pieces[(i + 1) % n]);
            next.speed2 = next.speed2.min(piece.speed2 + 2.0 * accel * piece.length);
        }
        for i in (0..n).rev().map(|k| (slowest + k) % n) {
            let next = pieces[(i + 1) % n];
            let piece = &mut pieces[i];
            piece.speed2 = piece.speed2.min(next.speed2 + 2.0 * accel * piece.length);
            piece.seconds = seconds(piece.length, piece.top2, piece.speed2, next.speed2, accel);
        }
        // At the slowest speed all the way there is the least to brake from.
        let stop = if least2 > 0.0 {
            seconds(length, least2, 0.0, 0.0, accel) - length / least2.sqrt()
        } else {
            0.0
        };
        let through = pieces.iter().map(|p| p.seconds).sum::<f64>() + sharp as f64 * wait;
        Some(Self { accel, length, through, stop: stop - saved, wait, even, pieces })
    }

    /// Seconds that the run takes at least, wherever it is entered.
    pub fn least(&self) -> f64 {
        self.through + self.stop
    }

    /// Seconds on top of [`ClosedRun::least`] when entered `along` mm from the path's start. Together they are
    /// [`super::work_time`] of the path re-cut to start there.
    pub fn extra(&self, along: f64) -> f64 {
        if self.even {
            return 0.0;
        }
        let n = self.pieces.len();
        let mut i = self.pieces.partition_point(|p| p.start <= along).saturating_sub(1);
        let mut at = along - self.pieces[i].start;
        if at >= self.pieces[i].length - SNAP {
            (i, at) = ((i + 1) % n, 0.0);
        } else if at <= SNAP {
            at = 0.0;
        }
        let whole = self.pieces[i];
        let saved = if whole.sharp && at <= 0.0 { self.wait } else { 0.0 };
        if self.accel.is_infinite() {
            return (-saved - self.stop).max(0.0);
        }
        let mut change = -saved;
        let (mut ahead, mut d) = (i, 0.0);
        // Pieces that are run whole, forwards or back.
        let mut left = n;
        if at > 0.0 {
            left -= 1;
            (ahead, d) = ((i + 1) % n, whole.length - at);
            change += seconds(d, whole.top2, 0.0, self.slowed2(ahead, d), self.accel)
                + seconds(at, whole.top2, self.slowed2(i, at), 0.0, self.accel)
                - whole.seconds;
        }
        while left > 0 && 2.0 * self.accel * d < self.pieces[ahead].speed2 {
            let next = (ahead + 1) % n;
            let there = d + self.pieces[ahead].length;
            change += self.slower(ahead, self.slowed2(ahead, d), self.slowed2(next, there));
            (ahead, d, left) = (next, there, left - 1);
        }
        let (mut behind, mut d) = (i, at);
        while left > 0 && 2.0 * self.accel * d < self.pieces[behind].speed2 {
            let previous = (behind + n - 1) % n;
            let there = d + self.pieces[previous].length;
            change += self.slower(previous, self.slowed2(previous, there), self.slowed2(behind, d));
            (behind, d, left) = (previous, there, left - 1);
        }
        (change - self.stop).max(0.0)
    }

    /// Seconds that each stop on the way takes at least; [`ClosedRun::least`] holds one. Negative where it saves a wait.
    pub fn stop(&self) -> f64 {
        self.stop
    }

    /// Sharp corners in it.
    pub fn sharp(&self) -> usize {
        self.pieces.iter().filter(|p| p.sharp).count()
    }

    /// Whether the run takes the same from wherever it is entered, as on a circle.
    pub fn is_even(&self) -> bool {
        self.even
    }

    /// Where elements start, the corners among them: arc length, mm, and square of the speed there without a stop.
    pub fn joints(&self) -> impl Iterator<Item = (f64, f64)> {
        self.pieces.iter().map(|p| (p.start, p.speed2))
    }

    /// Square of the speed at the start of piece `i`, `d` mm one way round from the stop.
    fn slowed2(&self, i: usize, d: f64) -> f64 {
        let ramp2 = 2.0 * self.accel * d.min(self.length - d).max(0.0);
        self.pieces[i].speed2.min(ramp2)
    }

    /// Seconds by which piece `i` takes longer between these speeds than without the stop.
    fn slower(&self, i: usize, from2: f64, to2: f64) -> f64 {
        let p = &self.pieces[i];
        seconds(p.length, p.top2, from2, to2, self.accel) - p.seconds
    }
}

#[cfg(test)]
mod tests;
