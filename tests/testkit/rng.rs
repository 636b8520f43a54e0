//! Random numbers for tests: `rand`'s traits over xoshiro256++, so that a seed draws the same cases on every machine.

use rand::SeedableRng;

/// The random number generator of the tests.
pub type Rng = rand_xoshiro::Xoshiro256PlusPlus;

/// The generator of a seed.
pub fn seeded(seed: u64) -> Rng {
    Rng::seed_from_u64(seed)
}
