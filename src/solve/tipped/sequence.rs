//! A sequence of stops with the exact seconds of every leg, and what is due before every stop because of heat.
//!
//! A change permutes the stops of a window and changes their entries. The legs outside it stay as they are: as many pieces are
//! free before each of them as before. So a change is priced by the legs of its window alone, first as straight moves, which
//! are a bound from below, and only if that is low enough with what is in their way. Where cuts begin on kerfs, all kerfs count for that bound, and
//! then those that have been cut by then. Where cuts heat each other, the stops after
//! the window are looked at as well, until what was changed has cooled (`clock.rs`).

use super::begin::{Head, Ways, begin, straight};
use super::change::{Change, Proposal};
use super::clock::{Clock, Window};
use super::visit::Visit;
use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{Item, ItemId, Problem};
use crate::solve::epsilon::EPSILON;
use crate::solve::precedence::Precedence;
use crate::solve::traits::Stop;
use crate::tipping::{Piece, Zones};
use std::rc::Rc;

/// The position of items that are not in the sequence.
const NOWHERE: u32 = u32::MAX;

/// Sums that differ by less may differ by rounding alone, s.
const ROUNDING: f64 = 1e-9;

/// Whether what has been cut before counts by pieces that may have tipped alone: nothing is hot, and no cut begins on a kerf.
pub(super) fn only_tips(problem: &Problem) -> bool {
    problem.cooling().is_none() && problem.starts.is_empty()
}

/// Stops in order, with the seconds of the legs that lead to them.
pub(super) struct Sequence<'p> {
    pub(super) problem: &'p Problem,
    zones: Option<&'p Zones>,
    /// Seconds of straight moves.
    air: AirTime,
    /// When each stop ends, where cuts heat each other.
    clock: Option<Clock<'p>>,
    precedence: Rc<Precedence>,
    visits: Vec<Visit>,
    /// Seconds of the leg to each visit; the last one leads home.
    legs: Vec<f64>,
    /// The same, if each were straight.
    straights: Vec<f64>,
    /// By item: its position.
    position: Vec<u32>,
    total: f64,
    /// Moves priced.
    pub(super) priced: u64,
    /// The legs of the change that is being priced.
    new_legs: Vec<f64>,
}

impl<'p> Sequence<'p> {
    pub(super) fn new(problem: &'p Problem, stops: &[Stop]) -> Self {
        let visits = stops.iter().filter_map(|&s| Visit::new(problem, s)).collect();
        Self::of(problem, Rc::new(Precedence::new(problem)), visits)
    }

    /// Another sequence of the same problem. What is entered as in this one is not looked up again.
    pub(super) fn another(&self, stops: &[Stop]) -> Self {
        let known = |stop: &Stop| {
            let item = self.problem.nodes.get(stop.node as usize)?.item;
            self.visit(self.position(item)?).filter(|v| v.stop == *stop).copied()
        };
        let visit = |stop: &Stop| known(stop).or_else(|| Visit::new(self.problem, *stop));
        Self::of(self.problem, Rc::clone(&self.precedence), stops.iter().filter_map(visit).collect())
    }

    fn of(problem: &'p Problem, precedence: Rc<Precedence>, visits: Vec<Visit>) -> Self {
        let mut new = Self {
            problem,
            zones: problem.avoided(),
            air: straight(problem),
            clock: problem.cooling().map(Clock::new),
            precedence,
            legs: Vec::new(),
            straights: Vec::new(),
            position: vec![NOWHERE; problem.items.len()],
            total: 0.0,
            priced: 0,
            new_legs: Vec::new(),
            visits,
        };
        new.place(0, new.visits.len());
        new.straights = (0..=new.visits.len()).map(|k| new.straight(k)).collect();
        new.legs = (0..=new.visits.len()).map(|k| new.leg(k)).collect();
        new.total = new.legs.iter().sum::<f64>() + new.visits.iter().map(|v| v.extra).sum::<f64>();
        if let Some(clock) = &mut new.clock {
            new.total += clock.begin(&new.visits, &new.legs);
        }
        new
    }

    pub(super) fn total(&self) -> f64 {
        self.total
    }

    pub(super) fn len(&self) -> usize {
        self.visits.len()
    }

    pub(super) fn visits(&self) -> &[Visit] {
        &self.visits
    }

    pub(super) fn visit(&self, k: usize) -> Option<&Visit> {
        self.visits.get(k)
    }

    pub(super) fn stops(&self) -> Vec<Stop> {
        self.visits.iter().map(|v| v.stop).collect()
    }

    pub(super) fn item(&self, k: usize) -> Option<&'p Item> {
        self.problem.items.get(self.visits.get(k)?.item as usize)
    }

    /// The items at both ends of leg `k`, where both are stops.
    pub(super) fn items_of(&self, k: usize) -> Option<(ItemId, ItemId)> {
        Some((self.visits.get(k.checked_sub(1)?)?.item, self.visits.get(k)?.item))
    }

    /// The position of an item.
    pub(super) fn position(&self, item: ItemId) -> Option<usize> {
        self.position.get(item as usize).filter(|&&p| p != NOWHERE).map(|&p| p as usize)
    }

    /// Whether cuts heat each other.
    pub(super) fn is_heated(&self) -> bool {
        self.clock.is_some()
    }

    /// Whether what has been cut before counts by pieces that may have tipped alone.
    pub(super) fn only_tips(&self) -> bool {
        only_tips(self.problem)
    }

    /// Whether nothing has to come after the stop at `k`.
    pub(super) fn is_last(&self, k: usize) -> bool {
        self.visits.get(k).is_some_and(|v| self.precedence.after(v.item).is_empty())
    }

    /// Whether something is due before the stop at `k` because of heat.
    pub(super) fn is_due(&self, k: usize) -> bool {
        self.clock.as_ref().is_some_and(|c| c.due(k) > 0.0)
    }

    /// Seconds of leg `k` beyond those of a straight move, and what is due after it.
    pub(super) fn surcharge(&self, k: usize) -> f64 {
        let due = self.clock.as_ref().map_or(0.0, |c| c.due(k));
        self.legs.get(k).zip(self.straights.get(k)).map_or(0.0, |(leg, straight)| leg - straight) + due
    }

    /// Whether only tipped pieces count, and none is in the way of a leg.
    pub(super) fn is_straight(&self) -> bool {
        self.only_tips() && (0..self.legs.len()).all(|k| self.surcharge(k) <= EPSILON)
    }

    /// The positions of the last cuts that free what is in the way of leg `k`, and of the last cut that is hot after it.
    pub(super) fn blockers(&self, k: usize) -> Vec<usize> {
        let Some((from, to)) = self.ends(k) else { return Vec::new() };
        let mut positions = Vec::new();
        for piece in self.zones.iter().flat_map(|z| z.crossed(from, to, |p| self.is_free(p, k))) {
            positions.extend(piece.cut_by.iter().filter_map(|&c| self.position(c)).max());
        }
        positions.extend(self.clock.as_ref().and_then(|c| c.hot(&self.visits, k)));
        positions
    }

    /// The ends of leg `k`; `None` for the way home where there is none.
    fn ends(&self, k: usize) -> Option<(DVec2, DVec2)> {
        let from = match k.checked_sub(1) {
            None => self.problem.home,
            Some(before) => self.visits.get(before)?.exit,
        };
        match self.visits.get(k) {
            Some(visit) => Some((from, visit.entry)),
            None => self.problem.closed.then_some((from, self.problem.home)),
        }
    }

    fn straight(&self, k: usize) -> f64 {
        self.begin(k, None, |_| true)
    }

    fn leg(&self, k: usize) -> f64 {
        self.begin(k, self.zones, |item| self.is_before(item, k))
    }

    /// Seconds of leg `k` with the quickest way to begin the cut there, if `is_cut` says which items have been cut before.
    fn begin(&self, k: usize, zones: Option<&Zones>, is_cut: impl Fn(ItemId) -> bool) -> f64 {
        let Some((from, to)) = self.ends(k) else { return 0.0 };
        let Some(visit) = self.visits.get(k) else {
            return match zones {
                Some(zones) => zones.leg(from, to, |p| self.is_free(p, k)).seconds,
                None => self.air.seconds(from, to),
            };
        };
        let ways = Ways { air: &self.air, zones };
        let left = k.checked_sub(1).and_then(|before| self.visits.get(before)).map(|v| v.stop.node);
        let head = Head { at: from, left };
        begin(self.problem, ways, head, (visit.stop.node, to), is_cut).1
    }

    /// Whether an item is cut before the stop at `k`.
    fn is_before(&self, item: ItemId, k: usize) -> bool {
        self.position.get(item as usize).is_some_and(|&p| p != NOWHERE && (p as usize) < k)
    }

    /// The positions of the later stops on whose kerfs the stop at `k` might begin.
    pub(super) fn later_kerfs(&self, k: usize) -> Vec<usize> {
        let Some(visit) = self.visits.get(k) else { return Vec::new() };
        let kerfs = self.problem.starts.of(visit.stop.node).iter().filter_map(|s| s.kerf);
        let mut later: Vec<usize> = kerfs.filter_map(|i| self.position(i)).filter(|&p| p > k).collect();
        later.sort_unstable();
        later.dedup();
        later
    }

    /// Seconds of the straight legs to and from the stop at `k`, with what depends on its entry, if it were this one.
    pub(super) fn straight_by(&self, k: usize, visit: &Visit) -> f64 {
        let from = self.ends(k).map_or(self.problem.home, |e| e.0);
        let to = self.ends(k + 1).map(|e| e.1);
        let on = to.map_or(0.0, |to| self.air.seconds(visit.exit, to));
        self.air.seconds(from, visit.entry) + on + visit.extra
    }

    /// Whether a piece is free before leg `k`.
    fn is_free(&self, piece: &Piece, k: usize) -> bool {
        piece.cut_by.iter().all(|&c| self.is_before(c, k))
    }

    /// Writes the positions of the visits from `low` to `high`.
    fn place(&mut self, low: usize, high: usize) {
        for k in low..high {
            if let Some(visit) = self.visits.get(k)
                && let Some(position) = self.position.get_mut(visit.item as usize)
            {
                *position = u32::try_from(k).unwrap_or(NOWHERE);
            }
        }
    }

    /// Whether a proposal may gain more than `gain` seconds, by the legs at the ends of its stretches: those within them take at
    /// least as long as straight moves, and what they take beyond that now is all that they can save. A proposal that may not
    /// counts as a move.
    pub(super) fn may_gain(&mut self, proposal: Proposal, gain: f64) -> bool {
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
    pub(super) fn try_change(&mut self, change: &mut Change, gain: f64) -> bool {
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
        if let Some(clock) = self.clock.as_mut().filter(|_| better) {
            let (more, looked_at) =
                clock.replay(&self.visits, &self.legs, &legs, Window { low, rotated: change.rotated });
            self.priced += looked_at;
            saved -= more;
            better = saved > gain;
            if better {
                clock.keep(low);
            }
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
    pub(super) fn undo(&mut self, change: &mut Change) {
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
        if let Some(clock) = &mut self.clock
            && let Some(legs) = self.legs.get(low..=high)
        {
            self.total += clock.replay(&self.visits, &self.legs, legs, Window { low, rotated: None }).0;
            clock.keep(low);
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
    pub(super) fn is_feasible(&self) -> bool {
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
