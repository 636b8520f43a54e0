//! Kerfway plans the path of a laser cutter.
//!
//! ```text
//! DXF bytes -> drawing -> contours -> parts -> problem -> solver -> plan -> output
//!              (dxf)      (sheet)   (sheet)   (problem)  (solve)   (plan)  (output)
//! ```
//!
//! Data flows one way: geometry knows no machine, solvers know no DXF, output knows no solver.
//! Units: mm, s, rad, counter-clockwise positive.

pub mod geometry;

pub mod dxf;
pub mod fields;
pub mod finding;
pub mod job;
pub mod machine;
mod order;
pub mod output;
pub mod plan;
pub mod problem;
pub mod quote;
pub mod sheet;
pub mod solve;

#[cfg(target_arch = "wasm32")]
pub mod wasm;
