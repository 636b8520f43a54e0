//! `rlsga` and the methods it is compared with: Liu & Chang, "An Improved Method for Optimizing CNC Laser Cutting Paths for
//! Ship Hull Components with Thicknesses up to 24 mm", Journal of Marine Science and Engineering 11, 652 (2023),
//! doi:10.3390/jmse11030652. The problem, HPCPO, is the cutting path of hull parts with partial cutting.
//!
//! 1. `model.rs`: the segments of all contours, which are cut in any order and direction, eqs (1) and (2).
//! 2. `chromosome.rs`, `crossover.rs`, `filling.rs`: eq. (3), mutation, migration, and the crossovers PSX, RSX and ISX
//!    (section 4.3).
//! 3. `agent.rs`: states, actions, rewards and Q-table, eqs (5) to (11). `genetic.rs`: the generations of `rlsga` and
//!    `sga`.
//! 4. `key_search.rs`, `rules.rs`, `permutations.rs`: `hull-pso`, `ofa` and `woa` on random keys or on permutations (section
//!    5.2).
//! 5. `decode.rs`, `nested.rs`, `holes.rs`: from a chromosome to a plan.
//!
//! Readings and deviations that are parameters: eq. (6) uses scaled fitness (`scaled_fitness`); eq. (9) follows its sentence
//! (`mean_reward`); eq. (11) takes the action chosen next (`next_action`); RSX turns the cutting directions of a run
//! (`reversed_run`); the comparators have random keys (`encoding`).
//!
//! Those that are none: segments lie between the nodes of the sheet, which has places between the corners of a long side,
//! while the paper's lie between corners; the paths of the first population hold the segments of their own contours; the two
//! places of a mutation may be the same, and then nothing changes; and where a sheet has holes or ranks, which the paper does
//! not have, the fitness is that of the repaired path.

mod agent;
mod chromosome;
mod crossover;
mod decode;
mod filling;
mod genetic;
mod holes;
mod key_methods;
mod key_search;
mod members;
mod model;
mod nested;
mod permutations;
mod rlsga;
mod rules;
mod settings;
#[cfg(test)]
mod tests;

pub use agent::{MeanReward, NextAction};
pub use crossover::ReversedRun;
pub use key_methods::{HullPso, Ofa, Woa};
pub use rlsga::{Rlsga, Sga};
pub use settings::{Encoding, HullSettings, OperatorRates};
