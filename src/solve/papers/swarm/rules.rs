//! How the parameters of LPSPSO change from iteration to iteration: Qu & Du, equations (16)-(18) and (23)-(27).

use crate::geometry::math;
use crate::solve::rng::{Draw, Rng};

/// Inertia weight, eq. (16). It falls from `most` towards the mean of `least` and `most`, as a power of `base`; `share` is
/// the fraction of the iterations done.
pub(super) fn inertia(share: f64, base: f64, least: f64, most: f64) -> f64 {
    (most + least) / 2.0 + math::pow(base, -share) * (most - least) / 2.0
}

/// Learning factors of the particle and of the swarm, eq. (17).
pub(super) fn learning(share: f64, a: f64, b: f64) -> (f64, f64) {
    let own = a + math::exp(-share);
    (own, b - own)
}

/// The next number of the Singer map, eq. (18). The map stays inside (0, 1) for mu from 0.9 to 1.08. Numbers that leave it
/// by rounding, or for another mu, are clamped.
pub(super) fn singer(x: f64, mu: f64) -> f64 {
    const EDGE: f64 = 1e-9;
    (mu * (7.86 * x - 23.3 * x * x + 28.75 * x * x * x - 13.3 * x * x * x * x)).clamp(EDGE, 1.0 - EDGE)
}

/// Levy steps, eqs (23) and (24), by Mantegna's algorithm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Levy {
    beta: f64,
    /// Standard deviation of the numerator.
    pub(super) sigma: f64,
}

impl Levy {
    /// Levy steps with the exponent beta in (1, 2].
    pub(super) fn new(beta: f64) -> Self {
        let above = math::gamma(1.0 + beta) * math::sin(std::f64::consts::PI * beta / 2.0);
        let below = math::gamma((1.0 + beta) / 2.0) * beta * math::pow(2.0, (beta - 1.0) / 2.0);
        // For beta = 2 the sine is 0, up to rounding.
        Self { beta, sigma: math::pow((above / below).max(0.0), 1.0 / beta) }
    }

    /// Draws a step.
    pub(super) fn step(&self, rng: &mut Rng) -> f64 {
        let (mu, nu) = (self.sigma * rng.standard_normal(), rng.standard_normal());
        // A denominator of 0 would give an infinite step.
        mu / math::pow(nu.abs().max(f64::MIN_POSITIVE), 1.0 / self.beta)
    }
}

/// The distances of a particle to the others, eq. (25).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spread {
    pub(super) mean: f64,
    pub(super) least: f64,
    pub(super) most: f64,
}

impl Spread {
    /// No distance yet.
    pub(super) const NONE: Self = Self { mean: 0.0, least: f64::INFINITY, most: 0.0 };

    fn add(&mut self, distance: f64, others: f64) {
        self.mean += distance / others;
        self.least = self.least.min(distance);
        self.most = self.most.max(distance);
    }

    /// The value kappa of eq. (26) for this particle alone, as step 5 prints it.
    pub(super) fn kappa(&self) -> f64 {
        ratio(self.mean, self.least, self.most)
    }
}

/// Adds the distances between the particle of `row` and those `behind` it to the distances of both.
pub(super) fn add_distances<'a>(
    distances: &mut [Spread],
    row: usize,
    keys: &[f64],
    behind: impl Iterator<Item = &'a [f64]>,
) {
    let others = (distances.len() - 1) as f64;
    for (other, j) in behind.zip(row + 1..) {
        let square: f64 = keys.iter().zip(other).map(|(a, b)| (a - b) * (a - b)).sum();
        distances[row].add(square.sqrt(), others);
        distances[j].add(square.sqrt(), others);
    }
}

/// The value kappa of eq. (26) for the whole swarm, from the mean distance (25) of each particle to the others.
pub(super) fn kappa(distances: &[Spread]) -> f64 {
    let means = || distances.iter().map(|d| d.mean);
    let least = means().fold(f64::INFINITY, f64::min);
    let most = means().fold(0.0, f64::max);
    ratio(means().sum::<f64>() / distances.len() as f64, least, most)
}

/// Eq. (26); 1 if all distances are equal.
fn ratio(mean: f64, least: f64, most: f64) -> f64 {
    if most > least { (mean - least) / (most - least) } else { 1.0 }
}

/// The threshold tau for kappa, eq. (27).
pub(super) fn tau(share: f64) -> f64 {
    math::exp(-share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::seeded;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }

    #[test]
    fn inertia_of_equation_16() {
        // By hand, 0.675 + 0.275 x^-t/T: 0.95 at the start; at the end, for x = e, 0.675 + 0.275 / 2.718281828.
        near(inertia(0.0, std::f64::consts::E, 0.4, 0.95), 0.95);
        near(inertia(1.0, std::f64::consts::E, 0.4, 0.95), 0.776_166_846_0);
        // With base 4, half way: 0.675 + 0.275 / 2.
        near(inertia(0.5, 4.0, 0.4, 0.95), 0.8125);
    }

    #[test]
    fn learning_factors_of_equation_17() {
        assert_eq!(learning(0.0, 1.25, 2.5), (2.25, 0.25));
        let (own, swarm) = learning(1.0, 1.25, 2.5);
        near(own, 1.617_879_441_2);
        near(swarm, 0.882_120_558_8);
    }

    #[test]
    fn mean_distances_of_equation_25_and_their_threshold() {
        // Distances: 5 from the first to the second, 5 from the second to the third, 8 from the first to the third.
        let keys: [&[f64]; 3] = [&[0.0, 0.0], &[3.0, 4.0], &[0.0, 8.0]];
        let mut distances = [Spread::NONE; 3];
        for row in 0..2 {
            add_distances(&mut distances, row, keys[row], keys[row + 1..].iter().copied());
        }
        distances.iter().zip([6.5, 5.0, 6.5]).for_each(|(d, wanted)| near(d.mean, wanted));
        // Of the swarm: (6 - 5) / (6.5 - 5). Of the first particle: (6.5 - 5) / (8 - 5). The second is as far from both.
        near(kappa(&distances), 2.0 / 3.0);
        near(distances[0].kappa(), 0.5);
        near(distances[1].kappa(), 1.0);
    }

    #[test]
    fn singer_map_of_equation_18() {
        // 1.04 (7.86 0.18 - 23.3 0.0324 + 28.75 0.005832 - 13.3 0.00104976).
        near(singer(0.18, 1.04), 0.846_131_719_68);
        for mu in [0.9, 1.04, 1.08] {
            let mut x = 0.18;
            for _ in 0..100_000 {
                x = singer(x, mu);
                assert!(x > 0.0 && x < 1.0);
            }
        }
    }

    #[test]
    fn levy_steps_of_equations_23_and_24() {
        // Known values: 0.6966 for beta = 1.5; for beta = 1, Gamma(2) sin(pi/2) / (Gamma(1) 1 2^0) = 1.
        assert!((Levy::new(1.5).sigma - 0.6966).abs() < 5e-5);
        near(Levy::new(1.0).sigma, 1.0);
        // The tail: a fraction of about 0.4 x^-1.5 of the steps are longer than x.
        let mut rng = seeded(1);
        let levy = Levy::new(1.5);
        let steps: Vec<f64> = (0..100_000).map(|_| levy.step(&mut rng).abs()).collect();
        for x in [10.0, 20.0] {
            let longer = steps.iter().filter(|&&s| s > x).count() as f64 / 1e5;
            let wanted = 0.4 / (x * f64::sqrt(x));
            assert!((0.8..1.25).contains(&(longer / wanted)), "{x}: {longer} {wanted}");
        }
    }

    #[test]
    fn thresholds_of_equations_26_and_27() {
        let of = |mean| Spread { mean, ..Spread::NONE };
        near(kappa(&[1.0, 2.0, 6.0].map(of)), 0.4);
        near(kappa(&[3.0, 3.0].map(of)), 1.0);
        near(tau(0.0), 1.0);
        near(tau(1.0), 0.367_879_441_2);
    }
}
