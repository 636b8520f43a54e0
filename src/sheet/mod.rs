//! From shapes to contours to parts: ends joined, copies removed, nesting found. See [`build`] and [`Sheet`].
//!
//! ```text
//! shapes -> layers: operations, order, what names suggest; ignored ones set aside
//!        -> clean: every line and arc once (zero lengths, copies, overlaps)
//!        -> assemble: chains joined end to end, best match first; gaps closed bit for bit
//!        -> exclude: contours left out one by one
//!        -> cross: contours that cross themselves or each other
//!        -> nest: containment tree of any depth; the sheet's own border recognised
//!        -> groups: contours that share cuts, and what they close in
//!        -> small: contours too narrow for any beam
//!        -> parts: outer contours counter-clockwise, holes clockwise, parts in holes
//! contours, machine with a kerf width
//!        -> kerf: the lines of the beam, half a kerf beside the outlines; groups anew
//! ```
//!
//! Everything that is left out, changed or doubted is a finding with its place. Results depend on the drawing alone:
//! no order of a hash map decides anything, and ties fall by drawing order. Every step is bounded for hostile
//! drawings (all ends in one point, 100,000 lines on top of each other): how, stands at each.

mod about;
mod assemble;
mod build;
mod clean;
mod cluster;
mod cross;
mod element;
mod exclude;
mod groups;
mod kerf;
mod layers;
mod model;
mod nest;
mod outline;
mod parts;
mod small;
mod source;
mod words;

pub use build::build;
pub use groups::{GroupElement, PierceGroup};
pub(crate) use kerf::compensated;
pub use model::{CommonCuts, Contour, Ignored, LayerUse, Operation, Part, Pin, Sheet, SheetOptions};
