//! The search for contacts: what lies near a place of a chain, and the nodes so far.

use super::super::joined::{Joined, Role};
use crate::geometry::{Aabb, BoxIndex, Budget, DVec2, Union};
use crate::order::{real, sort_by};
use crate::sheet::element::{Element, ROUNDING};

/// Number of boxes visited per element on average, and for a small drawing in total. Real networks need a few for each
/// element; a star of thousands of lines from one point needs thousands.
const BOXES_PER_ELEMENT: usize = 60;
const MIN_BOXES: usize = 500_000;
/// Number of pairs of candidates intersected per element on average, and for a small drawing in total. A perforated sheet drawn as 250 lines each
/// way has 62,500 crossings, and takes 3.5 s and 370 MB with its first plan; the least number allows half as much again.
const PAIRS_PER_ELEMENT: usize = 8;
const MIN_PAIRS: usize = 100_000;
/// A place within this fraction of an element's length from its end is not moved to that end, however short the element.
const MAX_SNAP: f64 = 0.25;

/// A place on a chain: the element, and the fraction along it, less than 1. The end of an open chain is the start of the
/// element after its last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::sheet::assemble::network) struct Place {
    pub(in crate::sheet::assemble::network) element: usize,
    pub(in crate::sheet::assemble::network) fraction: f64,
}

/// A place where a chain has a node.
#[derive(Clone, Copy, Debug)]
pub(in crate::sheet::assemble::network) struct Break {
    pub(in crate::sheet::assemble::network) chain: u32,
    pub(in crate::sheet::assemble::network) place: Place,
    pub(in crate::sheet::assemble::network) node: u32,
}

/// An element of a chain.
#[derive(Clone, Copy)]
pub(super) struct At {
    pub(super) chain: u32,
    pub(super) element: usize,
}

pub(super) struct Search<'a> {
    pub(super) joined: &'a Joined<'a>,
    pub(super) elements: Vec<At>,
    index: BoxIndex,
    /// The first node of each chain end is its own number; others follow.
    pub(super) union: Union,
    pub(super) sets: Union,
    pub(super) breaks: Vec<Break>,
    pub(super) boxes: Budget,
    pub(super) pairs: Budget,
    /// Where the first of the budgets was used up.
    pub(super) stopped: Option<TooMany>,
}

/// The search for contacts stopped, because there are more lines over each other than it compares.
#[derive(Clone, Copy, Debug)]
pub(in crate::sheet::assemble) struct TooMany {
    /// Number of pairs that it compares.
    pub(in crate::sheet::assemble) limit: usize,
    /// A place where it stopped.
    pub(in crate::sheet::assemble) at: DVec2,
}

impl TooMany {
    /// Whether a budget is spent, at a place.
    pub(super) fn spent(budget: &Budget, at: DVec2) -> Option<Self> {
        budget.is_spent().then_some(Self { limit: budget.limit, at })
    }
}

impl<'a> Search<'a> {
    pub(super) fn new(joined: &'a Joined<'a>) -> Self {
        let chains = &joined.chains.chains;
        let mut elements = Vec::with_capacity(joined.chains.elements.len());
        for (chain, c) in (0_u32..).zip(chains) {
            elements.extend((0..c.elements.len()).map(|element| At { chain, element }));
        }
        let of = |at: &At| &joined.chains.elements[chains[at.chain as usize].elements.start + at.element];
        let index = BoxIndex::new(elements.iter().map(|at| of(at).segment.bounds()));
        let n = elements.len();
        Self {
            joined,
            index,
            union: Union::new(2 * chains.len()),
            sets: Union::new(chains.len()),
            breaks: Vec::new(),
            boxes: Budget::new((BOXES_PER_ELEMENT * n).max(MIN_BOXES)),
            pairs: Budget::new((PAIRS_PER_ELEMENT * n).max(MIN_PAIRS)),
            stopped: None,
            elements,
        }
    }

    pub(super) fn of(&self, chain: u32) -> &'a [Element] {
        self.joined.chain(chain).map_or(&[], |c| self.joined.chains.of(c))
    }

    pub(super) fn new_node(&mut self) -> u32 {
        self.union.add()
    }

    /// The chains and places within the tolerance of a point.
    pub(super) fn around(&mut self, p: DVec2) -> Vec<(u32, Place)> {
        let tolerance = self.joined.tolerance.max(ROUNDING);
        let mut found = Vec::new();
        let mut boxes = self.boxes;
        self.index.visit(Aabb::of(p).grown(tolerance), |k| {
            found.push(self.elements[k]);
            boxes.take()
        });
        self.boxes = boxes;
        self.stopped = self.stopped.or_else(|| TooMany::spent(&boxes, p));
        let mut places: Vec<(u32, Place)> = found
            .into_iter()
            .filter_map(|at| {
                let (fraction, d2) = self.of(at.chain).get(at.element)?.segment.nearest(p);
                let near = d2 <= tolerance * tolerance;
                near.then(|| (at.chain, self.place(at, fraction)))
            })
            .collect();
        sort_by(&mut places, |(c, at)| [(*c).into(), at.element as u64, real(at.fraction)]);
        places.dedup();
        places
    }

    /// A place on an element, moved to an end of it that is within the tolerance.
    pub(super) fn place(&self, at: At, fraction: f64) -> Place {
        let elements = self.of(at.chain);
        let length = elements.get(at.element).map_or(0.0, |e| e.segment.length());
        let closed = self.joined.chain(at.chain).is_some_and(|c| c.closed);
        let snap = self.joined.tolerance.max(ROUNDING).min(MAX_SNAP * length);
        // The start of a full circle is no corner.
        let seamless = closed && elements.len() == 1;
        if fraction * length <= snap && !seamless {
            Place { element: at.element, fraction: 0.0 }
        } else if (1.0 - fraction) * length <= snap && !seamless {
            let next = at.element + 1;
            Place { element: if closed && next == elements.len() { 0 } else { next }, fraction: 0.0 }
        } else if fraction >= 1.0 {
            Place { element: at.element, fraction: 0.0 }
        } else {
            Place { element: at.element, fraction }
        }
    }

    /// The node at a place of a chain: that of its end, or `node`, which the chain gets there.
    pub(super) fn at(&mut self, chain: u32, place: Place, node: u32) -> u32 {
        let closed = self.joined.chain(chain).is_some_and(|c| c.closed);
        let n = self.of(chain).len();
        match place {
            Place { element: 0, fraction } if !closed && fraction <= 0.0 => 2 * chain,
            Place { element, .. } if !closed && element == n => 2 * chain + 1,
            _ => {
                self.breaks.push(Break { chain, place, node });
                node
            }
        }
    }

    pub(super) fn is_end(&self, chain: u32, place: Place) -> bool {
        let closed = self.joined.chain(chain).is_some_and(|c| c.closed);
        !closed && place.fraction <= 0.0 && (place.element == 0 || place.element == self.of(chain).len())
    }

    /// For the first chain of each set, whether the set holds anything to be found.
    pub(super) fn active(&mut self, touched: &[u32]) -> Vec<bool> {
        let mut active = vec![false; self.joined.roles.len()];
        for (chain, role) in (0_u32..).zip(&self.joined.roles) {
            active[self.sets.root(chain) as usize] |= matches!(role, Role::Candidate | Role::Rest(_));
        }
        for &c in touched {
            active[self.sets.root(c) as usize] = true;
        }
        active
    }
}
