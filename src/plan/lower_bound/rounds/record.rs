//! What the best walks so far were looked for with, for their certificate (`walk_certificate`).

use super::super::certificate::{Certified, divided, unit, units};
use super::super::charges::Charges;
use super::super::mixtures::Mixtures;
use super::super::priced_cuts::PricedCut;
use super::super::prices::Prices;
use super::super::walk_certificate::WalkCertificate;
use super::super::walks::Ground;
use crate::problem::Problem;

/// Everything that the shortest walk depends on.
#[derive(Clone, Debug)]
pub(in super::super) struct Record {
    /// The bound that follows, s.
    pub(in super::super) value: f64,
    knots: Vec<Vec<f64>>,
    near: Vec<Vec<usize>>,
    ng_sets: Vec<Vec<usize>>,
    charges: Charges,
    mixtures: Mixtures,
    /// If the value is not that of walks but of all orders: the knots of all enumerations, also of pieces that were dropped.
    enumerated: Option<Vec<Vec<f64>>>,
    /// And the walks before.
    before: Option<Box<Self>>,
}

impl Record {
    pub(super) fn new(value: f64, ground: &Ground, charges: &Charges) -> Self {
        let sorted = |mut list: Vec<usize>| {
            list.sort_unstable();
            list.dedup();
            list
        };
        let mut near = vec![Vec::new(); ground.items.len()];
        for [a, b] in ground.pairs.list.iter().map(|pair| pair.items) {
            if a.min(b) >= ground.first {
                near[a.min(b)].push(a.max(b));
            }
        }
        Self {
            value,
            knots: ground.items.iter().map(|i| i.along.clone()).collect(),
            near: near.into_iter().map(sorted).collect(),
            ng_sets: ground.ng_sets.iter().cloned().map(sorted).collect(),
            charges: charges.clone(),
            mixtures: ground.prices.mixtures.clone(),
            enumerated: None,
            before: None,
        }
    }

    /// The same for a value that is not that of walks, but of all orders. `knots`: those of all enumerations; `before`: the record so far.
    pub(super) fn of_all_orders(self, knots: &[Vec<f64>], before: Option<Box<Self>>) -> Self {
        let of_walks =
            before.and_then(|record| if record.enumerated.is_none() { Some(record) } else { record.before });
        Self { enumerated: Some(knots.to_vec()), before: of_walks, ..self }
    }

    /// The certificate: that of walks if all orders would take too long to check. `None` if its numbers do not fit each other, which a fault of this
    /// program would be.
    pub(in super::super) fn certificate(&self, problem: &Problem) -> Option<WalkCertificate> {
        let Some(knots) = &self.enumerated else { return self.proven(problem, &self.knots, false) };
        let of_orders = self.proven(problem, knots, true);
        of_orders.or_else(|| self.before.as_ref()?.certificate(problem))
    }

    /// The certificate with these knots and the bound that they prove.
    fn proven(&self, problem: &Problem, knots: &[Vec<f64>], all_orders: bool) -> Option<WalkCertificate> {
        let items = divided(problem, knots).ok()?;
        let (power, _) = unit(&items, &Prices::new(problem), problem);
        let (charges, prices) = self.charges.values().split_at(self.charges.items());
        let cut = |(cut, &price): (&Vec<bool>, &f64)| PricedCut {
            members: cut.iter().enumerate().filter(|held| *held.1).map(|held| held.0).collect(),
            parts: Vec::new(),
            visited: None,
            price: units(price, power),
        };
        let mut certificate = WalkCertificate {
            unit: power,
            knots: knots.to_vec(),
            near: self.near.clone(),
            ng_sets: self.ng_sets.clone(),
            charges: charges.iter().map(|&charge| units(charge, power)).collect(),
            cuts: self.charges.cuts().iter().zip(prices).map(cut).filter(|c| c.price > 0).collect(),
            mixtures: self.mixtures.list(),
            all_orders,
            bound: units(self.value, power),
        };
        certificate.bound = i64::try_from(certificate.adds_up_to(problem).ok()?).ok()?;
        Some(certificate)
    }
}
