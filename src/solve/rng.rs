//! Random numbers of the searches: [`rand`]'s traits over xoshiro256++, so that one seed draws the same numbers on every
//! machine.

use super::epsilon::EPSILON;
use crate::geometry::math;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// The random number generator of every search.
pub(super) type Rng = Xoshiro256PlusPlus;

/// The generator of a seed.
pub(super) fn seeded(seed: u64) -> Rng {
    Rng::seed_from_u64(seed)
}

/// What searches draw. The logarithms and cosines come from [`math`], because those of the platforms differ in the last
/// bit, and [`Draw::below`] does not follow [`RngExt::random_range`], whose numbers may change with the version of `rand`.
pub(super) trait Draw: rand::Rng {
    /// A uniform number in [0, 1).
    fn uniform(&mut self) -> f64 {
        self.random()
    }

    /// A uniform index below `n`, which is below 2^32.
    fn below(&mut self, n: usize) -> usize {
        let high = self.next_u64() >> 32;
        usize::try_from((high * n as u64) >> 32).unwrap_or(0)
    }

    /// A whole number from 1 to `longest` that is uniform on a log scale, so that most are small.
    fn log_uniform(&mut self, longest: usize) -> usize {
        let length = math::exp(self.uniform() * math::ln(longest as f64));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and longest")]
        (length as usize).clamp(1, longest)
    }

    /// A number of the standard normal distribution (Box and Muller).
    #[cfg(feature = "research")]
    fn standard_normal(&mut self) -> f64 {
        let length = (-2.0 * math::ln(1.0 - self.uniform())).sqrt();
        length * math::cos(std::f64::consts::TAU * self.uniform())
    }

    /// Whether a change of `seconds` is accepted at a temperature, in seconds (Metropolis): always if it is no worse,
    /// otherwise with probability e^(-seconds / temperature). A change for the better draws no number.
    fn accepts(&mut self, seconds: f64, temperature: f64) -> bool {
        seconds <= EPSILON || seconds < -math::ln(1.0 - self.uniform()) * temperature
    }
}

impl<R: rand::Rng> Draw for R {}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng as _;

    #[test]
    fn a_seed_draws_the_numbers_it_always_drew() {
        let (mut rng, mut raw) = (seeded(7), seeded(7));
        for n in 1..1000 {
            let high = raw.next_u64() >> 32;
            assert_eq!(rng.below(n) as u64, (high * n as u64) >> 32);
            let bits = raw.next_u64();
            assert_eq!(rng.uniform().to_bits(), ((bits >> 11) as f64 / (1_u64 << 53) as f64).to_bits());
        }
    }
}
