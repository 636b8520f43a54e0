//! The report of a quote: what a shop asks of a job before it names a price.
//!
//! It is made of the plan document (`kerfway.plan/1`) alone, which is the same bytes natively, under Node and in a
//! browser for the same drawing, options, seed and moves. So the report is, too, and so is its hash: a server that
//! plans the drawing again with the moves the report names must come to the same hash, or the report is another's.
//! Prices are no part of it.

mod confidence;
mod document;
mod narrow;
mod parts;
mod report;
mod shape;

pub use confidence::{Confidence, Defect, Level};
pub use report::{LayerUse, Narrowest, PartGroup, Quote, Smallest, Times};

use crate::fields::{self, Field, Kind, Range, Shaped, out_of_range};
use crate::output::json_text;
use crate::output::picture::{Picture, Stroke};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use shape::Shape;

/// What the sheet is made of.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Material {
    /// For people.
    pub name: Option<String>,
    /// mm.
    pub thickness: Option<f64>,
    /// g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19, birch plywood about 0.68.
    pub density: Option<f64>,
}

const THICKNESS: Range =
    Range::new(1e-3, 1000.0, "mm", "foils start at a few micrometres, and no beam cuts a metre");
const DENSITY: Range = Range::new(1e-3, 25.0, "g/cm3", "foam has some hundredths, and no metal more than 23");

impl Shaped for Material {
    const SHAPE: fields::Shape = fields::Shape {
        owner: "The material",
        item: "field",
        value: "The material's field",
        fields: &[
            Field::nullable("name", Kind::Text),
            Field::nullable("thickness", Kind::Number(THICKNESS)),
            Field::nullable("density", Kind::Number(DENSITY)),
        ],
    };
}

/// The report of a plan document.
///
/// # Errors
/// One sentence: not a plan document, or a thickness or density that cannot be.
pub fn quote(plan_json: &str, material: &Material) -> Result<Quote, String> {
    let numbers = [("thickness", material.thickness, THICKNESS), ("density", material.density, DENSITY)];
    for (name, value, range) in numbers {
        if let Some(n) = value.filter(|n| !range.holds(*n)) {
            return Err(out_of_range(Material::SHAPE.value, name, n, &range));
        }
    }
    let picture = Picture::read(plan_json)?;
    let head: document::Head =
        serde_json::from_str(plan_json).map_err(|e| format!("This is not a whole plan document: {e}."))?;
    let shapes = shapes(&picture, head.contours.len());
    let mut quote = report::made(head, &shapes, material);
    quote.hash = hash(&quote);
    Ok(quote)
}

/// Of the whole report: what was planned from, how, and every figure; of the budget only the moves done, as seconds
/// are not the same twice.
fn hash(quote: &Quote) -> String {
    Sha256::digest(json_text(quote)).iter().map(|b| format!("{b:02x}")).collect()
}

/// Every contour's line, as it is drawn.
fn shapes(picture: &Picture, contours: usize) -> Vec<Shape> {
    let mut shapes: Vec<Shape> = (0..contours).map(|_| Shape::default()).collect();
    for stroke in &picture.strokes {
        if let Stroke::Beam { contour: Some(id), path } = stroke
            && let Some(shape) = shapes.get_mut(*id)
        {
            shape.add(path);
        }
    }
    for (shape, outline) in shapes.iter_mut().zip(&picture.outlines) {
        if let Some(outline) = outline {
            *shape = Shape::default();
            shape.add(outline);
        }
    }
    shapes
}
