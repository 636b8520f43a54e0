//! The comprehensive prospect-regret value, Qu & Du eqs (4)-(13). It rates a path as a person would who minds losses more
//! than gains and regrets missed opportunities.
//!
//! The paper does not define its attributes, probabilities and reference. Here an outcome is the length of a path, all
//! outcomes of the swarm are equally probable, the reference E is the mean of the swarm in this iteration, and shorter is a
//! gain. A length is an interval of width 0, so the distance (4) is the difference. A path has either a V+ (8) or a V- (9)
//! that is not 0. Equations (11) and (12) both print V+, which makes all losses equal: a particle whose best path is longer than
//! the mean would never replace it by another such path. By default each path's own value is used; the parameter `regret`
//! takes V+ as printed.
//!
//! With its own value a shorter path always has a larger Z within one swarm, so comparing by Z gives the same result as
//! comparing by length, and the value is only a number to look at. With a regret avoidance near 0.04 it has the range of the values that the
//! paper prints (table 3, CPRV, -0.041 to 0.035); the single values are not reproduced.

use crate::geometry::math;
use serde::{Deserialize, Serialize};

/// Whose value (11) and (12) take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regret {
    /// Each path's own: V+ of a gain, V- of a loss.
    #[default]
    Own,
    /// V+ alone, as both are printed. It is 0 for all losses.
    Printed,
}

/// The coefficients of the value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prospect {
    /// Exponents of gains and losses, and the factor by which losses count more, eq. (5).
    pub(super) alpha: f64,
    pub(super) beta: f64,
    pub(super) gamma: f64,
    /// Exponents of the weights of gains (6) and losses (7).
    pub(super) delta: f64,
    pub(super) phi: f64,
    /// Regret avoidance, eqs (11) and (12).
    pub(super) avoidance: f64,
    pub(super) regret: Regret,
}

/// The outcomes of an iteration, with which a length is rated.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcomes {
    by: Prospect,
    /// The reference E.
    mean: f64,
    /// Decision weights of a gain and of a loss.
    weights: (f64, f64),
    /// The smallest and the largest prospect value: V-(min) and V+(max).
    least: f64,
    most: f64,
}

/// Decision weight of a probability, eqs (6) and (7).
fn weight(p: f64, exponent: f64) -> f64 {
    let (p, q) = (math::pow(p, exponent), math::pow(1.0 - p, exponent));
    p / math::pow(p + q, 1.0 / exponent)
}

impl Outcomes {
    /// The outcomes for the current lengths of a swarm. `kept` are further lengths to be rated: the best of each particle.
    pub(super) fn new(by: Prospect, now: &[f64], kept: &[f64]) -> Self {
        let count = now.len().max(1) as f64;
        let mean = now.iter().sum::<f64>() / count;
        let weights = (weight(1.0 / count, by.delta), weight(1.0 / count, by.phi));
        let mut outcomes = Self { by, mean, weights, least: 0.0, most: 0.0 };
        for &length in now.iter().chain(kept) {
            let value = outcomes.prospect(length);
            outcomes.least = outcomes.least.min(value);
            outcomes.most = outcomes.most.max(value);
        }
        outcomes
    }

    /// Weighted prospect value of a length, eqs (4)-(9).
    fn prospect(&self, length: f64) -> f64 {
        let distance = (length - self.mean).abs();
        if length < self.mean {
            self.weights.0 * math::pow(distance, self.by.alpha)
        } else {
            -self.weights.1 * self.by.gamma * math::pow(distance, self.by.beta)
        }
    }

    /// The value Z of a length, eqs (10)-(13).
    pub(super) fn value(&self, length: f64) -> f64 {
        let span = self.most - self.least;
        if span <= 0.0 {
            return 0.0;
        }
        let own = self.prospect(length);
        let value = if self.by.regret == Regret::Printed { own.max(0.0) } else { own };
        let regret = 1.0 - math::exp(-self.by.avoidance * ((value - self.least) / span).abs());
        let joy = 1.0 - math::exp(self.by.avoidance * ((value - self.most) / span).abs());
        regret + joy
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::{Draw, seeded};

    const PRINTED: Prospect = Prospect {
        alpha: 0.85,
        beta: 0.85,
        gamma: 2.25,
        delta: 0.61,
        phi: 0.69,
        avoidance: 0.69,
        regret: Regret::Own,
    };

    #[test]
    fn weights_of_equations_6_and_7() {
        // For 0.5: 0.5^d / (2 0.5^d)^(1/d).
        assert!((weight(0.5, 0.61) - 0.420_639_354).abs() < 1e-9);
        assert!((weight(0.5, 0.69) - 0.453_987_550).abs() < 1e-9);
        assert!((weight(1.0, 0.61) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn two_paths_by_hand() {
        // Lengths 90 and 110: E = 100, one gain and one loss of 10 each, so these are V+(max) and V-(min).
        let z = Outcomes::new(PRINTED, &[90.0, 110.0], &[]);
        // The shorter: regret 1 - e^-0.69, joy 0. The longer: regret 0, joy 1 - e^0.69.
        assert!((z.value(90.0) - 0.498_423_93).abs() < 1e-7);
        assert!((z.value(110.0) + 0.993_715_53).abs() < 1e-7);
        // The mean is neither a gain nor a loss: its relative position is loss / (gain + loss).
        let (gain, loss) = (weight(0.5, 0.61), 2.25 * weight(0.5, 0.69));
        let place = loss / (gain + loss);
        let wanted = 2.0 - math::exp(-0.69 * place) - math::exp(0.69 * (1.0 - place));
        assert!((z.value(100.0) - wanted).abs() < 1e-12);
    }

    #[test]
    fn a_shorter_path_has_a_larger_value() {
        let mut rng = seeded(7);
        for _ in 0..200 {
            let mut draw = |n: usize| (0..n).map(|_| 1000.0 * rng.uniform()).collect::<Vec<f64>>();
            let (now, kept) = (draw(50), draw(50));
            let outcomes = Outcomes::new(PRINTED, &now, &kept);
            let mut all: Vec<f64> = now.into_iter().chain(kept).collect();
            all.sort_by(f64::total_cmp);
            for pair in all.windows(2) {
                // Strictly, so that comparing by Z is comparing by length.
                let same = pair[0].to_bits() == pair[1].to_bits();
                assert!(same || outcomes.value(pair[0]) > outcomes.value(pair[1]), "{pair:?}");
            }
        }
        let same = Outcomes::new(PRINTED, &[5.0; 4], &[]);
        assert!(same.value(5.0).abs() < 1e-12);
    }

    #[test]
    fn with_v_plus_alone_as_printed_all_losses_are_alike() {
        // The mean is 100, so 110 and 130 are losses.
        let values = |regret| {
            let outcomes = Outcomes::new(Prospect { regret, ..PRINTED }, &[60.0, 110.0, 130.0], &[]);
            [60.0, 110.0, 130.0].map(|length| outcomes.value(length))
        };
        let [gain, one, other] = values(Regret::Printed);
        assert!(gain > one && (one - other).abs() < 1e-15, "{gain} {one} {other}");
        let [gain, one, other] = values(Regret::Own);
        assert!(gain > one && one > other, "{gain} {one} {other}");
    }
}
