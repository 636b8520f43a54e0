//! Certificates of the bound by flows (`flows/`), and their check in whole numbers.
//!
//! A certificate lists how contours are divided into pieces, which items are near, what is remembered at each item, a potential for each state at
//! each knot, and the prices of cuts. The check makes the problem and the states again (`states.rs`) and looks at every leg between two states: it costs its
//! seconds, less what cuts give for it, more by the potential that it leaves and less by the one it comes to. The sum of the cheapest legs to the
//! states of each item is the bound. Around a tour the potentials cancel, whatever they are.
//!
//! A state that no tour comes to may have any potential.

use super::super::certificate::Certified;
use super::super::fault::CertificateFault;
use super::super::priced_cuts::PricedCut;
use super::shortest::{Most, Walks, lower};
use super::{LARGEST, applies, read};
use crate::problem::Problem;
use serde::{Deserialize, Serialize};

/// Numbers that prove a bound of travel by flows.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlowCertificate {
    /// The unit is 2 to this power, in seconds (or in the unit of the table of costs).
    pub unit: i32,
    /// Arc length of the knots along each item that may be entered anywhere, mm; empty for other items.
    pub knots: Vec<Vec<f64>>,
    /// For each item those of a higher number that it is near, in ascending order: legs between them are priced from knot to knot, all others, but
    /// those of home, by boxes.
    pub near: Vec<Vec<usize>>,
    /// For each item which others are remembered there (its ng-set), in ascending order.
    #[serde(rename = "company")]
    pub ng_sets: Vec<Vec<usize>>,
    /// The potentials of each state at each knot of its item, in units, in the order in which the check finds the states; those of home last.
    pub potentials: Vec<Vec<i64>>,
    /// The cuts with prices.
    pub cuts: Vec<PricedCut>,
    /// The bound that follows, in units.
    pub bound: i64,
}

impl FlowCertificate {
    /// The potential of states that no tour comes to: their legs to others are too expensive to matter.
    pub(in super::super) const NOWHERE: i64 = LARGEST;

    /// The item of each state but home, and what is barred there in ascending order.
    pub(in super::super) fn states(
        &self,
        problem: &Problem,
    ) -> Result<Vec<(usize, Vec<usize>)>, CertificateFault> {
        let ground = read(&self.knots, [&self.near, &self.ng_sets], self.unit, problem)?;
        let states = ground.states()?;
        let barred = |s: usize| states.barred_in(s, &self.ng_sets).collect();
        Ok((0..states.item.len()).map(|s| (states.item[s], barred(s))).collect())
    }
}

impl Certified for FlowCertificate {
    fn stated(&self) -> (i64, i32) {
        (self.bound, self.unit)
    }

    fn adds_up_to(&self, problem: &Problem) -> Result<i128, CertificateFault> {
        if !applies(problem) {
            return Err(CertificateFault::Problem);
        }
        let ground = read(&self.knots, [&self.near, &self.ng_sets], self.unit, problem)?;
        let states = ground.states()?;
        let walks = ground.walks(&states);
        walks.are_few(&Most::OF_WALKS, self.cuts.len(), 1)?;
        let home = std::iter::once(0);
        let fits = |(item, list): (usize, &Vec<i64>)| {
            let small = list.iter().all(|p| (-LARGEST..=LARGEST).contains(p));
            small && list.len() == ground.items[item].knots
        };
        let of_items = states.item.iter().copied().chain(home);
        if self.potentials.len() != states.item.len() + 1 || !of_items.zip(&self.potentials).all(fits) {
            return Err(CertificateFault::Shape("potentials"));
        }
        let cuts = ground.cuts(&self.cuts)?;
        let legs = walks.cheapest_legs((self.unit, ground.guard), &self.potentials, &cuts)?;
        Ok(legs.iter().sum::<i128>() + cuts.back)
    }
}

impl Walks<'_> {
    /// For each item the cheapest leg to one of its states, in units.
    fn cheapest_legs(
        &self,
        unit: (i32, f64),
        potentials: &[Vec<i64>],
        cuts: &super::super::priced_cuts::Cuts,
    ) -> Result<Vec<i128>, CertificateFault> {
        let legs = self.legs(unit, cuts).ok_or(CertificateFault::Shape("cuts"))?;
        let (of_states, home) = potentials.split_at(self.states.item.len());
        let home = home.first().map_or(&[][..], Vec::as_slice);
        let mut lowest = vec![i64::MAX; self.items.len()];
        for (&item, list) in self.states.item.iter().zip(of_states) {
            lowest[item] = list.iter().copied().fold(lowest[item], i64::min);
        }
        let mut cheapest: Vec<Option<i128>> = vec![None; self.items.len()];
        let mut come = |item: usize, arrives: &[i64], potentials: &[i64]| {
            for ((&arrives, &potential), &pay) in arrives.iter().zip(potentials).zip(&cuts.pay[item]) {
                if arrives < super::shortest::NONE / 2 {
                    let leg = i128::from(arrives) - i128::from(potential) + pay;
                    cheapest[item] = Some(cheapest[item].map_or(leg, |c| c.min(leg)));
                }
            }
        };
        let mut steps = self.states.steps.iter().peekable();
        for (s, (&item, list)) in self.states.item.iter().zip(of_states).enumerate() {
            let mut row = vec![super::shortest::NONE; list.len()];
            while let Some(step) = steps.next_if(|step| step.to == s) {
                let mut least = vec![super::shortest::NONE; self.items[step.from].knots];
                for &source in &self.states.sources[step.sources.clone()] {
                    least.iter_mut().zip(&of_states[source]).for_each(|(l, &p)| *l = p.min(*l));
                }
                lower(&mut row, &self.left(step.from, &least), legs.between(step.from, item));
            }
            if self.states.fresh[item] == s {
                if self.order.places[item][0] <= 1 {
                    lower(&mut row, home, legs.between(0, item));
                }
                let far = legs.far[item].iter().map(|&(from, gap)| lowest[from].saturating_add(gap));
                let least = far.min().unwrap_or(super::shortest::NONE);
                row.iter_mut().for_each(|v| *v = least.min(*v));
            }
            come(item, &row, list);
        }
        let end = self.first - 1;
        let mut row = vec![super::shortest::NONE; home.len()];
        for (&item, list) in self.states.item.iter().zip(of_states) {
            if self.order.places[item][1] >= self.items.len() - self.first {
                lower(&mut row, &self.left(item, list), legs.between(item, end));
            }
        }
        come(0, &row, home);
        let all = cheapest.into_iter().enumerate().filter(|c| c.0 == 0 || c.0 >= self.first);
        all.map(|(_, leg)| leg.ok_or(CertificateFault::Problem)).collect()
    }
}
