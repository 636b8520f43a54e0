//! The report of a quote: what a shop asks of a job before it names a price.
//!
//! It is made from the plan document ([`crate::plan::document`]) alone, which is the same natively, under Node and in a
//! browser for the same drawing, options, seed and moves. So the report is the same, too, and so is its hash: a server that
//! plans the drawing again with the moves that the report names must come to the same hash, or the report belongs to another
//! plan. Prices are no part of it.
//!
//! Inside one program, [`crate::job::Job::quote`] makes the document and its quote without writing it out. A quote from the
//! text of a document is `quote(&Document::read(text)?, &terms)?`; both come to the same hash.

mod confidence;
mod limits;
mod material;
mod narrow;
mod parts;
mod report;
mod seconds;
mod shape;
mod terms;
mod times;

pub use confidence::{Confidence, Defect, Level, Reason, ReasonCode};
pub use limits::{CheckCode, Checks, Exceeded, Limits};
pub use material::Material;
pub use parts::{PartGroup, PartItem};
pub use report::{LayerUse, Narrowest, Quote, Smallest};
pub use terms::Terms;
pub use times::Times;

use crate::fields::FieldError;
use crate::geometry::Segment;
use crate::output::{json_text, sha256};
use crate::plan::Turn;
use crate::plan::document::{Document, Stroke, strokes};
use shape::Shape;

/// The report of a plan document.
///
/// # Errors
/// A thickness, density or limit out of its range.
pub fn quote(document: &Document, terms: &Terms) -> Result<Quote, FieldError> {
    terms.check()?;
    let mut quote = report::made(document, &shapes(document), terms);
    let (name, version) = (std::mem::take(&mut quote.input.name), std::mem::take(&mut quote.version));
    quote.hash = hash(&quote);
    (quote.input.name, quote.version) = (name, version);
    Ok(quote)
}

/// Of the whole report: what was planned from, how, and every figure; of the budget only the moves done, as seconds
/// are not the same twice. The name of the file and the version of the planner are empty in it: the same file under another
/// name is the same job, and a version that changes no figure changes no hash.
fn hash(quote: &Quote) -> String {
    sha256(json_text(quote))
}

/// Every contour's line, as it is drawn.
fn shapes(document: &Document) -> Vec<Shape> {
    let mut shapes = vec![Shape::default(); document.contours.len()];
    // The length that is still missing; further passes over a contour add nothing to its line.
    let mut missing: Vec<f64> = document.contours.iter().map(|c| c.length).collect();
    for stroke in strokes(document) {
        if let Stroke::Beam { contour: Some(id), path, leads, turns } = stroke
            && let (Some(shape), Some(missing)) = (shapes.get_mut(id as usize), missing.get_mut(id as usize))
            && (document.contours[id as usize].passes == 1
                || *missing > 0.5 * document.contours[id as usize].length)
        {
            let path = Turn::undone(&path, &turns);
            let on = leads.divide(&path)[1];
            *missing -= on.iter().map(Segment::length).sum::<f64>();
            shape.add(on);
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
