//! Local search: 2-opt, Or-opt and other entries over candidate lists, then small random kicks without end.
//!
//! Stages, all in steps that the caller hands out:
//! 1. At once (`start.rs`): contours along a space-filling curve, repaired for the nesting: the first feasible plan.
//! 2. Free: descent that ignores the nesting (ranks are kept), then kicks for a while. Now and then a repaired copy
//!    (`repair.rs`) is looked at, so that the best gets better on the way. A search held feasible from the start is
//!    caught in the shape of its start (7 to 9 % on nested sheets).
//! 3. Bound: the repaired tour, descent and kicks within the nesting. If the descent ends above the best known (a
//!    good warm start), that one is taken up instead.
//!
//! A kick exchanges two short neighbouring pieces of the tour (a double bridge within one place: Martin, Otto &
//! Felten, "Large-step Markov chains for the traveling salesman problem", 1991; local as in Applegate, Cook & Rohe,
//! "Chained Lin-Kernighan for large traveling salesman problems", INFORMS JoC 15, 2003), only the touched stops are
//! looked at again, and the result is kept when it is not worse. The don't-look bits are a queue of items.

mod moves;
mod repair;
mod start;
mod tour;

use super::traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};
use crate::problem::{ItemId, Neighbours, NodeId, Problem};
use moves::NOISE;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::collections::VecDeque;
use tour::{Change, Tour};

/// Stops in each of the two pieces that a kick exchanges, at most: long enough to leave the neighbourhood of
/// Or-opt, short enough that the descent afterwards stays in one place.
const PIECE: u32 = 50;
/// Kicks for each stop before the nesting is heeded. On nested sheets of 500, 2,000 and 10,000 contours 3 end 0.3, 0.3
/// and 3 % ahead of 1 after as much work; more gain nothing.
const FREE_KICKS: u64 = 3;
/// One kick in so many changes entries only.
const ENTER_EVERY: u32 = 4;
/// Moves for each stop between two looks at a repaired copy, and what a look costs: a few hundredths of the work.
const LOOK_EVERY: u64 = 100;
const LOOK: u64 = 5;
/// Stops moved in an array that cost as much as pricing one move: keeps steps of long tours short.
const MOVED_PER_MOVE: u64 = 64;

/// The method.
pub(super) struct TwoOpt;

impl Solver for TwoOpt {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "two-opt",
            title: "Local search",
            about: "Exchanges, moves and turns short stretches of the path as long as that saves time, then goes \
                    on with small random changes.",
            source: Some("Johnson & McGeoch, The traveling salesman problem: a case study (1997)"),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        Box::new(LocalSearch::new(problem, seed, warm))
    }
}

/// What the search is at.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    /// Nesting ignored; kicks left.
    Free(u64),
    /// Nesting kept, first descent.
    Descent,
    /// Nesting kept, kicks.
    Kicks,
}

struct LocalSearch<'p> {
    problem: &'p Problem,
    tour: Tour<'p>,
    lists: Neighbours<'p>,
    rng: Xoshiro256PlusPlus,
    stage: Stage,
    /// Items to look at, and whether each is in the queue.
    queue: VecDeque<ItemId>,
    queued: Vec<bool>,
    /// Seconds of the tour when it was last kept, and gained since then, a kick included.
    cost: f64,
    gained: f64,
    /// What the cost has to beat. Not that of `best`, which is summed up afresh at the end of a step: no decision may
    /// hang on where steps end.
    known: f64,
    /// Whether there is a kick to be judged.
    kicked: bool,
    touched: Vec<ItemId>,
    /// Work handed out, and done.
    granted: u64,
    priced: u64,
    /// Work at which the next repaired copy is looked at.
    next_look: u64,
    best: Solution,
    best_at: u64,
    /// The cost of the best is to be summed up again.
    stale: bool,
}

impl<'p> LocalSearch<'p> {
    fn new(problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Self {
        let order = match warm {
            Some(warm) => nodes(warm),
            None => start::along_curve(problem),
        };
        let mut tour = Tour::new(problem, &order);
        let feasible =
            start::entered_nearest(problem, &repair::repaired(problem, &tour.pricer, &order, None));
        let built =
            Solution::new(problem, feasible.into_iter().map(|node| Stop::at(problem, node)).collect());
        let best = warm.filter(|w| w.cost <= built.cost).cloned().unwrap_or(built);
        let nested = problem.items.iter().any(|i| i.before.is_some());
        tour.nested = !nested;
        let mut search = Self {
            problem,
            tour,
            lists: Neighbours::new(problem),
            rng: Xoshiro256PlusPlus::seed_from_u64(seed),
            stage: if nested { Stage::Free(FREE_KICKS * order.len() as u64) } else { Stage::Descent },
            queue: VecDeque::with_capacity(order.len()),
            queued: vec![false; problem.items.len()],
            cost: 0.0,
            gained: 0.0,
            known: f64::INFINITY,
            kicked: false,
            touched: Vec::new(),
            granted: 0,
            priced: 0,
            next_look: LOOK_EVERY * order.len() as u64,
            best,
            best_at: 0,
            stale: false,
        };
        search.look_at_all();
        search
    }

    fn work(&self) -> u64 {
        self.priced + self.tour.handled / MOVED_PER_MOVE
    }

    /// One small piece of work: one item looked at, or one decision between two descents.
    fn advance(&mut self) {
        let Some(item) = self.queue.pop_front() else {
            return self.descended();
        };
        self.queued[item as usize] = false;
        if let Some(gain) = moves::best_move(&mut self.tour, &mut self.lists, item, &mut self.priced) {
            self.gained += gain.seconds;
            gain.apply(&mut self.tour, &mut self.touched);
            self.touched.push(item);
            self.look_at_touched();
            if !self.kicked {
                self.tour.keep();
            }
        }
        if matches!(self.stage, Stage::Free(_)) && self.work() >= self.next_look {
            self.look_at_repaired();
        }
    }

    /// Nothing gains any more around any stop: judge the last kick, change the stage, kick.
    fn descended(&mut self) {
        if self.kicked && self.gained < -NOISE {
            self.tour.undo();
        } else {
            self.tour.keep();
            self.cost -= self.gained;
            if self.stage == Stage::Kicks && self.cost < self.known - NOISE {
                self.take_as_best();
            }
        }
        self.kicked = false;
        self.gained = 0.0;
        match self.stage {
            Stage::Free(0) => self.bind(),
            Stage::Free(left) => {
                self.stage = Stage::Free(left - 1);
                self.kick();
            }
            Stage::Descent => {
                self.stage = Stage::Kicks;
                self.cost = self.tour.solution().cost;
                if self.cost < self.best.cost {
                    self.take_as_best();
                } else if self.cost > self.best.cost {
                    self.take_up_best();
                }
                self.known = self.best.cost;
            }
            Stage::Kicks => self.kick(),
        }
    }

    /// From the free stage to the bound one.
    fn bind(&mut self) {
        let order = self.look_at_repaired();
        self.tour.reset(&order);
        self.tour.nested = true;
        self.stage = Stage::Descent;
        self.look_at_all();
    }

    /// Goes on from the best known.
    fn take_up_best(&mut self) {
        self.tour.reset(&nodes(&self.best));
        self.tour.nested = true;
        self.cost = self.tour.solution().cost;
        self.kicked = false;
        self.gained = 0.0;
        self.look_at_all();
    }

    /// A repaired copy of the free tour becomes the best when it is better.
    fn look_at_repaired(&mut self) -> Vec<NodeId> {
        let nodes = self.tour.nodes();
        let order = repair::repaired(self.problem, &self.tour.pricer, nodes, Some(&mut self.lists));
        self.priced += LOOK * order.len() as u64;
        self.next_look = self.work() + LOOK_EVERY * order.len() as u64;
        let found =
            Solution::new(self.problem, order.iter().map(|&node| Stop::at(self.problem, node)).collect());
        if found.cost < self.best.cost {
            self.best = found;
            self.best_at = self.work();
        }
        order
    }

    fn take_as_best(&mut self) {
        self.best.stops.clear();
        self.best.stops.extend(self.tour.nodes().iter().map(|&node| Stop::at(self.problem, node)));
        self.best.cost = self.cost;
        self.known = self.cost;
        self.best_at = self.work();
        self.stale = true;
    }

    /// Exchanges two neighbouring pieces somewhere, where that is allowed; now and then enters a few stops anew.
    fn kick(&mut self) {
        self.priced += 1;
        let stops = u32::try_from(self.tour.len()).unwrap_or(u32::MAX);
        if stops < 2 || self.rng.random_range(0..ENTER_EVERY) == 0 {
            return self.kick_entries(stops);
        }
        let lo = self.rng.random_range(1..stops);
        let mid = lo + self.rng.random_range(1..=PIECE.min(stops - lo));
        let hi = mid + self.rng.random_range(0..PIECE.min(stops + 1 - mid));
        let (lo, mid, hi) = (lo as usize, mid as usize, hi as usize);
        if !self.tour.may_swap(lo, mid, hi) {
            return;
        }
        let legs = |tour: &Tour, mid: usize| tour.leg(lo - 1) + tour.leg(mid - 1) + tour.leg(hi);
        let before = legs(&self.tour, mid);
        self.tour.apply(Change::Swap(lo, mid, hi));
        let mid = hi + 1 - (mid - lo);
        self.after_kick(before - legs(&self.tour, mid), &[lo - 1, lo, mid - 1, mid, hi, hi + 1]);
    }

    /// Up to three stops in a row are entered at any of their nodes: out of what single new entries cannot leave.
    fn kick_entries(&mut self, stops: u32) {
        let Some(first) = (stops > 0).then(|| self.rng.random_range(1..=stops) as usize) else { return };
        let last = (first + 2).min(self.tour.len());
        let legs = |tour: &Tour| (first - 1..=last).map(|p| tour.leg(p)).sum::<f64>();
        let before = legs(&self.tour);
        for p in first..=last {
            if let Some(item) = self.tour.item_at(p) {
                let node = self.rng.random_range(self.problem.items[item as usize].nodes.clone());
                self.tour.apply(Change::Enter(p, node));
            }
        }
        self.after_kick(before - legs(&self.tour), &[first - 1, first, first + 1, last, last + 1]);
    }

    fn after_kick(&mut self, gained: f64, positions: &[usize]) {
        self.gained = gained;
        self.kicked = true;
        self.touched.extend(positions.iter().filter_map(|&p| self.tour.item_at(p)));
        self.look_at_touched();
    }

    fn look_at_touched(&mut self) {
        for item in self.touched.drain(..) {
            if !std::mem::replace(&mut self.queued[item as usize], true) {
                self.queue.push_back(item);
            }
        }
    }

    fn look_at_all(&mut self) {
        self.touched.clear();
        self.touched.extend((1..=self.tour.len()).filter_map(|p| self.tour.item_at(p)));
        self.look_at_touched();
    }
}

fn nodes(solution: &Solution) -> Vec<NodeId> {
    solution.stops.iter().map(|s| s.node).collect()
}

impl Search for LocalSearch<'_> {
    fn step(&mut self, work: u64) -> Step {
        let before = self.best_at;
        // A piece of work may run over; what it ran over is taken from the next step.
        self.granted = self.granted.saturating_add(work);
        let mut status = Status::Running;
        while status == Status::Running && self.work() < self.granted {
            self.advance();
            if self.tour.len() < 2 && self.queue.is_empty() && self.stage == Stage::Kicks {
                status = Status::Exhausted;
            }
        }
        if self.stage == Stage::Descent {
            self.cost = self.tour.solution().cost;
            if self.cost < self.best.cost {
                self.take_as_best();
            }
        }
        if std::mem::take(&mut self.stale) {
            self.best = Solution::new(self.problem, std::mem::take(&mut self.best.stops));
        }
        Step { status, done: work, improved: self.best_at != before }
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.granted, best_at: self.best_at, best: self.best.cost }
    }

    fn offer(&mut self, other: &Solution) {
        if other.cost < self.best.cost {
            self.best = other.clone();
            self.best_at = self.work();
            self.stage = Stage::Kicks;
            self.known = other.cost;
            self.take_up_best();
        }
    }
}
