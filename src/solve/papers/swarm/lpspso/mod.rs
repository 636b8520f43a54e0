//! LPSPSO: P. Qu, F. Du, "Improved Particle Swarm Optimization for Laser Cutting Path Planning", IEEE Access 11 (2023), doi
//! 10.1109/ACCESS.2023.3236006.
//!
//! The improved proximity method initialises the swarm (`proximity.rs`), and the prospect-regret value compares its paths
//! (`prospect.rs`). In each iteration the particles move by (19) and (20), with the inertia (16), the learning factors (17)
//! and the chaotic number (18); or they make Levy flights (21)-(24) if the threshold (25)-(27) is passed (`rules.rs`).
//!
//! 1. `parameters.rs`: the parameters and the readings.
//! 2. `guide.rs`: steps 3 to 7, iteration by iteration.
//! 3. `flights.rs`: the Levy flights of single particles.
//!
//! # Differences from the paper
//! * By default 2-opt and Or-opt improve every tour (`local_search`), and a flight to a longer path is undone
//!   (`flights_must_gain`); neither is in the paper.
//! * By default steps 4 and 6 are one move of an iteration. Word for word step 4 moves and values the swarm as well
//!   (`step_4`). By default the first paths are the shortest ones with the leg from the origin; the paper compares the sums
//!   between contours (`shortest`).
//! * Not given, and chosen here: how a particle becomes a tour (`decode`), the largest velocity (`fastest`), the size of
//!   flights (`levy_step`), when random numbers are drawn (`draws`), the base of (16) (`inertia_base`).
//! * Misprints are read as meant: (14), (15), (19) and (20) in `particles.rs`, (11) and (12) in `prospect.rs` (`regret`).
//! * Where the machine returns home, the way back counts. Precedence, which the paper does not have, is repaired.

mod flights;
mod guide;
mod parameters;

pub use parameters::{Flights, Kappa, Lpspso, Stagnation, Step4};

use super::run::Run;
use crate::problem::Problem;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use guide::LpspsoGuide;

impl Solver for Lpspso {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "lpspso",
            title: "LPSPSO",
            about: "Particle swarm with Levy flights, a power function for its inertia and a Singer map.",
            source: Some(
                "P. Qu, F. Du, Improved Particle Swarm Optimization for Laser Cutting Path Planning, IEEE Access 11 \
                 (2023), doi 10.1109/ACCESS.2023.3236006",
            ),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let items = problem.items.iter().filter(|i| !i.nodes.is_empty()).count();
        Run::start(problem, seed, &self.settings, LpspsoGuide::new(self.clone(), items))
    }
}
