//! The nearest-neighbour construction: from where the head is, always to the nearest entry that may come next.
//!
//! May come next: contours of the lowest rank left whose inner contours are done. Only their nodes are in the
//! grid, so every query looks at candidates only; together about n log n.

use super::traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};
use crate::geometry::{Aabb, DVec2};
use crate::machine::AirTime;
use crate::order::sort_by;
use crate::problem::{Buckets, ItemId, NodeId, Problem};

/// Always to the nearest entry that may come next; ties go to the lower node. Feasible.
pub fn greedy(problem: &Problem) -> Solution {
    let air = AirTime::new(&problem.machine);
    let mut open = Candidates::new(problem);
    let mut stops = Vec::with_capacity(problem.items.len());
    let mut head = problem.home;
    while let Some(node) = open.nearest(&air, head) {
        stops.push(Stop::at(problem, node));
        head = problem.nodes[node as usize].exit;
        open.done(problem.nodes[node as usize].item);
    }
    Solution::new(problem, stops)
}

/// The contours that may come next.
struct Candidates<'p> {
    problem: &'p Problem,
    grid: Buckets,
    /// Inner contours left, by item.
    inner_left: Vec<u32>,
    /// Items by rank, the ranks still to come; the last is next.
    ranks: Vec<Vec<ItemId>>,
    /// Rank in work, and how many of its items are left.
    rank: u32,
    left: usize,
}

impl<'p> Candidates<'p> {
    fn new(problem: &'p Problem) -> Self {
        let mut inner_left = vec![0; problem.items.len()];
        for item in &problem.items {
            if let Some(outer) = item.before {
                inner_left[outer as usize] += 1;
            }
        }
        // An item without nodes cannot be visited and stands for nothing.
        let mut by_rank: Vec<ItemId> =
            (0..).zip(&problem.items).filter(|(_, i)| !i.nodes.is_empty()).map(|(id, _)| id).collect();
        sort_by(&mut by_rank, |&i| [problem.items[i as usize].rank.into(), 0, 0]);
        let ranks = by_rank
            .chunk_by(|&a, &b| problem.items[a as usize].rank == problem.items[b as usize].rank)
            .rev()
            .map(<[ItemId]>::to_vec)
            .collect();
        let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
        let grid = Buckets::new(bounds, problem.nodes.len());
        let mut open = Self { problem, grid, inner_left, ranks, rank: 0, left: 0 };
        open.next_rank();
        open
    }

    /// Opens the next rank: those of its items that wait for nothing.
    fn next_rank(&mut self) {
        let Some(items) = self.ranks.pop() else { return };
        self.left = items.len();
        for item in items {
            self.rank = self.problem.items[item as usize].rank;
            if self.inner_left[item as usize] == 0 {
                self.open(item);
            }
        }
    }

    fn open(&mut self, item: ItemId) {
        for node in self.problem.items[item as usize].nodes.clone() {
            self.grid.insert(node, self.problem.nodes[node as usize].entry);
        }
    }

    /// Takes an item out, and lets in what waited for it.
    fn done(&mut self, item: ItemId) {
        for node in self.problem.items[item as usize].nodes.clone() {
            self.grid.remove(node, self.problem.nodes[node as usize].entry);
        }
        if let Some(outer) = self.problem.items[item as usize].before {
            self.inner_left[outer as usize] -= 1;
            if self.inner_left[outer as usize] == 0 && self.problem.items[outer as usize].rank == self.rank {
                self.open(outer);
            }
        }
        self.left -= 1;
        if self.left == 0 {
            self.next_rank();
        }
    }

    fn nearest(&self, air: &AirTime, head: DVec2) -> Option<NodeId> {
        let mut best: Option<(f64, NodeId)> = None;
        for r in 0..self.grid.rings(head) {
            let least = air.seconds_at_least(self.grid.distance_of_ring(r));
            if best.is_some_and(|(seconds, _)| least > seconds) {
                break;
            }
            for node in self.grid.ring(head, r) {
                let seconds = air.seconds(head, self.problem.nodes[node as usize].entry);
                if best.is_none_or(|b| (seconds, node) < b) {
                    best = Some((seconds, node));
                }
            }
        }
        best.map(|b| b.1)
    }
}

/// [`greedy`] as a method: done as soon as it is started.
pub(super) struct Greedy;

impl Solver for Greedy {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "greedy",
            title: "Nearest next",
            about: "Goes always to the nearest place where a cut may start next.",
            source: None,
        }
    }

    fn start<'p>(&self, problem: &'p Problem, _seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let built = greedy(problem);
        let best = warm.filter(|w| w.cost <= built.cost).cloned().unwrap_or(built);
        Box::new(Done { best })
    }
}

struct Done {
    best: Solution,
}

impl Search for Done {
    fn step(&mut self, _work: u64) -> Step {
        Step { status: Status::Exhausted, done: 0, improved: false }
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: 0, best_at: 0, best: self.best.cost }
    }

    fn offer(&mut self, other: &Solution) {
        if other.cost < self.best.cost {
            self.best = other.clone();
        }
    }
}
