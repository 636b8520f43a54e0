//! How one cut is made. All programs take speed, power, z and air of a cut from here and from nowhere else.

use crate::machine::{Process, Profile};

/// Speed, power, height and air of one cut or mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CutProcess {
    /// Speed along the contour, mm/s.
    pub(super) speed: f64,
    /// Power as a fraction of full power, 0 to 1.
    pub(super) power: f64,
    /// Height of the head, mm; 0 is where it is focused on the top of the material.
    pub(super) z: f64,
    /// Whether the air assist is on.
    pub(super) air: bool,
}

impl CutProcess {
    /// The process of a cut or mark on a machine.
    pub(super) fn of(profile: &Profile, mark: bool) -> Self {
        Self::new(profile.process(mark), 0.0)
    }

    /// From the process of a contour, at the height of its pass.
    pub(super) fn new(process: &Process, z: f64) -> Self {
        Self { speed: process.speed, power: process.power, z, air: process.air }
    }
}
