//! A contour that may be entered anywhere, as the bound sees it.

use super::extras::Extras;
use crate::geometry::{DVec2, Path, Segment};
#[cfg(feature = "research")]
use crate::order::{real, sort_by};

/// Arc lengths that differ by less are the same, mm.
#[cfg(feature = "research")]
pub(super) const SAME: f64 = 1e-9;

/// A contour that may be entered anywhere.
#[derive(Clone, Debug)]
pub(super) struct Track {
    pub(super) path: Path,
    /// Arc length at which each element starts, the whole length at the end.
    pub(super) starts: Vec<f64>,
    pub(super) extras: Extras,
}

impl Track {
    pub(super) fn length(&self) -> f64 {
        self.starts[self.starts.len() - 1]
    }

    /// The place at an arc length.
    #[cfg(feature = "research")]
    pub(super) fn at(&self, along: f64) -> DVec2 {
        self.path.at(along).unwrap_or_default()
    }

    /// Half of the extra seconds of a stop at an arc length.
    #[cfg(feature = "research")]
    pub(super) fn half(&self, along: f64) -> f64 {
        self.extras.half(along)
    }

    /// Arc lengths between which the contour and the extra seconds have no kinks: the ends of its elements, and the kinks of these seconds.
    #[cfg(feature = "research")]
    pub(super) fn smooth_ends(&self) -> Vec<f64> {
        let mut ends = [self.starts.as_slice(), self.extras.kinks()].concat();
        sort_by(&mut ends, |&s| [real(s), 0, 0]);
        ends.dedup_by(|a, b| *a - *b < SAME);
        ends
    }

    /// Largest distance between the track from `from` to `to` (which may go beyond its end) and its chord, both run at
    /// even speed, mm. Between element ends the distance to a straight element is greatest at an end; a curve of radius
    /// r and length h lies within h^2 / 8 r of its own chord.
    pub(super) fn off_chord(&self, from: f64, to: f64, ends: [DVec2; 2]) -> f64 {
        let length = self.length();
        let span = to - from;
        if span <= 0.0 {
            return 0.0;
        }
        let (mut at_joints, mut of_curves): (f64, f64) = (0.0, 0.0);
        for lap in [0.0, length] {
            for (s, w) in self.path.segments.iter().zip(self.starts.windows(2)) {
                let (a, b) = ((w[0] + lap).max(from), (w[1] + lap).min(to));
                if a >= b {
                    continue;
                }
                if let Segment::Arc(arc) = s {
                    of_curves = of_curves.max((b - a) * (b - a) / (8.0 * arc.radius()));
                }
                if b < to {
                    let share = (b - from) / span;
                    at_joints = at_joints.max(s.end().distance(ends[0] + (ends[1] - ends[0]) * share));
                }
            }
        }
        at_joints + of_curves
    }
}
