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

mod flights;
mod guide;
mod parameters;

pub use parameters::{Flights, Kappa, Lpspso, Stagnation};

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
