//! Corners that the beam does not stop in: it runs through waste and crosses the corner twice (a *loop*), or cuts an arc
//! instead (a *rounded* corner), where the machine's `levers.corners` or a person allow that.
//!
//! This stage finds the corners of a contour that may be cut so (`planner.rs`): loops lie in the waste and keep their distance
//! from every other contour; arcs stay within the greatest deviation. For each place of entry, those are chosen that save time
//! (`choice.rs`), by the look-ahead that prices every cut. The elements of a cut with these corners are made in `turned.rs`.

mod choice;
mod planner;
mod turned;

pub use choice::chosen;
pub use planner::{ContourCorners, Planner};
pub use turned::{Corner, Made, turned};
