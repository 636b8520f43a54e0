//! Which corners count as sharp.

use serde::{Deserialize, Serialize};

/// When a corner needs a macro, and what it takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SharpCorner {
    /// Corners are sharp whose elements meet at less than this angle, rad: pi is straight on.
    pub angle: f64,
    /// Seconds that the corner cools.
    pub time: f64,
}
