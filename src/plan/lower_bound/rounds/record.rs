//! What the best walks so far were looked for with, for their certificate (`walk_certificate`).

use super::super::certificate::{divided, unit, units};
use super::super::charges::Charges;
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
    company: Vec<Vec<usize>>,
    charges: Charges,
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
            company: ground.company.iter().cloned().map(sorted).collect(),
            charges: charges.clone(),
        }
    }

    /// The certificate; `None` if its numbers do not fit each other, which a fault of this program would be, or if it would take too long to check.
    pub(in super::super) fn certificate(&self, problem: &Problem) -> Option<WalkCertificate> {
        let items = divided(problem, &self.knots).ok()?;
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
            knots: self.knots.clone(),
            near: self.near.clone(),
            company: self.company.clone(),
            charges: charges.iter().map(|&charge| units(charge, power)).collect(),
            cuts: self.charges.cuts().iter().zip(prices).map(cut).filter(|c| c.price > 0).collect(),
            bound: 0,
        };
        certificate.bound = i64::try_from(certificate.adds_up_to(problem).ok()?).ok()?;
        Some(certificate)
    }
}
