//! The limits of axes that move each for themselves, and the seconds of a move as a function of both.

use crate::geometry::DVec2;
use crate::machine::{Profile, Travel};

/// What an air move takes where the time depends on how far it goes along each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Seconds per mm at top speed, by axis.
    pub(super) per_speed: DVec2,
    /// Seconds squared per mm of the ramps, by axis; 0 if the machine reaches its speed at once.
    pub(super) per_accel: DVec2,
    /// Each axis moves for itself. If not, a straight move keeps to the speed of one axis and the acceleration of the other, if these are the slower ones.
    pub(super) each_axis: bool,
}

impl Limits {
    /// `None` if seconds depend on the distance alone.
    pub(super) fn new(machine: &Profile) -> Option<Self> {
        let accel = machine.rapid.accel;
        (machine.travel != Travel::Vector).then(|| Self {
            per_speed: 1.0 / DVec2::from_array(machine.rapid.speed),
            per_accel: accel.map_or(DVec2::ZERO, |a| 1.0 / DVec2::from_array(a)),
            // Without ramps, a straight move takes what its slower axis takes.
            each_axis: machine.travel == Travel::PerAxis || accel.is_none(),
        })
    }

    /// The seconds of a move from its time at top speed and its ramps (`machine/motion.rs`), and how fast they grow with each of them.
    pub(super) fn seconds(&self, run: f64, ramp2: f64) -> (f64, [f64; 2]) {
        if ramp2 < run * run || self.per_accel == DVec2::ZERO {
            let ramps = if run > 0.0 { ramp2 / run } else { 0.0 };
            (run + ramps, [1.0 - ramps / run.max(f64::MIN_POSITIVE), 1.0 / run.max(SHORT)])
        } else {
            (2.0 * ramp2.sqrt(), [0.0, 1.0 / ramp2.sqrt().max(SHORT)])
        }
    }
}

/// Seconds below which a slope that grows without end is taken to grow no more.
const SHORT: f64 = 1e-9;
