//! `pso`: the standard particle swarm that Qu & Du start from, eqs (14) and (15), on random keys: constant weights, even
//! random numbers, no flights, lengths as they are. Their parameters are not in the paper; these are the constricted
//! swarm's (Clerc & Kennedy, IEEE Transactions on Evolutionary Computation 6, 2002).

use super::flock::Flock;
use super::run::{Guide, Run};
use super::settings::{SwarmSettings, Weights};
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
}

impl Default for Pso {
    fn default() -> Self {
        Self { settings: SwarmSettings::with_fastest(0.2), weights: Weights::CONSTRICTED }
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
        Run::start(problem, seed, &self.settings, Plain::new(self.weights))
    }
}

/// The standard swarm at work; the others move as it does.
pub(super) struct Plain {
    weights: Weights,
    /// Particles that have their keys.
    sown: usize,
}

impl Plain {
    /// A swarm that is not sown yet.
    pub(super) fn new(weights: Weights) -> Self {
        Self { weights, sown: 0 }
    }
}

impl Guide for Plain {
    fn sow(&mut self, flock: &mut Flock) -> Option<u64> {
        if self.sown == flock.particles.len() {
            return None;
        }
        flock.draw(self.sown, None);
        self.sown += 1;
        Some(flock.worth.keys.count() as u64)
    }

    fn drive(&mut self, flock: &mut Flock, particle: usize, keys: Range<usize>) {
        let Weights { inertia, own, swarm } = self.weights;
        let draw =
            |rng: &mut Rng| Weights { inertia, own: own * rng.uniform(), swarm: swarm * rng.uniform() };
        flock.pull(particle, keys, draw);
    }
}
