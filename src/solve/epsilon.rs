//! The smallest difference in cost that counts.

/// Minimum improvement, in seconds, for a change to count as one: far above rounding, far below what matters.
pub(super) const EPSILON: f64 = 1e-9;
