//! Places where a file could not be read as it was written.

/// What is wrong at a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BreakKind {
    /// Group codes and values did not alternate, or a binary tag made no sense.
    OutOfSync,
    /// The value is not of the type that its group code requires.
    BadValue,
    /// A marker left by a version control system.
    MergeConflict,
}

/// A break in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Break {
    /// Line number from 1 (ASCII) or byte offset (binary).
    pub(super) place: u32,
    /// What was wrong.
    pub(super) kind: BreakKind,
}
