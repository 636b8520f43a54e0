//! The path of a partition-tree: its visits in order, when each contour is finished, and whether precedence is kept.
//!
//! A contour is run from its entry in its stored direction; at each node where a partition hangs the head leaves it for
//! that one, comes back and resumes.

use super::forest::{Forest, ROOT};
use super::ground::Ground;
use crate::problem::{ItemId, NodeId};
use crate::solve::{Solution, Stop};

/// Part of a contour, or all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Visit {
    /// Its contour.
    pub(super) item: ItemId,
    /// From this node ...
    pub(super) from: NodeId,
    /// ... to this one; the same: once round.
    pub(super) to: NodeId,
    /// It is the contour's last.
    pub(super) closes: bool,
}

enum Frame {
    /// A partition, from a place on.
    Route(u32, usize),
    /// A contour left for a partition: where, and how many nodes it has gone by since its entry.
    Contour { item: ItemId, from: NodeId, gone: u32 },
}

/// Calls back for every visit in order.
pub(super) fn walk(g: &Ground, forest: &Forest, mut visit: impl FnMut(Visit)) {
    let mut frames = vec![Frame::Route(ROOT, 0)];
    while let Some(frame) = frames.pop() {
        let (item, from, gone) = match frame {
            Frame::Route(route, k) => {
                let Some(&item) = forest.items(route).get(k) else { continue };
                frames.push(Frame::Route(route, k + 1));
                (item, forest.entry(item), 1)
            }
            Frame::Contour { item, from, gone } => (item, from, gone),
        };
        let entry = forest.entry(item);
        let nodes = g.nodes(item);
        let count = if forest.kids(item) == 0 { 0 } else { nodes.end - nodes.start };
        let node = |gone: u32| nodes.start + (entry - nodes.start + gone) % count;
        let next = (gone..count).find_map(|k| forest.child(node(k)).map(|route| (k, node(k), route)));
        match next {
            Some((k, to, route)) => {
                visit(Visit { item, from, to, closes: false });
                frames.push(Frame::Contour { item, from: to, gone: k + 1 });
                frames.push(Frame::Route(route, 0));
            }
            None => visit(Visit { item, from, to: entry, closes: true }),
        }
    }
}

/// When each contour is finished: how many are before it.
pub(super) fn finished(g: &Ground, forest: &Forest) -> Vec<u32> {
    let mut at = vec![u32::MAX; g.problem.items.len()];
    let mut count = 0;
    walk(g, forest, |v| {
        if v.closes {
            at[v.item as usize] = count;
            count += 1;
        }
    });
    at
}

/// Whether everything is finished before what is around it.
pub(super) fn keeps_precedence(g: &Ground, forest: &Forest) -> bool {
    if g.inwards.is_empty() {
        return true;
    }
    let at = finished(g, forest);
    g.problem.items.iter().zip(&at).all(|(item, &own)| {
        item.before.is_none_or(|o| at.get(o as usize).is_none_or(|&o| own < o || own == u32::MAX))
    })
}

/// The path.
pub(super) fn solution(g: &Ground, forest: &Forest) -> Solution {
    let mut stops = Vec::with_capacity(g.problem.items.len());
    let along = |node: NodeId| g.problem.nodes[node as usize].along;
    walk(g, forest, |v| stops.push(Stop { node: v.from, along: along(v.from), until: along(v.to) }));
    Solution::new(g.problem, stops)
}

/// How many contours are finished when the head passes each node for the first time after the contour's entry: what is
/// hung there would be cut then. And the same for each contour's end, as [`finished`].
pub(super) fn times(g: &Ground, forest: &Forest) -> (Vec<u32>, Vec<u32>) {
    let mut passed = vec![0; g.problem.nodes.len()];
    let mut ends = vec![u32::MAX; g.problem.items.len()];
    let mut count = 0;
    walk(g, forest, |v| {
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
