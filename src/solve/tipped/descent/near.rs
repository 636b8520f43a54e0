//! The changes that are tried near a leg: other entries at its ends, and other orders of the stops around it.

use super::super::change::Proposal;
use super::super::entries::entries;
use super::{Descent, LONGEST};
use crate::solve::epsilon::EPSILON;

/// Stops near a leg in the sequence that are tried as other ends of changes.
const NEAR: usize = 8;
/// Stops all over the sequence that are tried for a cut that has to wait.
const SPREAD: usize = 48;

impl Descent<'_> {
    /// Tries the changes near leg `k` until one gains.
    pub(super) fn improve(&mut self, k: usize) -> bool {
        if self.enter_better(k) || k.checked_sub(1).is_some_and(|before| self.enter_better(before)) {
            return true;
        }
        // What is in the way is cut later.
        for blocker in self.sequence.blockers(k) {
            for later in k..=(k + NEAR).min(self.sequence.len()) {
                for stretch in 1..=2 {
                    let (low, middle) = (blocker, blocker + stretch);
                    if self.make(Proposal::Exchange { low, middle, high: later }, EPSILON) {
                        return true;
                    }
                }
            }
        }
        // What it might begin on is cut earlier, or it comes later.
        for later in self.sequence.later_kerfs(k) {
            for stretch in 1..=3 {
                let (first, last) = ((later + 1).saturating_sub(stretch), (k + 1).saturating_sub(stretch));
                let earlier = Proposal::Exchange { low: k, middle: first, high: later + 1 };
                let put_off = Proposal::Exchange { low: last, middle: k + 1, high: later + 1 };
                if self.make(earlier, EPSILON) || self.make(put_off, EPSILON) {
                    return true;
                }
            }
        }
        for other in self.others(k) {
            let (low, high) = (k.min(other), k.max(other));
            if self.make(Proposal::Reverse { low, high }, EPSILON) {
                return true;
            }
            for stretch in 1..=3 {
                // The stops at the beginning of the window go to its end, or those at its end to its beginning.
                for middle in [low + stretch, high.saturating_sub(stretch)] {
                    if self.make(Proposal::Exchange { low, middle, high }, EPSILON) {
                        return true;
                    }
                }
            }
        }
        false
    }

    /// Positions near leg `k`, in the sequence and on the sheet.
    fn others(&mut self, k: usize) -> Vec<usize> {
        let length = self.sequence.len();
        let mut others: Vec<usize> = (k.saturating_sub(NEAR)..=(k + NEAR).min(length)).collect();
        for end in [k.checked_sub(1), Some(k)].into_iter().flatten() {
            let Some(visit) = self.sequence.visit(end) else { continue };
            for &item in self.neighbours.of(visit.item) {
                others.extend(self.sequence.position(item).into_iter().flat_map(|p| [p, p + 1]));
            }
        }
        if self.longest > LONGEST {
            // Around its neighbours there may be no time at which it is cold. What nothing waits for may be put off until then.
            let ends: Vec<usize> = (0..length).filter(|&p| self.sequence.is_last(p)).collect();
            let apart = ends.len().div_ceil(SPREAD).max(1);
            others.extend(ends.into_iter().skip(k % apart).step_by(apart));
        }
        others.retain(|&other| other != k && other <= length);
        others
    }

    /// Tries other entries of the stop at `k`.
    fn enter_better(&mut self, k: usize) -> bool {
        let mut better = false;
        for visit in entries(&self.sequence, k) {
            better |= self.make(Proposal::Enter { at: k, visit }, EPSILON);
        }
        better
    }
}
