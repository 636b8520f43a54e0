//! How one cut is made. All programs take speed, power, z and air of a cut from here and from nowhere else.

use super::cuts::Cut;
use super::sheet_facts::SheetFacts;
use crate::machine::{Process, Profile};

/// Speed, power, height and air of one cut or mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CutProcess {
    /// Speed along the contour, mm/s.
    pub(super) speed: f64,
    /// Power as a fraction of full power, 0 to 1.
    pub(super) power: f64,
    /// Least power, where the head is slow, as a fraction of full power; `None` if the layer sets none.
    pub(super) min_power: Option<f64>,
    /// Height of the head, mm; 0 is where it is focused on the top of the material.
    pub(super) z: f64,
    /// Whether the air assist is on.
    pub(super) air: bool,
}

impl CutProcess {
    /// From the process of a contour, at the height of its pass.
    pub(super) fn new(process: &Process, z: f64) -> Self {
        Self { speed: process.speed, power: process.power, min_power: process.min_power, z, air: process.air }
    }

    /// How a cut of a plan is made: with the settings of its layer, at the height of its pass.
    pub(super) fn of_cut(sheet: &SheetFacts, profile: &Profile, cut: &Cut) -> Self {
        Self::new(&sheet.process(cut.contour, profile), cut.z)
    }
}
