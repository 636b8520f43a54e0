//! The plan as data: the moves of the head in order, and their sums. It knows neither how a plan was found nor who checks it.

mod leads;
mod moves;
mod summary;
mod turn;

use crate::geometry::{Affine, DVec2, Segment};
use crate::machine::PLANS_ALL_LEVERS;
use crate::sheet::Strip;
pub use leads::Leads;
pub use moves::{Move, Way};
use serde::{Deserialize, Serialize};
pub use summary::Summary;
pub use turn::Turn;

/// Moves and their sums. As data it keeps every bit, unlike the plan document, whose arcs have no sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// The moves in order.
    pub moves: Vec<Move>,
    /// Their sums.
    pub summary: Summary,
    /// The strips of material that connect parts.
    #[serde(default, skip_serializing_if = "no_bridges")]
    pub bridges: Vec<Strip>,
}

/// Whether there are none to write. Builds that plan none are smaller without writing them.
pub(in crate::plan) fn no_bridges(bridges: &[Strip]) -> bool {
    !PLANS_ALL_LEVERS || bridges.is_empty()
}

impl Plan {
    /// The same plan at another place, moved by `shift` mm. Lengths and times stay as they are.
    pub fn moved(mut self, shift: DVec2) -> Self {
        if shift == DVec2::ZERO {
            return self;
        }
        let by = Affine::translation(shift);
        let run = |path: &mut [Segment]| {
            path.iter_mut().for_each(|s| *s = by.segment(s).unwrap_or(*s));
        };
        for step in &mut self.moves {
            match step {
                Move::Air { to, .. } => *to += shift,
                Move::Pierce | Move::MovingStart | Move::Height { .. } | Move::Wait { .. } => {}
                Move::PreCut { to, ahead, .. } => {
                    *to += shift;
                    run(ahead);
                }
                Move::Macro { at, .. } => *at += shift,
                Move::Cut { path, turns, .. } => {
                    run(path);
                    turns.iter_mut().for_each(|turn| turn.at += shift);
                }
                Move::Joint { path, .. } | Move::Fly { path } | Move::Chain { path } => run(path),
            }
        }
        if PLANS_ALL_LEVERS {
            self.bridges.iter_mut().flat_map(|b| b.sides.as_flattened_mut()).for_each(|p| *p += shift);
        }
        let [x0, y0, x1, y1] = self.summary.bounds;
        self.summary.bounds = [x0 + shift.x, y0 + shift.y, x1 + shift.x, y1 + shift.y];
        self
    }
}
