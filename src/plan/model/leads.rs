//! Which elements of a cut are leads and overcut.

use serde::{Deserialize, Serialize};

/// How many elements of a cut belong to leads and overcut. The lead-in comes first; then the contour, the overcut, and the
/// lead-out. All are cut without switching the beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Leads {
    /// Elements of the lead-in.
    pub lead_in: usize,
    /// Elements of the overcut, which repeat the beginning of the contour.
    pub overcut: usize,
    /// Elements of the lead-out.
    pub lead_out: usize,
}

impl Leads {
    /// Those of a cut and of the stretch that continues it.
    #[must_use]
    pub fn and(self, next: Self) -> Self {
        Self {
            lead_in: self.lead_in + next.lead_in,
            overcut: self.overcut + next.overcut,
            lead_out: self.lead_out + next.lead_out,
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Lead-in, contour, overcut and lead-out among the elements of a cut.
    pub fn divide<'p, T>(&self, path: &'p [T]) -> [&'p [T]; 4] {
        let (lead_in, rest) = path.split_at(self.lead_in.min(path.len()));
        let (rest, lead_out) = rest.split_at(rest.len().saturating_sub(self.lead_out));
        let (contour, overcut) = rest.split_at(rest.len().saturating_sub(self.overcut));
        [lead_in, contour, overcut, lead_out]
    }

    /// The leads of a stretch of the elements, from number `first`, of which there are `count`; `all` is their whole number.
    pub(in crate::plan) fn of_stretch(&self, first: usize, count: usize, all: usize) -> Self {
        let last = first + count;
        let within = |from: usize, to: usize| to.min(last).saturating_sub(from.max(first));
        let out = all.saturating_sub(self.lead_out);
        Self {
            lead_in: within(0, self.lead_in),
            overcut: within(out.saturating_sub(self.overcut), out),
            lead_out: within(out, all),
        }
    }
}
