//! Changes of a sequence: what one may gain at most, what it gains exactly, making it, and taking it back.
//!
//! A change permutes the stops of a window and changes their entries. The legs outside it stay as they are: as many pieces are
//! free before each of them as before. So a change is priced by the legs of its window alone, first as straight moves, which
//! are a bound from below, and only if that is low enough with what is in their way. Where cuts begin on kerfs, all kerfs count for that bound, and
//! then those that have been cut by then. Where cuts heat each other, the stops after
//! the window are looked at as well, until what was changed has cooled (`clock.rs`).

use super::super::begin::may_choose;
use super::super::change::{Change, Proposal};
use super::super::clock::Window;
use super::super::visit::Visit;
use super::Sequence;
use crate::geometry::DVec2;
use crate::problem::ItemId;

/// Sums that differ by less may differ by rounding alone, s.
const ROUNDING: f64 = 1e-9;

impl Sequence<'_> {
    /// Whether a proposal may gain more than `gain` seconds, by the legs at the ends of its stretches: those within them take at
    /// least as long as straight moves, and what they take beyond that now is all that they can save. A proposal that may not
    /// counts as a move.
    pub(in super::super) fn may_gain(&mut self, proposal: Proposal, gain: f64) -> bool {
        let Some((low, high, more)) = self.at_least(proposal) else { return true };
        let surcharges = self.legs.get(low..=high).into_iter().flatten().sum::<f64>()
            - self.straights.get(low..=high).into_iter().flatten().sum::<f64>();
        let due = self.clock.as_ref().map_or(0.0, |c| c.due_near(low, high));
        let may = more - surcharges - due < ROUNDING - gain;
        self.priced += u64::from(!may);
        may
    }

    /// The window of a proposal, and the seconds by which its straight legs take longer; `None` where more than its ends changes.
    fn at_least(&self, proposal: Proposal) -> Option<(usize, usize, f64)> {
        if !self.problem.starts.is_empty() || !self.problem.links.is_empty() {
            return None;
        }
        let place = |k: usize| self.visits.get(k).map(|v| (v.entry, v.exit));
        let exit = |k: usize| k.checked_sub(1).map_or(Some(self.problem.home), |b| Some(place(b)?.1));
        let home = (self.problem.home, self.problem.home);
        // The stop after a window; `None` if the path ends with it.
        let next = |high: usize| place(high).or_else(|| self.problem.closed.then_some(home)).map(|p| p.0);
        let leg = |from: DVec2, to: Option<DVec2>| to.map_or(0.0, |to| self.air.seconds(from, to));
        let now = |k: usize| self.straights.get(k).copied();
        match proposal {
            Proposal::Exchange { low, middle, high } if low < middle && middle < high => {
                let new = leg(exit(low)?, Some(place(middle)?.0))
                    + leg(exit(high)?, Some(place(low)?.0))
                    + leg(exit(middle)?, next(high));
                Some((low, high, new - now(low)? - now(middle)? - now(high)?))
            }
            Proposal::Reverse { low, high } if low + 1 < high => {
                let same = |v: &Visit| {
                    v.entry == v.exit
                        && self.problem.nodes.get(v.stop.node as usize).is_some_and(|n| n.twin == v.stop.node)
                };
                if !self.visits.get(low..high)?.iter().all(same) {
                    return None;
                }
                let new = leg(exit(low)?, Some(place(high - 1)?.0)) + leg(place(low)?.1, next(high));
                Some((low, high, new - now(low)? - now(high)?))
            }
            _ => None,
        }
    }

    /// Makes a change if that takes less time than now by more than `gain` seconds, which may be negative. Returns whether it
    /// did; then `change` holds what undoes it.
    pub(in super::super) fn try_change(&mut self, change: &mut Change, gain: f64) -> bool {
        self.priced += 1;
        let (low, high) = (change.low, change.low + change.visits.len());
        let Some(old) = self.visits.get(low..high) else { return false };
        let extras = |visits: &[Visit]| visits.iter().map(|v| v.extra).sum::<f64>();
        let now = self.legs.get(low..=high).map_or(0.0, |l| l.iter().sum()) + extras(old);
        let extra = extras(&change.visits);
        // What is due in the window and soon after it may be saved, too.
        let due = self.clock.as_ref().map_or(0.0, |c| c.due_near(low, high));
        self.exchange(change);
        let mut straight = extra;
        let mut k = low;
        while k <= high && straight < now + due - gain {
            straight += self.straight(k);
            k += 1;
        }
        if straight >= now + due - gain || !self.is_allowed(low, high) {
            self.exchange(change);
            return false;
        }
        // What the straight legs leave for detours and lifts.
        let mut sum = straight;
        let mut legs = std::mem::take(&mut self.new_legs);
        legs.clear();
        for k in low..=high {
            let leg = self.leg(k);
            sum += leg - self.straight(k);
            legs.push(leg);
            self.priced += 1;
            if sum >= now + due - gain {
                break;
            }
        }
        let mut better = sum < now + due - gain && legs.len() == high + 1 - low;
        let mut saved = now - sum;
        if better && let Some(mut clock) = self.clock.take() {
            // Where cuts may be begun in several ways, which of them there are depends on what has been cut before.
            let rotated = change.rotated.filter(|_| !may_choose(self.problem));
            let (more, looked_at) =
                clock.replay(&self.visits, &self.legs, &legs, Window { low, rotated }, |k, price| {
                    self.best_way(k, price)
                });
            self.priced += looked_at;
            saved -= more;
            better = saved > gain;
            if better {
                clock.keep(low);
            }
            self.clock = Some(clock);
        }
        if better {
            self.total -= saved;
            if let Some(place) = self.legs.get_mut(low..=high) {
                place.copy_from_slice(&legs);
            }
            self.straighten(low, high);
        } else {
            self.exchange(change);
        }
        self.new_legs = legs;
        better
    }

    /// Takes back a change that was made.
    pub(in super::super) fn undo(&mut self, change: &mut Change) {
        let (low, high) = (change.low, change.low + change.visits.len());
        let sum = |s: &Self| {
            s.legs.get(low..=high).map_or(0.0, |l| l.iter().sum::<f64>())
                + s.visits.get(low..high).map_or(0.0, |v| v.iter().map(|v| v.extra).sum())
        };
        let before = sum(self);
        self.exchange(change);
        for k in low..=high {
            let leg = self.leg(k);
            if let Some(place) = self.legs.get_mut(k) {
                *place = leg;
            }
        }
        self.straighten(low, high);
        self.total += sum(self) - before;
        if let Some(mut clock) = self.clock.take() {
            let legs = self.legs.get(low..=high).unwrap_or_default();
            let window = Window { low, rotated: None };
            self.total +=
                clock.replay(&self.visits, &self.legs, legs, window, |k, price| self.best_way(k, price)).0;
            clock.keep(low);
            self.clock = Some(clock);
        }
    }

    /// Writes the seconds of the straight legs of a window.
    fn straighten(&mut self, low: usize, high: usize) {
        for k in low..=high {
            let seconds = self.straight(k);
            if let Some(place) = self.straights.get_mut(k) {
                *place = seconds;
            }
        }
    }

    fn exchange(&mut self, change: &mut Change) {
        let (low, high) = (change.low, change.low + change.visits.len());
        if let Some(window) = self.visits.get_mut(low..high) {
            window.swap_with_slice(&mut change.visits);
        }
        self.place(low, high);
    }

    /// Whether the order keeps precedence, ranks and groups.
    pub(in super::super) fn is_feasible(&self) -> bool {
        self.is_allowed(0, self.len())
    }

    /// Whether the order within a window keeps precedence, ranks and groups.
    fn is_allowed(&self, low: usize, high: usize) -> bool {
        let rank = |k: usize| self.item(k).map(|i| i.rank);
        let from = low.saturating_sub(1);
        let ranked = (from..high).all(|k| rank(k + 1).is_none_or(|next| rank(k) <= Some(next)));
        let waits = |k: usize| {
            let Some(visit) = self.visits.get(k) else { return false };
            self.precedence.waits(visit.item, |i| self.position(i).is_some_and(|p| p < k))
        };
        ranked && !(low..high).any(waits) && self.keeps_groups()
    }

    fn keeps_groups(&self) -> bool {
        let groups = &self.problem.groups;
        let rank = |i: ItemId| self.problem.items.get(i as usize).map_or(0, |i| i.rank);
        groups.is_empty() || groups.are_together(self.visits.iter().map(|v| v.item), rank)
    }
}
