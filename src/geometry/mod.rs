//! Plane geometry in millimetres and radians; it knows no drawing and no machine.
//!
//! Two kinds of element ([`Segment`]: line, arc) make up every [`Path`]. Ellipses and splines become elements by
//! biarc fitting within a stated tolerance, so later stages know two kinds only.

mod aabb;
pub mod math;
mod path;
mod segment;

pub use aabb::Aabb;
pub use glam::DVec2;
pub use path::Path;
pub use segment::{Arc, Line, Segment};
