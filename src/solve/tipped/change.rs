//! Changes of a sequence: a window of stops in another order, or with other entries.

use super::visit::Visit;
use crate::problem::Problem;
use crate::solve::traits::Stop;

/// The visits that a window has after the change, or had before it once it is made.
#[derive(Debug, Default)]
pub(super) struct Change {
    /// Position of the first.
    pub(super) low: usize,
    pub(super) visits: Vec<Visit>,
    /// Number of stops that go from the beginning of the window to its end, if all else keeps its order.
    pub(super) rotated: Option<usize>,
}

impl Change {
    /// The stretches `[low, middle)` and `[middle, high)` of these visits exchanged.
    pub(super) fn exchange(visits: &[Visit], low: usize, middle: usize, high: usize) -> Option<Self> {
        if low >= middle || middle >= high {
            return None;
        }
        let mut visits = visits.get(low..high)?.to_vec();
        visits.rotate_left(middle - low);
        Some(Self { low, visits, rotated: Some(middle - low) })
    }

    /// The stretch `[low, high)` of these visits in reverse.
    pub(super) fn reverse(problem: &Problem, visits: &[Visit], low: usize, high: usize) -> Option<Self> {
        if low + 1 >= high {
            return None;
        }
        let turned = |visit: &Visit| {
            let twin = problem.nodes.get(visit.stop.node as usize)?.twin;
            if twin == visit.stop.node {
                return Some(*visit);
            }
            Visit::new(problem, Stop::at(problem, twin))
        };
        let visits: Option<Vec<Visit>> = visits.get(low..high)?.iter().rev().map(turned).collect();
        Some(Self { low, visits: visits?, rotated: None })
    }

    /// Another entry of the stop at `k`.
    pub(super) fn entry(problem: &Problem, k: usize, stop: Stop) -> Option<Self> {
        Some(Self { low: k, visits: vec![Visit::new(problem, stop)?], rotated: None })
    }
}
