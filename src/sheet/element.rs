//! Elements and chains: what the stages of this folder work on between shapes and contours.
//!
//! An [`Element`] is one line or arc that remembers the shape and layer it came from. A [`Chain`] is a run of
//! elements that are joined bit for bit by birth: an untouched polyline is one chain, a LINE is a chain of one. Both
//! stand in flat lists ([`Chains`]), so 200,000 loose lines cost no allocation each.

use crate::geometry::{DVec2, Path, Segment};
use std::ops::Range;

/// Distances up to this are rounding, mm: files carry six decimals at best, and sheets are under 10 m, where a
/// double still resolves 1e-12. Ends this near are one point and are joined without a word.
pub(super) const ROUNDING: f64 = 1e-6;

/// One line or arc on its way from a shape to a contour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    /// The geometry, in the direction the shape was drawn.
    pub(super) segment: Segment,
    /// Index of the shape in the drawing.
    pub(super) shape: u32,
    /// Index of its layer.
    pub(super) layer: u32,
}

/// A run of elements joined bit for bit.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Where its elements stand in [`Chains::elements`].
    pub(super) elements: Range<usize>,
    /// The last end is the first start.
    pub(super) closed: bool,
    /// Beside it something was taken out that lies along another one.
    pub(super) left_over: bool,
    /// What is left of this one of [`Chains::outlines`].
    pub(super) rest_of: Option<u32>,
}

/// All elements of one operation, in chains, in drawing order.
#[derive(Clone, Debug, Default)]
pub(super) struct Chains {
    /// Elements, chain after chain.
    pub(super) elements: Vec<Element>,
    /// Chains in drawing order.
    pub(super) chains: Vec<Chain>,
    /// Closed shapes of which a part lies along another one and was taken out.
    pub(super) outlines: Vec<Path>,
}

impl Chains {
    /// The elements of a chain.
    pub(super) fn of(&self, chain: &Chain) -> &[Element] {
        &self.elements[chain.elements.clone()]
    }
}

/// The element with its start moved to `p`. An arc keeps centre and sweep: only for moves within [`ROUNDING`].
pub(super) fn with_start(s: Segment, p: DVec2) -> Segment {
    match s {
        Segment::Line(l) => Segment::line(p, l.end),
        Segment::Arc(mut a) => {
            a.start = p;
            Segment::Arc(a)
        }
    }
}

/// The element with its end moved to `p`, as [`with_start`].
pub(super) fn with_end(s: Segment, p: DVec2) -> Segment {
    with_start(s.reversed(), p).reversed()
}
