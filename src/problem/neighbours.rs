//! Candidate lists: for each node, where one would go next if nothing else mattered.
//!
//! The k nearest other items by air time, each by its node that is nearest. Lists are made when first asked for, so
//! a search over 10,000 contours (120,000 nodes) starts at once and never prices what it does not look at.

use super::buckets::Buckets;
use super::model::{NodeId, Problem};
use crate::geometry::Aabb;
use crate::machine::AirTime;

/// Items to a list. 5 is enough for lists by quadrant and 10 the usual for plain ones (Johnson & McGeoch, "The
/// travelling salesman problem: a case study", 1997); here each of the 8 stands for all nodes of its item.
const NEIGHBOURS: usize = 8;

/// Lists of the nearest nodes of other items, made on demand.
#[derive(Debug)]
pub struct Neighbours<'p> {
    problem: &'p Problem,
    air: AirTime,
    grid: Buckets,
    lists: Vec<Option<Box<[NodeId]>>>,
}

impl<'p> Neighbours<'p> {
    /// No list made yet; every node in the grid.
    pub fn new(problem: &'p Problem) -> Self {
        let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
        let mut grid = Buckets::new(bounds, problem.nodes.len());
        for (id, node) in (0..).zip(&problem.nodes) {
            grid.insert(id, node.entry);
        }
        Self { problem, air: AirTime::new(&problem.machine), grid, lists: vec![None; problem.nodes.len()] }
    }

    /// Whether the list of a node is made already: asking for one that is not is dear.
    pub fn knows(&self, node: NodeId) -> bool {
        self.lists[node as usize].is_some()
    }

    /// The nodes that are nearest to the exit of `node`, one of each other item, nearest first.
    pub fn after(&mut self, node: NodeId) -> &[NodeId] {
        let (problem, air, grid) = (self.problem, &self.air, &self.grid);
        self.lists[node as usize].get_or_insert_with(|| nearest(problem, air, grid, node))
    }
}

fn nearest(problem: &Problem, air: &AirTime, grid: &Buckets, node: NodeId) -> Box<[NodeId]> {
    let from = problem.nodes[node as usize].exit;
    let own = problem.nodes[node as usize].item;
    let mut best: Vec<(f64, NodeId)> = Vec::with_capacity(NEIGHBOURS + 1);
    for r in 0..grid.rings(from) {
        if let Some(&(worst, _)) = best.get(NEIGHBOURS - 1)
            && air.seconds_at_least(grid.distance_of_ring(r)) > worst
        {
            break;
        }
        for candidate in grid.ring(from, r) {
            let there = &problem.nodes[candidate as usize];
            if there.item != own {
                keep(problem, &mut best, (air.seconds(from, there.entry), candidate));
            }
        }
    }
    best.into_iter().map(|(_, node)| node).collect()
}

/// Puts a candidate in its place; one node an item, at most [`NEIGHBOURS`].
fn keep(problem: &Problem, best: &mut Vec<(f64, NodeId)>, candidate: (f64, NodeId)) {
    if best.len() == NEIGHBOURS && best[NEIGHBOURS - 1] <= candidate {
        return;
    }
    let item = |node: NodeId| problem.nodes[node as usize].item;
    if let Some(same) = best.iter().position(|b| item(b.1) == item(candidate.1)) {
        if best[same] <= candidate {
            return;
        }
        best.remove(same);
    }
    let place = best.partition_point(|b| *b < candidate);
    best.insert(place, candidate);
    best.truncate(NEIGHBOURS);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::DVec2 as P;
    use crate::machine::presets;
    use crate::problem::{Item, Node};

    /// `items` items of `each` nodes at scattered places.
    fn scattered(items: u32, each: u32, machine: usize) -> Problem {
        let mut nodes = Vec::new();
        for item in 0..items {
            for k in 0..each {
                let (a, b) = (item * 7919 % 1009 + 5 * k, item * 104_729 % 997 + 3 * k * k);
                let (entry, twin) = (P::new(f64::from(a), f64::from(b)), item * each + k);
                nodes.push(Node { item, entry, exit: entry, along: 0.0, reversed: false, twin });
            }
        }
        let machine = presets().swap_remove(machine);
        let items = (0..items)
            .map(|i| Item { nodes: i * each..(i + 1) * each, before: None, rank: 0, fixed: 0.0, track: None })
            .collect();
        Problem { items, nodes, home: P::ZERO, closed: true, machine }
    }

    #[test]
    fn lists_are_those_of_a_full_search() {
        for machine in 0..presets().len() {
            for (items, each) in [(60, 5), (3, 4), (1, 3), (200, 1)] {
                let problem = scattered(items, each, machine);
                let air = AirTime::new(&problem.machine);
                let mut lists = Neighbours::new(&problem);
                for node in (0..items * each).step_by(7) {
                    let from = &problem.nodes[node as usize];
                    let mut all: Vec<(f64, NodeId)> = (0..items)
                        .filter(|&i| i != from.item)
                        .filter_map(|i| {
                            (i * each..(i + 1) * each)
                                .map(|n| (air.seconds(from.exit, problem.nodes[n as usize].entry), n))
                                .min_by(|a, b| a.partial_cmp(b).unwrap())
                        })
                        .collect();
                    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
                    let expected: Vec<NodeId> = all.iter().take(NEIGHBOURS).map(|a| a.1).collect();
                    assert!(!lists.knows(node));
                    assert_eq!(lists.after(node), expected);
                    assert!(lists.knows(node));
                }
            }
        }
    }
}
