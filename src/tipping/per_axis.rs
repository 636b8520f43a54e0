//! Where the head runs on a machine that moves each axis by itself (`travel: per-axis`).
//!
//! Both axes begin at once, and the one that is there first waits for the other: the head leaves the straight line towards a
//! *corner*, and ends along one axis. How sharply it turns depends on the ramps of both axes, but it stays within the triangle
//! of the move's ends and that corner. What is crossed along a side of the triangle or lies within it is therefore in the way.

use crate::geometry::DVec2;
use crate::machine::{AirTime, Profile, Travel};

/// How the axes of a machine compare.
#[derive(Clone, Copy, Debug)]
pub(super) struct PerAxis {
    /// What y is sure to have gone for each mm of x while both run, and x for each mm of y.
    y_for_x: f64,
    x_for_y: f64,
}

impl PerAxis {
    /// `None` for a machine whose rapids are straight.
    pub(super) fn new(machine: &Profile) -> Option<Self> {
        if machine.travel != Travel::PerAxis {
            return None;
        }
        let [vx, vy] = machine.rapid.speed;
        let [ax, ay] = machine.rapid.accel.unwrap_or([vx, vy]);
        Some(Self { y_for_x: (vy / vx).min(ay / ax), x_for_y: (vx / vy).min(ax / ay) })
    }

    /// The corner of the way from place to place; one of its ends where it is straight.
    pub(super) fn corner(self, from: DVec2, to: DVec2, air: &AirTime) -> DVec2 {
        let way = to - from;
        let alone = |part: DVec2| air.seconds(DVec2::ZERO, part);
        let d = way.abs();
        let gone = if alone(DVec2::X * d.x) < alone(DVec2::Y * d.y) {
            DVec2::new(d.x, d.y.min(d.x * self.y_for_x))
        } else {
            DVec2::new(d.x.min(d.y * self.x_for_y), d.y)
        };
        from + gone * way.signum()
    }
}
