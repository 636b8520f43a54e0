//! Random numbers of the searches: the same on every machine.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

use super::epsilon::EPSILON;
use crate::geometry::math;

/// A source of random numbers.
pub(super) struct Dice(Xoshiro256PlusPlus);

impl Dice {
    /// The numbers of a seed.
    pub(super) fn new(seed: u64) -> Self {
        Self(Xoshiro256PlusPlus::seed_from_u64(seed))
    }

    /// Whether a change for the worse by so many seconds passes at this heat (Metropolis): with probability
    /// e^(-change / heat). Changes for the better draw no number.
    pub(super) fn passes(&mut self, change: f64, heat: f64) -> bool {
        change <= EPSILON || change < -math::ln(1.0 - self.even()) * heat
    }

    /// An even number in [0, 1).
    pub(super) fn even(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number of the standard normal distribution (Box and Muller).
    #[cfg(feature = "research")]
    pub(super) fn normal(&mut self) -> f64 {
        let length = (-2.0 * math::ln(1.0 - self.even())).sqrt();
        length * math::cos(std::f64::consts::TAU * self.even())
    }

    /// An even index below `n` (n < 2^32).
    pub(super) fn below(&mut self, n: usize) -> usize {
        let high = self.0.next_u64() >> 32;
        usize::try_from((high * n as u64) >> 32).unwrap_or(0)
    }

    /// A length of 1 to `longest`, even on a log scale: mostly short.
    pub(super) fn length(&mut self, longest: usize) -> usize {
        let length = math::exp(self.even() * math::ln(longest as f64));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and longest")]
        (length as usize).clamp(1, longest)
    }
}
