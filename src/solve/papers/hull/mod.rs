//! `rlsga` and what it is compared with: Liu & Chang, "An Improved Method for Optimizing CNC Laser Cutting Paths for Ship Hull
//! Components with Thicknesses up to 24 mm", Journal of Marine Science and Engineering 11, 652 (2023),
//! doi:10.3390/jmse11030652. Its problem is HPCPO, the cutting path of hull parts by partial cutting.
//!
//! 1. `model.rs`: the segments of all contours, cut in any order and either way, eqs (1) and (2).
//! 2. `chromosome.rs`, `crossover.rs`, `filling.rs`: eq. (3), mutation, migration, PSX, RSX and ISX (section 4.3).
//! 3. `agent.rs`: state, actions, rewards, Q-table, eqs (5) to (11). `genetic.rs`: the generations of `rlsga` and `sga`.
//! 4. `swarm.rs`, `rules.rs`: `hull-pso`, `ofa`, `woa` on random keys (section 5.2).
//! 5. `decode.rs`, `nested.rs`, `holes.rs`: from a chromosome to a plan.
//!
//! Deviations: fitness is scaled in (6) (`scaled_fitness`), ways turn with their runs in RSX (the paper is silent), and where
//! a sheet has holes or ranks, the fitness is that of the repaired path (the paper has none).

mod agent;
mod chromosome;
mod crossover;
mod decode;
mod filling;
mod flock;
mod genetic;
mod holes;
mod model;
mod nested;
mod rlsga;
mod rules;
mod settings;
mod swarm;
mod swarms;
#[cfg(test)]
mod tests;

pub use rlsga::{Rlsga, Sga};
pub use settings::{HullSettings, OperatorRates};
pub use swarms::{HullPso, Ofa, Woa};
