//! The improvement framework, steps 1 to 9 of section 4. `pieces.rs` runs it in pieces of work.

mod pieces;

use super::connect::Connections;
use super::edmonds::{Arc, arborescence};
use super::forest::{Forest, ROOT};
use super::graph::Graph;
use super::parameters::{InitialPartitions, InitialTours, PartitionTree};
use super::pfr::Pfr;
use super::repair::repair;
use super::resolve::resolve;
use super::stage::{After, STEPS, Stage};
use super::visits::{keeps_precedence, solution};
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use crate::solve::greedy;
use crate::solve::papers::piecewise::Progress;
use rustc_hash::FxHashSet;

pub(super) struct Framework<'p> {
    g: Graph<'p>,
    parameters: PartitionTree,
    seed: u64,
    /// Whether only the construction heuristic runs.
    only_construction: bool,
    forest: Forest,
    stage: Stage,
    /// Partitions after their GTSP was solved, by parent node and entries, so that only changed ones are solved again. The
    /// set is only used for lookups, never iterated.
    solved: FxHashSet<Vec<NodeId>>,
    round: u32,
    idle: u32,
    /// The best result of a round, which ignores precedence, and its seconds.
    best: Option<(f64, Forest)>,
    /// Contours that the repair moved.
    moved: Vec<ItemId>,
    /// Seconds of the final path, before and after its entries were improved.
    repaired: Option<f64>,
    ended: Option<f64>,
    /// Moves that each of [`STEPS`] took.
    work: [u64; STEPS.len()],
    progress: Progress,
}

impl<'p> Framework<'p> {
    pub(super) fn new(problem: &'p Problem, parameters: PartitionTree, seed: u64) -> Self {
        let g = Graph::new(problem, parameters.neighbourhood);
        let forest = Forest::new(&g);
        let progress = Progress::new(greedy(problem), f64::INFINITY);
        Self {
            g,
            parameters,
            seed,
            only_construction: false,
            forest,
            stage: Stage::Near,
            solved: FxHashSet::default(),
            round: 0,
            idle: 0,
            best: None,
            moved: Vec::new(),
            repaired: None,
            ended: None,
            work: [0; STEPS.len()],
            progress,
        }
    }

    /// The construction heuristic PFr alone.
    pub(super) fn construction(problem: &'p Problem) -> Self {
        let mut frame = Self::new(problem, PartitionTree::default(), 0);
        frame.only_construction = true;
        frame.stage = Stage::Construct(Box::new(Pfr::new(&frame.g)));
        frame
    }

    /// Builds the initial partitions, or starts the construction.
    fn begin(&mut self) -> Stage {
        let path = greedy(self.g.problem);
        let nodes: Vec<NodeId> = path.stops.iter().map(|s| s.node).collect();
        let items: Vec<ItemId> = nodes.iter().map(|&n| self.g.item(n)).collect();
        match self.parameters.start {
            InitialPartitions::Pfr => Stage::Construct(Box::new(Pfr::new(&self.g))),
            InitialPartitions::Single => {
                self.forest.splice(ROOT, 0, items);
                self.forest.order(&self.g, ROOT, &nodes);
                self.gtsp(After::Round)
            }
            InitialPartitions::Each => {
                for (k, &node) in nodes.iter().enumerate() {
                    let own = vec![items[k]];
                    self.forest.enter(items[k], node);
                    // The first contour goes into the root, which may not be empty.
                    if k == 0 {
                        self.forest.splice(ROOT, 0, own);
                    } else {
                        self.forest.open(own);
                    }
                }
                self.connect()
            }
        }
    }

    /// Offers the current path as the best, if it is feasible.
    fn take(&mut self) {
        if keeps_precedence(&self.g, &self.forest) {
            let seconds = self.forest.seconds(&self.g);
            self.progress.take(seconds, || solution(&self.g, &self.forest));
        }
    }

    /// The stage that solves the GTSP of the partitions, the last first.
    fn gtsp(&mut self, then: After) -> Stage {
        let free = |f: &Forest, r: u32| {
            then == After::Round || self.parameters.first == InitialTours::All || self.is_free(f, r)
        };
        let routes: Vec<u32> = match (then, self.parameters.first) {
            (After::Initial, InitialTours::None) => Vec::new(),
            _ => self.forest.used().filter(|&r| free(&self.forest, r)).collect(),
        };
        Stage::Gtsp { routes, now: None, then }
    }

    /// Whether precedence is free in a partition: none of its contours, or of those attached to them, must come before
    /// another one of these.
    fn is_free(&self, forest: &Forest, route: u32) -> bool {
        if self.g.inwards.is_empty() {
            return true;
        }
        let all = 0..forest.items(route).len();
        let inside = |i: ItemId| forest.hangs_from(&self.g, i, route, &all);
        !(0..)
            .zip(&self.g.problem.items)
            .any(|(id, item)| item.before.is_some_and(|o| !item.nodes.is_empty() && inside(id) && inside(o)))
    }

    fn repartition(then: After) -> Stage {
        Stage::Repartition { next: 0, idle: 0, then }
    }

    fn connect(&self) -> Stage {
        let routes: Vec<u32> = self.forest.used().collect();
        Stage::Connect { routes, found: Box::default() }
    }

    /// Steps 2 and 3: chooses the connections and rebuilds the tree.
    fn resolve(&mut self, found: &Connections) -> u64 {
        let arcs: Vec<Arc> = found.all.iter().map(|c| c.arc).collect();
        // Unused routes have no vertex, since nothing needs to reach them.
        let used: Vec<usize> = self.forest.used().map(|r| r as usize).collect();
        let mut number = vec![usize::MAX; self.forest.routes.len()];
        used.iter().zip(0..).for_each(|(&r, n)| number[r] = n);
        let packed: Vec<Arc> =
            arcs.iter().map(|a| Arc { from: number[a.from], to: number[a.to], ..*a }).collect();
        if let Some(chosen) = arborescence(used.len(), number[ROOT as usize], &packed) {
            let chosen: Vec<_> = chosen.into_iter().map(|k| found.all[k]).collect();
            resolve(&self.g, &mut self.forest, &chosen);
        }
        (10 * arcs.len() + self.g.problem.items.len()) as u64
    }

    /// Ends a round.
    fn count(&mut self) -> Stage {
        self.round += 1;
        let seconds = self.forest.seconds(&self.g);
        if self.best.as_ref().is_none_or(|b| seconds < b.0 - EPSILON) {
            self.best = Some((seconds, self.forest.clone()));
            self.idle = 0;
        } else {
            self.idle += 1;
        }
        if self.idle >= self.parameters.stall.max(1) { Stage::Repair } else { self.connect() }
    }

    fn entries(&self, then: After) -> Stage {
        Stage::Entries { routes: self.forest.used().collect(), then }
    }

    /// The key of a partition in `solved`.
    fn key(&self, route: u32) -> Vec<NodeId> {
        let at = self.forest.at(route).unwrap_or(NodeId::MAX);
        // Where a group is left, the path determines where the head returns.
        let host = self.forest.at(route).map(|node| self.g.item(node)).filter(|&i| self.g.is_group(i));
        let path = host.map(|group| self.forest.entry(group));
        std::iter::once(at)
            .chain(path)
            .chain(self.forest.items(route).iter().map(|&i| self.forest.entry(i)))
            .collect()
    }

    /// The stage after a GTSP or repartitioning stage.
    fn after(&mut self, then: After, repartitioned: bool) -> Stage {
        match (then, repartitioned) {
            (After::Initial, false) => {
                // Only solving the GTSP of all partitions violates precedence here.
                let (moved, _) = repair(&self.g, &mut self.forest);
                if moved.is_empty() { Self::repartition(then) } else { self.entries(then) }
            }
            (_, false) => Self::repartition(then),
            (After::Initial, true) => {
                self.take();
                if self.parameters.stall == 0 { Stage::End } else { self.connect() }
            }
            (After::Round, true) => self.count(),
            (After::Final, true) => {
                self.ended = Some(self.forest.seconds(&self.g));
                self.take();
                Stage::End
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::papers::test_sheet::sheet;

    #[test]
    fn the_frame_stops_after_ten_rounds_without_gain() {
        let problem =
            sheet(&[&[[1.0, 0.0], [2.0, 0.0]], &[[9.0, 0.0], [9.0, 4.0]]], Some(0.5), "length-partial");
        let parameters = PartitionTree { start: InitialPartitions::Single, ..PartitionTree::default() };
        let mut frame = Framework::new(&problem, parameters, 1);
        frame.begin();
        // The first round is a gain, nine without one go on, and the tenth is the last.
        for round in 0..10 {
            assert!(!matches!(frame.count(), Stage::Repair), "{round}");
        }
        // A gain counts from the beginning again.
        if let Some((seconds, _)) = &mut frame.best {
            *seconds += 1.0;
        }
        for round in 0..10 {
            assert!(!matches!(frame.count(), Stage::Repair), "{round}");
        }
        assert!(matches!(frame.count(), Stage::Repair));
        assert_eq!((frame.round, frame.idle), (21, 10));
    }
}
