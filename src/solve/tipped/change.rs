//! Changes of a sequence: a window of stops in another order, or with other entries.
//!
//! A proposal says what a change would be without the stops in it, because most proposals are dropped by their ends alone.

use super::visit::Visit;
use crate::problem::Problem;
use crate::solve::traits::Stop;

/// A change that may be made.
#[derive(Clone, Copy, Debug)]
pub(super) enum Proposal {
    /// The stretches `[low, middle)` and `[middle, high)` exchanged.
    Exchange { low: usize, middle: usize, high: usize },
    /// The stretch `[low, high)` in reverse.
    Reverse { low: usize, high: usize },
    /// Another entry at a position.
    Enter { at: usize, visit: Visit },
}

impl Proposal {
    /// Number of stops in the window.
    pub(super) fn width(self) -> usize {
        match self {
            Self::Exchange { low, high, .. } | Self::Reverse { low, high } => high.saturating_sub(low),
            Self::Enter { .. } => 1,
        }
    }

    /// The change, if there is one.
    pub(super) fn change(self, problem: &Problem, visits: &[Visit]) -> Option<Change> {
        match self {
            Self::Exchange { low, middle, high } => Change::exchange(visits, low, middle, high),
            Self::Reverse { low, high } => Change::reverse(problem, visits, low, high),
            Self::Enter { at, visit } => Some(Change { low: at, visits: vec![visit], rotated: None }),
        }
    }
}

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
    fn exchange(visits: &[Visit], low: usize, middle: usize, high: usize) -> Option<Self> {
        if low >= middle || middle >= high {
            return None;
        }
        let mut visits = visits.get(low..high)?.to_vec();
        visits.rotate_left(middle - low);
        Some(Self { low, visits, rotated: Some(middle - low) })
    }

    /// The stretch `[low, high)` of these visits in reverse.
    fn reverse(problem: &Problem, visits: &[Visit], low: usize, high: usize) -> Option<Self> {
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
}
