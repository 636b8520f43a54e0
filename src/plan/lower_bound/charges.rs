//! What walks pay and get back, so that they come close to tours: charges for stops, and prices of cuts.
//!
//! A walk pays the charge of an item at each stop there, and all charges are given back once. A tour stops once everywhere, so that it takes as
//! long as without charges. A *cut* is a set of items. A tour enters it and leaves it, so at least two of its legs cross the border. Each
//! such leg gets the price of the cut, and twice the price is taken back: no tour takes longer for that. But walks that never come to
//! the set do.

/// A set of items, home not among them: whether each is in it.
pub(super) type Cut = Vec<bool>;

/// The core wasm has no cuts, which the worker of a proof adds (`job::Proof`): they would cost a first visit 2 kB.
pub(super) const HAS_CUTS: bool = cfg!(feature = "research");

/// Charges and prices.
#[derive(Clone, Debug, Default)]
pub(super) struct Charges {
    /// For each item what a stop costs, and then the price of each cut, which is not negative, s.
    values: Vec<f64>,
    cuts: Vec<Cut>,
    items: usize,
    /// For each two items the prices of the cuts between them; empty if there are none.
    crossing: Vec<f64>,
}

impl Charges {
    pub(super) fn none(items: usize) -> Self {
        Self { values: vec![0.0; items], items, ..Self::default() }
    }

    pub(super) fn items(&self) -> usize {
        self.items
    }

    pub(super) fn cuts(&self) -> &[Cut] {
        &self.cuts
    }

    /// The charges of all items and then the prices of all cuts, s.
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Replaces them. Prices below 0 become 0.
    pub(super) fn set(&mut self, values: &[f64]) {
        self.values.copy_from_slice(values);
        self.values[self.items..].iter_mut().for_each(|p| *p = p.max(0.0));
        self.crossing.clear();
        if !HAS_CUTS || self.cuts.is_empty() {
            return;
        }
        self.crossing.resize(self.items * self.items, 0.0);
        for (cut, &price) in self.cuts.iter().zip(&self.values[self.items..]).filter(|c| *c.1 > 0.0) {
            for (row, &a) in self.crossing.chunks_exact_mut(self.items).zip(cut) {
                row.iter_mut().zip(cut).filter(|x| *x.1 != a).for_each(|(s, _)| *s += price);
            }
        }
    }

    /// Adds a cut, without a price.
    pub(super) fn add(&mut self, cut: Cut) {
        self.cuts.push(cut);
        self.values.push(0.0);
    }

    /// Goes on without cuts.
    pub(super) fn drop_cuts(&mut self) {
        self.cuts.clear();
        self.values.truncate(self.items);
        self.crossing.clear();
    }

    /// The charge of an item.
    pub(super) fn of(&self, item: usize) -> f64 {
        self.values[item]
    }

    /// What a leg to a stop costs beside its seconds.
    pub(super) fn of_leg(&self, from: usize, to: usize) -> f64 {
        self.values[to] - self.between(from, to)
    }

    /// The prices of the cuts between two items.
    pub(super) fn between(&self, from: usize, to: usize) -> f64 {
        if !HAS_CUTS {
            return 0.0;
        }
        self.crossing.get(from * self.items + to).copied().unwrap_or(0.0)
    }

    /// What is given back, less what is taken back.
    pub(super) fn back(&self) -> f64 {
        let (charges, prices) = self.values.split_at(self.items);
        charges.iter().sum::<f64>() - 2.0 * prices.iter().sum::<f64>()
    }
}
