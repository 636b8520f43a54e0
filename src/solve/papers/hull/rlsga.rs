//! The methods `rlsga` and `sga` and their parameters.

use super::agent::{Learning, MeanReward, NextAction};
use super::crossover::ReversedRun;
use super::decode::Decoder;
use super::genetic::{Breeding, Genetic};
use super::settings::{HullSettings, OperatorRates};
use crate::problem::Problem;
use crate::solve::papers::piecewise::PiecewiseSearch;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

pub(super) const SOURCE: &str = "Liu & Chang: An Improved Method for Optimizing CNC Laser Cutting Paths for Ship Hull Components \
                                 with Thicknesses up to 24 mm. J. Mar. Sci. Eng. 11 (2023) 652";

/// The segmented genetic algorithm based on reinforcement learning. It starts from random chromosomes, whatever path it is
/// given.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rlsga {
    /// Parameters of every method for hull parts.
    #[serde(flatten)]
    pub settings: HullSettings,
    /// Probabilities of the genetic operators.
    #[serde(flatten)]
    pub rates: OperatorRates,
    /// Learning rate alpha of eq. (11).
    pub alpha: f64,
    /// Discount factor gamma of eq. (11).
    pub gamma: f64,
    /// Probability epsilon of a random action.
    pub epsilon: f64,
    /// Whether eq. (6) uses fitness divided by its mean, so that the state does not depend on the unit of length. The paper
    /// does not scale it.
    pub scaled_fitness: bool,
    /// With what eq. (9) compares the mean fitness of a generation.
    pub mean_reward: MeanReward,
    /// Whose value eq. (11) takes in the next state.
    pub next_action: NextAction,
    /// What RSX reverses; the paper does not say whether the cutting directions turn.
    pub reversed_run: ReversedRun,
}

impl Default for Rlsga {
    fn default() -> Self {
        Self {
            settings: HullSettings::default(),
            rates: OperatorRates::default(),
            alpha: 0.9,
            gamma: 0.9,
            epsilon: 0.1,
            scaled_fitness: true,
            mean_reward: MeanReward::Sentence,
            next_action: NextAction::Chosen,
            reversed_run: ReversedRun::Turned,
        }
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
        let Self { alpha, gamma, epsilon, mean_reward, next_action, reversed_run, .. } = *self;
        let learning = Learning { alpha, gamma, epsilon, mean_reward, next_action };
        let breeding = Breeding { rates: self.rates, scaled_fitness: self.scaled_fitness, reversed_run };
        let decoder = Decoder::new(problem, self.settings.measure);
        Box::new(PiecewiseSearch(Genetic::new(decoder, self.settings, breeding, Some(learning), seed)))
    }
}

/// RLSGA without learning: each generation uses a random crossover (section 5.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sga {
    /// Parameters of every method for hull parts.
    #[serde(flatten)]
    pub settings: HullSettings,
    /// Probabilities of the genetic operators.
    #[serde(flatten)]
    pub rates: OperatorRates,
    /// What RSX reverses, as in `rlsga`.
    pub reversed_run: ReversedRun,
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
        let breeding = Breeding {
            rates: self.rates,
            scaled_fitness: Rlsga::default().scaled_fitness,
            reversed_run: self.reversed_run,
        };
        let decoder = Decoder::new(problem, self.settings.measure);
        Box::new(PiecewiseSearch(Genetic::new(decoder, self.settings, breeding, None, seed)))
    }
}
