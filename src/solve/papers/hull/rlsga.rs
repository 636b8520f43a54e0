//! The parameters of `rlsga` and `sga`, as methods.

use super::agent::Learning;
use super::decode::Decoder;
use super::genetic::{Genetic, Rates};
use crate::problem::Problem;
use crate::solve::papers::Measure;
use crate::solve::papers::lead::Running;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

pub(super) const SOURCE: &str = "Liu & Chang: An Improved Method for Optimizing CNC Laser Cutting Paths for Ship Hull Components \
                                 with Thicknesses up to 24 mm. J. Mar. Sci. Eng. 11 (2023) 652";

/// The segmented genetic algorithm based on reinforcement learning. It starts from random chromosomes, whatever path it is
/// given.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Rlsga {
    /// Chromosomes n. The paper has 200 for ten parts with 45 segments and 100 for five with 20.
    pub population: u32,
    /// Generations t_max; it ends after them.
    pub generations: u32,
    /// Probability pC that a pair is crossed.
    pub crossover: f64,
    /// Probability pMu that two codes of a path change places.
    pub mutation: f64,
    /// Probability pMi that a run of codes moves to another path.
    pub migration: f64,
    /// Learning rate alpha of eq. (11).
    pub alpha: f64,
    /// Discount gamma of eq. (11).
    pub gamma: f64,
    /// Probability epsilon of a random action.
    pub epsilon: f64,
    /// Fitness in eq. (6) divided by its mean, so that the state does not hang on the unit of length. The paper: no.
    pub scaled_fitness: bool,
    /// What empty travel is measured in, eq. (1).
    pub measure: Measure,
}

impl Default for Rlsga {
    fn default() -> Self {
        Self {
            population: 200,
            generations: 1000,
            crossover: 0.6,
            mutation: 0.1,
            migration: 0.1,
            alpha: 0.9,
            gamma: 0.9,
            epsilon: 0.1,
            scaled_fitness: true,
            measure: Measure::Euclidean,
        }
    }
}

impl Rlsga {
    /// Starts the algorithm, with an agent that learns or one that does not.
    fn run<'p>(&self, problem: &'p Problem, seed: u64, learning: Option<Learning>) -> Box<dyn Search + 'p> {
        let rates = Rates {
            population: self.population as usize,
            generations: self.generations,
            crossover: self.crossover,
            mutation: self.mutation,
            migration: self.migration,
            scaled_fitness: self.scaled_fitness,
        };
        let decoder = Decoder::new(problem, self.measure);
        Box::new(Running(Genetic::new(decoder, rates, learning, seed)))
    }
}

impl Solver for Rlsga {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "rlsga",
            title: "RLSGA",
            about: "A genetic algorithm over the segments of contours, which learns which of three crossovers to use.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let learning = Learning { alpha: self.alpha, gamma: self.gamma, epsilon: self.epsilon };
        self.run(problem, seed, Some(learning))
    }
}

/// The same without learning: a random crossover in each generation (section 5.2).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sga {
    /// Chromosomes n.
    pub population: u32,
    /// Generations t_max; it ends after them.
    pub generations: u32,
    /// Probability pC that a pair is crossed.
    pub crossover: f64,
    /// Probability pMu that two codes of a path change places.
    pub mutation: f64,
    /// Probability pMi that a run of codes moves to another path.
    pub migration: f64,
    /// What empty travel is measured in, eq. (1).
    pub measure: Measure,
}

impl Default for Sga {
    fn default() -> Self {
        let Rlsga { population, generations, crossover, mutation, migration, measure, .. } = Rlsga::default();
        Self { population, generations, crossover, mutation, migration, measure }
    }
}

impl Solver for Sga {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "sga",
            title: "SGA",
            about: "RLSGA without learning: the crossover of each generation is a random one.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let Self { population, generations, crossover, mutation, migration, measure } = *self;
        let same =
            Rlsga { population, generations, crossover, mutation, migration, measure, ..Rlsga::default() };
        same.run(problem, seed, None)
    }
}
