//! Conversion of counts to 32-bit indices.

/// A count as an index. Counts fit 32 bits: the reader's limits leave fewer than 2^32 places.
#[expect(clippy::cast_possible_truncation, reason = "see above")]
pub(super) fn index(n: usize) -> u32 {
    n as u32
}
