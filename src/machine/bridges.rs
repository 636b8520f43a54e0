//! Data of bridges: strips of material that stay between parts, so that the outlines of several parts are one cut.
//!
//! Waterjet and laser shops cut small parts so: they hang together and are pierced once ([IGEMS, "Bridges"]).
//!
//! [IGEMS, "Bridges"]: https://igems.zendesk.com/hc/en-us/articles/22394892034076-Bridges

use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};

const WIDTH: Range = Range::new(0.1, 1000.0, "mm", "a narrower strip burns away, and no part is so wide");
const REACH: Range = Range::new(0.1, 1000.0, "mm", "a longer strip takes longer to cut than piercing");
const CLEARANCE: Range =
    Range::new(0.0, 100.0, "mm", "a bridge keeps away from everything that it does not join");
const MOST: Range = Range::new(2.0, 1e6, "", "a bridge joins two parts at least");

/// Bridges: parts stay connected by strips of material through the waste. The outlines are opened where a strip ends on them, and
/// the sides of the strips are cut, so that the outlines of connected parts are one cut, which is pierced once.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Bridges {
    /// Width of a strip, mm.
    pub width: f64,
    /// Longest strip, mm.
    pub reach: f64,
    /// Least distance of a strip from everything else that is cut or marked, and from the corners of the sides that it joins, mm. Default 1.
    #[serde(default = "usual_clearance")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub clearance: f64,
    /// Most parts that hang together, a whole number; `None`: any number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub most: Option<f64>,
    /// The machine cuts the bridges itself, after the cut around the connected parts: across each strip, along the outlines of both parts.
    /// Otherwise a person separates the parts. Default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<bool>"))]
    pub cut_later: bool,
}

/// A millimetre, as for chains.
fn usual_clearance() -> f64 {
    1.0
}

impl Bridges {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::required("width", Kind::Number(WIDTH)),
        Field::required("reach", Kind::Number(REACH)),
        Field::optional("clearance", Kind::Number(CLEARANCE)),
        Field::nullable("most", Kind::Whole(MOST)),
        Field::optional("cut_later", Kind::Flag),
    ];

    /// The numbers with their names and ranges.
    pub(crate) fn numbers(&self) -> Vec<(&'static str, f64, Range)> {
        let most = self.most.map(|most| ("levers.bridges.most", most, MOST));
        let sizes = [
            ("levers.bridges.width", self.width, WIDTH),
            ("levers.bridges.reach", self.reach, REACH),
            ("levers.bridges.clearance", self.clearance, CLEARANCE),
        ];
        sizes.into_iter().chain(most).collect()
    }
}
