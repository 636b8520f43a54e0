//! `dual-coding-ga`: Jianjun Yang, "Application of Improved Dual Coding Genetic Algorithm for Contour Path Planning in Laser
//! Processing", Information Technology Journal (2013), ISSN 1812-5638.
//!
//! A chromosome has two rows: the order of contours, and for each the feature point it is scanned from (`code.rs`, with its
//! crossovers and mutations). What is least is spare travel *time*: the head moves along both axes at once, so a way takes
//! the longer of its two parts, eq. (1). Fitness is stretched as generations go by, eq. (2) (`fitness.rs`).
//!
//! Where the paper is silent: selection is by roulette on (2), children take the place of their parents, the best so far is
//! kept aside, both probabilities are per pair and per child, and the run ends after `generations`. Feature points are the
//! nodes of the sheet; the paper's own, vertices and eighths of circles, are those of the instance in `tests/fixtures/yang`.
//! Where a sheet has holes, ranks or groups, the order is repaired before it is priced, and its fitness is that of the
//! repaired one: a deviation, as the paper has none.

mod code;
mod fitness;
mod search;

pub use search::DualCodingGa;
