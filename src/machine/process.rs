//! What the beam does along a contour.

use serde::{Deserialize, Serialize};

/// How the beam works in the material, for cutting or for marking.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Process {
    /// Speed along the contour, mm/s.
    pub speed: f64,
    /// Acceleration along the contour, mm/s2; `None` if the speed is reached instantly.
    pub accel: Option<f64>,
    /// Power as a fraction of full power, 0 to 1.
    pub power: f64,
    /// Least power, where the head is slow, as a fraction of full power; `None`: it follows the speed. For controllers
    /// that take two powers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub min_power: Option<f64>,
    /// Number of passes over a contour.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    #[cfg_attr(test, ts(optional, as = "Option<u32>"))]
    pub passes: u32,
    /// By how much the head is lowered for each further pass, mm.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(optional, as = "Option<f64>"))]
    pub z_step: f64,
    /// Whether the air assist is on.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub air: bool,
}

impl Process {
    /// A process of one pass.
    pub const fn new(speed: f64, accel: Option<f64>, power: f64) -> Self {
        Self { speed, accel, power, min_power: None, passes: 1, z_step: 0.0, air: false }
    }
}

fn one() -> u32 {
    1
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_one(passes: &u32) -> bool {
    *passes == 1
}
