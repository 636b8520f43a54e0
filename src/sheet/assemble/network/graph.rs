//! The planar graph of a network: edges between nodes, and the faces they enclose.
//!
//! Every edge is traversed in both directions, with the face on its left. At a node the traversal goes on with the edge
//! that turns least to the left, which is the next one clockwise. An edge that is passed in both directions on one
//! round leads nowhere (a dead end, or a bridge between two rings) and is left out. A round that comes back to a node
//! on its way is divided there, so that two squares that touch in a corner are two rounds. Rounds that run
//! counter-clockwise are the outlines of faces.

use super::contacts::{Net, Place};
use super::joined::Joined;
use crate::geometry::{DVec2, Path, Segment, interior_point};
use crate::order::sort_by;
use crate::sheet::element::Element;
use crate::sheet::half_edges::link;

/// Where the directions of the edges at a node are compared: at this fraction of the shortest of them. There no edge has gone around a corner that another one still has ahead.
const AHEAD: f64 = 0.25;

/// A stretch of a chain between two nodes.
pub(super) struct Edge {
    pub(super) chain: u32,
    /// Its connected set.
    pub(super) set: u32,
    pub(super) nodes: [u32; 2],
    /// Its elements, from the first node to the second.
    pub(super) elements: Vec<Element>,
    pub(super) length: f64,
}

/// An edge in one direction: `2 e` as drawn, `2 e + 1` back.
pub(super) type HalfEdge = usize;

/// A face, by the edges around it, counter-clockwise.
pub(super) struct Face {
    pub(super) around: Vec<HalfEdge>,
    /// mm2.
    pub(super) area: f64,
}

/// The edges of all sets in which something is to be found, chain after chain.
pub(super) struct Graph {
    pub(super) edges: Vec<Edge>,
    /// For each chain, the first of its edges; chains without edges have none.
    first: Vec<usize>,
}

impl Graph {
    pub(super) fn new(joined: &Joined, net: &Net) -> Self {
        let chains = &joined.chains.chains;
        let mut edges = Vec::new();
        let mut first = Vec::with_capacity(chains.len() + 1);
        let mut from = 0;
        for (chain, c) in (0_u32..).zip(chains) {
            first.push(edges.len());
            let to = from + net.breaks[from..].iter().take_while(|b| b.chain == chain).count();
            let breaks = &net.breaks[from..to];
            from = to;
            let set = net.set[chain as usize];
            if !net.active[set as usize] {
                continue;
            }
            let elements = joined.chains.of(c);
            let mut add = |a: usize, b: usize| {
                let elements = between(elements, breaks[a].place, breaks[b].place);
                let length: f64 = elements.iter().map(|e| e.segment.length()).sum();
                let nodes = [breaks[a].node, breaks[b].node];
                if !elements.is_empty() {
                    edges.push(Edge { chain, set, nodes, elements, length });
                }
            };
            (1..breaks.len()).for_each(|k| add(k - 1, k));
            if c.closed && !breaks.is_empty() {
                add(breaks.len() - 1, 0);
            }
        }
        first.push(edges.len());
        Self { edges, first }
    }

    /// The edges of a chain.
    pub(super) fn of(&self, chain: u32) -> std::ops::Range<usize> {
        let at = |c: usize| self.first.get(c).copied().unwrap_or(self.edges.len());
        at(chain as usize)..at(chain as usize + 1)
    }

    /// The elements of a half-edge, in its direction.
    pub(super) fn elements(&self, h: HalfEdge) -> Vec<Element> {
        let elements = &self.edges[h / 2].elements;
        match h % 2 {
            0 => elements.clone(),
            _ => {
                let back = |e: &Element| Element { segment: e.segment.reversed(), ..*e };
                elements.iter().rev().map(back).collect()
            }
        }
    }

    /// The faces that the edges enclose and that are wider than `tolerance` mm, in the order of their first edges.
    pub(super) fn faces(&self, tolerance: f64) -> Vec<Face> {
        let mut alive: Vec<usize> = (0..self.edges.len()).collect();
        let rounds = self.rounds(&alive);
        let mut round_of = vec![usize::MAX; 2 * self.edges.len()];
        for (k, round) in rounds.iter().enumerate() {
            round.iter().for_each(|&h| round_of[h] = k);
        }
        alive.retain(|e| round_of[2 * e] != round_of[2 * e + 1]);
        let mut faces: Vec<Face> = Vec::new();
        for round in self.rounds(&alive) {
            for around in self.simple(&round) {
                let area = self.area(&around);
                let length: f64 = around.iter().map(|h| self.edges[h / 2].length).sum();
                if area > 0.5 * tolerance * length {
                    faces.push(Face { around, area });
                }
            }
        }
        sort_by(&mut faces, |f| [f.around.iter().copied().min().unwrap_or(0) as u64, 0, 0]);
        faces
    }

    /// The rounds along these edges with what they enclose on the left.
    fn rounds(&self, alive: &[usize]) -> Vec<Vec<HalfEdge>> {
        let mut leaving: Vec<(u32, HalfEdge)> = Vec::with_capacity(2 * alive.len());
        for &e in alive {
            let [a, b] = self.edges[e].nodes;
            leaving.extend([(a, 2 * e), (b, 2 * e + 1)]);
        }
        sort_by(&mut leaving, |(node, h)| [(*node).into(), *h as u64, 0]);
        let mut after = vec![usize::MAX; 2 * self.edges.len()];
        for at in leaving.chunk_by(|a, b| a.0 == b.0) {
            let mut around: Vec<HalfEdge> = at.iter().map(|(_, h)| *h).collect();
            let length = |h: HalfEdge| self.edges[h / 2].length;
            link(&mut around, &mut after, AHEAD, length, |h, ahead| self.direction(h, ahead));
        }
        let mut seen = vec![false; after.len()];
        let mut rounds = Vec::new();
        for start in alive.iter().flat_map(|e| [2 * e, 2 * e + 1]) {
            let mut round = Vec::new();
            let mut h = start;
            while h < seen.len() && !seen[h] {
                seen[h] = true;
                round.push(h);
                h = after[h];
            }
            if !round.is_empty() {
                rounds.push(round);
            }
        }
        rounds
    }

    /// A round, divided where it comes back to a node.
    fn simple(&self, round: &[HalfEdge]) -> Vec<Vec<HalfEdge>> {
        let mut out = Vec::new();
        let mut way: Vec<HalfEdge> = Vec::new();
        let mut at: rustc_hash::FxHashMap<i64, usize> = rustc_hash::FxHashMap::default();
        for &h in round {
            let [from, to] = self.nodes(h);
            at.insert(from.into(), way.len());
            way.push(h);
            if let Some(&k) = at.get(&to.into()) {
                let ring = way.split_off(k);
                for &passed in &ring {
                    at.remove(&self.nodes(passed)[0].into());
                }
                out.push(ring);
            }
        }
        out
    }

    fn nodes(&self, h: HalfEdge) -> [u32; 2] {
        let [a, b] = self.edges[h / 2].nodes;
        if h.is_multiple_of(2) { [a, b] } else { [b, a] }
    }

    /// The direction from a node to the point `distance` mm along a half-edge.
    fn direction(&self, h: HalfEdge, distance: f64) -> DVec2 {
        let elements = &self.edges[h / 2].elements;
        let back = h % 2 == 1;
        let mut left = distance;
        let mut start = None;
        let n = elements.len();
        for k in 0..n {
            let e = if back { &elements[n - 1 - k] } else { &elements[k] };
            let segment = if back { e.segment.reversed() } else { e.segment };
            let start = *start.get_or_insert(segment.start());
            let length = segment.length();
            if left <= length || k + 1 == n {
                return segment.at(left / length) - start;
            }
            left -= length;
        }
        DVec2::ZERO
    }

    /// The area within a round, mm2, negative when it runs clockwise. Small gaps at its nodes are closed by lines.
    fn area(&self, round: &[HalfEdge]) -> f64 {
        let ends = |h: HalfEdge| {
            let elements = &self.edges[h / 2].elements;
            let start = elements.first().map_or(DVec2::ZERO, |e| e.segment.start());
            let end = elements.last().map_or(DVec2::ZERO, |e| e.segment.end());
            if h.is_multiple_of(2) { [start, end] } else { [end, start] }
        };
        let mut sum = 0.0;
        for (k, &h) in round.iter().enumerate() {
            let swept: f64 = self.edges[h / 2].elements.iter().map(|e| e.segment.doubled_area()).sum();
            let gap = Segment::line(ends(h)[1], ends(round[(k + 1) % round.len()])[0]);
            sum += if h.is_multiple_of(2) { swept } else { -swept } + gap.doubled_area();
        }
        0.5 * sum
    }

    /// A point well inside a face.
    pub(super) fn inner_point(&self, face: &Face) -> Option<DVec2> {
        let segments = face.around.iter().flat_map(|&h| self.elements(h)).map(|e| e.segment).collect();
        interior_point(&Path::new(segments, true))
    }
}

/// The elements from one place to another in the direction of the chain, across its start if they come in this order.
fn between(elements: &[Element], from: Place, to: Place) -> Vec<Element> {
    let n = elements.len();
    let mut out = Vec::new();
    let mut push = |k: usize, a: f64, b: f64| {
        if let Some(e) = elements.get(k).filter(|_| a < b) {
            let segment = if a <= 0.0 && b >= 1.0 { e.segment } else { e.segment.piece(a, b) };
            out.push(Element { segment, ..*e });
        }
    };
    let ahead = from.element < to.element || (from.element == to.element && from.fraction < to.fraction);
    if ahead && from.element == to.element {
        push(from.element, from.fraction, to.fraction);
        return out;
    }
    push(from.element, from.fraction, 1.0);
    if ahead {
        (from.element + 1..to.element).for_each(|k| push(k, 0.0, 1.0));
    } else {
        (from.element + 1..n).chain(0..to.element).for_each(|k| push(k, 0.0, 1.0));
    }
    push(to.element, 0.0, to.fraction);
    out
}
