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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::seeded;

    #[test]
    fn a_wheel_by_hand() {
        // Of a sum of 8: index 0 up to 1, index 2 up to 4, index 3 up to 8; index 1 has no share.
        let wheel = Roulette::new([1.0, 0.0, 3.0, 4.0]);
        let mut drawn = [0; 4];
        for seed in 0..4000 {
            let at = 8.0 * seeded(seed).uniform();
            let wanted = if at < 1.0 {
                0
            } else if at < 4.0 {
                2
            } else {
                3
            };
            let index = wheel.spin(&mut seeded(seed));
            assert_eq!(index, wanted, "{at}");
            drawn[index] += 1;
        }
        assert!(
            (400..600).contains(&drawn[0]) && drawn[1] == 0 && (1850..2150).contains(&drawn[3]),
            "{drawn:?}"
        );
        assert_eq!(Roulette::new([]).spin(&mut seeded(1)), 0);
    }
}
