//! Problems with few places to enter: other kicks and temperatures pay there, by turns of three cycles.
//!
//! What is done at a kick then takes time that grows with all of the tour: all its entries are chosen anew
//! (`entries.rs`), some of its items taken out and put back (`rebuild.rs`).

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
/// The temperatures for at most [`MOST_POINTS`] items entered at points of the plane, where every kick rebuilds: on Qu &
/// Du's 43 contours (boundary points, Chebyshev) 27 of 32 runs came to the best value within 12 million moves with 4, 0.5,
/// 4 and rebuilding by turns, 48 of 48 within 17 million so.
const REHEAT_POINTS: [f64; 3] = [8.0, 2.0, 8.0];
/// Between the sizes measured.
const MOST_POINTS: usize = 100;
/// A kick may end this many mean ways above the best of its cycle for all its entries to be chosen anew: of 5 runs of 6 s
/// on 132d657 all reach the best value with 0.3, two with 0.1, two with 1 and one with 10.
pub(super) const ENTER_ANEW: f64 = 0.3;

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
}

impl Turn {
    /// Of the cycle of this number, over so many items.
    pub(super) fn of(cycle: u32, problem: &Problem, items: usize) -> Self {
        let turn = cycle as usize % 3;
        let points = items <= MOST_POINTS && problem.table().is_none();
        let rebuilds = match (points, problem.pairs.is_empty()) {
            // Rebuilding knows no groups.
            _ if !problem.groups.is_empty() => 0,
            (true, _) => 100,
            (false, true) => REBUILDS[turn],
            (false, false) => REBUILDS_PAIRS[turn],
        };
        let heat = if points { REHEAT_POINTS[turn] } else { REHEAT[turn] };
        Self { heat: if cycle > 0 { heat } else { 1.0 }, rebuilds }
    }
}
