//! `pso`: the standard particle swarm that Qu & Du start from, eqs (14) and (15), on random keys: constant weights, even
//! random numbers, no flights, lengths as they are. Their parameters are not in the paper; these are the constricted
//! swarm's (Clerc & Kennedy, IEEE Transactions on Evolutionary Computation 6, 2002).

use super::super::legs::Measure;
use super::flock::{Flock, Pull};
use super::run::{Guide, Run, Settings};
use crate::problem::{NodeId, Problem};
use crate::solve::dice::Dice;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Pso {
    /// Particles.
    pub particles: u32,
    /// Iterations.
    pub rounds: u32,
    /// How ways are measured.
    pub measure: Measure,
    /// 2-opt, Or-opt and the best entries on each particle's tour before it is valued.
    pub local_search: bool,
    /// The node every path starts with; none: any.
    pub first: Option<NodeId>,
    /// Inertia weight.
    pub inertia: f64,
    /// Individual learning factor.
    pub own: f64,
    /// Group learning factor.
    pub swarm: f64,
    /// Largest velocity, in shares of the range of a key.
    pub fastest: f64,
}

impl Default for Pso {
    fn default() -> Self {
        Self {
            particles: 50,
            rounds: 600,
            measure: Measure::Euclidean,
            local_search: true,
            first: None,
            inertia: 0.7298,
            own: 1.496_18,
            swarm: 1.496_18,
            fastest: 0.2,
        }
    }
}

impl Pso {
    /// What every swarm method is told.
    pub(super) fn settings(&self) -> Settings {
        Settings {
            particles: self.particles,
            rounds: self.rounds,
            measure: self.measure,
            local_search: self.local_search,
            first: self.first,
            fastest: self.fastest,
        }
    }

    /// How it moves.
    pub(super) fn plain(&self) -> Plain {
        Plain { pull: Pull { inertia: self.inertia, own: self.own, swarm: self.swarm }, sown: 0 }
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
        Run::start(problem, seed, &self.settings(), self.plain())
    }
}

/// The standard swarm at work; the others move as it does.
pub(super) struct Plain {
    pub(super) pull: Pull,
    /// Particles that have their keys.
    pub(super) sown: usize,
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
        let Pull { inertia, own, swarm } = self.pull;
        let draw = |dice: &mut Dice| Pull { inertia, own: own * dice.even(), swarm: swarm * dice.even() };
        flock.pull(particle, keys, draw);
    }
}
