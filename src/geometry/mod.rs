//! Plane geometry in millimetres and radians; it knows no drawing and no machine.
//!
//! Two kinds of element ([`Segment`]: line, arc) make up every [`Path`]. Ellipses and splines become elements by
//! biarc fitting within a stated tolerance, so later stages know two kinds only.

mod aabb;
mod affine;
mod biarc;
mod boxes;
mod buckets;
mod cells;
mod chain;
mod cover;
mod ellipse;
mod fit;
mod inside;
mod intersect;
mod knots;
mod mapped;
pub mod math;
mod nurbs;
mod path;
mod sample;
mod sampler;
mod segment;
mod single;
mod through;

pub use aabb::Aabb;
pub use affine::Affine;
pub use boxes::BoxIndex;
pub use buckets::Buckets;
pub use cells::Cells;
pub use ellipse::Ellipse;
pub use glam::DVec2;
pub use inside::{Winding, interior_point, turns, winding};
pub use intersect::{Intersections, Meeting, Overlap, intersect};
pub use knots::CurveError;
pub use nurbs::{MAX_DEGREE, Nurbs};
pub use path::Path;
pub use segment::{Arc, Line, Segment};
