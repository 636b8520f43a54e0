//! `dual-coding-ga`: Jianjun Yang, "Application of Improved Dual Coding Genetic Algorithm for Contour Path Planning in
//! Laser Processing", Information Technology Journal (2013), ISSN 1812-5638.
//!
//! A chromosome has two rows: the order of the contours, and the feature point where each is entered (`code.rs`, with
//! crossovers and mutations). The method minimises the travel *time*: the head moves along both axes at once, so an air
//! move takes the time of the longer axis, eq. (1). Fitness is scaled more strongly with every generation, eq. (2)
//! (`fitness.rs`).
//!
//! The paper does not give the following. Selection is by roulette on (2). Children replace their parents, and the best
//! code is remembered separately. The crossover probability applies to a pair, the mutation probability to a child. The run
//! ends after `generations`. Feature points are the nodes of the sheet; those of the paper, vertices and eighths of
//! circles, are in the instance in `tests/fixtures/yang`.
//!
//! Deviations: by default the legs from home and back to it count, which eq. (1) does not have (`home_legs`). The paper has
//! no holes, ranks or groups; where a sheet has them, the order is repaired, and the fitness is that of the repaired order.

mod code;
mod fitness;
mod search;

pub use search::DualCodingGa;
