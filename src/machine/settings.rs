//! Settings of a layer or a material.
//!
//! What a contour is worked with comes from three places: the machine's own process, the material on it, and the layer
//! the contour is on. Each may leave values open, which the one before it fills.

use super::process::Process;
use serde::{Deserialize, Serialize};

/// What a layer or a material sets; `None`: as without it.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Settings {
    /// Speed along the contour, mm/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Power as a fraction of full power, 0 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power: Option<f64>,
    /// Least power, where the head is slow, as a fraction of full power.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min_power: Option<f64>,
    /// Number of passes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub passes: Option<u32>,
    /// By how much the head is lowered for each further pass, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z_step: Option<f64>,
    /// Whether the air assist is on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub air: Option<bool>,
}

impl Settings {
    /// Nothing set.
    pub const NONE: Self =
        Self { speed: None, power: None, min_power: None, passes: None, z_step: None, air: None };

    /// Whether nothing is set.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// A process with these settings. A least power above the power is lowered to it.
    pub fn over(&self, process: &Process) -> Process {
        let power = self.power.unwrap_or(process.power);
        Process {
            speed: self.speed.unwrap_or(process.speed),
            accel: process.accel,
            power,
            min_power: self.min_power.or(process.min_power).map(|least| least.min(power)),
            passes: self.passes.unwrap_or(process.passes),
            z_step: self.z_step.unwrap_or(process.z_step),
            air: self.air.unwrap_or(process.air),
        }
    }
}

/// How a machine works one material: an entry of its library.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MaterialSetting {
    /// Its name, by which it is chosen (`3 mm birch ply`).
    pub name: String,
    /// Cutting.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Settings>"))]
    pub cut: Settings,
    /// Marking.
    #[serde(default, skip_serializing_if = "Settings::is_none")]
    #[cfg_attr(test, ts(optional, as = "Option<Settings>"))]
    pub mark: Settings,
    /// Seconds to pierce it; `None`: as the machine's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub pierce_time: Option<f64>,
    /// Width of the cut in it, mm; `None`: as the machine's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub kerf_width: Option<f64>,
}
