//! A tour put by.

/// Order and entries, for keeping.
#[derive(Clone)]
pub(super) struct Kept {
    /// Item by position, home first.
    pub(super) order: Vec<u32>,
    /// Place of entry by item.
    pub(super) at: Vec<u32>,
}
