//! The members of a swarm by their keys.

/// Members by their keys.
pub(super) struct Flock {
    pub(super) keys: Vec<Vec<f32>>,
    /// TL of each.
    pub(super) lengths: Vec<f64>,
    /// The keys of the shortest so far, and its length.
    pub(super) best: Vec<f32>,
    pub(super) shortest: f64,
}
