//! What cleaning leaves.

/// What cleaning leaves of an element.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kept {
    /// All of it.
    Whole,
    /// These parts, as fractions of its length, in order.
    Pieces(Vec<(f64, f64)>),
    /// Nothing: one other element has the same ends and the same course.
    Copy,
    /// Nothing: longer or several other elements cover it.
    Covered,
}
