//! Repairs knot vectors as files write them, and defines what can be wrong with a spline.

/// Knots may decrease by this fraction of their range, which is rounding of printed numbers.
const KNOT_ROUNDING: f64 = 1e-6;

/// Why spline data describe no curve.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CurveError {
    /// The degree is 0 or above [`MAX_DEGREE`](super::MAX_DEGREE).
    #[error("its degree is {0}; 1 to 15 can be read")]
    Degree(usize),
    /// There are fewer points than the degree needs.
    #[error("it has {points} points, its degree {degree} needs {}", degree + 1)]
    TooFewPoints {
        /// Control points given.
        points: usize,
        /// Degree given.
        degree: usize,
    },
    /// There are fewer than two distinct fit points.
    #[error("it has fewer than two fit points that differ")]
    TooFewFitPoints,
    /// A coordinate, weight or knot is infinite or not a number.
    #[error("it holds a value that is not a number")]
    NotFinite,
    /// A weight is zero or negative.
    #[error("it has a weight of {0}; weights must be above 0")]
    Weight(f64),
    /// The number of weights differs from the number of control points.
    #[error("it has {weights} weights for {points} points")]
    WeightCount {
        /// Weights given.
        weights: usize,
        /// Control points given.
        points: usize,
    },
    /// The number of knots does not match the points and the degree.
    #[error("it has {knots} knots for {points} points of degree {degree}")]
    KnotCount {
        /// Knots given.
        knots: usize,
        /// Control points given.
        points: usize,
        /// Degree given.
        degree: usize,
    },
    /// The knots decrease, or all are equal.
    #[error("its knots do not ascend")]
    KnotOrder,
}

/// The complete knot vector: as given, with its outer knots added, or uniform when none is given.
pub(super) fn complete(mut knots: Vec<f64>, points: usize, degree: usize) -> Result<Vec<f64>, CurveError> {
    let full = points + degree + 1;
    if knots.is_empty() {
        let spans = points - degree;
        return Ok((0..full).map(|i| i.saturating_sub(degree).min(spans) as f64).collect());
    }
    if knots.len() + 2 == full {
        let (first, last) = (knots[0], knots[knots.len() - 1]);
        knots.insert(0, first);
        knots.push(last);
    }
    if knots.len() == full {
        Ok(knots)
    } else {
        Err(CurveError::KnotCount { knots: knots.len(), points, degree })
    }
}

/// Lifts knots that decrease by rounding; larger decreases are an error.
pub(super) fn ascending(mut knots: Vec<f64>) -> Result<Vec<f64>, CurveError> {
    let (low, high) =
        knots.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), k| (l.min(*k), h.max(*k)));
    for i in 1..knots.len() {
        if knots[i] < knots[i - 1] {
            if knots[i - 1] - knots[i] > KNOT_ROUNDING * (high - low) {
                return Err(CurveError::KnotOrder);
            }
            knots[i] = knots[i - 1];
        }
    }
    Ok(knots)
}
