//! Budgets of comparisons, which bound the work on hostile drawings.

/// A number of comparisons that may be made.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// The number at first.
    pub limit: usize,
    left: usize,
}

impl Budget {
    /// This many.
    pub fn new(limit: usize) -> Self {
        Self { limit, left: limit }
    }

    /// Takes one comparison; returns whether any are left.
    pub fn take(&mut self) -> bool {
        self.left = self.left.saturating_sub(1);
        self.left > 0
    }

    /// Whether none are left, so that not everything was compared.
    pub fn is_spent(&self) -> bool {
        self.left == 0
    }
}
