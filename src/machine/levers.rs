//! Data of the levers: abilities of a machine that make a job shorter and that a person switches on.
//!
//! With all of them off, plans are what they were without them.

use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};

const OVERCUT: Range = Range::new(0.0, 100.0, "mm", "thin sheet is cut through after a few millimetres");

/// The levers that are switched on.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Levers {
    /// The beam goes on as the head starts to move; `None`: the head pierces at rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moving_pierce: Option<MovingPierce>,
}

/// Piercing while the head moves: for marks, and for closed cuts in material that is thin enough. Neither the piercing time
/// nor the delay of the beam before a cut is spent then.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MovingPierce {
    /// Length of a closed cut that is cut again at its end because the beam was not through at its beginning, mm. Default 0.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub overcut: f64,
}

impl Levers {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] =
        &[Field::nullable("moving_pierce", Kind::Object(MOVING_PIERCE))];

    /// Length that a contour of `length` mm is cut again because it was pierced at speed, mm: at most half of it.
    pub fn cut_again(&self, length: f64) -> f64 {
        self.moving_pierce.map_or(0.0, |p| p.overcut.min(0.5 * length))
    }

    /// Whether all are off.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> {
        self.moving_pierce.map(|p| ("levers.moving_pierce.overcut", p.overcut, OVERCUT)).into_iter()
    }
}

const MOVING_PIERCE: &[Field] = &[Field::optional("overcut", Kind::Number(OVERCUT))];
