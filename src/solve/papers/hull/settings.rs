//! Parameters that several methods for hull parts share. Each method holds them in a field that serde flattens, so callers
//! see one flat object.

use crate::solve::papers::Measure;
use serde::{Deserialize, Serialize};

/// Parameters of every method for hull parts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HullSettings {
    /// Number of solutions in the population (n). The paper has 200 for ten parts with 45 segments and 100 for five parts
    /// with 20.
    pub population: u32,
    /// Number of generations (t_max), after which the method ends.
    pub generations: u32,
    /// How empty travel is measured, eq. (1).
    pub measure: Measure,
}

impl Default for HullSettings {
    fn default() -> Self {
        Self { population: 200, generations: 1000, measure: Measure::Euclidean }
    }
}

/// How `hull-pso`, `ofa` and `woa` represent a path. The paper only says that they solve the same model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Encoding {
    /// Random keys, on which the equations of the methods work as they stand.
    #[default]
    Keys,
    /// Permutations of the segments with directions, on which differences are lists of exchanges.
    Permutation,
}

/// Probabilities of the genetic operators, with and without learning.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OperatorRates {
    /// Probability pC that a pair is crossed.
    pub crossover: f64,
    /// Probability pMu that two codes of a path change places.
    pub mutation: f64,
    /// Probability pMi that a run of codes moves to another path.
    pub migration: f64,
}

impl Default for OperatorRates {
    fn default() -> Self {
        Self { crossover: 0.6, mutation: 0.1, migration: 0.1 }
    }
}
