//! Plane geometry in millimetres and radians. It knows neither drawings nor machines.
//!
//! Every [`Path`] consists of two kinds of [`Segment`]: lines and arcs. Ellipses and splines are converted to these by
//! biarc fitting within a given tolerance, so later stages handle only two kinds.

mod aabb;
mod affine;
mod affine_path;
pub(crate) mod arcs;
mod bezier;
mod biarc;
mod box_index;
mod buckets;
mod budget;
mod cells;
mod chain;
mod cover;
mod distance;
mod ellipse;
mod fit;
mod inscribed;
mod interpolate;
mod intersect;
mod knots;
pub mod math;
mod nurbs;
mod path;
mod recognise;
mod sample;
mod sampler;
mod segment;
mod union;
mod winding;

pub use aabb::Aabb;
pub use affine::Affine;
pub use bezier::Beziers;
pub use box_index::BoxIndex;
pub use buckets::Buckets;
pub use budget::Budget;
pub use cells::Cells;
pub use distance::distance;
pub use ellipse::Ellipse;
pub use glam::DVec2;
pub use inscribed::inscribed;
pub use intersect::{Intersections, Meeting, Overlap, intersect};
pub use knots::CurveError;
pub use nurbs::{MAX_DEGREE, Nurbs};
pub use path::Path;
pub(crate) use path::pin_ends;
pub use segment::{Arc, Line, Segment};
pub(crate) use union::Union;
pub use winding::{Winding, filled_area, interior_point, winding, winding_number};
