//! Selection in proportion to fitness ("roulette wheel").

use crate::solve::rng::{Draw, Rng};

/// Draws indices with probabilities in proportion to their fitness.
#[derive(Clone, Debug, Default)]
pub(super) struct Roulette {
    /// For each index, the sum of the fitness values up to it.
    sums: Vec<f64>,
}

impl Roulette {
    /// A wheel for these fitness values.
    pub(super) fn new(fitness: impl IntoIterator<Item = f64>) -> Self {
        let mut sum = 0.0;
        let add = |f| {
            sum += f;
            sum
        };
        Self { sums: fitness.into_iter().map(add).collect() }
    }

    /// Draws an index; 0 when there are none.
    pub(super) fn spin(&self, rng: &mut Rng) -> usize {
        let at = rng.uniform() * self.sums.last().copied().unwrap_or(0.0);
        self.sums.partition_point(|&s| s <= at).min(self.sums.len().saturating_sub(1))
    }
}
