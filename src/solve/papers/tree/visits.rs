//! The path of a partition-tree: its visits in order, when each contour is finished, and whether precedence is kept.
//!
//! A contour is cut from its entry in its stored direction. At each node with a partition the head leaves the contour, cuts
//! the partition, returns and resumes.

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
    /// A contour that was left for a partition: the node, and the number of nodes passed since its entry.
    Contour { item: ItemId, from: NodeId, gone: u32 },
}

/// Calls `visit` for every visit in order.
pub(super) fn for_each_visit(g: &Graph, forest: &Forest, mut visit: impl FnMut(Visit)) {
    let mut frames = vec![StackFrame::Route(ROOT, 0)];
    while let Some(frame) = frames.pop() {
        let (item, from, gone) = match frame {
            StackFrame::Route(route, k) => {
                let Some(&item) = forest.items(route).get(k) else { continue };
                frames.push(StackFrame::Route(route, k + 1));
                (item, forest.entry(item), 1)
            }
            StackFrame::Contour { item, from, gone } => (item, from, gone),
        };
        let entry = forest.entry(item);
        let nodes = g.nodes(item);
        let count = if forest.children(item) == 0 { 0 } else { nodes.end - nodes.start };
        let node = |gone: u32| nodes.start + (entry - nodes.start + gone) % count;
        let next = (gone..count).find_map(|k| forest.child(node(k)).map(|route| (k, node(k), route)));
        match next {
            Some((k, to, route)) => {
                visit(Visit { item, from, to, closes: false });
                frames.push(StackFrame::Contour { item, from: to, gone: k + 1 });
                frames.push(StackFrame::Route(route, 0));
            }
            None => visit(Visit { item, from, to: entry, closes: true }),
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
    g.problem.items.iter().zip(&at).all(|(item, &own)| {
        item.before.is_none_or(|o| at.get(o as usize).is_none_or(|&o| own < o || own == u32::MAX))
    })
}

/// The path as a solution.
pub(super) fn solution(g: &Graph, forest: &Forest) -> Solution {
    let mut stops = Vec::with_capacity(g.problem.items.len());
    let along = |node: NodeId| g.problem.nodes[node as usize].along;
    for_each_visit(g, forest, |v| {
        stops.push(Stop { node: v.from, along: along(v.from), until: along(v.to) })
    });
    Solution::new(g.problem, stops)
}

/// For each node, the number of contours finished when the head first passes it after the contour's entry, which is when a
/// partition attached to it would be cut. The second list is that of [`finished`].
pub(super) fn times(g: &Graph, forest: &Forest) -> (Vec<u32>, Vec<u32>) {
    let mut passed = vec![0; g.problem.nodes.len()];
    let mut ends = vec![u32::MAX; g.problem.items.len()];
    let mut count = 0;
    for_each_visit(g, forest, |v| {
        let nodes = g.nodes(v.item);
        let mut node = v.from;
        loop {
            node = if node + 1 == nodes.end { nodes.start } else { node + 1 };
            passed[node as usize] = count;
            if node == v.to {
                break;
            }
        }
        if v.closes {
            ends[v.item as usize] = count;
            count += 1;
        }
    });
    (passed, ends)
}
