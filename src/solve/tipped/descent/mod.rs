//! Local search on the exact seconds of a sequence, where moves are in the way of tipped pieces or cuts heat each other.
//!
//! A queue holds the legs to be looked at: those that take longer than a straight move or than a start on a kerf that is not cut yet, and all where cuts heat each other. For each, other entries at its ends are
//! tried, and other orders nearby: what blocks it is cut later, a stop or two go elsewhere, a stretch is reversed, two stretches
//! are exchanged (`near.rs`). When the queue is empty, a kick near such a leg exchanges two short stretches; the search repairs what it
//! can, and the result stays if it is no worse (`kicks.rs`).

mod kicks;
mod near;

use super::change::{Change, Proposal};
use super::neighbours::Neighbours;
use super::patches::{Patch, patches};
use super::sequence::Sequence;
use crate::problem::ItemId;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Rng;
use crate::solve::traits::Stop;

/// Longest window of a change: a longer one is priced too slowly for what it gains.
const LONGEST: usize = 400;
/// In sequences up to this length, straight legs are looked at as well.
const SMALL: usize = 100;

/// Moves of the local search without a gain after which it has ended, once the method has.
pub(super) const PATIENCE: u64 = 400_000;

/// The local search.
pub(super) struct Descent<'p> {
    sequence: Sequence<'p>,
    /// The best seconds found from where it last began.
    best: f64,
    best_stops: Vec<Stop>,
    /// The method's stops when the search began there; empty if it began elsewhere.
    began_as: Vec<Stop>,
    /// What the search has changed in the last such sequence that it has left.
    patches: Vec<Patch>,
    /// By item: the item before it when the leg between them was last looked at in vain.
    tried: Vec<Option<ItemId>>,
    /// Another sequence to descend from when this one has settled.
    other: Option<Sequence<'p>>,
    queue: Vec<usize>,
    rng: Rng,
    neighbours: Neighbours<'p>,
    /// Changes since the last kick, and the seconds before it; `None` before the first.
    kicked: Option<(Vec<Change>, f64)>,
    settled: bool,
    since_gain: u64,
    /// Longest window of the changes that are tried now.
    longest: usize,
}

impl<'p> Descent<'p> {
    /// Waits at a sequence for a better one to begin at.
    pub(super) fn new(sequence: Sequence<'p>, rng: Rng) -> Self {
        Self {
            best: sequence.total(),
            best_stops: sequence.stops(),
            neighbours: Neighbours::new(sequence.problem),
            began_as: Vec::new(),
            patches: Vec::new(),
            tried: vec![None; sequence.problem.items.len()],
            other: None,
            queue: Vec::new(),
            rng,
            kicked: None,
            settled: false,
            since_gain: 0,
            longest: LONGEST,
            sequence,
        }
    }

    /// The best seconds.
    pub(super) fn best(&self) -> f64 {
        self.best
    }

    /// The stops of the best.
    pub(super) fn stops(&self) -> Vec<Stop> {
        self.best_stops.clone()
    }

    /// Moves since the last gain.
    pub(super) fn since_gain(&self) -> u64 {
        self.since_gain
    }

    /// Whether nothing is left to be looked at before the next kick.
    pub(super) fn is_settled(&self) -> bool {
        self.queue.is_empty() && self.other.is_none()
    }

    /// Goes on from another sequence.
    pub(super) fn begin_at(&mut self, sequence: Sequence<'p>) {
        self.leave();
        self.sequence = sequence;
        self.settled = false;
        self.since_gain = 0;
        self.look_at_all();
        self.save();
    }

    /// A sequence of other stops; with what was changed in the last sequence of the method, if only tipped pieces count.
    pub(super) fn patched(&self, stops: &[Stop]) -> Sequence<'p> {
        let mut sequence = self.sequence.another(stops);
        if !sequence.only_tips() {
            return sequence;
        }
        let now = (!self.began_as.is_empty()).then(|| patches(&self.began_as, &self.sequence));
        for patch in now.as_ref().unwrap_or(&self.patches) {
            patch.apply(&mut sequence);
        }
        sequence
    }

    /// Descends as well from a sequence that was made of stops of the method, and goes on with the better one: at once if only
    /// tipped pieces count, otherwise when this one has settled, because a descent takes long.
    pub(super) fn also_try(&mut self, sequence: Sequence<'p>, stops: Vec<Stop>) {
        if !sequence.only_tips() {
            self.other = Some(sequence);
            return;
        }
        self.leave();
        self.sequence = sequence;
        self.began_as = stops;
        self.settled = true;
        self.look_at_all();
        // What could not be improved in another sequence is looked at last.
        let (sequence, tried) = (&self.sequence, &self.tried);
        self.queue.sort_by_key(|&k| {
            let leg = sequence.items_of(k);
            leg.is_none_or(|(from, to)| tried.get(to as usize).is_none_or(|t| *t != Some(from)))
        });
        self.save();
    }

    /// Leaves the sequence: takes back the kick, and keeps what was changed.
    fn leave(&mut self) {
        if let Some((mut changes, _)) = self.kicked.take() {
            while let Some(mut change) = changes.pop() {
                self.sequence.undo(&mut change);
            }
        }
        if !self.began_as.is_empty() {
            self.patches = patches(&self.began_as, &self.sequence);
            self.began_as.clear();
        }
    }

    fn look_at_all(&mut self) {
        if self.sequence.is_straight() {
            // The method knows what such a sequence costs, and finds shorter ones sooner.
            self.queue.clear();
            return;
        }
        let all = self.sequence.len() <= SMALL || self.sequence.is_heated();
        let looked_at = |&k: &usize| all || self.sequence.surcharge(k) > EPSILON;
        self.queue = (0..=self.sequence.len()).rev().filter(looked_at).collect();
        if self.sequence.is_heated() {
            // What is due is looked at first.
            self.queue.sort_by_key(|&k| self.sequence.is_due(k));
        } else if self.sequence.only_tips() {
            // The legs that cost most are looked at first.
            self.queue.sort_by(|&a, &b| self.sequence.surcharge(a).total_cmp(&self.sequence.surcharge(b)));
        }
    }

    /// Keeps what a descent that is not finished has reached.
    pub(super) fn save_so_far(&mut self) {
        if self.kicked.is_none() {
            self.save();
        }
    }

    fn save(&mut self) {
        if self.sequence.total() < self.best - EPSILON {
            self.best = self.sequence.total();
            self.best_stops = self.sequence.stops();
            self.since_gain = 0;
        }
    }

    /// Does the smallest piece of work there is. Returns the number of moves priced; 0 if nothing is in the way of anything.
    pub(super) fn advance(&mut self) -> u64 {
        let before = self.sequence.priced;
        if let Some(k) = self.queue.pop() {
            // A cut that has to wait may go anywhere: there are few of them.
            let waits = |k: usize| self.sequence.is_due(k);
            self.longest = if waits(k) || k.checked_sub(1).is_some_and(waits) { usize::MAX } else { LONGEST };
            if self.improve(k) {
                self.queue.push(k);
            } else if let Some((from, to)) = self.sequence.items_of(k)
                && let Some(place) = self.tried.get_mut(to as usize)
            {
                *place = Some(from);
            }
            self.longest = LONGEST;
        } else if self.settle() {
            return 1;
        } else if !self.kick() {
            self.since_gain = self.since_gain.saturating_add(PATIENCE);
            return 0;
        }
        let priced = (self.sequence.priced - before).max(1);
        self.since_gain += priced;
        priced
    }

    /// What follows when the queue is empty: a kick stays or is taken back, and another sequence gets its turn. Returns whether
    /// the sequence is another one now.
    fn settle(&mut self) -> bool {
        if let Some((mut changes, seconds)) = self.kicked.take()
            && self.sequence.total() > seconds + EPSILON
        {
            while let Some(mut change) = changes.pop() {
                self.sequence.undo(&mut change);
            }
        }
        self.save();
        if self.settled && self.sequence.total() > self.best + EPSILON {
            // The other sequence came out worse: back to the best.
            let stops = self.best_stops.clone();
            self.begin_again(&stops);
            return true;
        }
        self.settled = false;
        if let Some(other) = self.other.take() {
            self.sequence = other;
            self.settled = true;
            self.look_at_all();
            return true;
        }
        false
    }

    fn begin_again(&mut self, stops: &[Stop]) {
        self.leave();
        self.sequence = self.sequence.another(stops);
        self.settled = false;
        self.queue.clear();
    }

    /// Makes a change if it gains more than `gain`, and puts what it touches on the queue.
    fn make(&mut self, proposal: Proposal, gain: f64) -> bool {
        if proposal.width() > self.longest || !self.sequence.may_gain(proposal, gain) {
            return false;
        }
        let change = proposal.change(self.sequence.problem, self.sequence.visits());
        let Some(mut change) = change else { return false };
        if !self.sequence.try_change(&mut change, gain) {
            return false;
        }
        let (low, high) = (change.low, change.low + change.visits.len());
        let touched = [low, low + 1, high.saturating_sub(1), high];
        for k in (low..=high).filter(|&k| touched.contains(&k) || self.sequence.surcharge(k) > EPSILON) {
            if !self.queue.contains(&k) {
                self.queue.push(k);
            }
        }
        if let Some((changes, _)) = &mut self.kicked {
            changes.push(change);
        }
        true
    }
}
