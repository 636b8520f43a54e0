//! Air moves of a group that contours beside it bridge.
//!
//! A group is left where its path makes an air move anyway. A contour that lies between two nodes may be cut on the way from one
//! to the other, so that an air move which is long by itself costs next to nothing (Dewil et al., 2014, figure 8). The authors
//! found no gain in it; on a row of three parts with four slits beside it, it is the difference to the best there is.
//!
//! The orders are searched as all others are, with air moves that cost what they take beyond cutting the contour from its
//! nearest node. What is cut where is then up to the search over all items, which sees the real seconds of each path.

use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::GroupProblem;

/// Seconds from node to node, row by row, where a contour beside the group is cut on the way, minus what it takes to leave the
/// group for it at its nearest node; at least 0 s. Only the contour that gains most counts. Empty if none gains anything.
pub(super) fn ways(group: &GroupProblem, air: &AirTime, plain: &[f64]) -> Vec<f64> {
    let nodes = group.nodes.len();
    let mut bridged = plain.to_vec();
    for contour in group.beside.iter().filter(|_| !plain.is_empty()) {
        let legs = |leg: &dyn Fn(DVec2, &[DVec2; 2]) -> f64| -> Vec<Vec<f64>> {
            group.nodes.iter().map(|&n| contour.iter().map(|way| leg(n, way)).collect()).collect()
        };
        let there = legs(&|n, [entry, _]| air.seconds(n, *entry));
        let back = legs(&|n, [_, exit]| air.seconds(*exit, n));
        let through =
            |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).fold(f64::INFINITY, f64::min);
        let alone = there.iter().zip(&back).map(|(a, b)| through(a, b)).fold(f64::INFINITY, f64::min);
        for (from, row) in there.iter().zip(bridged.chunks_mut(nodes)) {
            for (to, way) in back.iter().zip(row) {
                *way = way.min((through(from, to) - alone).max(0.0));
            }
        }
    }
    if bridged == plain { Vec::new() } else { bridged }
}
