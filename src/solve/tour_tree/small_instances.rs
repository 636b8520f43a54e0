//! Small problems: the kicks, temperatures and lengths of cycles that pay there.
//!
//! With few places to enter, a kick may take time that grows with the whole tour: all entries are chosen again
//! (`entries.rs`), and some items are taken out and put back (`ruin_recreate.rs`). The temperature then changes in turns
//! of three cycles. Short tours are ruined and recreated too where items may be entered anywhere.

use super::config::CONFIG;
use super::space::Space;
use crate::problem::Problem;

/// What a cycle over a short tour does differently, whose items may be entered anywhere.
pub(super) struct ShortTour {
    /// Kicks per item in the first cycle.
    pub(super) first_kicks: u64,
    /// Percentage of kicks that ruin and recreate.
    pub(super) ruin_percent: usize,
}

impl ShortTour {
    /// For a tour of this many items.
    pub(super) fn of(problem: &Problem, items: u64) -> Self {
        let (config, usual) = (CONFIG.short, CONFIG.cycle.first_kicks);
        if items > config.most_items {
            return Self { first_kicks: usual, ruin_percent: 0 };
        }
        Self {
            first_kicks: (items / config.items_per_kick).clamp(usual, config.most_first_kicks),
            ruin_percent: if may_ruin(problem) { config.ruin_percent } else { 0 },
        }
    }
}

/// Ruin and recreate does not respect groups.
fn may_ruin(problem: &Problem) -> bool {
    problem.groups.is_empty()
}

/// Whether a problem is small: few items in the tour, none of which has a ring of places.
pub(super) fn is_small(space: &Space, items: usize) -> bool {
    items <= CONFIG.small.most_items && !(0..=space.home).any(|i| space.is_ring(i))
}

/// Temperature, kicks and length of one cycle.
pub(super) struct CyclePlan {
    /// Temperature at its start, relative to the first cycle's.
    pub(super) temperature: f64,
    /// Percentage of kicks that ruin and recreate.
    pub(super) ruin_percent: usize,
    /// Number of kicks.
    pub(super) kicks: u64,
}

impl CyclePlan {
    /// The plan of a cycle over a small problem, by the cycle's number; `first_kicks`: kicks of the first cycle.
    pub(super) fn of_small(cycle: u32, problem: &Problem, first_kicks: u64) -> Self {
        let (small, points) = (CONFIG.small, CONFIG.points);
        let turn = cycle as usize % 3;
        let has_points = problem.items.len() <= points.most_items && problem.table().is_none();
        let ruin_percent = match (has_points, problem.pairs.is_empty()) {
            _ if !may_ruin(problem) => 0,
            (true, _) => 100,
            (false, true) => small.ruin_percent[turn],
            (false, false) => small.ruin_percent_pairs[turn],
        };
        let (temperature, length) = if has_points {
            (points.reheat, points.first_cycle << (cycle / points.cycles_per_doubling).min(40))
        } else {
            (small.reheat[turn], 1 << (cycle / 2).min(40))
        };
        Self {
            temperature: if cycle > 0 { temperature } else { 1.0 },
            ruin_percent,
            kicks: first_kicks.saturating_mul(length),
        }
    }
}
