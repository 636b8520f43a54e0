//! Splines and ellipses become lines and arcs: measured against a dense evaluation of the curve itself.

mod distances;
mod exact;
mod fit;
mod splines;
