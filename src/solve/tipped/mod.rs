//! A search that knows which pieces may have tipped (`Problem::zones`), which cuts are still hot (`Problem::cooling`), and which kerfs a cut can
//! begin on (`Problem::starts`).
//!
//! What a move costs depends on what has been cut before it, which a method that prices moves by their ends cannot see. So two
//! searches take turns: the method itself, for which every move is straight with the head down, nothing is hot (that is never more
//! than the real cost), and cuts begin on no kerf but the last one, and a local search on the exact seconds of the whole sequence (`descent.rs`), which
//! begins where the method's best is and changes order, entries and directions where a move is in the way of a tipped piece, a cut
//! has to wait, or the kerf it would begin on is cut later. Where cuts begin on kerfs, the method's order is also tried as one that grows from kerf
//! to kerf (`grown.rs`). Where cuts heat each other, it begins as well at a path that always goes to where it can go on soonest (`soonest`).
//! Small problems get the exact optimum over their nodes, where nothing is hot (`exact.rs`).
//!
//! The costs that callers see are the exact ones.

mod begin;
mod change;
mod clock;
mod descent;
mod exact;
mod grown;
mod sequence;
mod soonest;
mod visit;

use super::epsilon::EPSILON;
use super::insight::Insight;
use super::rng::seeded;
use super::traits::{Search, Solution, Solver, Status, Step, Stop, Telemetry};
use crate::problem::Problem;
pub use begin::begun;
use descent::{Descent, PATIENCE};
use grown::grown;
use sequence::Sequence;
use soonest::soonest;

/// Least moves of a turn, and moves of a turn by item. After each turn of the method its best is priced exactly, which takes
/// about as long as two moves by item.
const TURN: u64 = 2_000;
const TURN_BY_ITEM: u64 = 4;
/// Moves by item before the local search begins, while the method gains in every turn: until then its first descent goes on, and
/// whatever the local search found would be left behind.
const HEAD_START: u64 = 200;
/// The local search makes one in four moves while the method gains in every turn, and one in two otherwise.
const SHARE: [u64; 2] = [4, 2];
/// The same where cuts begin on kerfs: the method finds chains better, and the local search needs few moves for what it leaves to pierce.
const STARTS_SHARE: u64 = 12;
/// Where heat counts, the method makes one in four moves and the local search the others: the method does not know the cost of heat.
const HEATED_SHARE: u64 = 4;

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
    Box::new(Tipped {
        problem,
        best,
        best_at: 0,
        descent,
        alone,
        inner,
        ended: false,
        seen: f64::INFINITY,
        turn_moves: TURN.max(TURN_BY_ITEM * problem.items.len() as u64),
        turn: Turn::Method(1),
        local_done: 0,
        granted: 0,
        done: 0,
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
    turn: Turn,
    turn_moves: u64,
    /// Moves of the local search.
    local_done: u64,
    /// Moves granted so far: what one slice does beyond its grant, the next does less.
    granted: u64,
    /// Moves done so far by both.
    done: u64,
    tried_exact: bool,
}

impl Tipped<'_> {
    /// Does a piece of work of at most `most` moves, or the smallest there is.
    fn advance(&mut self, most: u64) {
        match self.turn {
            Turn::Method(0) => {
                let gains = self.take_from_method();
                let early = gains && self.done < HEAD_START * self.problem.items.len() as u64;
                let share = match (self.problem.starts.is_empty(), gains) {
                    (false, _) => STARTS_SHARE,
                    (true, true) => SHARE[0],
                    (true, false) => SHARE[1],
                };
                let is_behind = match self.problem.cooling() {
                    Some(_) => (self.done - self.local_done) * HEATED_SHARE > self.done,
                    None => !early && self.local_done * share < self.done,
                };
                let due = self.ended || is_behind;
                self.turn = if due && !self.alone {
                    Turn::Local(self.turn_moves)
                } else {
                    Turn::Method(self.turn_moves)
                };
            }
            Turn::Method(_) if self.ended => self.turn = Turn::Method(0),
            Turn::Method(left) => {
                let step = self.inner.step(left.min(most));
                self.ended = step.status == Status::Exhausted;
                self.done += step.done;
                self.turn = Turn::Method(left.saturating_sub(step.done.max(1)));
            }
            Turn::Local(left) => {
                let priced = self.local();
                self.done += priced;
                self.local_done += priced;
                self.turn = if left <= priced || priced == 0 {
                    self.descent.save_so_far();
                    self.keep();
                    Turn::Method(self.turn_moves)
                } else {
                    Turn::Local(left - priced)
                };
            }
        }
    }

    /// A piece of local search. Returns the number of moves priced; 0 if there is nothing to do.
    fn local(&mut self) -> u64 {
        if !std::mem::replace(&mut self.tried_exact, true)
            && self.problem.cooling().is_none()
            && let Some((stops, priced)) = exact::optimum(self.problem)
        {
            let sequence = Sequence::new(self.problem, &stops);
            self.descent.begin_at(sequence);
            self.keep();
            return priced;
        }
        let priced = self.descent.advance();
        self.keep();
        priced
    }

    /// Takes the local search's best over, if it is better.
    fn keep(&mut self) {
        if self.descent.best() < self.best.cost - EPSILON {
            self.best = Solution { stops: self.descent.stops(), cost: self.descent.best() };
            self.best_at = self.done;
        }
    }

    /// Lets the local search begin at the method's best, if that is new. Returns whether it is.
    fn take_from_method(&mut self) -> bool {
        let found = self.inner.best();
        let cost = self.inner.telemetry().best;
        if cost >= self.seen - EPSILON {
            return false;
        }
        self.seen = cost;
        let sequence = Sequence::new(self.problem, &found.stops);
        if sequence.total() < self.best.cost - EPSILON {
            self.best = Solution { stops: found.stops.clone(), cost: sequence.total() };
            self.best_at = self.done;
        }
        // The same in an order that begins on kerfs as far as it can; the better one is descended from.
        let other = grown(self.problem, &found.stops).map(|stops| Sequence::new(self.problem, &stops));
        let other = other.filter(|o| o.total() < sequence.total() && o.is_feasible());
        if let Some(other) = other.as_ref().filter(|o| o.total() < self.best.cost - EPSILON) {
            self.best = Solution { stops: other.stops(), cost: other.total() };
            self.best_at = self.done;
        }
        if !self.alone {
            self.descent.also_try(other.unwrap_or(sequence));
        }
        true
    }
}

impl Search for Tipped<'_> {
    fn step(&mut self, work: u64) -> Step {
        let (cost, before) = (self.best.cost, self.done);
        let already = self.done.saturating_sub(self.granted);
        self.granted = self.granted.saturating_add(work);
        let idle = |s: &Self| s.ended && (s.alone || s.descent.since_gain() > PATIENCE);
        let mut turns = 0;
        // Where both have nothing left to do, no move is priced.
        while self.done < self.granted && !idle(self) && turns < 4 {
            let was = self.done;
            self.advance(self.granted - self.done);
            turns = if self.done > was { 0 } else { turns + 1 };
        }
        let ended = self.ended && (idle(self) || turns >= 4) && self.done <= self.granted;
        let improved = self.best.cost < cost;
        if ended {
            self.take_from_method();
            let done = (self.done - before + already).min(work);
            return Step { status: Status::Exhausted, done, improved: self.best.cost < cost };
        }
        Step { status: Status::Running, done: work, improved }
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.done, best_at: self.best_at, best: self.best.cost }
    }

    fn insight(&self) -> Option<Insight> {
        self.inner.insight()
    }

    fn offer(&mut self, other: &Solution) {
        if !other.stops.iter().all(Stop::is_whole) {
            return;
        }
        let sequence = Sequence::new(self.problem, &other.stops);
        if sequence.total() < self.best.cost - EPSILON {
            self.inner.offer(&Solution::new(self.problem, other.stops.clone()));
            self.best = Solution { stops: other.stops.clone(), cost: sequence.total() };
            self.best_at = self.done;
            self.descent.begin_at(sequence);
        }
    }
}
