//! Finds the smallest box around a given box, by the area of the contour in it.
//!
//! A k-d tree over boxes as points in four dimensions (left, bottom, right, top), split at the median of one dimension
//! after the other. A node stores the union of its boxes and the smallest and largest area below it. If the union does
//! not contain the queried box, no box below contains it. Nodes are visited in order of smallest area, so among
//! thousands of nested boxes the smallest is found first.

use crate::geometry::Aabb;
use crate::order::{real, sort_by};
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// Boxes in a leaf: so few that testing all of them costs less than another level.
const LEAF_SIZE: usize = 6;

/// A box, the area of the contour in it, and the contour's id.
type Item = (Aabb, f64, u32);

/// The caller's decision about a candidate.
pub(super) enum Answer {
    /// Accept it.
    Found,
    /// Reject it and continue.
    Next,
    /// Stop the search.
    Stop,
}

struct Node {
    from: usize,
    to: usize,
    union: Aabb,
    least: f64,
    greatest: f64,
    /// Index of the left child, followed by the right one. `None` in leaves.
    children: Option<usize>,
}

/// The tree; see the module's documentation.
pub(super) struct BoxTree {
    items: Vec<Item>,
    nodes: Vec<Node>,
}

/// A node or box to visit, ordered by area, then by index.
#[derive(PartialEq)]
struct Candidate {
    area: f64,
    /// A node before a box of the same area, then by index.
    what: Entry,
}

#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Entry {
    Node(usize),
    Item(u32),
}

impl Eq for Candidate {}
impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.area.total_cmp(&other.area).then_with(|| self.what.cmp(&other.what))
    }
}

impl BoxTree {
    /// A tree over the items.
    pub(super) fn new(mut items: Vec<Item>) -> Self {
        let mut nodes = vec![Node::of(&items, 0, items.len())];
        // The tree is built level by level; a node's children are appended after it.
        let mut next = 0;
        let mut level_end = nodes.len();
        let mut side = 0;
        while next < nodes.len() {
            if next == level_end {
                level_end = nodes.len();
                side = (side + 1) % 4;
            }
            let (from, to) = (nodes[next].from, nodes[next].to);
            if to - from > LEAF_SIZE {
                let middle = (from + to) / 2;
                let key = |i: &Item| [i.0.min.x, i.0.min.y, i.0.max.x, i.0.max.y][side];
                // A full sort instead of a selection, because it is already in the wasm file.
                let mut part = items[from..to].to_vec();
                sort_by(&mut part, |i| [real(key(i)), i.2.into(), 0]);
                items[from..to].copy_from_slice(&part);
                nodes[next].children = Some(nodes.len());
                nodes.push(Node::of(&items, from, middle));
                nodes.push(Node::of(&items, middle, to));
            }
            next += 1;
        }
        Self { items, nodes }
    }

    /// Calls the visitor with the boxes around `inner` whose area is larger than `area`, smallest area first, until it
    /// accepts one.
    pub(super) fn smallest_around(
        &self,
        inner: &Aabb,
        area: f64,
        mut answer: impl FnMut(u32) -> Answer,
    ) -> Option<u32> {
        let mut queue = BinaryHeap::new();
        let open = |node: usize, queue: &mut BinaryHeap<Reverse<Candidate>>| {
            let n = &self.nodes[node];
            if n.greatest > area && n.union.contains_box(inner) {
                queue.push(Reverse(Candidate { area: n.least.max(area), what: Entry::Node(node) }));
            }
        };
        open(0, &mut queue);
        while let Some(Reverse(next)) = queue.pop() {
            match next.what {
                Entry::Item(i) => match answer(i) {
                    Answer::Found => return Some(i),
                    Answer::Next => {}
                    Answer::Stop => return None,
                },
                Entry::Node(node) => match self.nodes[node].children {
                    Some(left) => {
                        open(left, &mut queue);
                        open(left + 1, &mut queue);
                    }
                    None => {
                        let leaf = &self.items[self.nodes[node].from..self.nodes[node].to];
                        let around = leaf.iter().filter(|i| i.1 > area && i.0.contains_box(inner));
                        queue
                            .extend(around.map(|i| Reverse(Candidate { area: i.1, what: Entry::Item(i.2) })));
                    }
                },
            }
        }
        None
    }
}

impl Node {
    fn of(items: &[Item], from: usize, to: usize) -> Self {
        let mut node =
            Self { from, to, union: Aabb::EMPTY, least: f64::INFINITY, greatest: 0.0, children: None };
        for (bounds, area, _) in &items[from..to] {
            node.union = node.union.union(*bounds);
            node.least = node.least.min(*area);
            node.greatest = node.greatest.max(*area);
        }
        node
    }
}
