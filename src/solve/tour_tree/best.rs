//! The best path so far. If the search over the root route found it, it is kept as a tour and converted to a solution only
//! when a caller asks: on 10,000 contours the conversion takes as long as a slice of work, and callers seldom ask.

use super::polish::{self, unpolished};
use super::snapshot::TourSnapshot;
use super::tour::Tour;
use crate::solve::{Solution, Stop};
use std::cell::OnceCell;

/// Where a solution comes from, in the order in which one is preferred to another of equal cost. A search that is cut into
/// slices sees them in an order that depends on the slices; this order makes the result independent of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Origin {
    /// The search over all routes.
    Children,
    /// Entries of a cycle's best slid to the exact minimum.
    Polished,
    /// The search over the root route.
    Root,
    /// The caller: the first path, or one found elsewhere. It may have entries between nodes, which a tour has not.
    Caller,
}

/// The best solution, converted on demand.
pub(super) struct Best {
    /// Cost, s; equal to the cost of the solution up to the rounding of sums.
    cost: f64,
    origin: Origin,
    /// The tour to be converted, unless the best was a solution from the start.
    snapshot: Option<TourSnapshot>,
    solution: OnceCell<Solution>,
    /// Number of moves when it was found.
    pub(super) at: u64,
}

impl Best {
    pub(super) fn new(solution: Solution, origin: Origin, at: u64) -> Self {
        Self { cost: solution.cost, origin, snapshot: None, solution: OnceCell::from(solution), at }
    }

    pub(super) fn cost(&self) -> f64 {
        self.cost
    }

    pub(super) fn solution(&self, tour: &Tour) -> &Solution {
        self.solution.get_or_init(|| {
            self.snapshot.as_ref().map_or_else(Solution::default, |snapshot| unpolished(tour, snapshot))
        })
    }

    /// The stops of the solution, without its cost.
    pub(super) fn stops(&self, tour: &Tour) -> Vec<Stop> {
        match (self.solution.get(), &self.snapshot) {
            (None, Some(snapshot)) => polish::stops(tour, snapshot),
            (found, _) => found.map_or_else(Vec::new, |s| s.stops.clone()),
        }
    }

    /// Whether a solution of this cost and origin takes the place of the best.
    #[expect(clippy::float_cmp, reason = "solutions of equal cost are those whose sums are the same bits")]
    pub(super) fn yields_to(&self, cost: f64, origin: Origin) -> bool {
        cost < self.cost || (cost == self.cost && origin > self.origin)
    }

    /// Takes over a solution if it costs less, or is preferred at the same cost.
    pub(super) fn take(&mut self, found: Solution, origin: Origin, at: u64) {
        if self.yields_to(found.cost, origin) {
            let at = if found.cost < self.cost { at } else { self.at };
            *self = Self::new(found, origin, at);
        }
    }

    /// Takes over a tour of this cost if it costs less, or is preferred at the same cost.
    pub(super) fn take_tour(&mut self, cost: f64, snapshot: &TourSnapshot, at: u64) {
        if self.yields_to(cost, Origin::Root) {
            let at = if cost < self.cost { at } else { self.at };
            let snapshot = Some(snapshot.clone());
            *self = Self { cost, origin: Origin::Root, snapshot, solution: OnceCell::new(), at };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A search in slices of other sizes gave another plan of equal cost.
    #[test]
    fn of_equal_costs_the_same_is_kept_in_any_order() {
        let tour = TourSnapshot { order: vec![0], at: vec![0] };
        let found = || Solution { stops: Vec::new(), cost: 1.0 };
        let orders: [[Origin; 3]; 4] = [
            [Origin::Children, Origin::Polished, Origin::Root],
            [Origin::Root, Origin::Children, Origin::Polished],
            [Origin::Polished, Origin::Root, Origin::Children],
            [Origin::Children, Origin::Root, Origin::Polished],
        ];
        for order in orders {
            let mut best = Best::new(Solution { stops: Vec::new(), cost: 2.0 }, Origin::Caller, 0);
            for (origin, at) in order.into_iter().zip(1..) {
                match origin {
                    Origin::Root => best.take_tour(1.0, &tour, at),
                    _ => best.take(found(), origin, at),
                }
            }
            assert_eq!((best.origin, best.cost(), best.at), (Origin::Root, 1.0, 1), "{order:?}");
        }
    }
}
