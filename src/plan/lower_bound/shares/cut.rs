//! A set of items that every tour enters and leaves, with its price.

/// A set of items, and the price of legs between it and the others.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// In ascending order.
    pub(super) members: Vec<usize>,
    /// The pairs of which it holds one item.
    pub(super) pairs: Vec<usize>,
    pub(super) price: f64,
    /// The legs of the smooth solution that cross it.
    pub(super) legs: f64,
}

impl Cut {
    fn holds(&self, item: usize) -> bool {
        self.members.binary_search(&item).is_ok()
    }

    /// Whether a leg between two items crosses it.
    pub(super) fn crosses(&self, ends: [usize; 2]) -> bool {
        self.holds(ends[0]) != self.holds(ends[1])
    }
}
