//! What a round takes over from the one before.

use super::net::Net;

/// What potentials were for before a round.
#[derive(Debug)]
pub(super) struct Before {
    pub(super) net: Net,
    pub(super) potentials: Vec<f64>,
    /// The size of each ng-set.
    pub(super) members: Vec<usize>,
    /// For each knot of each item the two knots around it then, or twice the same.
    pub(super) around: Vec<Vec<[usize; 2]>>,
}
