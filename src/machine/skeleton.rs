//! Data of skeleton cuts: straight cuts through the waste, after everything else, that divide what is left of the sheet into
//! pieces that a person can lift off the machine.
//!
//! TRUMPF names them "Slice Sheet Skeleton", with a spacing in x and y, "Microjoint spacing on long cuts", and a remainder
//! sheet with a least width. The default sizes are guesses.

use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};

const SPACING: Range = Range::new(10.0, 1e5, "mm", "smaller pieces fall through the slats");
const CLEARANCE: Range = Range::new(0.1, 1000.0, "mm", "a cut that meets a part marks its edge");
const JOINT_WIDTH: Range = Range::new(0.01, 100.0, "mm", "a joint is broken by hand");
const REMAINDER: Range = Range::new(10.0, 1e5, "mm", "nobody keeps a narrower strip");

/// Cuts through the waste, in the directions of x and y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Skeleton {
    /// Greatest width of a piece in x, mm: cuts in the direction of y divide the sheet evenly. Not given: there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spacing_x: Option<f64>,
    /// Greatest height of a piece in y, mm: cuts in the direction of x divide the sheet evenly. Not given: there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spacing_y: Option<f64>,
    /// Least distance of these cuts from the cuts of parts, mm. Default 2.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub clearance: f64,
    /// Greatest length that is cut without leaving a joint, mm; not given: any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_spacing: Option<f64>,
    /// Width of the material that a joint leaves, mm. The width of the cut is added to it. Default 1.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub joint_width: f64,
    /// Least width of a strip at an edge of the sheet, without parts, that is cut off in one piece and kept, mm; not given: no
    /// strip is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remainder: Option<f64>,
}

impl Default for Skeleton {
    fn default() -> Self {
        Self {
            spacing_x: None,
            spacing_y: None,
            clearance: 2.0,
            joint_spacing: None,
            joint_width: 1.0,
            remainder: None,
        }
    }
}

impl Skeleton {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::nullable("spacing_x", Kind::Number(SPACING)),
        Field::nullable("spacing_y", Kind::Number(SPACING)),
        Field::optional("clearance", Kind::Number(CLEARANCE)),
        Field::nullable("joint_spacing", Kind::Number(SPACING)),
        Field::optional("joint_width", Kind::Number(JOINT_WIDTH)),
        Field::nullable("remainder", Kind::Number(REMAINDER)),
    ];

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> {
        [
            ("skeleton.spacing_x", self.spacing_x, SPACING),
            ("skeleton.spacing_y", self.spacing_y, SPACING),
            ("skeleton.clearance", Some(self.clearance), CLEARANCE),
            ("skeleton.joint_spacing", self.joint_spacing, SPACING),
            ("skeleton.joint_width", Some(self.joint_width), JOINT_WIDTH),
            ("skeleton.remainder", self.remainder, REMAINDER),
        ]
        .into_iter()
        .filter_map(|(name, value, range)| Some((name, value?, range)))
    }
}
