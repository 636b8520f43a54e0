//! `pso`: the standard particle swarm on random keys, eqs (14) and (15), from which Qu & Du start: constant weights,
//! uniform random numbers, no flights, and comparison by length. The paper does not give their parameters; these are those
//! of the constricted swarm (Clerc & Kennedy, IEEE Transactions on Evolutionary Computation 6, 2002).

use super::particles::Swarm;
use super::proximity::{Initial, Initialisation, PROXIMITY_STEPS, Shortest};
use super::run::{Guide, Run};
use super::settings::{Draws, SwarmSettings, Weights};
use crate::problem::Problem;
use crate::solve::rng::{Draw, Rng};
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pso {
    /// Parameters of every swarm method.
    #[serde(flatten)]
    pub settings: SwarmSettings,
    /// Constant weights.
    #[serde(flatten)]
    pub weights: Weights,
    /// Where the particles begin.
    pub initial: Initial,
}

impl Default for Pso {
    fn default() -> Self {
        let (settings, weights) = (SwarmSettings::with(0.2, Draws::Key), Weights::CONSTRICTED);
        Self { settings, weights, initial: Initial::Random }
    }
}

impl Solver for Pso {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "pso",
            title: "PSO",
            about: "Standard particle swarm on random keys; what LPSPSO is compared with.",
            source: Some(
                "As compared with by P. Qu, F. Du, IEEE Access 11 (2023), doi 10.1109/ACCESS.2023.3236006; parameters of \
                 M. Clerc, J. Kennedy, IEEE Trans. Evol. Comput. 6 (2002)",
            ),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let guide = StandardGuide::new(self.weights, self.settings.draws, self.initial);
        Run::start(problem, seed, &self.settings, guide)
    }
}

/// The rules of the standard swarm, which the other methods use as well.
pub(super) struct StandardGuide {
    weights: Weights,
    draws: Draws,
    initialisation: Initialisation,
    /// The random numbers of the particle that is being moved, and the iteration of the second one.
    drawn: (f64, f64, Option<u32>),
}

impl StandardGuide {
    /// A swarm that is not initialised yet.
    pub(super) fn new(weights: Weights, draws: Draws, initial: Initial) -> Self {
        let initialisation = Initialisation::new(initial, PROXIMITY_STEPS, Shortest::Whole);
        Self { weights, draws, initialisation, drawn: (0.0, 0.0, None) }
    }
}

impl Guide for StandardGuide {
    fn initialise(&mut self, swarm: &mut Swarm) -> Option<u64> {
        self.initialisation.piece(swarm)
    }

    fn move_keys(&mut self, swarm: &mut Swarm, particle: usize, keys: Range<usize>) {
        let weights = self.weights;
        if self.draws == Draws::Equation {
            if keys.start == 0 {
                self.drawn.0 = swarm.rng.uniform();
            }
            if self.drawn.2 != Some(swarm.round) {
                self.drawn = (self.drawn.0, swarm.rng.uniform(), Some(swarm.round));
            }
            let (own, all) = (weights.own * self.drawn.0, weights.swarm * self.drawn.1);
            return swarm.pull(particle, keys, |_| Weights { own, swarm: all, ..weights });
        }
        let draw = |rng: &mut Rng| Weights {
            own: weights.own * rng.uniform(),
            swarm: weights.swarm * rng.uniform(),
            ..weights
        };
        swarm.pull(particle, keys, draw);
    }
}
