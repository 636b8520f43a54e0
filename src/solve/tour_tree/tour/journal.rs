//! The changes that the journal of a tour holds.

/// One change, to be taken back.
#[derive(Clone, Copy)]
pub(super) enum Change {
    /// A stretch was reversed: its first and last position.
    Reversed(usize, usize),
    /// An item was entered elsewhere: the item, and its place before.
    Entered(u32, u32),
    /// The order was replaced; the one before is the last of [`Tour::orders`].
    Reordered,
}
