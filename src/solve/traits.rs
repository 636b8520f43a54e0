//! The two traits of every method, and what they exchange with callers.
//!
//! The core neither reads a clock nor decides when to stop: the caller grants work in moves and looks at the result. A
//! search in slices of any size gives the same bytes as one long run.

use super::Insight;
use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{NodeId, Problem};
use serde::Serialize;

/// A method, for lists and citations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "MethodInfo"))]
pub struct SolverInfo {
    /// Name on the command line.
    pub name: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub about: &'static str,
    /// The paper it comes from, if any.
    pub source: Option<&'static str>,
}

/// One visit of a route: an item that is cut from one place to another. A partial visit runs in the stored direction.
///
/// A contour that is left unfinished has several visits in order. Each begins where the previous one ended, and the last
/// ends where the first began, so that together they are one loop. The stops between two visits of a contour are its child
/// route: visits nest like brackets.
///
/// A pierce group is left and resumed in the same way: places are those on the path that its node stands for, and 0 is both
/// its beginning and its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// The node where its item is entered, or from which the entry has slid away.
    pub node: NodeId,
    /// Arc length of the entry along the item's track, mm; without a track, that of the node.
    pub along: f64,
    /// Arc length where this visit ends, mm. If it equals `along`, the visit is all of the item.
    pub until: f64,
}

impl Stop {
    /// The stop at a node itself.
    pub fn at(problem: &Problem, node: NodeId) -> Self {
        Self::whole(node, problem.nodes.get(node as usize).map_or(0.0, |n| n.along))
    }

    /// All of an item in one visit.
    pub fn whole(node: NodeId, along: f64) -> Self {
        Self { node, along, until: along }
    }

    /// Whether this visit is all of its item.
    #[expect(clippy::float_cmp, reason = "the places of a stop are one number, bit for bit, or two")]
    pub fn is_whole(&self) -> bool {
        self.along == self.until
    }

    /// Where the head enters and leaves; `None` if there is no such node.
    pub fn ends(&self, problem: &Problem) -> Option<(DVec2, DVec2)> {
        let node = problem.nodes.get(self.node as usize)?;
        let item = problem.items.get(node.item as usize)?;
        if let Some(path) = item.path(self.node) {
            return path.arrival(self.along).zip(path.departure(self.until));
        }
        #[expect(clippy::float_cmp, reason = "a stop that did not slide has its node's place bit for bit")]
        let slid = |along: f64| item.track.as_ref().filter(|_| along != node.along).and_then(|t| t.at(along));
        if self.is_whole() {
            return Some(slid(self.along).map_or((node.entry, node.exit), |p| (p, p)));
        }
        #[expect(clippy::float_cmp, reason = "as above")]
        let place = |along: f64| {
            let at_node = || {
                item.nodes.clone().find_map(|n| problem.nodes.get(n as usize).filter(|n| n.along == along))
            };
            slid(along).or_else(|| at_node().map(|n| n.entry))
        };
        Some((place(self.along)?, place(self.until)?))
    }
}

/// An order of all items with their entries, and what it costs.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Solution {
    /// In order of visit.
    pub stops: Vec<Stop>,
    /// Seconds that depend on order and entries, which the search minimises: travel, contours left unfinished, and what
    /// the extra seconds of entries.
    pub cost: f64,
}

/// Whether a search can go on after a slice of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// More work may help.
    Running,
    /// Nothing more can be gained by this method.
    Exhausted,
}

/// Result of [`Search::step`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Whether more work may help.
    pub status: Status,
    /// Moves done in this slice, never more than were granted.
    pub done: u64,
    /// The best solution changed in this slice.
    pub improved: bool,
}

/// Numbers about a search, for charts and comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize)]
pub struct Telemetry {
    /// Moves so far.
    pub moves: u64,
    /// Moves when the best was found.
    pub best_at: u64,
    /// Cost of the best, s.
    pub best: f64,
}

/// A method.
pub trait Solver: Sync {
    /// Name, citation.
    fn info(&self) -> SolverInfo;
    /// Whether this is the method of a paper, run as published: it builds its first path itself. A path given to it at its
    /// start is only its best until it finds an improvement of its own.
    fn is_published(&self) -> bool {
        false
    }
    /// Starts a search; `warm` is a feasible solution to start from.
    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p>;
}

impl Solver for &'static dyn Solver {
    fn info(&self) -> SolverInfo {
        (**self).info()
    }

    fn is_published(&self) -> bool {
        (**self).is_published()
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        (**self).start(problem, seed, warm)
    }
}

/// A running search. It has a feasible best solution from its start on.
pub trait Search {
    /// Works for at most `work` moves (priced candidate moves, whether taken or not).
    fn step(&mut self, work: u64) -> Step;
    /// The best solution so far.
    fn best(&self) -> &Solution;
    /// The stops of the best solution, which some searches know sooner than its cost.
    fn best_stops(&self) -> Vec<Stop> {
        self.best().stops.clone()
    }
    /// The numbers about this search.
    fn telemetry(&self) -> Telemetry;
    /// The current inner state of a published method; other methods have none.
    fn insight(&self) -> Option<Insight> {
        None
    }
    /// Offers a solution from elsewhere, which is taken over if it costs less than the best.
    fn offer(&mut self, _other: &Solution) {}
}

impl Solution {
    /// A solution with its cost: the legs from home, from each exit to the next entry, by a link where there is one, and, if
    /// closed, back home; the extra seconds of entries; and the charge each time an item is resumed. With a table of costs it is the cost of the cycle
    /// of the stops' nodes, which include the start.
    pub fn new(problem: &Problem, stops: Vec<Stop>) -> Self {
        if let Some(table) = problem.table() {
            let nodes: Vec<NodeId> = stops.iter().map(|s| s.node).collect();
            return Self { cost: table.around(&nodes), stops };
        }
        let air = AirTime::new(&problem.machine);
        let mut cost = 0.0;
        let mut head = problem.home;
        let mut last: Option<NodeId> = None;
        let mut begun = vec![false; problem.items.len()];
        for stop in &stops {
            let Some((entry, exit)) = stop.ends(problem) else { continue };
            let before = head;
            head = exit;
            let id = problem.nodes[stop.node as usize].item as usize;
            let item = &problem.items[id];
            let link = last.replace(stop.node).and_then(|last| problem.links.between(last, stop.node));
            cost += link.map_or_else(|| air.seconds(before, entry), |l| l.seconds);
            cost += item.extra(stop.node, stop.along);
            if std::mem::replace(&mut begun[id], true) {
                cost += item.resume();
            }
        }
        if problem.closed {
            cost += air.seconds(head, problem.home);
        }
        Self { stops, cost }
    }
}
