//! Places where a file could not be read as written.

/// What was wrong at a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BreakKind {
    /// Group codes and values did not alternate, or a binary record made no sense.
    LostStep,
    /// The value is not of the type its group code asks for.
    BadValue,
    /// A line left by a version control system.
    MergeConflict,
}

/// One break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Break {
    /// Line from 1 (ASCII) or byte offset (binary).
    pub(super) place: u32,
    /// What was wrong.
    pub(super) kind: BreakKind,
}
