//! From shapes to contours to parts, on drawings made by hand, at random, and real ones.
#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

mod assemble;
mod clean;
mod cross;
mod fixtures;
mod layers;
mod lettering;
mod metamorphic;
mod metamorphic_networks;
mod near_copies;
mod nest;
mod networks;
mod overlaps;
mod sketch;
