//! The solution of the smooth problem.

/// The smooth solution.
#[derive(Clone, Debug, Default)]
pub(super) struct Flow {
    /// What enters each state and knot, and what leaves it.
    pub(super) inflow: Vec<f64>,
    pub(super) outflow: Vec<f64>,
    /// How much each pair is used.
    pub(super) usage: Vec<f64>,
    /// The same for items without a table: from, to.
    pub(super) far: Vec<(usize, usize, f64)>,
    /// The value of the smooth problem, s.
    pub(super) value: f64,
}
