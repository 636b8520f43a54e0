//! Fitness, eq. (2). It is nearly uniform at first, so that a few good codes do not take over, and becomes more selective
//! with every generation.

use crate::geometry::math;

/// Upper limit of lambda alpha^k. The paper sets no limit to 1.02^k. At this value the worst code is never drawn any more,
/// and without a limit the number would overflow.
const MOST: f64 = 1e12;

/// The fitness F for each length f in iteration k, eq. (2). k counts from 1. Equal lengths give equal fitness.
pub(super) fn fitness(f: &[f64], lambda: f64, alpha: f64, k: u32) -> Vec<f64> {
    let mean = f.iter().sum::<f64>() / f.len() as f64;
    let most = f.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = f.iter().copied().fold(f64::INFINITY, f64::min);
    let stretch = (lambda * math::pow(alpha, f64::from(k))).min(MOST);
    let part = |f: f64| if most > least { (most - f) / (most - least) } else { 0.0 };
    f.iter().map(|&f| mean + stretch * part(f) * mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// "In the first iteration, the ratio of the minimum fitness function value to the maximum is 0.907. When in the 200th
    /// iteration, the ratio is 0.16."
    #[test]
    fn the_ratios_of_the_paper() {
        let ratio = |k| {
            let all = fitness(&[700.0, 1000.0, 800.0], 0.1, 1.02, k);
            // The mean is 2500/3, which is the fitness of the longest.
            assert!((all[1] - 2500.0 / 3.0).abs() < 1e-9);
            assert!((all[2] - all[1] - (all[0] - all[1]) * 2.0 / 3.0).abs() < 1e-9, "linear in between");
            all[1] / all[0]
        };
        assert!((ratio(1) - 0.907).abs() < 5e-4, "{}", ratio(1));
        assert!((ratio(200) - 0.16).abs() < 5e-4, "{}", ratio(200));
        assert!(ratio(100_000) > 0.0);
    }

    #[test]
    fn codes_of_one_length_are_even() {
        assert_eq!(fitness(&[3.0; 4], 0.1, 1.02, 9), [3.0; 4]);
    }
}
