//! The plan document: a plan with everything it came from, as other programs read it. The format is `kerfway.plan/1`, and
//! its JSON Schema is `www/sdk/plan.schema.json`.
//!
//! This is the one model of that format. [`crate::output::json_text`] writes it, the PNG renderer draws it, and a quote is
//! made from it, whether it was made from a plan in memory or read from text by [`Document::read`]. Numbers survive text
//! bit for bit, so both ways give the same quote.
//!
//! Everything needed to check or repeat the plan is in it: the drawing's hash, its units and their source, the method, the
//! seed and the budget, the machine, the options, the moves and the findings. Lengths are in mm, areas in mm2, times in s;
//! y points up, and angles run counter-clockwise.

mod contour;
mod model;
mod moves;
mod strokes;

pub use contour::{Contour, Outline, contours};
pub use model::{Budget, Document, Input, LayerOperation, Options, Placement, SCHEMA};
pub(crate) use moves::segments;
pub use moves::{Contours, Element, Move};
pub use strokes::{Stroke, strokes};
