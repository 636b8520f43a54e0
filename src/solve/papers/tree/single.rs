//! One partition of all contours, each cut whole: a GTSP tour that ignores precedence and is then repaired.
//!
//! By default inner contours are moved to just before the contour around them, because CAM programs cut holes first; the
//! parameter `repair` moves outer ones back instead, as in the paper. Then the entries are chosen again. The repair forwards
//! also keeps ranks, groups, pairs and tables of costs, which the paper does not have. On problems with these, all three
//! methods run this search, `pfr` with the nearest-neighbour path.

use super::forest::{Forest, ROOT};
use super::graph::{Graph, Neighbourhood};
use super::parameters::TourRepair;
use super::repair::repair as move_outer_back;
use super::{entries, visits};
use crate::problem::{Item, NodeId, Problem};
use crate::solve::insight::charts;
use crate::solve::papers::piecewise::{Piecewise, Progress, solution};
use crate::solve::papers::repair::Repair;
use crate::solve::tour_tree::TourTree;
use crate::solve::{Curve, Insight};
use crate::solve::{Search, Solution, Solver, greedy};

type Searching<'p> = Box<dyn Search + 'p>;

// The search borrows the problem, so both are stored together.
self_cell::self_cell!(
    struct Relaxed {
        owner: Problem,
        #[covariant]
        dependent: Searching,
    }
);

/// Number of moves in one piece: about a millisecond.
const SLICE: u64 = 1_000;

pub(super) struct Single<'p> {
    problem: &'p Problem,
    relaxed: Relaxed,
    repair: TourRepair,
    left: u64,
    repaired: bool,
    progress: Progress,
}

impl<'p> Single<'p> {
    /// Starts the search with `each` moves for each contour.
    pub(super) fn new(problem: &'p Problem, seed: u64, each: u64, repair: TourRepair) -> Self {
        let free = |item: &Item| Item { before: None, rank: 0, track: None, ..item.in_one_go() };
        let relaxed = Problem {
            items: problem.items.iter().map(free).collect(),
            nodes: problem.nodes.clone(),
            home: problem.home,
            closed: problem.closed,
            table: problem.table.clone(),
            ..Problem::empty(problem.machine.clone())
        };
        let relaxed = Relaxed::new(relaxed, |p| TourTree.start(p, seed, None));
        let progress = Progress::new(greedy(problem), f64::INFINITY);
        let left = each * problem.items.len() as u64;
        Self { problem, relaxed, repair, left, repaired: each == 0, progress }
    }

    /// Repairs the tour that was found.
    fn repair(&mut self) {
        let found: &Solution = self.relaxed.borrow_dependent().best();
        let nodes: Vec<NodeId> = found.stops.iter().map(|s| s.node).collect();
        let back = self.repair == TourRepair::OuterBack && Graph::is_one_tree(self.problem);
        let nodes = if back { nodes } else { Repair::new(self.problem).tour(self.problem, &nodes) };
        let repaired = if self.problem.table().is_some() {
            solution(self.problem, &nodes)
        } else {
            let g = Graph::new(self.problem, Neighbourhood::Near);
            let mut forest = Forest::new(&g);
            forest.splice(ROOT, 0, nodes.iter().map(|&n| g.item(n)).collect());
            forest.order(&g, ROOT, &nodes);
            if back {
                move_outer_back(&g, &mut forest);
            }
            entries::improve(&g, &mut forest, ROOT, false, None);
            visits::solution(&g, &forest)
        };
        self.progress.take(repaired.cost, || repaired);
    }
}

impl Piecewise for Single<'_> {
    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress {
        &mut self.progress
    }

    fn piece(&mut self) -> Option<u64> {
        if self.left > 0 {
            let work = SLICE.min(self.left);
            self.left -= work;
            self.relaxed.with_dependent_mut(|_, search| search.step(work));
            return Some(work);
        }
        (!std::mem::replace(&mut self.repaired, true)).then(|| {
            self.repair();
            self.problem.items.len() as u64
        })
    }

    fn insight(&self) -> Insight {
        let relaxed = self.relaxed.borrow_dependent().best().cost;
        let value = |name, value| Curve { name, value, chart: charts::SECONDS };
        let best = self.progress.solution().cost;
        let curves = vec![value("tour with precedence left out, s", relaxed), value("path, s", best)];
        Insight { curves, ..Insight::default() }
    }
}
