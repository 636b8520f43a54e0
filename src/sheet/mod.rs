//! From shapes to contours to parts: joins ends, removes copies, determines the nesting. See [`build`] and [`Sheet`].
//!
//! ```text
//! shapes -> layers: operations, order, what names suggest; ignored layers are separated
//!        -> clean: every line and arc once (zero lengths, copies, overlaps)
//!        -> assemble: chains joined end to end, best match first; gaps closed bit for bit
//!        -> exclude: contours excluded one by one
//!        -> lettering: strokes of single-line lettering and leaders, as groups
//!        -> crossings: contours that cross themselves or each other
//!        -> near_copies: cuts along others, a little farther than the copy tolerance
//!        -> nest: containment tree of any depth; the sheet's own border recognised
//!        -> groups: contours that share cuts, and what they enclose
//!        -> narrow: contours too narrow for any beam
//!        -> parts: outer contours counter-clockwise, holes clockwise, parts in holes
//! contours, machine with bridges
//!        -> bridges: outlines of neighbours opened and joined by strips of material, one contour around several parts
//! contours, machine with a kerf width
//!        -> kerf: the lines of the beam, offset from the outlines by half the kerf; groups found again
//! contours, machine with skeleton cuts
//!        -> skeleton: straight cuts through the waste, last of all; what remains of the sheet
//! ```
//!
//! Everything that is skipped, changed or doubtful is reported as a finding with its place. Results depend on the
//! drawing alone: no hash order decides anything, and ties are decided by drawing order. Every step is bounded for
//! hostile drawings (all ends in one point, 100,000 lines on top of each other); its documentation says how.

mod assemble;
mod bridges;
mod build;
mod choices;
mod clean;
mod cluster;
mod crossings;
mod element;
mod exclude;
mod findings;
mod groups;
mod half_edges;
mod kerf;
mod layer_names;
mod layers;
mod lettering;
mod model;
mod narrow;
mod near_copies;
mod nest;
mod outline;
mod parts;
mod passes;
mod sequence;
mod skeleton;
mod sliver;
mod source;
mod together;

pub use build::build;
pub(crate) use findings::plural;
pub use groups::{GroupElement, PierceGroup};
pub(crate) use kerf::{Shift, compensated, shifts};
pub(crate) use layers::usual_operation;
pub use model::{
    BridgeCut, Bridged, CommonCuts, Contour, ContourChoice, Group, HandJoint, Ignored, LayerUse, Operation,
    Part, PassOrder, Pin, Sheet, SheetOptions, Strip,
};
