//! Elements and chains: the data between shapes and contours.
//!
//! An [`Element`] is one line or arc with the shape and layer it came from. A [`Chain`] is a run of elements that were
//! drawn joined bit for bit: an unchanged polyline is one chain, and a LINE is a chain of one element. Both are stored
//! in flat lists ([`Chains`]), so 200,000 loose lines need no allocation each.

use crate::geometry::{DVec2, Path, Segment};
use std::ops::Range;

/// Distances up to this are rounding, mm. Files have six decimals at best, and a double resolves 1e-12 on sheets under
/// 10 m. Ends this close are one point and are joined without a finding.
pub(super) const ROUNDING: f64 = 1e-6;

/// One line or arc between shape and contour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    /// The geometry, in the direction in which the shape was drawn.
    pub(super) segment: Segment,
    /// Index of the shape in the drawing.
    pub(super) shape: u32,
    /// Index of its layer.
    pub(super) layer: u32,
}

/// A run of elements joined bit for bit.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Range of its elements in [`Chains::elements`].
    pub(super) elements: Range<usize>,
    /// Whether the last end is the first start.
    pub(super) closed: bool,
    /// Whether a neighbouring part was removed because it lies along another element.
    pub(super) left_over: bool,
    /// If it is the rest of a closed shape, the index of the shape in [`Chains::outlines`].
    pub(super) rest_of: Option<u32>,
}

/// All elements of one operation, as chains in drawing order.
#[derive(Clone, Debug, Default)]
pub(super) struct Chains {
    /// Elements, chain after chain.
    pub(super) elements: Vec<Element>,
    /// Chains in drawing order.
    pub(super) chains: Vec<Chain>,
    /// Closed shapes that lost a part because it lies along another one.
    pub(super) outlines: Vec<Path>,
    /// Closed shapes that lost everything: copies of others, and shapes all of whose sides are shared.
    pub(super) covered: Vec<Vec<Element>>,
}

impl Chains {
    /// The elements of a chain.
    pub(super) fn of(&self, chain: &Chain) -> &[Element] {
        &self.elements[chain.elements.clone()]
    }
}

/// The element with its start moved to `p`. An arc keeps its centre and sweep, so the move must be within [`ROUNDING`].
pub(super) fn with_start(s: Segment, p: DVec2) -> Segment {
    match s {
        Segment::Line(l) => Segment::line(p, l.end),
        Segment::Arc(mut a) => {
            a.start = p;
            Segment::Arc(a)
        }
    }
}

/// The element with its end moved to `p`, like [`with_start`].
pub(super) fn with_end(s: Segment, p: DVec2) -> Segment {
    with_start(s.reversed(), p).reversed()
}
