//! Counts what it takes to work out styles and copies: copies of copies and rules for ancestors take time without making
//! anything that another limit would count.

/// Most steps for each byte that a file may have. Without copies and rules, reading takes about one.
const PER_BYTE: usize = 4;

/// Bytes of attributes and rules that were read, with all copies, and elements that were compared with others.
#[derive(Debug)]
pub(super) struct Steps {
    taken: usize,
    most: usize,
}

impl Steps {
    /// None taken yet. `bytes`: the largest file.
    pub(super) fn new(bytes: usize) -> Self {
        Self { taken: 0, most: bytes.saturating_mul(PER_BYTE) }
    }

    /// Counts some.
    pub(super) fn take(&mut self, count: usize) {
        self.taken = self.taken.saturating_add(count);
    }

    /// Whether there are too many, so that the file is refused.
    pub(super) fn are_used_up(&self) -> bool {
        self.taken > self.most
    }
}
