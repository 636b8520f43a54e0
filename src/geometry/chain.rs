//! A growing chain of fitted segments, which merges neighbours that lie on one line or circle.

use super::segment::{Arc, Segment};
use std::f64::consts::TAU;

/// Fraction of the tolerance within which a stretch counts as an exact line or arc, and two neighbours as parts of one
/// element.
pub(super) const EXACT_SHARE: f64 = 0.002;

/// A growing chain.
pub(super) struct Chain {
    pub(super) segments: Vec<Segment>,
    /// Index of the first segment of the current run. Segments are not merged across a kink.
    run: usize,
    tolerance: f64,
}

impl Chain {
    /// An empty chain for a fit within `tolerance` mm.
    pub(super) fn new(tolerance: f64) -> Self {
        Self { segments: Vec::new(), run: 0, tolerance }
    }

    /// Distance below which two places of the fit are the same, mm.
    pub(super) fn same(&self) -> f64 {
        EXACT_SHARE * self.tolerance
    }

    /// Marks a kink: the next segment is not merged with the last one.
    pub(super) fn start_run(&mut self) {
        self.run = self.segments.len();
    }

    /// Adds a segment that starts where the last one ended.
    pub(super) fn push(&mut self, next: Segment) {
        let last = self.segments.get(self.run..).and_then(|run| run.last());
        match last.and_then(|last| merged(last, &next, self.same())) {
            Some(both) => {
                self.segments.pop();
                self.segments.push(both);
            }
            None => self.segments.push(next),
        }
    }
}

/// Two neighbours as one segment, if both lie on it within `same` mm.
fn merged(last: &Segment, next: &Segment, same: f64) -> Option<Segment> {
    match (last, next) {
        (Segment::Line(a), Segment::Line(b)) => {
            let chord = (b.end - a.start).normalize_or_zero();
            let forward = chord.dot(a.end - a.start) > 0.0 && chord.dot(b.end - b.start) > 0.0;
            (forward && chord.perp_dot(a.end - a.start).abs() <= same).then(|| Segment::line(a.start, b.end))
        }
        (Segment::Arc(a), Segment::Arc(b)) => {
            let one = a.center.distance(b.center) + (a.radius() - b.radius()).abs() <= same;
            let sweep = a.sweep + b.sweep;
            let closes = sweep.abs() > TAU - 1e-9;
            let fits = if closes { a.start == b.end && sweep.abs() < TAU + 1e-6 } else { a.start != b.end };
            (one && a.ccw() == b.ccw() && fits).then(|| {
                let sweep = if closes { TAU.copysign(sweep) } else { sweep };
                Segment::Arc(Arc { start: a.start, end: b.end, center: a.center, sweep })
            })
        }
        _ => None,
    }
}
