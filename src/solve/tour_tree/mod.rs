//! `tour-tree`, the default method: order, entry and direction are searched together.
//!
//! 1. Nearest neighbour (`greedy`) gives the first feasible path at once.
//! 2. Neighbour lists by gate (`neighbours.rs`), then local search over the whole tour (`improve.rs`).
//!    Where items are in rows, tours along the rows are tried as well (`rows.rs`).
//! 3. Cycles of annealed kicks, each longer than the one before (`anneal`): first with nesting ignored, then repaired
//!    (`repair.rs`) and with nesting kept. The results of cycles are recombined (`recombine.rs`). Small problems get
//!    other kicks (`small_instances.rs`).
//! 4. At the end of every cycle entries slide to the exact minimum (`polish.rs`).
//! 5. Where contours may be left unfinished, the search over the root route takes turns with one over all routes
//!    (`children`), whose cycles start from the better of both.
//!
//! The tuning constants are in `config.rs`. `docs/internals/search.md` describes a cycle with pictures.
//!
//! Sources: neighbour lists and a work queue instead of don't-look bits: Bentley, ORSA J. Computing 4 (1992); Or-opt: Or,
//! PhD thesis, Northwestern (1976); gain criterion: Lin & Kernighan, Operations Research 21 (1973); segment double-bridge
//! kicks: Martin, Otto & Felten, Complex Systems 5 (1991), local as in Applegate, Cook & Rohe, INFORMS J. Computing 15
//! (2003); precedence by exchange of neighbouring stretches: Gambardella & Dorigo, INFORMS J. Computing 12 (2000).

mod allowed;
mod anneal;
mod best;
mod boxes;
mod chain;
mod children;
mod config;
mod entries;
mod exchange;
mod gap;
mod gates;
mod improve;
mod improve_entry;
mod index;
mod leave_places;
mod long_legs;
mod neighbours;
mod polish;
mod queue;
mod recombine;
mod repair;
mod ring;
mod ring_in_gap;
mod rows;
mod ruin_recreate;
mod slide;
mod slide_together;
mod small_instances;
mod snapshot;
mod space;
#[cfg(test)]
mod tests;
mod tour;
mod travel;

use super::greedy::greedy;
use super::traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};
use crate::problem::Problem;
use crate::solve::rng::seeded;
use anneal::Annealing;
use best::{Best, Origin};
use children::ChildRoutes;
use space::Space;
use tour::Tour;

/// The default method.
pub(super) struct TourTree;

impl Solver for TourTree {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "tour-tree",
            title: "Kerfway",
            about: "Order, entry and direction searched together; the path improves at every moment.",
            source: None,
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let first = warm.cloned().unwrap_or_else(|| greedy(problem));
        let space = Space::new(problem);
        let leaving = children::may_leave(&space);
        // The routes have a seed of their own, so that the cycles of the root are the same with and without them.
        let children = leaving.then(|| ChildRoutes::new(&space, &first, seeded(seed.wrapping_add(1))));
        let snapshot = if leaving { children::flattened(&space, &first) } else { space.snapshot(&first) };
        let annealing = Annealing::new(Tour::new(space, snapshot), seeded(seed));
        Box::new(TourTreeSearch {
            annealing,
            children,
            children_next: false,
            granted: 0,
            best: Best::new(first, Origin::Caller, 0),
        })
    }
}

struct TourTreeSearch<'p> {
    annealing: Annealing<'p>,
    /// The search over all routes, where contours may be left unfinished.
    children: Option<ChildRoutes>,
    /// The search over all routes works next.
    children_next: bool,
    /// Work granted so far, in moves: what one slice does beyond its grant, the next does less.
    granted: u64,
    best: Best,
}

impl TourTreeSearch<'_> {
    /// Takes over a solution if it costs less than the best, or is preferred at the same cost.
    fn take(&mut self, found: Solution, origin: Origin) {
        self.best.take(found, origin, self.priced());
    }

    fn priced(&self) -> u64 {
        self.annealing.priced() + self.children.as_ref().map_or(0, ChildRoutes::priced)
    }

    /// Does the smallest piece of work there is.
    fn advance(&mut self) {
        let root = &mut self.annealing;
        let ended = match &mut self.children {
            Some(children) if self.children_next => {
                children.advance(root).then(|| children.polished(&root.tour().space))
            }
            _ => root.advance().then(|| polish::polished(root.tour(), root.best().1)),
        };
        self.children_next = self.children.as_ref().is_some_and(|c| c.is_next(root, self.children_next));
        if let Some(found) = ended {
            self.take(found, Origin::Polished);
        }
    }

    /// Takes over what has improved since the last slice.
    fn collect(&mut self) {
        self.annealing.save();
        let priced = self.priced();
        // On tens of thousands of contours the first local search takes a second: its progress is shown meanwhile.
        for (seconds, tour) in [Some(self.annealing.best()), self.annealing.settling()].into_iter().flatten()
        {
            self.best.take_tour(seconds, tour, priced);
        }
        if let Some(children) = &mut self.children {
            children.save(&self.annealing.tour().space);
            if self.best.yields_to(children.best().cost, Origin::Children) {
                let found = children.best().clone();
                self.take(found, Origin::Children);
            }
        }
    }
}

impl Search for TourTreeSearch<'_> {
    fn step(&mut self, work: u64) -> Step {
        let cost = self.best.cost();
        let before = self.granted;
        self.granted = before.saturating_add(work);
        while !self.annealing.is_finished() && self.priced() < self.granted {
            self.advance();
        }
        self.collect();
        // A search that ends counts all the work it did and no more, in slices of any size: work beyond the last grant is
        // paid for before the search ends.
        let ended = self.annealing.is_finished() && self.priced() <= self.granted;
        let (status, done) = if ended {
            (Status::Exhausted, self.priced().saturating_sub(before))
        } else {
            (Status::Running, work)
        };
        Step { status, done, improved: self.best.cost() < cost }
    }

    fn best(&self) -> &Solution {
        self.best.solution(self.annealing.tour())
    }

    fn best_stops(&self) -> Vec<Stop> {
        self.best.stops(self.annealing.tour())
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.priced(), best_at: self.best.at, best: self.best.cost() }
    }

    fn offer(&mut self, other: &Solution) {
        if other.cost < self.best.cost() {
            if let Some(children) = &mut self.children {
                children.offer(other);
            }
            if other.stops.iter().all(Stop::is_whole) {
                let snapshot = self.annealing.tour().space.snapshot(other);
                self.annealing.offer(other.cost, snapshot);
            }
            self.take(other.clone(), Origin::Caller);
        }
    }
}
