//! A cut with its price.

/// A set of items without home, and the price of legs between them and the others.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// Whether each item is in it.
    pub(super) set: Vec<bool>,
    pub(super) price: f64,
    /// The pairs that cross it.
    pub(super) pairs: Vec<u32>,
    /// The legs of the smooth solution that cross it.
    pub(super) legs: f64,
}
