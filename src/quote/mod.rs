//! The report of a quote: what a shop asks of a job before it names a price.
//!
//! It is made from the plan document ([`crate::plan::document`]) alone, which is the same natively, under Node and in a
//! browser for the same drawing, options, seed and moves. So the report is the same, too, and so is its hash: a server that
//! plans the drawing again with the moves that the report names must come to the same hash, or the report belongs to another
//! plan. Prices are no part of it.
//!
//! Inside one program, [`crate::job::Job::quote`] makes the document and its quote without writing it out. A quote from the
//! text of a document is `quote(&Document::read(text)?, &material)?`; both come to the same hash.

mod confidence;
mod material;
mod narrow;
mod parts;
mod report;
mod shape;

pub use confidence::{Confidence, Defect, Level};
pub use material::Material;
pub use parts::PartGroup;
pub use report::{LayerUse, Narrowest, Quote, Smallest, Times};

use crate::output::json_text;
use crate::plan::document::{Document, Stroke, strokes};
use sha2::{Digest, Sha256};
use shape::Shape;

/// The report of a plan document.
///
/// # Errors
/// One sentence: a thickness or density out of its range.
pub fn quote(document: &Document, material: &Material) -> Result<Quote, String> {
    material.check()?;
    let mut quote = report::made(document, &shapes(document), material);
    quote.hash = hash(&quote);
    Ok(quote)
}

/// Of the whole report: what was planned from, how, and every figure; of the budget only the moves done, as seconds
/// are not the same twice.
fn hash(quote: &Quote) -> String {
    Sha256::digest(json_text(quote)).iter().map(|b| format!("{b:02x}")).collect()
}

/// Every contour's line, as it is drawn.
fn shapes(document: &Document) -> Vec<Shape> {
    let mut shapes = vec![Shape::default(); document.contours.len()];
    for stroke in strokes(document) {
        if let Stroke::Beam { contour: Some(id), path } = stroke
            && let Some(shape) = shapes.get_mut(id as usize)
        {
            shape.add(&path);
        }
    }
    for (shape, contour) in shapes.iter_mut().zip(&document.contours) {
        if let Some(outline) = &contour.drawn {
            *shape = Shape::default();
            shape.add(&outline.segments());
        }
    }
    shapes
}
