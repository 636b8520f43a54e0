//! The plan as data: what the head does, in order, and what it adds up to.

use crate::geometry::{DVec2, Segment};

/// One thing the head does. It starts where the last one ended, the first at home.
#[derive(Clone, Debug, PartialEq)]
pub enum Move {
    /// Beam off, straight or per axis as the machine moves.
    Air {
        /// Where to, mm.
        to: DVec2,
    },
    /// Piercing at the spot.
    Pierce,
    /// Beam on at the end of a cut that leaves its contour unfinished: a bit cut ahead, so that the contour is resumed
    /// from within it without piercing.
    PreCut {
        /// The contour's id.
        contour: u32,
        /// Where to, mm.
        to: DVec2,
        /// What is cut ahead from there, before the head comes back dark; empty where pre-cuts have no length.
        ahead: Vec<Segment>,
    },
    /// A pause in a sharp corner, beam off; the next move goes on with the cut.
    Macro {
        /// The contour's id.
        contour: u32,
        /// The corner, mm.
        at: DVec2,
    },
    /// Beam on along a contour, or a stretch of it: a contour left unfinished goes on in a later cut from where this one
    /// ended.
    Cut {
        /// The contour's id; of a pierce group, the one it begins on.
        contour: u32,
        /// Other contours of a pierce group that it runs along, in order.
        with: Vec<u32>,
        /// Its elements from where it is entered or resumed, in the direction of travel.
        path: Vec<Segment>,
        /// Marks instead of cutting through.
        mark: bool,
    },
}

/// What a plan adds up to. Lengths mm, times s.
#[derive(Clone, Debug, PartialEq, Default, serde::Serialize)]
pub struct Summary {
    /// Contours worked.
    pub contours: u32,
    /// Of them open.
    pub open_contours: u32,
    /// Parts.
    pub parts: u32,
    /// Piercings.
    pub pierces: u32,
    /// Pre-cuts.
    pub pre_cuts: u32,
    /// Length of cuts and marks.
    pub cut_length: f64,
    /// Length of air moves.
    pub air_length: f64,
    /// Seconds along contours, by look-ahead over corners and acceleration.
    pub cut_time: f64,
    /// Seconds of air moves.
    pub air_time: f64,
    /// Seconds of piercing, with beam delays.
    pub pierce_time: f64,
    /// Seconds of pre-cuts.
    pub pre_cut_time: f64,
    /// Seconds of sharp-corner macros.
    pub macro_time: f64,
    /// All of it.
    pub total_time: f64,
    /// Total no plan can be under, s; 0 when not computed.
    pub lower_bound: f64,
    /// (total - bound) / bound; `None` when there is no bound.
    pub gap: Option<f64>,
    /// Box of everything worked: xmin, ymin, xmax, ymax.
    pub bounds: [f64; 4],
}

impl Summary {
    /// Takes in a lower bound of the total, s; 0: none. One above it is off by rounding: the plan is optimal.
    pub fn set_bound(&mut self, bound: f64) {
        if bound > 0.0 {
            self.lower_bound = bound.min(self.total_time);
            self.gap = Some((self.total_time - self.lower_bound) / self.lower_bound);
        }
    }
}

/// Moves and what they add up to.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// In order.
    pub moves: Vec<Move>,
    /// Sums.
    pub summary: Summary,
}
