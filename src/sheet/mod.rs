//! From shapes to contours to parts: ends joined, copies removed, nesting found. See [`Sheet`].

mod model;

pub use model::{Contour, Ignored, LayerUse, Operation, Part, Sheet, SheetOptions};
