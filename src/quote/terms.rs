//! What whoever asks for a quote states about the job: the material, and the limits of what the shop makes.

use super::limits::Limits;
use super::material::{MATERIAL, Material};
use crate::fields::{self, Field, FieldError, Kind, Shaped};
use serde::{Deserialize, Serialize};

/// What a quote is asked for.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "QuoteTerms", optional_fields))]
pub struct Terms {
    /// The material of the sheet.
    pub material: Material,
    /// What the shop can make. Each limit that a part exceeds is reported with its place.
    pub limits: Limits,
}

impl From<Material> for Terms {
    fn from(material: Material) -> Self {
        Self { material, limits: Limits::default() }
    }
}

impl Shaped for Terms {
    const SHAPE: fields::Shape = fields::Shape {
        owner: "The quote",
        item: "option",
        value: "The option",
        fields: &[
            Field::optional("material", Kind::Object(MATERIAL)),
            Field::optional("limits", Kind::Object(super::limits::LIMITS)),
        ],
    };
}

impl Terms {
    /// Checks the numbers, which may not have been read through [`Shaped`].
    pub(super) fn check(&self) -> Result<(), FieldError> {
        self.material.check()?;
        self.limits.check()
    }
}
