//! The strokes of the head that a plan document describes: the PNG renderer draws them, a quote measures them.

use super::super::model::{Leads, Turn};
use super::model::Document;
use super::moves::{Move, segments};
use crate::geometry::{DVec2, Segment};

/// One stroke of the head: what is drawn of a plan, and what is measured.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// Beam off.
    Air {
        /// mm.
        from: DVec2,
        /// mm.
        to: DVec2,
    },
    /// Beam off between two cuts on the run.
    Fly {
        /// Elements, mm.
        path: Vec<Segment>,
    },
    /// Beam on through waste, between two cuts.
    Chain {
        /// Elements, mm.
        path: Vec<Segment>,
    },
    /// A micro-joint, which stays uncut.
    Joint {
        /// The contour's id.
        contour: u32,
        /// Elements, mm.
        path: Vec<Segment>,
    },
    /// Beam on.
    Beam {
        /// The contour's id, the first of several; `None` for a pre-cut.
        contour: Option<u32>,
        /// Elements, mm.
        path: Vec<Segment>,
        /// Which of them are leads and overcut.
        leads: Leads,
        /// The corners that are cut in a loop or rounded.
        turns: Vec<Turn>,
    },
}

/// The strokes of a plan in order, the first from home.
pub fn strokes(document: &Document) -> Vec<Stroke> {
    let mut at = document.machine.home();
    let stroke = |step: &Move| {
        let from = at;
        match step {
            Move::Air { to, .. } => {
                at = DVec2::from(*to);
                Some(Stroke::Air { from, to: at })
            }
            Move::Pierce
            | Move::MovingStart
            | Move::Macro { .. }
            | Move::Height { .. }
            | Move::Wait { .. } => None,
            Move::Joint { contour, path, .. } => {
                Some(Stroke::Joint { contour: *contour, path: segments(path, &mut at) })
            }
            Move::Fly { path } => Some(Stroke::Fly { path: segments(path, &mut at) }),
            Move::Chain { path } => Some(Stroke::Chain { path: segments(path, &mut at) }),
            Move::PreCut { to, .. } => {
                at = DVec2::from(*to);
                Some(Stroke::Beam {
                    contour: None,
                    path: vec![Segment::line(from, at)],
                    leads: Leads::default(),
                    turns: Vec::new(),
                })
            }
            Move::Cut { contour, path, lead_in, overcut, lead_out, corners } => {
                let leads = Leads { lead_in: *lead_in, overcut: *overcut, lead_out: *lead_out };
                let turns = corners.iter().map(Turn::from).collect();
                Some(Stroke::Beam { contour: contour.first(), path: segments(path, &mut at), leads, turns })
            }
        }
    };
    document.moves.iter().filter_map(stroke).collect()
}
