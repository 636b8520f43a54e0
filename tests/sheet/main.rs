//! From shapes to contours to parts, on drawings made by hand, at random, and real ones.

mod assemble;
mod clean;
mod cross;
mod nest;
mod sketch;
