//! From shapes to contours to parts, on drawings made by hand, at random, and real ones.

mod assemble;
mod clean;
mod cross;
mod fixtures;
mod layers;
mod metamorphic;
mod nest;
mod sketch;
