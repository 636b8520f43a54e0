//! A sequence of stops with the exact seconds of every leg, and what is due before every stop because of heat.
//!
//! `changes.rs` prices and makes changes of it.

mod changes;

use super::begin::{Beginning, Head, Ways, begin, cold, may_choose, straight};
use super::clock::{Clock, Price};
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
        if let Some(mut clock) = new.clock.take() {
            new.total += clock.begin(&new.visits, &new.legs, |k, price| new.best_way(k, price));
            new.clock = Some(clock);
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
        match self.way(k, zones, is_cut, cold) {
            Some(way) => way.seconds,
            None => match zones {
                Some(zones) => zones.leg(from, to, |p| self.is_free(p, k)).seconds,
                None => self.air.seconds(from, to),
            },
        }
    }

    /// The cheapest way to begin the cut at `k`; `None` on the way home.
    fn way(
        &self,
        k: usize,
        zones: Option<&Zones>,
        is_cut: impl Fn(ItemId) -> bool,
        price: impl Fn(Option<f64>, f64) -> f64,
    ) -> Option<Beginning> {
        let (from, to) = self.ends(k)?;
        let node = self.visits.get(k)?.stop.node;
        let ways = Ways { air: &self.air, zones };
        let left = k.checked_sub(1).and_then(|before| self.visits.get(before)).map(|v| v.stop.node);
        Some(begin(self.problem, ways, Head { at: from, left }, (node, to), is_cut, price))
    }

    /// The way to begin the cut at `k` that is best by a price; `None` if there is but one.
    fn best_way(&self, k: usize, price: &Price<'_>) -> Option<Beginning> {
        if !may_choose(self.problem) {
            return None;
        }
        self.way(k, self.zones, |item| self.is_before(item, k), price)
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
}
