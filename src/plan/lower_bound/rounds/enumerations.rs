//! What the rounds keep of enumerations: looks at all orders that may still be better than the known path (`close.rs`).

use super::super::net::Item;

/// The core wasm does not enumerate orders, which the worker of a proof does (`job::Proof`).
pub(super) const ENUMERATES_ORDERS: bool = cfg!(feature = "research");

/// What is known of enumerations.
#[derive(Clone, Debug, Default)]
pub(super) struct Enumerations {
    /// One has come to its end: from then on only pieces are halved.
    pub(super) has_begun: bool,
    /// The gap at the last one that was given up, s; 0 before there was one.
    pub(super) given_up_at: f64,
    /// Nothing else can be done: the last one is not given up for its work.
    pub(super) is_last: bool,
    /// The one in progress ends at this much work.
    pub(super) until: u64,
    /// The knots of each item in all of them so far, also those of pieces that were dropped since.
    pub(super) knots: Vec<Vec<f64>>,
}

impl Enumerations {
    /// Begins with new mixtures, which may price pieces that were dropped lower than before: all contours are whole again, with the knots of all enumerations.
    pub(super) fn begin_again(&mut self, items: &mut [Item]) {
        self.add_knots(items);
        for (item, knots) in items.iter_mut().zip(std::mem::take(&mut self.knots)) {
            if let Some(whole) = item.with_knots(&knots) {
                *item = whole;
            }
        }
    }

    /// Adds the knots of the items of an enumeration that has ended.
    pub(super) fn add_knots(&mut self, items: &[Item]) {
        self.knots.resize(items.len(), Vec::new());
        for (knots, item) in self.knots.iter_mut().zip(items) {
            knots.extend_from_slice(&item.along);
            knots.sort_unstable_by(f64::total_cmp);
            knots.dedup();
        }
    }
}
