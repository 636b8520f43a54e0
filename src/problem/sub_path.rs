//! A path through a pierce group: what the head does from the place where it arrives to the place where it leaves.
//!
//! The paths of a group are the nodes of its item. A solver of groups (`solve::pierce_group`) finds them; the solvers of
//! whole problems look at their ends and seconds only, and the plan writes their strokes out.

use crate::geometry::{DVec2, Segment};

/// A path through all of a pierce group.
#[derive(Clone, Debug, PartialEq)]
pub struct SubPath {
    /// Where the head arrives and leaves, mm.
    pub ends: [DVec2; 2],
    /// What the head does in between.
    pub strokes: Vec<Stroke>,
    /// The seconds of all strokes together.
    pub seconds: f64,
}

impl SubPath {
    /// The stretches of contours that it cuts, in order.
    pub fn spans(&self) -> impl Iterator<Item = &Span> {
        self.strokes
            .iter()
            .flat_map(|s| if let Stroke::Cut { spans, .. } = s { spans.as_slice() } else { &[] })
    }
}

/// One action of the head in a group.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// Moves through the air to a point, mm.
    Air(DVec2),
    /// Pierces.
    Pierce,
    /// Cuts the beginning of a later stretch in advance, from where the head is.
    PreCut {
        /// The contour it is on.
        contour: u32,
        /// What is cut; empty where pre-cuts have no length.
        ahead: Vec<Segment>,
    },
    /// Cuts along elements of the group.
    Cut {
        /// The stretches of contours, in order.
        spans: Vec<Span>,
        /// The geometry of all of them, in the direction of travel.
        path: Vec<Segment>,
    },
}

/// A stretch of a contour in the direction of travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Its contour.
    pub contour: u32,
    /// Arc length from the contour's stored start to where the stretch is entered, mm.
    pub along: f64,
    /// Arc length from the contour's stored start to where the stretch is left, mm.
    pub until: f64,
    /// Runs against the contour's stored direction.
    pub reversed: bool,
    /// Length, mm.
    pub length: f64,
    /// Number of segments of the path that belong to it.
    pub elements: usize,
}
