//! Ways around tipped pieces: the shortest way in a small visibility graph.
//!
//! The nodes are the corners of the octagons around the pieces that are in the way of the straight move, and then of those
//! that are in the way of ways around these. A way is a chain of moves from rest to rest; it is looked for only as long as it is
//! faster than lifting the head.

use super::{Piece, Zones};
use crate::geometry::DVec2;

/// Pieces that a way goes around, at most. Beyond that the head is lifted: each more makes the search for a way slower by its
/// square, and way points cost more than a lift long before.
const MOST_PIECES: usize = 6;
/// Octagons stand off by this factor of the reach, so that their corners are not on its limit.
const STAND_OFF: f64 = 1.001;

/// The end of a way so far.
struct Node {
    place: DVec2,
    seconds: f64,
    from: usize,
    done: bool,
}

impl Zones {
    /// The places of the fastest way around free pieces and its seconds, if it takes less than `limit` seconds.
    pub(super) fn around(
        &self,
        from: DVec2,
        to: DVec2,
        is_free: &impl Fn(&Piece) -> bool,
        limit: f64,
    ) -> Option<(f64, Vec<DVec2>)> {
        let mut pieces: Vec<usize> = Vec::new();
        let mut nodes = vec![Node { place: from, seconds: 0.0, from: 0, done: false }];
        nodes.push(Node { place: to, seconds: limit, from: 0, done: false });
        let mut new = Vec::new();
        self.visit(from, to, is_free, |k| {
            new.push(k);
            new.len() < MOST_PIECES
        });
        loop {
            new.sort_unstable();
            new.dedup();
            new.retain(|k| !pieces.contains(k));
            if new.is_empty() || pieces.len() + new.len() > MOST_PIECES {
                return None;
            }
            let octagons = new.iter().filter_map(|&k| self.pieces.get(k));
            for corner in octagons.flat_map(|p| p.octagon(self.reach * STAND_OFF)) {
                let place = self.bed.map_or(corner, |bed| corner.clamp(bed.min, bed.max));
                // A place is of use if it is on a way that is fast enough, and clear.
                let fast = self.down.seconds(from, place) + self.down.seconds(place, to) < limit;
                if fast && !self.is_near(place, is_free) {
                    nodes.push(Node { place, seconds: limit, from: 0, done: false });
                }
            }
            pieces.append(&mut new);
            self.shortest(&mut nodes, is_free, &mut new);
            let end = nodes.get(1)?;
            if end.seconds < limit {
                return Some((end.seconds, places(&nodes)));
            }
            for node in nodes.iter_mut().skip(1) {
                node.seconds = limit;
                node.done = false;
            }
            if let Some(start) = nodes.first_mut() {
                start.done = false;
            }
        }
    }

    /// The fastest ways from the first node to all others (Dijkstra), until the second is reached. Pieces in the way of moves
    /// that would have been faster are added to `blocking`.
    fn shortest(&self, nodes: &mut [Node], is_free: &impl Fn(&Piece) -> bool, blocking: &mut Vec<usize>) {
        let limit = nodes.get(1).map_or(0.0, |end| end.seconds);
        let Some(goal) = nodes.get(1).map(|n| n.place) else { return };
        loop {
            let open = nodes.iter().enumerate().filter(|(k, n)| !n.done && (n.seconds < limit || *k == 0));
            let next = open.min_by(|a, b| a.1.seconds.total_cmp(&b.1.seconds)).map(|(k, _)| k);
            let Some((at, place, seconds)) = next.and_then(|k| {
                let node = nodes.get_mut(k)?;
                node.done = true;
                Some((k, node.place, node.seconds))
            }) else {
                return;
            };
            if at == 1 {
                return;
            }
            for node in nodes.iter_mut().filter(|n| !n.done) {
                let there = seconds + self.down.seconds(place, node.place);
                if there >= node.seconds || there + self.down.seconds(node.place, goal) >= limit {
                    continue;
                }
                let before = blocking.len();
                self.visit(place, node.place, is_free, |k| {
                    blocking.push(k);
                    blocking.len() < before + MOST_PIECES
                });
                if blocking.len() == before {
                    (node.seconds, node.from) = (there, at);
                }
            }
        }
    }
}

/// The places between the first node and the second, on the way between them.
fn places(nodes: &[Node]) -> Vec<DVec2> {
    let back = |&k: &usize| nodes.get(k).map(|n| n.from).filter(|&k| k > 1);
    let mut places: Vec<DVec2> = std::iter::successors(back(&1), back)
        .take(nodes.len())
        .filter_map(|k| nodes.get(k).map(|n| n.place))
        .collect();
    places.reverse();
    places
}
