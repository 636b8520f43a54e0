//! A first order at once.

use crate::geometry::{Aabb, DVec2};
use crate::machine::AirTime;
use crate::problem::{NodeId, Problem};

/// Cells of the curve along an axis: 2^16, a hundredth of a millimetre on a sheet of half a metre.
const LEVELS: u32 = 16;

/// Items along a Hilbert curve, rank after rank, each entered at its first node. A tour of some 25 % above the best
/// in n log n (Platzman & Bartholdi, "Spacefilling curves and the planar travelling salesman problem", JACM 36,
/// 1989): all that a local search needs to begin with.
pub(super) fn along_curve(problem: &Problem) -> Vec<NodeId> {
    let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
    let side = bounds.size().max_element().max(f64::MIN_POSITIVE);
    let mut keyed: Vec<(u32, u64, NodeId)> = problem
        .items
        .iter()
        .filter_map(|item| {
            let node = item.nodes.clone().next()?;
            let place = (problem.nodes.get(node as usize)?.entry - bounds.min) / side;
            Some((item.rank, along_hilbert(place), node))
        })
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, _, node)| node).collect()
}

/// How far along the Hilbert curve a place of the unit square lies.
fn along_hilbert(place: DVec2) -> u64 {
    let (mut x, mut y) = (cell(place.x), cell(place.y));
    let mut along = 0;
    for level in (0..LEVELS).rev() {
        let side = 1u64 << level;
        let (right, up) = (x & side != 0, y & side != 0);
        along += side * side * ((3 * u64::from(right)) ^ u64::from(up));
        // Turn the quarter so that the curve enters and leaves it at the same corners.
        if !up {
            if right {
                (x, y) = (!x, !y);
            }
            std::mem::swap(&mut x, &mut y);
        }
    }
    along
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a float cast saturates")]
fn cell(fraction: f64) -> u64 {
    let cells = f64::from(1u32 << LEVELS);
    (fraction * cells).clamp(0.0, cells - 1.0) as u64
}

/// The same order, each item entered where it is nearest to the exit of the one before it.
pub(super) fn entered_nearest(problem: &Problem, order: &[NodeId]) -> Vec<NodeId> {
    let air = AirTime::new(&problem.machine);
    let mut head = problem.home;
    order
        .iter()
        .map(|&node| {
            let mut best = (f64::INFINITY, node);
            for candidate in problem.items[problem.nodes[node as usize].item as usize].nodes.clone() {
                let seconds = air.seconds(head, problem.nodes[candidate as usize].entry);
                if seconds < best.0 {
                    best = (seconds, candidate);
                }
            }
            head = problem.nodes[best.1 as usize].exit;
            best.1
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_neighbours() {
        // All cells of a 16 x 16 grid in order of the curve: each step goes to an adjacent cell.
        let mut cells: Vec<(u64, DVec2)> = (0..256)
            .map(|k| DVec2::new(f64::from(k % 16) + 0.5, f64::from(k / 16) + 0.5))
            .map(|p| (along_hilbert(p / 16.0), p))
            .collect();
        cells.sort_by_key(|c| c.0);
        for w in cells.windows(2) {
            assert!((w[0].1.distance(w[1].1) - 1.0).abs() < 1e-12);
        }
    }
}
