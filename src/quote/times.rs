//! Seconds, by what they go into.

use serde::Serialize;

/// Seconds of the job or of a part, by what they go into.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "QuoteTimes"))]
pub struct Times {
    /// The whole job.
    pub total: f64,
    /// Along contours.
    pub cut: f64,
    /// Air moves.
    pub air: f64,
    /// Piercing, with beam delays.
    pub pierce: f64,
    /// Pre-cuts.
    pub pre_cut: f64,
    /// Sharp corners.
    pub macros: f64,
}
