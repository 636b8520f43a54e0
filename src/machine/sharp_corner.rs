//! Data of sharp corners.

use serde::{Deserialize, Serialize};

/// Which corners need a macro, and how long it takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SharpCorner {
    /// Corners whose elements meet at less than this angle are sharp, rad; pi is straight on.
    pub angle: f64,
    /// Seconds that the corner cools.
    pub time: f64,
}
