//! The path of a partition-tree: its visits in order, when each contour is finished, and whether precedence is kept.
//!
//! A contour is cut from its entry in its stored direction, a pierce group along its path. At each node with a partition the
//! head leaves it, cuts the partition, returns and resumes.

use super::forest::{Forest, ROOT};
use super::graph::Graph;
use crate::problem::{ItemId, NodeId};
use crate::solve::{Solution, Stop};

/// A part of a contour, or all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Visit {
    /// Its contour.
    pub(super) item: ItemId,
    /// The node where it begins.
    pub(super) from: NodeId,
    /// The node where it ends; the same as `from` if the visit goes once around.
    pub(super) to: NodeId,
    /// Whether it is the contour's last visit.
    pub(super) closes: bool,
}

enum StackFrame {
    /// A partition, from this position on.
    Route(u32, usize),
    /// A contour that was left for a partition: the node, and the number of its partitions that are done.
    Contour { item: ItemId, from: NodeId, done: usize },
}

/// Calls `visit` for every visit in order.
pub(super) fn for_each_visit(g: &Graph, forest: &Forest, mut visit: impl FnMut(Visit)) {
    let mut frames = vec![StackFrame::Route(ROOT, 0)];
    while let Some(frame) = frames.pop() {
        let (item, from, done) = match frame {
            StackFrame::Route(route, k) => {
                let Some(&item) = forest.items(route).get(k) else { continue };
                frames.push(StackFrame::Route(route, k + 1));
                (item, forest.entry(item), 0)
            }
            StackFrame::Contour { item, from, done } => (item, from, done),
        };
        let next = forest.next_hanging(g, item, done).and_then(|node| Some((node, forest.child(node)?)));
        match next {
            Some((to, route)) => {
                visit(Visit { item, from, to, closes: false });
                frames.push(StackFrame::Contour { item, from: to, done: done + 1 });
                frames.push(StackFrame::Route(route, 0));
            }
            None => visit(Visit { item, from, to: forest.entry(item), closes: true }),
        }
    }
}

/// For each contour, the number of contours finished before it.
pub(super) fn finished(g: &Graph, forest: &Forest) -> Vec<u32> {
    let mut at = vec![u32::MAX; g.problem.items.len()];
    let mut count = 0;
    for_each_visit(g, forest, |v| {
        if v.closes {
            at[v.item as usize] = count;
            count += 1;
        }
    });
    at
}

/// Whether every contour is finished before the one around it.
pub(super) fn keeps_precedence(g: &Graph, forest: &Forest) -> bool {
    if g.inwards.is_empty() {
        return true;
    }
    let at = finished(g, forest);
    (0..).zip(&g.problem.items).zip(&at).all(|((id, item), &own)| {
        let in_time = |o: ItemId| at.get(o as usize).is_none_or(|&o| own < o) && !forest.is_late(g, id);
        own == u32::MAX || item.before.is_none_or(in_time)
    })
}

/// The path as a solution.
pub(super) fn solution(g: &Graph, forest: &Forest) -> Solution {
    let mut stops = Vec::with_capacity(g.problem.items.len());
    for_each_visit(g, forest, |v| {
        let node = if g.is_group(v.item) { forest.entry(v.item) } else { v.from };
        let along = |at: NodeId| match g.leave_point(node, at) {
            Some(point) => point.along,
            None => g.problem.nodes[at as usize].along,
        };
        stops.push(Stop { node, along: along(v.from), until: along(v.to) });
    });
    Solution::new(g.problem, stops)
}

/// For each node, the number of contours finished when the head first passes it after the contour's entry, which is when a
/// partition attached to it would be cut. The second list is that of [`finished`].
pub(super) fn times(g: &Graph, forest: &Forest) -> (Vec<u32>, Vec<u32>) {
    let mut passed = vec![0; g.count()];
    let mut ends = vec![u32::MAX; g.problem.items.len()];
    let mut count = 0;
    for_each_visit(g, forest, |v| {
        if g.is_group(v.item) {
            let entry = forest.entry(v.item);
            let along = |n: NodeId| g.leave_point(entry, n).map(|p| p.along);
            let (from, to) = (along(v.from).unwrap_or(0.0), along(v.to).unwrap_or(f64::INFINITY));
            for n in g.parent_nodes(v.item).filter(|&n| along(n).is_some_and(|a| from < a && a <= to)) {
                passed[n as usize] = count;
            }
        } else {
            let nodes = g.nodes(v.item);
            let mut node = v.from;
            loop {
                node = if node + 1 == nodes.end { nodes.start } else { node + 1 };
                passed[node as usize] = count;
                if node == v.to {
                    break;
                }
            }
        }
        if v.closes {
            ends[v.item as usize] = count;
            count += 1;
        }
    });
    (passed, ends)
}
