//! The remainder of an element after cleaning.

/// The remainder of an element after cleaning.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Remainder {
    /// The whole element.
    Whole,
    /// These parts, in order, as fractions of its length.
    Pieces(Vec<(f64, f64)>),
    /// Nothing, because another element has the same ends and the same course.
    Copy,
    /// Nothing, because longer or several other elements cover it.
    Covered,
}
