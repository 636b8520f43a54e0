//! The members of a population that is represented by random keys.

/// The members, and the best solution so far.
pub(super) struct Members {
    pub(super) keys: Vec<Vec<f32>>,
    /// TL of each member.
    pub(super) lengths: Vec<f64>,
    /// Keys and length of the best solution so far.
    pub(super) best: Vec<f32>,
    pub(super) shortest: f64,
}
