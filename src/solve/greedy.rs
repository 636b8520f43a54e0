//! Nearest neighbour: from where the head is, always to the nearest entry of an item that may come next.
//!
//! An item may come next if it has the lowest rank that is left and everything it waits for is done. The grid holds only the
//! nodes of such items, so that all queries together take about n log n steps. With a table of costs there is no grid, and
//! all nodes are looked through, beginning at the first node of the start.

use super::precedence::Precedence;
use super::traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};
use crate::geometry::{Aabb, Buckets};
use crate::machine::AirTime;
use crate::order::sort_by;
use crate::problem::{ItemId, NodeId, Problem};

/// The feasible tour that always goes to the nearest entry that may come next; of equally near nodes the first wins.
pub fn greedy(problem: &Problem) -> Solution {
    let air = AirTime::new(&problem.machine);
    let mut open = Candidates::new(problem);
    let mut stops = Vec::with_capacity(problem.items.len());
    let mut last = problem.start().map(|item| problem.items[item as usize].nodes.start);
    stops.extend(last.map(|node| Stop::at(problem, node)));
    while let Some(node) = open.nearest(&air, last) {
        stops.push(Stop::at(problem, node));
        last = Some(node);
        open.done(problem.nodes[node as usize].item);
    }
    Solution::new(problem, stops)
}

/// The items that may come next.
pub(super) struct Candidates<'p> {
    problem: &'p Problem,
    grid: Buckets,
    /// Whether an item may come next.
    open: Vec<bool>,
    precedence: Precedence,
    /// By item: how many items it still waits for.
    waits_for: Vec<usize>,
    /// The items of each rank that is still to come; the last rank is next.
    ranks: Vec<Vec<ItemId>>,
    /// The current rank, and how many of its items are left in all and in each group.
    rank: u32,
    left: usize,
    left_in: Vec<usize>,
    /// The smallest group that has begun and is not done: no item outside may come in between.
    within: Option<u32>,
}

impl<'p> Candidates<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let precedence = Precedence::new(problem);
        let waits_for = (0..).zip(&problem.items).map(|(id, _)| precedence.before(id).len()).collect();
        // An item without nodes is not visited.
        let start = problem.start();
        let visited = (0..).zip(&problem.items).filter(|(id, i)| !i.nodes.is_empty() && Some(*id) != start);
        let mut by_rank: Vec<ItemId> = visited.map(|(id, _)| id).collect();
        sort_by(&mut by_rank, |&i| [problem.items[i as usize].rank.into(), 0, 0]);
        let ranks = by_rank
            .chunk_by(|&a, &b| problem.items[a as usize].rank == problem.items[b as usize].rank)
            .rev()
            .map(<[ItemId]>::to_vec)
            .collect();
        let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
        let grid = Buckets::new(bounds, problem.nodes.len());
        let open = vec![false; problem.items.len()];
        let mut all = Self {
            problem,
            grid,
            open,
            precedence,
            waits_for,
            ranks,
            rank: 0,
            left: 0,
            left_in: Vec::new(),
            within: None,
        };
        all.next_rank();
        all
    }

    /// Goes on to the next rank and opens its items that wait for nothing.
    fn next_rank(&mut self) {
        let Some(items) = self.ranks.pop() else { return };
        self.left = items.len();
        self.within = None;
        self.left_in = vec![0; self.problem.groups.count()];
        for item in items {
            self.problem.groups.of(item).for_each(|g| self.left_in[g as usize] += 1);
            self.rank = self.problem.items[item as usize].rank;
            if self.waits_for[item as usize] == 0 {
                self.open(item);
            }
        }
    }

    /// The nodes of an item that are in the grid.
    fn placed(&self, item: ItemId) -> std::ops::Range<NodeId> {
        if self.problem.table().is_some() { 0..0 } else { self.problem.items[item as usize].nodes.clone() }
    }

    fn open(&mut self, item: ItemId) {
        self.open[item as usize] = true;
        for node in self.placed(item) {
            self.grid.insert(node, self.problem.nodes[node as usize].entry);
        }
    }

    /// Removes a visited item and opens the items that waited for it alone.
    pub(super) fn done(&mut self, item: ItemId) {
        for node in self.placed(item) {
            self.grid.remove(node, self.problem.nodes[node as usize].entry);
        }
        self.open[item as usize] = false;
        for k in 0..self.precedence.after(item).len() {
            let waiting = self.precedence.after(item)[k];
            self.waits_for[waiting as usize] -= 1;
            if self.waits_for[waiting as usize] == 0 && self.problem.items[waiting as usize].rank == self.rank
            {
                self.open(waiting);
            }
        }
        self.left -= 1;
        self.problem.groups.of(item).for_each(|g| self.left_in[g as usize] -= 1);
        self.within = self.problem.groups.of(item).find(|&g| self.left_in[g as usize] > 0);
        if self.left == 0 {
            self.next_rank();
        }
    }

    /// Whether a node is in the group that must be finished first.
    fn stays(&self, node: NodeId) -> bool {
        let item = self.problem.nodes[node as usize].item;
        self.within.is_none_or(|group| self.problem.groups.of(item).any(|g| g == group))
    }

    /// The nearest candidate after a node, or after home.
    fn nearest(&self, air: &AirTime, last: Option<NodeId>) -> Option<NodeId> {
        let mut best: Option<(f64, NodeId)> = None;
        if let Some(table) = self.problem.table() {
            for (node, _) in (0..).zip(&self.problem.nodes).filter(|(_, to)| self.open[to.item as usize]) {
                let cost = last.map_or(0.0, |from| table.cost(from, node));
                if best.is_none_or(|b| cost < b.0) {
                    best = Some((cost, node));
                }
            }
            return best.map(|b| b.1);
        }
        self.soonest(air, last, |_, _| 0.0)
    }

    /// The candidate that can be gone on with soonest after a node, or after home. `due`: the seconds that a candidate has to wait
    /// beyond those of the move to it, s.
    pub(super) fn soonest(
        &self,
        air: &AirTime,
        last: Option<NodeId>,
        mut due: impl FnMut(ItemId, f64) -> f64,
    ) -> Option<NodeId> {
        let mut best: Option<(f64, NodeId)> = None;
        let head = last.map_or(self.problem.home, |node| self.problem.nodes[node as usize].exit);
        for r in 0..self.grid.rings(head) {
            let least = air.seconds_at_least(self.grid.distance_of_ring(r));
            if best.is_some_and(|(seconds, _)| least > seconds) {
                break;
            }
            for node in self.grid.ring(head, r).filter(|&n| self.stays(n)) {
                let to = self.problem.nodes[node as usize];
                let mut seconds = air.seconds(head, to.entry);
                if best.is_none_or(|b| (seconds, node) < b) {
                    seconds += due(to.item, seconds);
                }
                if best.is_none_or(|b| (seconds, node) < b) {
                    best = Some((seconds, node));
                }
            }
        }
        best.map(|b| b.1)
    }
}

/// [`greedy`] as a method, which is exhausted from the start.
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
