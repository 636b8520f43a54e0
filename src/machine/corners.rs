//! Data of the lever of corners: what the beam does where a contour turns, instead of slowing down or stopping there.
//!
//! Loops through the waste and rounded corners are usual in plasma and oxy-fuel cutting, where a corner that is cut slowly
//! burns off. The default sizes are guesses.

use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};

const RADIUS: Range = Range::new(0.05, 100.0, "mm", "waste beside parts is not wider");
const CLEARANCE: Range = Range::new(0.0, 100.0, "mm", "loops keep away from everything that is not waste");
const DEVIATION: Range = Range::new(0.001, 10.0, "mm", "a corner rounded by more is not the corner drawn");

/// What the beam does in a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum CornerKind {
    /// It turns in the corner, slowly, and pauses if the corner is sharp.
    #[default]
    Stop,
    /// It cuts on straight through the corner into the waste, turns there, and crosses the corner again along the other side.
    Loop,
    /// It cuts an arc instead of the corner.
    Round,
}

/// The names of the kinds, as callers write them.
pub(crate) const CORNER_KINDS: &[&str] = &["stop", "loop", "round"];

/// Which corners are cut how, where that saves time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Corners {
    /// What is done at corners of the outlines of parts. Default `stop`.
    #[cfg_attr(test, ts(as = "Option<CornerKind>"))]
    pub outer: CornerKind,
    /// What is done at corners of holes. Default `stop`.
    #[cfg_attr(test, ts(as = "Option<CornerKind>"))]
    pub hole: CornerKind,
    /// Radius of loops, mm. Default 2.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub loop_radius: f64,
    /// Least distance of loops from every other contour, mm. Default 1.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub clearance: f64,
    /// Greatest radius of rounded corners, mm. Default 1.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub round_radius: f64,
    /// Greatest distance of a rounded corner from the corner drawn, mm. Default 0.1.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub deviation: f64,
}

impl Default for Corners {
    fn default() -> Self {
        Self {
            outer: CornerKind::Stop,
            hole: CornerKind::Stop,
            loop_radius: 2.0,
            clearance: 1.0,
            round_radius: 1.0,
            deviation: 0.1,
        }
    }
}

impl Corners {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::optional("outer", Kind::Choice(CORNER_KINDS)),
        Field::optional("hole", Kind::Choice(CORNER_KINDS)),
        Field::optional("loop_radius", Kind::Number(RADIUS)),
        Field::optional("clearance", Kind::Number(CLEARANCE)),
        Field::optional("round_radius", Kind::Number(RADIUS)),
        Field::optional("deviation", Kind::Number(DEVIATION)),
    ];

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> {
        [
            ("levers.corners.loop_radius", self.loop_radius, RADIUS),
            ("levers.corners.clearance", self.clearance, CLEARANCE),
            ("levers.corners.round_radius", self.round_radius, RADIUS),
            ("levers.corners.deviation", self.deviation, DEVIATION),
        ]
        .into_iter()
    }
}
