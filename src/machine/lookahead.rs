//! Time along a contour: from rest at the entry to rest at the exit, within the limits of the process, the arcs and the
//! corners.
//!
//! The speed limits are the process speed everywhere, the limit of `arc.rs` on arcs, and GRBL's junction speed at a
//! corner between two elements. In between, the speed changes by at most the acceleration a. Two passes over the
//! squares of the speeds at the junctions find the fastest run, because they change by at most 2 a L along an element
//! of length L: the forward pass limits them to what can be reached, the backward pass to what can be braked. Each
//! element is then a trapezoid in closed form.
//!
//! Junction speed: S. K. Jeon, "Improving Grbl: Cornering Algorithm" (2011), and `planner.c` of GRBL 1.1. A circle that
//! touches both elements and passes the corner at the distance `junction_deviation` (delta) is run at v^2 = a R, with R
//! = delta sin(t/2) / (1 - sin(t/2)), where t is the angle between the elements as seen from the corner (pi: straight
//! on, 0: a reversal).

use super::arc::arc_speed2;
use super::process::Process;
use super::profile::Profile;
use super::ramp::seconds;
use crate::geometry::{DVec2, Segment};

/// Seconds to run `path` (elements joined end to end) with `process` on this machine, at rest at both ends. Without an
/// acceleration this is length divided by speed.
pub fn cut_time(profile: &Profile, process: &Process, path: &[Segment]) -> f64 {
    let Some(accel) = process.accel else {
        return path.iter().map(Segment::length).sum::<f64>() / process.speed;
    };
    let runs: Vec<ElementLimits> = path
        .iter()
        .map(|s| ElementLimits::new(profile, process.speed, accel, s))
        .filter(|r| r.length > 0.0)
        .collect();

    // Squares of the speeds at the junctions. Both ends are at rest.
    let mut speed2 = vec![0.0; runs.len() + 1];
    for (i, pair) in runs.windows(2).enumerate() {
        speed2[i + 1] = corner_speed2(profile, accel, &pair[0], &pair[1]);
    }
    for (i, run) in runs.iter().enumerate() {
        speed2[i + 1] = speed2[i + 1].min(speed2[i] + 2.0 * accel * run.length);
    }
    for (i, run) in runs.iter().enumerate().rev() {
        speed2[i] = speed2[i].min(speed2[i + 1] + 2.0 * accel * run.length);
    }
    runs.iter().zip(speed2.windows(2)).map(|(r, v2)| seconds(r.length, r.top2, v2[0], v2[1], accel)).sum()
}

/// Seconds to cut or mark along `path` once with `process`, including the pauses in sharp corners.
pub fn process_time(profile: &Profile, process: &Process, mark: bool, path: &[Segment]) -> f64 {
    if mark {
        return cut_time(profile, process, path);
    }
    let runs = profile.runs(path).map(|run| cut_time(profile, process, run));
    runs.reduce(|sum, seconds| sum + profile.macro_seconds() + seconds).unwrap_or(0.0)
}

/// Limits of one element in the look-ahead.
pub(super) struct ElementLimits {
    pub(super) length: f64,
    /// Square of the speed limit along it, (mm/s)^2.
    pub(super) top2: f64,
    /// Unit direction of travel at its start, and at its end below.
    pub(super) enters: DVec2,
    pub(super) leaves: DVec2,
}

impl ElementLimits {
    pub(super) fn new(profile: &Profile, speed: f64, accel: f64, element: &Segment) -> Self {
        let top2 = match element {
            Segment::Line(_) => speed * speed,
            Segment::Arc(a) => {
                arc_speed2(profile.junction_deviation, accel, speed * speed, a.radius(), a.sweep)
            }
        };
        Self { length: element.length(), top2, enters: element.tangent(0.0), leaves: element.tangent(1.0) }
    }
}

/// Square of the highest speed from one element into the next, (mm/s)^2.
pub(super) fn corner_speed2(profile: &Profile, accel: f64, a: &ElementLimits, b: &ElementLimits) -> f64 {
    junction_speed2(profile.junction_deviation, accel, a.leaves, b.enters).min(a.top2).min(b.top2)
}

/// Square of the speed limit at the corner between two directions; infinite where they agree or corners have no limit.
fn junction_speed2(deviation: Option<f64>, accel: f64, leaves: DVec2, enters: DVec2) -> f64 {
    let Some(deviation) = deviation else { return f64::INFINITY };
    // The angle between the elements is measured at the corner, so straight on is pi.
    let cos = -leaves.dot(enters);
    // GRBL's own thresholds: within 1.4 mrad of straight on, or of a reversal.
    if cos < -0.999_999 {
        return f64::INFINITY;
    }
    if cos > 0.999_999 {
        return 0.0;
    }
    let sin_half = (0.5 * (1.0 - cos)).sqrt();
    accel * deviation * sin_half / (1.0 - sin_half)
}

#[cfg(test)]
mod tests;
