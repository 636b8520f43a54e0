//! The best potentials so far, for their certificate.

use super::super::certificate::{Certified, divided, unit, units};
use super::super::priced_cuts::PricedCut;
use super::super::prices::Prices;
use super::super::walk_certificate::FlowCertificate;
use super::super::walks::Ground;
use super::cut::Cut;
use super::net::{Net, barred};
use super::reach::Key;
use crate::problem::Problem;
use std::collections::{BTreeMap, BTreeSet};

/// Everything that the value depends on.
#[derive(Clone, Debug)]
pub(super) struct Record {
    knots: Vec<Vec<f64>>,
    near: Vec<Vec<usize>>,
    ng_sets: Vec<Vec<usize>>,
    /// The potentials of each state, which is an item and what is barred there, in ascending order.
    potentials: BTreeMap<(usize, Vec<usize>), Vec<f64>>,
    /// States that tours come to and do not come home from.
    dead_ends: BTreeSet<(usize, Vec<usize>)>,
    cuts: Vec<(Vec<usize>, f64)>,
}

impl Record {
    pub(super) fn new(ground: &Ground, net: &Net, potentials: &[f64], cuts: &[Cut]) -> Self {
        let sorted = |mut list: Vec<usize>| {
            list.sort_unstable();
            list.dedup();
            list
        };
        let mut near = vec![Vec::new(); ground.items.len()];
        for pair in ground.pairs.list.iter().filter(|p| p.items.iter().all(|&i| i >= ground.first)) {
            let [a, b] = pair.items;
            near[a.min(b)].push(a.max(b));
        }
        let named = |key: &Key| (key.0, sorted(barred(&ground.ng_sets, *key).collect()));
        let state = |(s, key): (usize, &Key)| (named(key), potentials[net.range(s)].to_vec());
        let members = |cut: &Cut| (0..cut.set.len()).filter(|&i| cut.set[i]).collect();
        Self {
            knots: ground.items.iter().map(|item| item.along.clone()).collect(),
            near: near.into_iter().map(sorted).collect(),
            ng_sets: ground.ng_sets.iter().map(|list| sorted(list.clone())).collect(),
            potentials: net.keys.iter().enumerate().map(state).collect(),
            dead_ends: net.dead_ends.iter().map(named).collect(),
            cuts: cuts.iter().filter(|c| c.price > 0.0).map(|c| (members(c), c.price)).collect(),
        }
    }

    /// The certificate of these potentials; `None` if its numbers do not fit each other, which a fault of this program would be.
    pub(super) fn certificate(&self, problem: &Problem) -> Option<FlowCertificate> {
        let items = divided(problem, &self.knots).ok()?;
        let (power, _) = unit(&items, &Prices::new(problem), problem);
        let cut = |(members, price): &(Vec<usize>, f64)| PricedCut {
            members: members.clone(),
            parts: Vec::new(),
            visited: None,
            price: units(*price, power),
        };
        let mut certificate = FlowCertificate {
            unit: power,
            knots: self.knots.clone(),
            near: self.near.clone(),
            ng_sets: self.ng_sets.clone(),
            potentials: Vec::new(),
            cuts: self.cuts.iter().map(cut).filter(|c| c.price > 0).collect(),
            bound: 0,
        };
        let states = certificate.states(problem).ok()?;
        let home = std::iter::once((0, Vec::new()));
        for (item, barred) in states.into_iter().chain(home) {
            let state = (item, barred);
            // Tours do not come to the others, or do not come home from them: their legs to those that count are too expensive to matter.
            let nowhere = if self.dead_ends.contains(&state) {
                -FlowCertificate::NOWHERE
            } else {
                FlowCertificate::NOWHERE
            };
            let known = self.potentials.get(&state);
            let potentials = known.map(|list| list.iter().map(|&p| units(p, power)).collect());
            certificate.potentials.push(potentials.unwrap_or_else(|| vec![nowhere; items[item].knots]));
        }
        certificate.bound = i64::try_from(certificate.adds_up_to(problem).ok()?).ok()?;
        Some(certificate)
    }
}
