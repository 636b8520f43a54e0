//! Runs: elements that follow each other.

use std::ops::Range;

/// Elements of one shape that follow each other bit for bit, or a loop of several shapes.
pub(super) struct Run {
    /// Range of its elements.
    pub(super) elements: Range<usize>,
    /// Whether the last end is the first start.
    pub(super) closed: bool,
    /// Whether it is a loop of several shapes. Closed shapes that are drawn as one come before loops.
    pub(super) is_loop: bool,
}
