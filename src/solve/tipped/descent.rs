//! Local search on the exact seconds of a sequence, where moves are in the way of tipped pieces or cuts heat each other.
//!
//! A queue holds the legs to be looked at: those that take longer than a straight move or than a start on a kerf that is not cut yet, and all where cuts heat each other. For each, other entries at its ends are
//! tried, and other orders nearby: what blocks it is cut later, a stop or two go elsewhere, a stretch is reversed, two stretches
//! are exchanged. When the queue is empty, a kick near such a leg exchanges two short stretches; the search repairs what it
//! can, and the result stays if it is no worse.

use super::change::Change;
use super::sequence::Sequence;
use crate::geometry::{Aabb, Buckets};
use crate::problem::Problem;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::{Draw, Rng};
use crate::solve::traits::Stop;

/// Stops near a leg in the sequence that are tried as other ends of changes.
const NEAR: usize = 8;
/// Stops near a leg on the sheet that are tried, for each of its ends.
const NEIGHBOURS: usize = 6;
/// Longest window of a change: a longer one is priced too slowly for what it gains.
const LONGEST: usize = 400;
/// Stops all over the sequence that are tried for a cut that has to wait.
const SPREAD: usize = 48;
/// Longest stretch of a kick.
const KICK: usize = 5;
/// In sequences up to this length with cuts that heat each other, kicks exchange any stretches, several times at once: what is due
/// hides what most single changes gain, and there are not many orders.
const FEW: usize = 12;
const FEW_KICKS: usize = 3;
/// In sequences up to this length, straight legs are looked at as well.
const SMALL: usize = 100;
/// Parts of a contour's length by which an entry slides.
const SLIDES: [f64; 3] = [32.0, 256.0, 2048.0];

/// Moves of the local search without a gain after which it has ended, once the method has.
pub(super) const PATIENCE: u64 = 400_000;

/// The local search.
pub(super) struct Descent<'p> {
    sequence: Sequence<'p>,
    /// The best seconds found from where it last began.
    best: f64,
    best_stops: Vec<Stop>,
    /// Another sequence to descend from when this one has settled.
    other: Option<Sequence<'p>>,
    queue: Vec<usize>,
    rng: Rng,
    /// By item: its nearest items.
    neighbours: Vec<Vec<u32>>,
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
        let mut neighbours = neighbours(sequence.problem, NEIGHBOURS, |_, _| true);
        if let Some(cooling) = sequence.problem.cooling() {
            // What is cut next to an item is best one that is near, but not too near.
            let cool = self::neighbours(sequence.problem, NEIGHBOURS, |a, b| !cooling.are_near(a, b));
            neighbours.iter_mut().zip(cool).for_each(|(all, cool)| all.extend(cool));
        }
        Self {
            best: sequence.total(),
            best_stops: sequence.stops(),
            sequence,
            other: None,
            queue: Vec::new(),
            rng,
            neighbours,
            kicked: None,
            settled: false,
            since_gain: 0,
            longest: LONGEST,
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

    /// Goes on from another sequence.
    pub(super) fn begin_at(&mut self, sequence: Sequence<'p>) {
        self.sequence = sequence;
        self.kicked = None;
        self.settled = false;
        self.since_gain = 0;
        self.look_at_all();
        self.save();
    }

    /// Descends from another sequence as well, when this one has settled, and goes on with the better one.
    pub(super) fn also_try(&mut self, sequence: Sequence<'p>) {
        self.other = Some(sequence);
    }

    fn look_at_all(&mut self) {
        let all = self.sequence.len() <= SMALL || self.sequence.is_heated();
        let looked_at = |&k: &usize| all || self.sequence.surcharge(k) > EPSILON;
        self.queue = (0..=self.sequence.len()).rev().filter(looked_at).collect();
        if self.sequence.is_heated() {
            // What is due is looked at first.
            self.queue.sort_by_key(|&k| self.sequence.is_due(k));
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
        self.sequence = Sequence::new(self.sequence.problem, stops);
        self.settled = false;
        self.queue.clear();
    }

    /// Exchanges two short stretches near a leg that is not straight. Returns whether there is one.
    fn kick(&mut self) -> bool {
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
        let change = if self.rng.below(4) == 0 {
            Change::reverse(self.sequence.problem, self.sequence.visits(), low, (low + first + 1).min(length))
        } else {
            Change::exchange(self.sequence.visits(), low, middle, (middle + second).min(length))
        };
        self.make(change, f64::NEG_INFINITY);
        true
    }

    /// Exchanges any two stretches, and enters a stop by any of its nodes.
    fn kick_few(&mut self) {
        let length = self.sequence.len();
        let low = self.rng.below(length - 1);
        let middle = low + 1 + self.rng.below(length - 1 - low);
        let high = middle + 1 + self.rng.below(length - middle);
        self.make(Change::exchange(self.sequence.visits(), low, middle, high), f64::NEG_INFINITY);
        let k = self.rng.below(length);
        let Some(nodes) = self.sequence.item(k).map(|i| i.nodes.clone()) else { return };
        let Some(node) = nodes.clone().nth(self.rng.below(nodes.len().max(1))) else { return };
        let stop = Stop::at(self.sequence.problem, node);
        self.make(Change::entry(self.sequence.problem, k, stop), f64::NEG_INFINITY);
    }

    /// Makes a change if it gains more than `gain`, and puts what it touches on the queue.
    fn make(&mut self, change: Option<Change>, gain: f64) -> bool {
        let Some(mut change) = change.filter(|c| c.visits.len() <= self.longest) else { return false };
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

    /// Tries the changes near leg `k` until one gains.
    fn improve(&mut self, k: usize) -> bool {
        if self.enter_better(k) || k.checked_sub(1).is_some_and(|before| self.enter_better(before)) {
            return true;
        }
        // What is in the way is cut later.
        for blocker in self.sequence.blockers(k) {
            for later in k..=(k + NEAR).min(self.sequence.len()) {
                for stretch in 1..=2 {
                    let change = Change::exchange(self.sequence.visits(), blocker, blocker + stretch, later);
                    if self.make(change, EPSILON) {
                        return true;
                    }
                }
            }
        }
        // What it might begin on is cut earlier, or it comes later.
        for later in self.sequence.later_kerfs(k) {
            for stretch in 1..=3 {
                let visits = self.sequence.visits();
                let earlier = Change::exchange(visits, k, (later + 1).saturating_sub(stretch), later + 1);
                let put_off = Change::exchange(visits, (k + 1).saturating_sub(stretch), k + 1, later + 1);
                if self.make(earlier, EPSILON) || self.make(put_off, EPSILON) {
                    return true;
                }
            }
        }
        for other in self.others(k) {
            let (low, high) = (k.min(other), k.max(other));
            if self.make(Change::reverse(self.sequence.problem, self.sequence.visits(), low, high), EPSILON) {
                return true;
            }
            for stretch in 1..=3 {
                // The stops at the beginning of the window go to its end, or those at its end to its beginning.
                let to_end = Change::exchange(self.sequence.visits(), low, low + stretch, high);
                if self.make(to_end, EPSILON) {
                    return true;
                }
                let to_start =
                    Change::exchange(self.sequence.visits(), low, high.saturating_sub(stretch), high);
                if self.make(to_start, EPSILON) {
                    return true;
                }
            }
        }
        false
    }

    /// Positions near leg `k`, in the sequence and on the sheet.
    fn others(&self, k: usize) -> Vec<usize> {
        let length = self.sequence.len();
        let mut others: Vec<usize> = (k.saturating_sub(NEAR)..=(k + NEAR).min(length)).collect();
        for end in [k.checked_sub(1), Some(k)].into_iter().flatten() {
            let Some(visit) = self.sequence.visit(end) else { continue };
            for &item in self.neighbours.get(visit.item as usize).into_iter().flatten() {
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

    /// Tries other entries of the stop at `k`: its nodes, and along its contour those nearest to the stops around it and a
    /// little to either side.
    fn enter_better(&mut self, k: usize) -> bool {
        let (Some(item), Some(visit)) = (self.sequence.item(k), self.sequence.visit(k)) else { return false };
        let (problem, stop) = (self.sequence.problem, visit.stop);
        let mut stops: Vec<Stop> = item.nodes.clone().map(|node| Stop::at(problem, node)).collect();
        if let Some(track) = &item.track {
            let before =
                k.checked_sub(1).and_then(|b| self.sequence.visit(b)).map_or(problem.home, |v| v.exit);
            let after = self.sequence.visit(k + 1).map_or(problem.home, |v| v.entry);
            let length = track.length();
            let near = [before, after, (before + after) * 0.5].into_iter().filter_map(|p| track.nearest(p));
            let slides = SLIDES.iter().flat_map(|part| [length / part, -length / part]);
            let places = near.map(|n| n.0).chain(slides.map(|by| (stop.along + by).rem_euclid(length)));
            stops.extend(
                places
                    .filter(|along| (0.0..=length).contains(along))
                    .map(|along| Stop::whole(stop.node, along)),
            );
        }
        let mut better = false;
        for entry in stops.into_iter().filter(|s| *s != stop) {
            better |= self.make(Change::entry(problem, k, entry), EPSILON);
        }
        better
    }
}

/// By item: its `count` nearest items of those that are wanted, by the places of their first nodes.
fn neighbours(problem: &Problem, count: usize, wanted: impl Fn(u32, u32) -> bool) -> Vec<Vec<u32>> {
    let place = |item: &crate::problem::Item| problem.nodes.get(item.nodes.start as usize).map(|n| n.entry);
    let places: Vec<_> = problem.items.iter().map(|i| place(i).filter(|_| !i.nodes.is_empty())).collect();
    let bounds = places.iter().flatten().fold(Aabb::EMPTY, |b, &p| b.with(p));
    if bounds.is_empty() {
        return vec![Vec::new(); places.len()];
    }
    let mut grid = Buckets::new(bounds, places.len());
    for (id, place) in (0..).zip(&places) {
        if let Some(place) = place {
            grid.insert(id, *place);
        }
    }
    let nearest = |(id, place): (u32, &Option<_>)| {
        let Some(place) = *place else { return Vec::new() };
        let mut found: Vec<(f64, u32)> = Vec::new();
        for ring in 0..grid.rings(place) {
            let far = grid.distance_of_ring(ring);
            if found.len() >= count && found.get(count - 1).is_some_and(|f| f.0 <= far * far) {
                break;
            }
            let here = grid.ring(place, ring).filter(|&other| other != id && wanted(id, other));
            found.extend(here.filter_map(|other| {
                let other_place = places.get(other as usize).copied().flatten()?;
                Some((other_place.distance_squared(place), other))
            }));
            found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            found.truncate(count);
        }
        found.into_iter().map(|f| f.1).collect()
    };
    (0..).zip(&places).map(nearest).collect()
}
