//! What the journal of a tour holds.

/// One change, to be taken back.
#[derive(Clone, Copy)]
pub(super) enum Change {
    /// Positions reversed.
    Reversed(usize, usize),
    /// Item, and the place where it was entered before.
    Entered(u32, u32),
    /// Another order altogether; the one before is the last of [`Tour::orders`].
    Reordered,
}
