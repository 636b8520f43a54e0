//! Data of heat: how far from each other, in place or in time, cuts have to be, and which holes come first in thick plate.
//!
//! Shops spread cuts over the sheet, so that a plate does not warp or burn where it is hot: "skip" orders
//! ([lapas.io, "Cut sequence"]), and a least *thermal distance* from one tool path to the next (BobCAD). Nothing is known of
//! temperatures here: the figures are a person's.
//!
//! [lapas.io, "Cut sequence"]: https://lapas.io/blog/cut-sequence-laser-cutting

use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};

const DISTANCE: Range = Range::new(0.0, 500.0, "mm", "plate half a metre away stays cold");
const SECONDS: Range = Range::new(0.0, 600.0, "s", "plate cools in minutes");
const CHARGE: Range = Range::new(0.0, 600.0, "s", "waiting would take less");
const THICKNESS: Range = Range::new(0.1, 300.0, "mm", "no beam, jet or plasma cuts thicker plate");
const RATIO: Range = Range::new(0.1, 20.0, "", "a hole that is wider than that is not small");

/// Distances that differ by less are the same, mm, and times, s: sums of coordinates and seconds differ in their last digits.
pub(crate) const SAME_HEAT: f64 = 1e-6;

/// Least distance of cuts that follow each other within least seconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Heat {
    /// Cuts that are nearer to each other than this, from line to line, heat each other, mm. 0: none do.
    pub distance: f64,
    /// Seconds from the end of one such cut to the beginning of the other.
    pub seconds: f64,
    /// Seconds that the search charges for each pair of cuts that follow each other sooner; `None`: the head waits, so that there
    /// are no such pairs. The charge is no time of the machine, and not part of the time of the plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub charge: Option<f64>,
    /// Small holes in thick plate are cut before all other cuts; `None`: they are not.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub small_holes: Option<SmallHoles>,
}

/// Which holes are small.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SmallHoles {
    /// Thickness of the plate, mm.
    pub thickness: f64,
    /// Holes up to this many times the thickness are small, by the larger of their extents along x and y. Default 1, a guess.
    #[serde(default = "usual_ratio")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub ratio: f64,
}

fn usual_ratio() -> f64 {
    1.0
}

impl Heat {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::required("distance", Kind::Number(DISTANCE)),
        Field::required("seconds", Kind::Number(SECONDS)),
        Field::nullable("charge", Kind::Number(CHARGE)),
        Field::nullable("small_holes", Kind::Object(SMALL_HOLES)),
    ];

    /// Whether cuts near each other matter at all.
    pub fn minds_pairs(&self) -> bool {
        self.distance > 0.0 && self.seconds > 0.0
    }

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> + use<> {
        let small = self.small_holes;
        [
            ("levers.heat.distance", Some(self.distance), DISTANCE),
            ("levers.heat.seconds", Some(self.seconds), SECONDS),
            ("levers.heat.charge", self.charge, CHARGE),
            ("levers.heat.small_holes.thickness", small.map(|s| s.thickness), THICKNESS),
            ("levers.heat.small_holes.ratio", small.map(|s| s.ratio), RATIO),
        ]
        .into_iter()
        .filter_map(|(name, value, range)| Some((name, value?, range)))
    }
}

impl SmallHoles {
    /// Whether a hole whose larger extent is `size` mm is small.
    pub fn holds(&self, size: f64) -> bool {
        size <= self.ratio * self.thickness + SAME_HEAT
    }
}

const SMALL_HOLES: &[Field] =
    &[Field::required("thickness", Kind::Number(THICKNESS)), Field::optional("ratio", Kind::Number(RATIO))];
