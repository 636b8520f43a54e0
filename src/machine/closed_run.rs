//! Time along a closed contour, as a function of the place where it is entered.
//!
//! Wherever a closed contour is entered, the head is at rest there at the start and at the end. The cost of that
//! depends on the place: at a sharp corner the head is slow anyway, but in the middle of a side it accelerates from
//! rest to full speed and brakes again. The fastest run without a stop is computed once, by the rules of `lookahead.rs`
//! applied around the loop. A stop lowers its speed profile only near the stop: the two ramps from rest are followed
//! forwards and backwards until they meet the profile, so pricing a place visits only the few elements around it.
//! Squares of speeds change by at most 2 a d over a distance d, so the profile with the stop is the minimum of the
//! profile without it and both ramps, and the price is exact.
//!
//! In a sharp corner ([`super::SharpCorner`]) the head stops and waits in any case. A run that is entered there does
//! not cut through it and saves the wait.
//!
//! The least cost of a stop at any place is part of every run, and the extra seconds of a place are those above it. With sharp corners a
//! stop may have a negative cost, because it saves a wait.

use super::lookahead::{ElementLimits, corner_speed2};
use super::process::Process;
use super::profile::Profile;
use super::ramp::seconds;
use crate::geometry::Segment;
use crate::order::{real, sort_by};

/// A place nearer than this to an element's end is that end, mm, as in `geometry/path.rs`.
const SNAP: f64 = 1e-9;

/// The times along a closed contour from rest to rest, for every entry.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedRun {
    /// Acceleration, mm/s2; infinite if speeds change instantly.
    accel: f64,
    length: f64,
    /// Seconds without any stop except those in sharp corners.
    nonstop: f64,
    /// Least seconds that a stop costs; negative if it may save a wait in a sharp corner.
    stop: f64,
    /// Seconds of a wait in a sharp corner.
    wait: f64,
    /// Whether the speed is the same everywhere.
    uniform: bool,
    /// Number of rounds, each from rest to rest.
    rounds: f64,
    pieces: Vec<Piece>,
}

/// One element of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    /// Arc length at its start, mm.
    start: f64,
    length: f64,
    /// Square of the speed limit along it, (mm/s)^2.
    top2: f64,
    /// Square of the speed at its start without a stop, (mm/s)^2.
    speed2: f64,
    /// Seconds along it without a stop.
    seconds: f64,
    /// Whether it starts at a sharp corner.
    sharp: bool,
}

impl ClosedRun {
    /// The times along a closed path that is marked (`mark`) or cut. `None` where a stop costs nothing (without
    /// acceleration and sharp corners) and for a path without length.
    pub fn new(profile: &Profile, process: &Process, mark: bool, path: &[Segment]) -> Option<Self> {
        let accel = process.accel.unwrap_or(f64::INFINITY);
        let mut runs = Vec::with_capacity(path.len());
        let (mut pieces, mut length) = (Vec::with_capacity(path.len()), 0.0);
        for element in path {
            let run = ElementLimits::new(profile, process.speed, accel, element);
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
            let nonstop = pieces.iter().map(|p| p.seconds).sum::<f64>() + sharp as f64 * wait;
            let run =
                Self { accel, length, nonstop, stop: -saved, wait, uniform: false, rounds: 1.0, pieces };
            return (sharp > 0).then_some(run);
        }
        // The slowest corner is passed at its own limit, so both passes may start there.
        let slowest = (0..n).fold(0, |s, i| if pieces[i].speed2 < pieces[s].speed2 { i } else { s });
        let least2 = pieces[slowest].speed2;
        let uniform = pieces.iter().all(|p| p.speed2.max(p.top2) <= least2);
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
        let nonstop = pieces.iter().map(|p| p.seconds).sum::<f64>() + sharp as f64 * wait;
        let mut run = Self { accel, length, nonstop, stop: -saved, wait, uniform, rounds: 1.0, pieces };
        if least2 > 0.0 {
            run.stop = run.least_stop(least2);
        }
        Some(run)
    }

    /// The least seconds of a stop, where the head is nowhere slower than the root of `least2`. Moving a stop forwards changes its seconds
    /// by 1 / v for the speed at which the ramp behind meets the profile, less the same for the ramp ahead. Both speeds jump only where
    /// a ramp comes past a place after which the head speeds up. Between jumps, the one behind does not fall and the one ahead does not
    /// rise, so the seconds are least at a jump.
    fn least_stop(&self, least2: f64) -> f64 {
        if self.uniform {
            return seconds(self.length, least2, 0.0, 0.0, self.accel) - self.length / least2.sqrt();
        }
        let n = self.pieces.len();
        let mut least = self.extra(0.0);
        for (i, piece) in self.pieces.iter().enumerate() {
            let [before, next] = [n - 1, 1].map(|k| &self.pieces[(i + k) % n]);
            let highest2 = piece.top2.min(0.5 * (piece.speed2 + next.speed2) + self.accel * piece.length);
            if highest2 > self.accel * self.length {
                // The ramps meet each other.
                return 2.0 * (self.length / self.accel).sqrt() - self.nonstop;
            }
            if piece.speed2 < piece.top2.max(before.top2) {
                let ramp = piece.speed2 / (2.0 * self.accel);
                for along in [piece.start - ramp, piece.start + ramp] {
                    least = least.min(self.extra(self.on_path(along)));
                }
            }
        }
        least
    }

    /// The same, run several times, each from rest to rest at the same entry.
    pub fn repeated(self, rounds: u32) -> Self {
        Self { rounds: f64::from(rounds), ..self }
    }

    /// Least seconds of the run, over all entries.
    pub fn least(&self) -> f64 {
        self.rounds * (self.nonstop + self.stop)
    }

    /// Seconds above [`ClosedRun::least`] for the entry `along` mm from the path's start. Their sum is the
    /// [`super::process_time`] of the path re-cut to start there.
    pub fn extra(&self, along: f64) -> f64 {
        if self.uniform {
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
            return self.rounds * (-saved - self.stop).max(0.0);
        }
        let mut change = -saved;
        let (mut ahead, mut d) = (i, 0.0);
        // Elements that are passed completely, forwards or backwards.
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
        self.rounds * (change - self.stop).max(0.0)
    }

    /// Where [`ClosedRun::extra`] may not be concave: arc lengths along the path, ascending. Between two of them its slope does not rise (see
    /// `least_stop`), so that it lies above each of its chords there. In a sharp corner it may be less than on both sides.
    pub fn kinks(&self) -> Vec<f64> {
        let n = self.pieces.len();
        let slows = |(i, piece): &(usize, &Piece)| {
            piece.sharp || piece.speed2 < piece.top2.max(self.pieces[(i + n - 1) % n].top2)
        };
        let of_piece = |(_, piece): (usize, &Piece)| {
            let ramp = piece.speed2 / (2.0 * self.accel);
            [piece.start - ramp, piece.start + ramp].map(|along| self.on_path(along))
        };
        let mut kinks: Vec<f64> = self.pieces.iter().enumerate().filter(slows).flat_map(of_piece).collect();
        sort_by(&mut kinks, |&s| [real(s), 0, 0]);
        kinks.dedup_by(|a, b| a.to_bits() == b.to_bits());
        kinks
    }

    /// The same place, as an arc length on the path.
    pub fn on_path(&self, along: f64) -> f64 {
        along - self.length * (along / self.length).floor()
    }

    /// Least seconds of each stop on the way, one of which is part of [`ClosedRun::least`]. Negative if a stop saves a
    /// wait.
    pub fn stop(&self) -> f64 {
        self.stop
    }

    /// Number of sharp corners.
    pub fn sharp_corners(&self) -> usize {
        self.pieces.iter().filter(|p| p.sharp).count()
    }

    /// Whether the time is the same for every entry, as on a circle.
    pub fn is_uniform(&self) -> bool {
        self.uniform
    }

    /// The joints between elements, corners included: arc length in mm, and the square of the speed there without a
    /// stop.
    pub fn joints(&self) -> impl Iterator<Item = (f64, f64)> {
        self.pieces.iter().map(|p| (p.start, p.speed2))
    }

    /// Square of the speed at the start of piece `i`, which is `d` mm from the stop in one direction.
    fn slowed2(&self, i: usize, d: f64) -> f64 {
        let ramp2 = 2.0 * self.accel * d.min(self.length - d).max(0.0);
        self.pieces[i].speed2.min(ramp2)
    }

    /// Extra seconds along piece `i` when it is run between these speeds, compared with no stop.
    fn slower(&self, i: usize, from2: f64, to2: f64) -> f64 {
        let p = &self.pieces[i];
        seconds(p.length, p.top2, from2, to2, self.accel) - p.seconds
    }
}

#[cfg(test)]
mod tests;
