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

/// The report of a plan document.
///
/// # Errors
/// One sentence: not a plan document, or a thickness or density that cannot be.
pub fn quote(plan_json: &str, material: &Material) -> Result<Quote, String> {
    for (what, unit, value) in
        [("thickness", "mm", material.thickness), ("density", "g/cm3", material.density)]
    {
        if value.is_some_and(|v| !(v.is_finite() && v > 0.0)) {
            return Err(format!(
                "The {what} cannot be {} {unit}. Give a number above 0.",
                value.unwrap_or(0.0)
            ));
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
