//! `tour-tree`, the default method: order, entry and direction searched together, good at any moment.
//!
//! 1. At once: nearest next (`greedy`), the first feasible path.
//! 2. Neighbour lists by gate (`neighbours.rs`), then local search over the whole tour (`improve.rs`).
//! 3. Cycles of annealed kicks, each longer than the one before (`anneal`): first free of the nesting, then
//!    repaired (`repair.rs`) and within it.
//!    What they end in is crossed (`crossing.rs`); few items take rather more at a kick (`few.rs`).
//! 4. Entries slide to the exact minimum at the end of every cycle (`polish.rs`).
//! 5. Where contours may be left unfinished, the search over the root takes turns with one over all routes (`children`),
//!    whose cycles start from the better of both.
//!
//! Sources: neighbour lists and queue instead of don't-look bits: Bentley, ORSA J. Computing 4 (1992); Or-opt: Or,
//! PhD thesis, Northwestern (1976); gain criterion: Lin & Kernighan, Operations Research 21 (1973); segment
//! double-bridge kicks: Martin, Otto & Felten, Complex Systems 5 (1991), local as in Applegate, Cook & Rohe, INFORMS
//! J. Computing 15 (2003); precedence by exchange of neighbouring stretches: Gambardella & Dorigo, INFORMS J.
//! Computing 12 (2000).

mod allowed;
mod anneal;
mod best;
mod boxes;
mod chain;
mod children;
mod crossing;
mod entries;
mod exchange;
mod few;
mod gap;
mod gates;
mod improve;
mod index;
mod kept;
mod neighbours;
mod polish;
mod queue;
mod rebuild;
mod reenter;
mod repair;
mod ring;
mod ring_in;
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
use best::Best;
use children::Children;
use space::Space;
use tour::Tour;

/// The method.
pub(super) struct TourTree;

impl Solver for TourTree {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "tour-tree",
            title: "Kerfway",
            about: "Order, entry and direction searched together: local search with annealed kicks, better every \
                    moment.",
            source: None,
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let first = warm.cloned().unwrap_or_else(|| greedy(problem));
        let space = Space::new(problem);
        let leaving = children::may_leave(&space);
        // One more seed for the routes: the root's cycles are the same with and without them.
        let children = leaving.then(|| Children::new(&space, &first, seeded(seed.wrapping_add(1))));
        let kept = if leaving { children::flattened(&space, &first) } else { space.kept(&first) };
        let annealing = Annealing::new(Tour::new(space, kept), seeded(seed));
        Box::new(TourTreeSearch {
            annealing,
            children,
            hanging: false,
            granted: 0,
            best: Best::new(first, 0),
        })
    }
}

struct TourTreeSearch<'p> {
    annealing: Annealing<'p>,
    /// The search over all routes, where contours may be left unfinished; `hanging`: it works next.
    children: Option<Children>,
    hanging: bool,
    /// Work handed out so far: what one slice did too much, the next does less.
    granted: u64,
    best: Best,
}

impl TourTreeSearch<'_> {
    /// Takes a solution over, if it is better.
    fn take(&mut self, found: Solution) {
        self.best.take(found, self.priced());
    }

    fn priced(&self) -> u64 {
        self.annealing.priced() + self.children.as_ref().map_or(0, Children::priced)
    }

    /// The smallest piece of work there is.
    fn advance(&mut self) {
        let root = &mut self.annealing;
        let ended = match &mut self.children {
            Some(children) if self.hanging => {
                children.advance(root).then(|| children.polished(&root.tour().space))
            }
            _ => root.advance().then(|| polish::polished(root.tour(), root.best().1)),
        };
        self.hanging = self.children.as_ref().is_some_and(|c| c.is_next(root, self.hanging));
        if let Some(found) = ended {
            self.take(found);
        }
    }

    /// Takes over what is better since the last slice.
    fn collect(&mut self) {
        self.annealing.save();
        let (priced, (seconds, kept)) = (self.priced(), self.annealing.best());
        self.best.take_tour(seconds, kept, priced);
        if let Some(children) = &mut self.children {
            children.save(&self.annealing.tour().space);
            if children.best().cost < self.best.cost() {
                let found = children.best().clone();
                self.take(found);
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
        // A search that ends counts all it did, and no more, in slices of any size: what it did too much is paid for first.
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

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.priced(), best_at: self.best.at, best: self.best.cost() }
    }

    fn offer(&mut self, other: &Solution) {
        if other.cost < self.best.cost() {
            if let Some(children) = &mut self.children {
                children.offer(other);
            }
            if other.stops.iter().all(Stop::is_whole) {
                let kept = self.annealing.tour().space.kept(other);
                self.annealing.offer(other.cost, kept);
            }
            self.take(other.clone());
        }
    }
}
