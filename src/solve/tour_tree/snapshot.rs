//! A snapshot of a tour, from which the tour can be restored.

/// Order and entries of a tour.
#[derive(Clone)]
pub(super) struct TourSnapshot {
    /// Item by position, home first.
    pub(super) order: Vec<u32>,
    /// Place of entry by item.
    pub(super) at: Vec<u32>,
}
