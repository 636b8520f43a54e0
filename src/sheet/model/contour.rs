//! A contour: its geometry, its nesting, and what is done with it.

use super::options::Operation;
use crate::geometry::{Aabb, Path};
use crate::machine::PLANS_ALL_LEVERS;

/// Whether a contour is processed before or after all contours that are not pinned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Pin {
    /// Before the others.
    First,
    /// In the order that the search chooses.
    #[default]
    None,
    /// After the others.
    Last,
}

/// A closed or open chain of elements that is cut or marked in one go.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Geometry in mm. A closed path is counter-clockwise for outer contours (even depth) and clockwise for holes.
    pub path: Path,
    /// If it is the open rest of a closed shape because another contour cuts the side they share: the outline of that
    /// shape. It bounds a part or a hole like a closed contour.
    pub outline: Option<Path>,
    /// The outline as drawn, if `path` is offset from it by half the kerf; see [`Sheet`](crate::sheet::Sheet).
    pub drawn: Option<Path>,
    /// Index into [`Sheet::layers`](crate::sheet::Sheet::layers) of the layer that most of its length is on.
    pub layer: u32,
    /// Cut or mark; [`Operation::Ignore`] if it is excluded individually.
    pub operation: Operation,
    /// The smallest cut contour around it that bounds an area.
    pub inside: Option<u32>,
    /// Number of such contours around it.
    pub depth: u32,
    /// Length, mm.
    pub length: f64,
    /// Unsigned area of a closed contour or of its outline, as drawn, mm2; 0 for other open contours.
    pub area: f64,
    /// The smallest box around it.
    pub bounds: Aabb,
    /// Number of its pass, from 0; it counts the passes of the contour that come before it as contours of their own.
    pub pass: u32,
    /// The contour that is the next pass over the same line, if passes are run sheet by sheet and this is not the last.
    pub next_pass: Option<u32>,
    /// Whether it is pinned to be processed first or last.
    pub pin: Pin,
    /// The sequence that it belongs to, and its place in it; see [`SheetOptions::sequences`](crate::sheet::SheetOptions::sequences).
    pub turn: Option<(u32, u32)>,
    /// The group that it belongs to, itself or inside another contour; see [`SheetOptions::together`](crate::sheet::SheetOptions::together).
    pub together: Option<u32>,
    /// Whether it crosses itself, so that its interior is in doubt.
    pub self_crossing: bool,
    /// Smallest index of the shapes it consists of, which gives the drawing order.
    pub first_shape: u32,
    /// If it is the open rest of a closed shape: a number that all rests of that shape share.
    pub rest_of: Option<u32>,
    /// Whether it is a skeleton cut: a straight cut through the waste, after everything else, that nobody drew.
    pub skeleton: bool,
    /// The contour with which this outline is cut, because bridges connect their parts, or itself; see [`Bridged`](crate::sheet::Bridged). Of an open cut the
    /// outline that it completes ([`Contour::completes`]).
    pub bridged: Option<u32>,
}

impl Contour {
    /// Whether it is marked, not cut.
    pub fn is_mark(&self) -> bool {
        self.operation == Operation::Mark
    }

    /// Whether it is cut or marked.
    pub fn is_processed(&self) -> bool {
        self.operation != Operation::Ignore
    }

    /// Of a cut through a bridge, which nobody drew: the outline of the part that it completes where the bridge ends on it.
    pub fn completes(&self) -> Option<u32> {
        if PLANS_ALL_LEVERS && !self.path.closed { self.bridged } else { None }
    }

    /// Whether it is a cut that nobody drew: a skeleton cut, or one through a bridge.
    pub fn is_added(&self) -> bool {
        self.skeleton || self.completes().is_some()
    }

    /// The curve that bounds its area: the path of a closed contour, or the outline that an open contour is the rest
    /// of.
    pub fn boundary(&self) -> Option<&Path> {
        if self.path.closed { Some(&self.path) } else { self.outline.as_ref() }
    }

    /// The outline of the part or hole, if it differs from the path that is cut because that is offset or only a rest.
    pub fn part_outline(&self) -> Option<&Path> {
        let rest_of = self.outline.as_ref().filter(|_| self.operation == Operation::Cut);
        self.drawn.as_ref().or(rest_of)
    }

    /// Whether it is a cut that bounds a part or a hole.
    pub fn bounds_area(&self) -> bool {
        self.operation == Operation::Cut && self.boundary().is_some()
    }
}
