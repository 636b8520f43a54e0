//! The best path that is known, with its best entries, on machines whose axes have limits of their own (`level`). Its mixtures price legs, and no order that
//! takes longer is enumerated.
//!
//! It comes from a search beside the bound or from an enumeration of orders, which may find a better one (`learn.rs`). If it is known before the walks
//! begin, they use its mixtures from their first round on, so that charges fit them; this proves the optimum soonest. But mixtures on large pieces prove less than the
//! closest functions, and the bound may come to no end. Then everything begins again (`LowerBound`), and mixtures are used once an enumeration has come to its end, when
//! pieces are small where it matters.

use super::super::known_path::KnownPath;
use super::super::mixtures::Mixtures;

/// The best path, and what is done with its mixtures.
#[derive(Debug)]
pub(super) struct Known {
    pub(super) path: KnownPath,
    /// Its mixtures, until they are used.
    pub(super) mixtures: Option<Mixtures>,
    /// They are not used before the gap is as small as this, s.
    pub(super) wait_for: f64,
    /// It was known before the walks began, which use its mixtures from their first round on.
    pub(super) from_start: bool,
}

impl Default for Known {
    fn default() -> Self {
        Self { path: KnownPath::default(), mixtures: None, wait_for: f64::INFINITY, from_start: false }
    }
}
