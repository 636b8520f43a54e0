//! The times of moves with the beam off, in the plain form of textbooks: speed, acceleration, distance.
//!
//! Trapezoidal motion is computed here a second time on purpose. Otherwise an error in `machine/motion.rs` would not be noticed.

use crate::geometry::DVec2;
use crate::machine::{Profile, RiskyMoves, Travel};
use crate::plan::model::Way;

/// Whether the head is lifted on its way, mm. Sums of coordinates may be off in their last digits.
pub(super) fn is_lifted(machine: &Profile, way: DVec2, past: Way) -> bool {
    let chosen = machine.levers.tips.is_some_and(|tips| tips.risky_moves == RiskyMoves::Avoid);
    if chosen || past == Way::Lifted {
        return past == Way::Lifted;
    }
    machine.levers.lift.is_some_and(|lift| way.length() - lift.stay_down > 1e-6)
}

/// Seconds of an air move along the vector `way`, mm, with the head lifted or down.
pub(super) fn air_time(machine: &Profile, way: DVec2, lifted: bool) -> f64 {
    let [vx, vy] = machine.rapid.speed;
    let [ax, ay] = machine.rapid.accel.unwrap_or([f64::INFINITY; 2]);
    let distance = way.length();
    if distance == 0.0 {
        return 0.0;
    }
    let (ux, uy) = (way.x.abs() / distance, way.y.abs() / distance);
    // Height to climb and to sink, and the speed of that.
    let (rise, vz) = match (machine.levers.lift, machine.z_speed) {
        (Some(lift), Some(vz)) if lifted => (2.0 * lift.height, vz),
        _ => (0.0, f64::INFINITY),
    };
    let at_rest = rise > 0.0 && machine.levers.lift.is_some_and(|lift| lift.at_rest);
    // The speed on the way with which the z axis keeps up.
    let slope = |length: f64| if rise > 0.0 && !at_rest { length / rise * vz } else { f64::INFINITY };
    let seconds = match machine.travel {
        Travel::Vector => trapezoid(distance, vx.min(vy).min(slope(distance)), ax.min(ay)),
        Travel::Straight => {
            trapezoid(distance, (vx / ux).min(vy / uy).min(slope(distance)), (ax / ux).min(ay / uy))
        }
        Travel::PerAxis => [(way.x.abs(), vx, ax), (way.y.abs(), vy, ay)]
            .into_iter()
            .filter(|axis| axis.0 > 0.0)
            .map(|(length, v, a)| trapezoid(length, v.min(slope(length)), a))
            .fold(0.0, f64::max),
    };
    if at_rest { seconds + rise / vz } else { seconds }
}

/// Seconds for `distance` from rest to rest with top speed `v` and acceleration `a`.
pub(super) fn trapezoid(distance: f64, v: f64, a: f64) -> f64 {
    let to_reach_speed = v * v / (2.0 * a);
    if distance < 2.0 * to_reach_speed {
        2.0 * (distance / a).sqrt()
    } else {
        2.0 * (v / a) + (distance - 2.0 * to_reach_speed) / v
    }
}
