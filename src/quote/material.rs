//! The material of a sheet, as whoever asks for a quote gives it.

use crate::fields::{self, Field, FieldError, Kind, Range, Shaped};
use serde::{Deserialize, Serialize};

/// The material of the sheet.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Material {
    /// A name, which is only shown.
    pub name: Option<String>,
    /// Thickness, mm.
    pub thickness: Option<f64>,
    /// Density, g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19, birch plywood about 0.68.
    pub density: Option<f64>,
}

const THICKNESS: Range =
    Range::new(1e-3, 1000.0, "mm", "foils start at a few micrometres, and no beam cuts a metre");
const DENSITY: Range = Range::new(1e-3, 25.0, "g/cm3", "foam has some hundredths, and no metal more than 23");

/// The fields of [`Material`].
pub(super) const MATERIAL: &[Field] = &[
    Field::nullable("name", Kind::Text),
    Field::nullable("thickness", Kind::Number(THICKNESS)),
    Field::nullable("density", Kind::Number(DENSITY)),
];

impl Shaped for Material {
    const SHAPE: fields::Shape = fields::Shape {
        owner: "The material",
        item: "field",
        value: "The material's field",
        fields: MATERIAL,
    };
}

impl Material {
    /// Checks the thickness and the density, which may not have been read through [`Shaped`].
    pub(super) fn check(&self) -> Result<(), FieldError> {
        let numbers = [("thickness", self.thickness, THICKNESS), ("density", self.density, DENSITY)];
        for (name, value, range) in numbers {
            if let Some(n) = value.filter(|n| !range.holds(*n)) {
                return Err(FieldError::out_of_range(Self::SHAPE.value, name, n, &range));
            }
        }
        Ok(())
    }
}
