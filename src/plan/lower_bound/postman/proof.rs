//! The certificate of the repaired numbers.

use super::super::certificate::{Certified, unit, units};
use super::super::net::Item;
use super::super::priced_cuts::Part;
use super::super::stop_certificate::{CutPart, PricedParts, StopCertificate};
use super::StopBound;
use super::cut::Partition;

/// What a certificate takes to be checked, for each number in the tables of legs.
const CHECK: u64 = 20;

impl StopBound {
    /// Takes over what the repaired numbers prove, if it is more than before. Returns about the work done.
    pub(super) fn prove(&mut self) -> u64 {
        let Some(proof) = self.written() else { return 0 };
        if let Ok(seconds) = proof.check(&self.problem)
            && seconds > self.best
        {
            self.best = seconds;
            self.proof = Some(proof);
        }
        CHECK * self.numbers() as u64
    }

    /// The certificate of the repaired numbers; `None` if its numbers do not fit each other, which a fault of this program would be.
    fn written(&self) -> Option<StopCertificate> {
        let items: Vec<Item> = self.members.iter().map(|m| m.item.clone()).collect();
        let (power, _) = unit(&items, &self.prices, &self.problem);
        let of_knots = |k: usize| {
            let knots = self.base[k]..self.base[k] + self.members[k].item.knots;
            self.potential[knots].iter().map(|&u| units(u, power)).collect()
        };
        let priced = |c: &Partition| PricedParts {
            parts: parts(c),
            price: units(c.price / (c.visited.len() + 1) as f64, power),
        };
        let mut certificate = StopCertificate {
            unit: power,
            knots: items.iter().map(|i| i.along.clone()).collect(),
            potentials: (0..items.len()).map(of_knots).collect(),
            cuts: self.cuts.iter().map(priced).filter(|c| c.price > 0).collect(),
            bound: 0,
        };
        certificate.bound = i64::try_from(certificate.adds_up_to(&self.problem).ok()?).ok()?;
        Some(certificate)
    }
}

/// The parts of a cut as a certificate lists them.
fn parts(cut: &Partition) -> Vec<CutPart> {
    let mut parts: Vec<CutPart> =
        cut.visited.iter().map(|v| CutPart { members: Vec::new(), some: Vec::new(), visited: *v }).collect();
    for (item, of) in &cut.held {
        for (number, part) in (1..).zip(&mut parts) {
            let knots: Vec<usize> = of.iter().enumerate().filter(|p| *p.1 == number).map(|p| p.0).collect();
            if knots.len() == of.len() {
                part.members.push(*item);
            } else if !knots.is_empty() {
                part.some.push(Part { item: *item, knots });
            }
        }
    }
    parts
}
