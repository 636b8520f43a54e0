//! Kicks: changes at random, near a leg that costs more than a straight one, from which the descent goes on.

use super::super::change::Proposal;
use super::super::visit::Visit;
use super::Descent;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Draw;
use crate::solve::traits::Stop;

/// Longest stretch of a kick.
const KICK: usize = 5;
/// In sequences up to this length with cuts that heat each other, kicks exchange any stretches, several times at once: what is due
/// hides what most single changes gain, and there are not many orders.
const FEW: usize = 12;
const FEW_KICKS: usize = 3;

impl Descent<'_> {
    /// Exchanges two short stretches near a leg that is not straight. Returns whether there is one.
    pub(super) fn kick(&mut self) -> bool {
        let length = self.sequence.len();
        if length < 3 {
            return false;
        }
        let from = self.rng.below(length + 1);
        let mut onwards = (from..=length).chain(0..from);
        // What is not due any more may still be far away from what is next to it.
        let anywhere = self.sequence.is_heated() && self.rng.below(2) == 0;
        let at = onwards.find(|&k| anywhere || self.sequence.surcharge(k) > EPSILON);
        let Some(at) = at.or(self.sequence.is_heated().then_some(from)) else { return false };
        let seconds = self.sequence.total();
        self.kicked = Some((Vec::new(), seconds));
        if self.sequence.is_heated() && length <= FEW {
            (0..=self.rng.below(FEW_KICKS)).for_each(|_| self.kick_few());
            return true;
        }
        let (first, second) = (1 + self.rng.below(KICK), 1 + self.rng.below(KICK));
        let low = (at + self.rng.below(KICK)).saturating_sub(KICK + first).min(length - 2);
        let middle = (low + first).min(length - 1);
        let proposal = if self.rng.below(4) == 0 {
            Proposal::Reverse { low, high: (low + first + 1).min(length) }
        } else {
            Proposal::Exchange { low, middle, high: (middle + second).min(length) }
        };
        self.make(proposal, f64::NEG_INFINITY);
        true
    }

    /// Exchanges any two stretches, and enters a stop by any of its nodes.
    fn kick_few(&mut self) {
        let length = self.sequence.len();
        let low = self.rng.below(length - 1);
        let middle = low + 1 + self.rng.below(length - 1 - low);
        let high = middle + 1 + self.rng.below(length - middle);
        self.make(Proposal::Exchange { low, middle, high }, f64::NEG_INFINITY);
        let k = self.rng.below(length);
        let Some(nodes) = self.sequence.item(k).map(|i| i.nodes.clone()) else { return };
        let Some(node) = nodes.clone().nth(self.rng.below(nodes.len().max(1))) else { return };
        let stop = Stop::at(self.sequence.problem, node);
        if let Some(visit) = Visit::new(self.sequence.problem, stop) {
            self.make(Proposal::Enter { at: k, visit }, f64::NEG_INFINITY);
        }
    }
}
