//! The machine profile: versioned data in mm, s and rad.

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How the axes move on an air move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Travel {
    /// Together along a straight line; time by the distance, limits by direction (Euclidean).
    Straight,
    /// Each at its own top speed; time is that of the axis that takes longest (Chebyshev).
    PerAxis,
}

/// Limits of one axis pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axes {
    /// Top speed of x and y, mm/s.
    pub speed: [f64; 2],
    /// Acceleration of x and y, mm/s2; `None`: at once.
    pub accel: Option<[f64; 2]>,
}

/// What the beam does in the material: one for cutting, one for marking.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Process {
    /// Speed along the contour, mm/s.
    pub speed: f64,
    /// Acceleration along the contour, mm/s2; `None`: at once.
    pub accel: Option<f64>,
    /// Power, 0 to 1.
    pub power: f64,
}

/// Flavour of G-code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Dialect {
    /// GRBL 1.1 laser mode, M4 dynamic power.
    GrblM4,
}

/// A machine with a material on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// Format of this data: 1.
    pub version: u32,
    /// Name of the preset (`co2-100w`).
    pub name: String,
    /// For people.
    pub title: String,
    /// Where the head starts, mm.
    pub home: [f64; 2],
    /// Goes back home at the end.
    pub return_home: bool,
    /// How air moves run.
    pub travel: Travel,
    /// Limits of air moves.
    pub rapid: Axes,
    /// Cutting.
    pub cut: Process,
    /// Marking.
    pub mark: Process,
    /// Allowed deviation at corners for the look-ahead, mm (GRBL's junction deviation); `None`: full speed through
    /// every corner.
    pub junction_deviation: Option<f64>,
    /// Seconds to pierce.
    pub pierce_time: f64,
    /// Beam settling before a cut, s.
    pub beam_on_delay: f64,
    /// Beam settling after a cut, s.
    pub beam_off_delay: f64,
    /// G-code flavour.
    pub dialect: Dialect,
    /// The S word of full power.
    pub max_s: f64,
}

impl Profile {
    /// Home as a point.
    pub fn home(&self) -> DVec2 {
        DVec2::from_array(self.home)
    }
}
