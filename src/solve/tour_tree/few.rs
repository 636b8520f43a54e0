//! Problems with few places to enter: other kicks and temperatures pay there, by turns of three cycles.
//!
//! What is done at a kick then takes time that grows with all of the tour: all its entries are chosen anew
//! (`entries.rs`), some of its items taken out and put back (`rebuild.rs`). Small tours are rebuilt too where items may
//! be entered anywhere.

use super::space::Space;
use crate::problem::Problem;

/// Items at most.
const MOST: usize = 500;
/// Share of the first cycle's temperature in later ones, by turns: one forgets most of the best path, one refines it,
/// one loosens it. With 4 for the first, cycles come back to the valley of the second one however long they are;
/// crossing (`crossing.rs`) needs flaws that differ. Of 15 runs of 6 s on 132d657, 157rat783 and 89rbg443 11 reach the
/// best value, with 16 for the first 6, with 8 for the last 9. Only refining, at 0.3, ended 0.6 % above the best values
/// of 13 PCGTSP and 7 GTSPLIB instances; 4 and no refining at 0.0 %, but half of 16 PCGTSP runs beside them, not 5.
const REHEAT: [f64; 3] = [8.0, 0.5, 4.0];
/// Kicks that rebuild, percent, by the same turns. They cost three times an exchange: with 50 in the middle turn 8 of
/// those 15 runs reach the best value, and with 50, 100, 0 none of 5 on 132d657. Without any half of the runs on 89rbg443
/// miss it.
const REBUILDS: [usize; 3] = [0, 10, 0];
/// The same where precedence is given by pairs, which forbid most exchanges.
const REBUILDS_PAIRS: [usize; 3] = [50, 100, 50];
/// The temperature for at most [`MOST_POINTS`] items entered at points of the plane, where every kick rebuilds, and how many
/// times as long as elsewhere the first cycle is; cycles double every sixteenth time only. On Qu & Du's 43 contours
/// (boundary points, Chebyshev, open) 60 to 120 runs took so many million moves on average to the best value, with cycles
/// of one length: 4.0 at 2, 3.9 at 3, 4.2 at 4; 6.7 and 5.4 at 2 and 4 with half that length. Cycles that double every
/// second time, at 8, 2, 8 by turns, took 8.1, at 3 alone 7.4. The closed path took 1.6 to 1.9 so, and takes 3.4 now.
const REHEAT_POINTS: f64 = 4.0;
const FIRST_POINTS: u64 = 4;
/// Between the sizes measured.
const MOST_POINTS: usize = 100;
/// A kick may end this many mean ways above the best of its cycle for all its entries to be chosen anew: of 5 runs of 6 s
/// on 132d657 all reach the best value with 0.3, two with 0.1, two with 1 and one with 10.
pub(super) const ENTER_ANEW: f64 = 0.3;

/// Items at most of a small tour, entered anywhere: between the sizes measured.
const SMALL: u64 = 150;
/// Kicks of a small tour that rebuild, percent. Sheets of Dewil et al. (`npm run bench -- dewil`) after 0.15 s, 12 to 20
/// seeds: with 0, 5, 15, 40 sheet 11 (72 items) takes 104.20, 104.03, 104.02, 104.00 s, sheet 18 (109) 93.44, 93.41, 93.47,
/// 93.41 s; others gain up to 0.3 % (14, 22) or lose less than 0.1 % (16, 19). `sheet_100` after 0.3 s: 2,735.35 mm with 0,
/// 2,734.92 with 40. On 209 to 292 items nothing is gained, and 500 end 0.2 % longer with 40 after 8 s.
const REBUILDS_SMALL: usize = 30;
/// How many items of a small tour add a kick for each item in the first cycle, and how many kicks there are then at most:
/// the valley it ends in is seldom left. From 72 items on 4 kicks are 0.1 % better than 2 after 0.15 s, 8 not better;
/// 5 items have 1 ms until F-R is at its end, and twice the first cycle is too long then.
const ITEMS_A_KICK: u64 = 16;
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
