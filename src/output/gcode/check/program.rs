//! A program as the check follows it: what the head and the beam do, line by line.

use super::beam::Power;
use crate::geometry::Segment;

/// What the head does.
#[derive(Clone, Debug)]
pub(super) enum Event {
    /// Moves.
    Move {
        line: u32,
        rapid: bool,
        path: Segment,
        power: Power,
        /// mm/s.
        feed: f64,
        /// Whether the head is lifted at the end.
        lifted: bool,
    },
    /// Rises or is lowered at its place with the beam off. `distance`: mm; 0 for lifts, which are part of the air moves.
    Height { line: u32, power: Power, distance: f64 },
    /// Stands still.
    Dwell { line: u32, seconds: f64, power: Power },
    /// A comment of Kerfway's says that another contour begins, which is cut or marked.
    Contour { mark: bool },
}

/// A program that was followed to its end.
#[derive(Debug, Default)]
pub(super) struct Program {
    pub(super) events: Vec<Event>,
    pub(super) comments: Vec<String>,
    /// The powers that lines set, with their lines.
    pub(super) powers: Vec<(u32, f64)>,
    /// Number of lines.
    pub(super) lines: u32,
    /// The commands without comments, in order: as many of the last as the footer has lines.
    pub(super) tail: Vec<String>,
    /// Whether the beam is off at the end.
    pub(super) dark_at_end: bool,
    /// Whether the first motion is relative, so that it begins where the job does.
    pub(super) begins_relative: bool,
    /// How often the head is lifted above the height at which it cuts first.
    pub(super) lifts: u32,
}
