//! Problems with few places to enter: other kicks and temperatures pay there, by turns of three cycles.
//!
//! What is done at a kick then takes time that grows with all of the tour: all its entries are chosen anew
//! (`entries.rs`), some of its items taken out and put back (`rebuild.rs`). Small tours are rebuilt too where items may
//! be entered anywhere.

use super::space::Space;
use crate::problem::Problem;

/// Most items of a small problem.
const MOST: usize = 500;
/// Temperatures of three cycles in turn, relative to the first: one forgets most of the best path, one refines it, one loosens it.
const REHEAT: [f64; 3] = [8.0, 0.5, 4.0];
/// Percentage of kicks that ruin and recreate, in the same turns: they get past what exchanges cannot, at three times the price.
const REBUILDS: [usize; 3] = [0, 10, 0];
/// The same where precedence is given by pairs, which forbid most exchanges.
const REBUILDS_PAIRS: [usize; 3] = [50, 100, 50];
/// Temperature for points of the plane, relative to the first: between 2 and 4 the best value is found about as soon.
const REHEAT_POINTS: f64 = 4.0;
/// How many times as long the first cycle is for them: with half of it, the best value is found later.
const FIRST_POINTS: u64 = 4;
/// Most items entered at points of the plane for which every kick ruins and recreates: between the sizes measured.
const MOST_POINTS: usize = 100;
/// Mean legs above the best of its cycle up to which all entries of a kick are chosen again: more costs time, less misses gains.
pub(super) const ENTER_ANEW: f64 = 0.3;

/// Most items of a small tour whose items may be entered anywhere: between the sizes measured.
const SMALL: u64 = 150;
/// Percentage of kicks of such a tour that ruin and recreate: better up to 109 items, slower beyond 200.
const REBUILDS_SMALL: usize = 30;
/// Items of a small tour that add one kick per item to the first cycle: the local optimum it ends in is seldom left.
const ITEMS_A_KICK: u64 = 16;
/// Most kicks per item in that first cycle: more is no better, and later.
const FIRST_SMALL: u64 = 4;

/// What small tours do differently that may be entered anywhere.
pub(super) struct Small {
    /// Kicks in the first cycle, for every item.
    pub(super) first_cycle: u64,
    /// Kicks that rebuild, percent.
    pub(super) rebuilds: usize,
}

impl Small {
    /// Of a tour of so many items, where larger ones have so many kicks an item in their first cycle.
    pub(super) fn of(problem: &Problem, items: u64, first_cycle: u64) -> Self {
        if items > SMALL {
            return Self { first_cycle, rebuilds: 0 };
        }
        Self {
            first_cycle: (items / ITEMS_A_KICK).clamp(first_cycle, FIRST_SMALL),
            rebuilds: if may_rebuild(problem) { REBUILDS_SMALL } else { 0 },
        }
    }
}

/// Rebuilding knows no groups.
fn may_rebuild(problem: &Problem) -> bool {
    problem.groups.is_empty()
}

/// Whether a tour of so many items is one: few, none of them entered just anywhere.
pub(super) fn is_few(space: &Space, items: usize) -> bool {
    items <= MOST && !(0..=space.home).any(|i| space.is_ring(i))
}

/// What a cycle does differently.
pub(super) struct Turn {
    /// Share of the first cycle's temperature.
    pub(super) heat: f64,
    /// Kicks that rebuild, percent.
    pub(super) rebuilds: usize,
    /// Kicks in all.
    pub(super) kicks: u64,
}

impl Turn {
    /// Of the cycle of this number, where the first has so many kicks.
    pub(super) fn of(cycle: u32, problem: &Problem, first: u64) -> Self {
        let turn = cycle as usize % 3;
        let points = problem.items.len() <= MOST_POINTS && problem.table().is_none();
        let rebuilds = match (points, problem.pairs.is_empty()) {
            _ if !may_rebuild(problem) => 0,
            (true, _) => 100,
            (false, true) => REBUILDS[turn],
            (false, false) => REBUILDS_PAIRS[turn],
        };
        let (heat, length) = if points {
            (REHEAT_POINTS, FIRST_POINTS << (cycle / 16).min(40))
        } else {
            (REHEAT[turn], 1 << (cycle / 2).min(40))
        };
        Self { heat: if cycle > 0 { heat } else { 1.0 }, rebuilds, kicks: first.saturating_mul(length) }
    }
}
