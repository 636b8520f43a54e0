//! A search that knows which pieces may have tipped (`Problem::zones`), which cuts are still hot (`Problem::cooling`), and which kerfs a cut can
//! begin on (`Problem::starts`).
//!
//! What a move costs depends on what has been cut before it, which a method that prices moves by their ends cannot see. So two
//! searches take turns: the method itself, for which every move is straight with the head down, nothing is hot (that is never more
//! than the real cost), and cuts begin on no kerf but the last one, and a local search on the exact seconds of the whole sequence (`descent`), which
//! begins where the method's best is and changes order, entries and directions where a move is in the way of a tipped piece, a cut
//! has to wait, or the kerf it would begin on is cut later. Where cuts begin on kerfs, the method's order is also tried as one that grows from kerf
//! to kerf (`grown.rs`). Where cuts heat each other, it begins as well at a path that always goes to where it can go on soonest (`soonest`).
//! Small problems get the exact optimum over their nodes, where nothing is hot (`exact.rs`), or where hot cuts may begin in several ways (`exact_hot.rs`).
//!
//! The costs that callers see are the exact ones.

mod begin;
mod change;
mod clock;
mod descent;
mod entries;
mod exact;
mod exact_hot;
mod grown;
mod neighbours;
mod pace;
mod patches;
mod sequence;
mod soonest;
mod visit;

use super::epsilon::EPSILON;
use super::insight::Insight;
use super::rng::seeded;
use super::traits::{Search, Solution, Solver, Status, Step, Stop, Telemetry};
use crate::problem::Problem;
use begin::may_choose;
pub use begin::{Begun, begun};
use descent::{Descent, PATIENCE};
use grown::grown;
use pace::{LocalState, Pace};
use sequence::{Sequence, only_tips};
use soonest::soonest;
use std::cell::OnceCell;

/// Starts a method; on a machine that avoids tipped pieces or minds heat, with the local search beside it. Published methods run alone.
pub fn start<'p>(
    method: &dyn Solver,
    problem: &'p Problem,
    seed: u64,
    warm: Option<&Solution>,
) -> Box<dyn Search + 'p> {
    let inner = method.start(problem, seed, warm);
    if !problem.depends_on_the_past() {
        return inner;
    }
    let first = warm.unwrap_or_else(|| inner.best()).clone();
    let sequence = Sequence::new(problem, &first.stops);
    let alone = method.is_published();
    let other = problem.cooling().filter(|_| !alone).and_then(|cooling| soonest(problem, cooling));
    let mut best = Solution { cost: sequence.total(), stops: first.stops };
    let mut descent = Descent::new(sequence, seeded(seed.wrapping_add(2)));
    if let Some(other) = other.map(|stops| Sequence::new(problem, &stops)) {
        if other.total() < best.cost {
            best = Solution { cost: other.total(), stops: other.stops() };
        }
        descent.begin_at(other);
    }
    let pace = Pace::new(problem, inner.telemetry().best);
    Box::new(Tipped {
        problem,
        best,
        best_at: 0,
        not_taken: OnceCell::new(),
        descent,
        alone,
        inner,
        ended: false,
        seen: f64::INFINITY,
        turn: Turn::Method(1),
        pace,
        granted: 0,
        tried_exact: false,
    })
}

/// A solution with its exact seconds, where what has been cut before counts.
pub fn priced(problem: &Problem, solution: Solution) -> Solution {
    if !problem.depends_on_the_past() {
        return solution;
    }
    Solution { cost: Sequence::new(problem, &solution.stops).total(), stops: solution.stops }
}

/// Whose turn it is, and how many moves of it are left.
#[derive(Clone, Copy)]
enum Turn {
    Method(u64),
    Local(u64),
}

struct Tipped<'p> {
    problem: &'p Problem,
    inner: Box<dyn Search + 'p>,
    /// Whether the method has ended.
    ended: bool,
    /// Whether the method works alone.
    alone: bool,
    /// The cost, as the method sees it, of its best when the local search began there.
    seen: f64,
    descent: Descent<'p>,
    best: Solution,
    best_at: u64,
    /// What the method has found since the local search last went on from its best, if it is better than `best`; priced when
    /// a caller asks.
    not_taken: OnceCell<Option<Solution>>,
    turn: Turn,
    pace: Pace,
    /// Moves granted so far: what one slice does beyond its grant, the next does less.
    granted: u64,
    tried_exact: bool,
}

impl Tipped<'_> {
    /// Does a piece of work of at most `most` moves, or the smallest there is.
    fn advance(&mut self, most: u64) {
        match self.turn {
            Turn::Method(0) => {
                self.pace.saw(self.inner.telemetry().best);
                if self.ended || self.pace.may_take() {
                    self.take_from_method();
                }
                self.turn = if self.is_due() && !self.alone {
                    Turn::Local(self.pace.session())
                } else {
                    Turn::Method(self.pace.turn())
                };
            }
            Turn::Method(_) if self.ended => self.turn = Turn::Method(0),
            Turn::Method(left) => {
                let step = self.inner.step(left.min(most));
                self.ended = step.status == Status::Exhausted;
                self.pace.done += step.done;
                self.turn = Turn::Method(left.saturating_sub(step.done.max(1)));
            }
            Turn::Local(left) => {
                let priced = self.local();
                self.pace.did(priced);
                self.turn = if left <= priced || priced == 0 {
                    self.descent.save_so_far();
                    self.keep();
                    Turn::Method(self.pace.turn())
                } else {
                    Turn::Local(left - priced)
                };
            }
        }
    }

    /// Whether the local search works next.
    fn is_due(&self) -> bool {
        let is_small = !self.tried_exact && only_tips(self.problem) && exact::is_small(self.problem);
        let of = LocalState { settled: self.descent.is_settled(), since_gain: self.descent.since_gain() };
        self.ended || is_small || self.pace.is_due(&of)
    }

    /// A piece of local search. Returns the number of moves priced; 0 if there is nothing to do.
    fn local(&mut self) -> u64 {
        if !std::mem::replace(&mut self.tried_exact, true) {
            let (stops, priced) = self.exact();
            if let Some(stops) = stops {
                let sequence = Sequence::new(self.problem, &stops);
                self.descent.begin_at(sequence);
                self.keep();
            }
            if priced > 0 {
                return priced;
            }
        }
        let priced = self.descent.advance();
        self.keep();
        priced
    }

    /// The best stops of a small problem, if they are better than those known, with the number of moves priced.
    fn exact(&self) -> (Option<Vec<Stop>>, u64) {
        match self.problem.cooling() {
            Some(cooling) if may_choose(self.problem) => {
                exact_hot::optimum(self.problem, cooling, self.best.cost)
            }
            Some(_) => (None, 0),
            None => exact::optimum(self.problem).map_or((None, 0), |(stops, priced)| (Some(stops), priced)),
        }
    }

    /// Takes the local search's best over, if it is better.
    fn keep(&mut self) {
        if self.descent.best() < self.best.cost - EPSILON {
            self.best = Solution { stops: self.descent.stops(), cost: self.descent.best() };
            self.best_at = self.pace.done;
        }
    }

    /// Lets the local search begin at the method's best, if that is new.
    fn take_from_method(&mut self) {
        let cost = self.inner.telemetry().best;
        let is_new = cost < self.seen - EPSILON;
        self.pace.took(is_new);
        if !is_new {
            return;
        }
        self.seen = cost;
        let stops = self.inner.best_stops();
        let sequence = self.descent.patched(&stops);
        self.pace.did(sequence.priced);
        if sequence.total() < self.best.cost - EPSILON {
            self.best = Solution { stops: sequence.stops(), cost: sequence.total() };
            self.best_at = self.pace.done;
        }
        // The same in an order that begins on kerfs as far as it can; the better one is descended from.
        let other = grown(self.problem, &stops).map(|stops| Sequence::new(self.problem, &stops));
        let other = other.filter(|o| o.total() < sequence.total() && o.is_feasible());
        if let Some(other) = other.as_ref().filter(|o| o.total() < self.best.cost - EPSILON) {
            self.best = Solution { stops: other.stops(), cost: other.total() };
            self.best_at = self.pace.done;
        }
        if !self.alone {
            self.descent.also_try(other.unwrap_or(sequence), stops);
        }
    }

    /// The method's best with what the local search has changed before, if the local search has not gone on from it yet and it
    /// is better.
    fn not_taken(&self) -> Option<Solution> {
        if !only_tips(self.problem) || self.inner.telemetry().best >= self.seen - EPSILON {
            return None;
        }
        let sequence = self.descent.patched(&self.inner.best_stops());
        let is_better = sequence.total() < self.best.cost - EPSILON;
        is_better.then(|| Solution { stops: sequence.stops(), cost: sequence.total() })
    }
}

impl Search for Tipped<'_> {
    fn step(&mut self, work: u64) -> Step {
        self.not_taken = OnceCell::new();
        let (cost, before) = (self.best.cost, self.pace.done);
        let already = self.pace.done.saturating_sub(self.granted);
        self.granted = self.granted.saturating_add(work);
        let idle = |s: &Self| s.ended && (s.alone || s.descent.since_gain() > PATIENCE);
        let mut turns = 0;
        // Where both have nothing left to do, no move is priced.
        while self.pace.done < self.granted && !idle(self) && turns < 4 {
            let was = self.pace.done;
            self.advance(self.granted - self.pace.done);
            turns = if self.pace.done > was { 0 } else { turns + 1 };
        }
        let ended = self.ended && (idle(self) || turns >= 4) && self.pace.done <= self.granted;
        let improved = self.best.cost < cost;
        if ended {
            self.take_from_method();
            let done = (self.pace.done - before + already).min(work);
            return Step { status: Status::Exhausted, done, improved: self.best.cost < cost };
        }
        Step { status: Status::Running, done: work, improved }
    }

    fn best(&self) -> &Solution {
        self.not_taken.get_or_init(|| self.not_taken()).as_ref().unwrap_or(&self.best)
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.pace.done, best_at: self.best_at, best: self.best.cost }
    }

    fn insight(&self) -> Option<Insight> {
        self.inner.insight()
    }

    fn offer(&mut self, other: &Solution) {
        if !other.stops.iter().all(Stop::is_whole) {
            return;
        }
        self.not_taken = OnceCell::new();
        let sequence = Sequence::new(self.problem, &other.stops);
        if sequence.total() < self.best.cost - EPSILON {
            self.inner.offer(&Solution::new(self.problem, other.stops.clone()));
            self.best = Solution { stops: other.stops.clone(), cost: sequence.total() };
            self.best_at = self.pace.done;
            self.descent.begin_at(sequence);
        }
    }
}
