//! Contacts: where the chains of a network meet.

use super::joined::{Joined, Role};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, Union, intersect};
use crate::order::{real, sort_by};
use crate::sheet::budget::Budget;
use crate::sheet::cluster::cluster;
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
/// A chain that returns to its own end within this many tolerances of length does not touch itself there.
const OWN_END: f64 = 4.0;

/// A place on a chain: the element, and the fraction along it, less than 1. The end of an open chain is the start of the
/// element after its last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) element: usize,
    pub(super) fraction: f64,
}

/// A place where a chain has a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Break {
    pub(super) chain: u32,
    pub(super) place: Place,
    pub(super) node: u32,
}

/// The nodes of all chains that meet.
pub(super) struct Net {
    /// Sorted by chain, then by place. Every place is listed once.
    pub(super) breaks: Vec<Break>,
    /// For each chain the connected set that it belongs to, by number of its first chain.
    pub(super) set: Vec<u32>,
    /// Whether the sets hold anything to be found, by number of the first chain.
    pub(super) active: Vec<bool>,
}

impl Net {
    /// The net; where the search stopped if there are too many lines over each other.
    pub(super) fn new(joined: &Joined, covered: &[Path]) -> Result<Self, TooMany> {
        let mut search = Search::new(joined);
        search.ends();
        search.crossings();
        let mut touched = Vec::new();
        for outline in covered {
            let mut first = None;
            for corner in outline.segments.iter().map(Segment::start) {
                let node = search.new_node();
                for (chain, place) in search.around(corner) {
                    let node_of = search.at(chain, place, node);
                    search.union.join(node, node_of);
                    search.sets.join(chain, *first.get_or_insert(chain));
                }
            }
            touched.extend(first);
        }
        search.corners(&touched);
        search.finish(&touched)
    }
}

/// An element of a chain.
#[derive(Clone, Copy)]
struct At {
    chain: u32,
    element: usize,
}

struct Search<'a> {
    joined: &'a Joined<'a>,
    elements: Vec<At>,
    index: BoxIndex,
    /// The first node of each chain end is its own number; others follow.
    union: Union,
    sets: Union,
    breaks: Vec<Break>,
    boxes: Budget,
    pairs: Budget,
    /// Where the first of the budgets was used up.
    stopped: Option<TooMany>,
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
    fn spent(budget: &Budget, at: DVec2) -> Option<Self> {
        budget.is_spent().then_some(Self { limit: budget.limit, at })
    }
}

impl<'a> Search<'a> {
    fn new(joined: &'a Joined<'a>) -> Self {
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

    fn of(&self, chain: u32) -> &'a [Element] {
        self.joined.chain(chain).map_or(&[], |c| self.joined.chains.of(c))
    }

    fn new_node(&mut self) -> u32 {
        self.union.add()
    }

    /// The chains and places within the tolerance of a point.
    fn around(&mut self, p: DVec2) -> Vec<(u32, Place)> {
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
    fn place(&self, at: At, fraction: f64) -> Place {
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
    fn at(&mut self, chain: u32, place: Place, node: u32) -> u32 {
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

    /// Nodes where open chains end.
    fn ends(&mut self) {
        let points: Vec<DVec2> = (0..self.joined.mates.len()).map(|end| self.point(end)).collect();
        // Ends in one point ask for its surroundings once.
        let point_of = cluster(&points, 2.0 * ROUNDING);
        let mut asked: Vec<Option<u32>> = vec![None; points.len()];
        for (end, &mate) in (0_u32..).zip(self.joined.mates) {
            let chain = end / 2;
            match self.joined.roles.get(chain as usize) {
                Some(Role::Candidate | Role::Rest(_)) => {}
                // Loops are closed, so their ends only need to know each other.
                Some(Role::Loop(_)) if mate != u32::MAX => {
                    self.union.join(end, mate);
                    self.sets.join(chain, mate / 2);
                    continue;
                }
                _ => continue,
            }
            if mate != u32::MAX {
                self.union.join(end, mate);
                self.sets.join(chain, mate / 2);
            }
            if let Some(first) = asked[point_of[end as usize] as usize] {
                self.union.join(first, end);
                self.sets.join(first / 2, chain);
                continue;
            }
            asked[point_of[end as usize] as usize] = Some(end);
            for (other, place) in self.around(points[end as usize]) {
                if other == chain && self.is_own_end(chain, end % 2 == 1, place) {
                    continue;
                }
                let node = self.at(other, place, end);
                self.union.join(end, node);
                self.sets.join(chain, other);
            }
        }
        // The rests of one shape belong together.
        let mut first: Vec<Option<u32>> = vec![None; self.joined.chains.outlines.len()];
        for (chain, role) in (0_u32..).zip(&self.joined.roles) {
            if let Role::Rest(of) = role
                && let Some(first) = first.get_mut(*of as usize)
            {
                self.sets.join(chain, *first.get_or_insert(chain));
            }
        }
    }

    /// The place of a chain end.
    fn point(&self, end: usize) -> DVec2 {
        let elements = u32::try_from(end / 2).map_or(&[][..], |chain| self.of(chain));
        let at = match end % 2 {
            0 => elements.first().map(|e| e.segment.start()),
            _ => elements.last().map(|e| e.segment.end()),
        };
        at.unwrap_or_default()
    }

    /// Whether a place of a chain is so near to its end along the chain that the end does not touch it there.
    fn is_own_end(&self, chain: u32, last: bool, place: Place) -> bool {
        let elements = self.of(chain);
        let least = OWN_END * self.joined.tolerance.max(ROUNDING);
        let length = |range: &[Element]| range.iter().map(|e| e.segment.length()).sum::<f64>();
        let part = elements.get(place.element).map_or(0.0, |e| e.segment.length() * place.fraction);
        let from = if last { place.element..elements.len() } else { 0..place.element };
        // Only a few elements need to be measured.
        let mut along = if last { -part } else { part };
        for e in elements.get(from).unwrap_or(&[]) {
            along += length(std::slice::from_ref(e));
            if along > least {
                return false;
            }
        }
        along <= least
    }

    /// Nodes where candidates cross or touch each other away from their ends.
    fn crossings(&mut self) {
        let is_candidate = |at: &At| self.joined.roles[at.chain as usize] == Role::Candidate;
        let candidates: Vec<At> = self.elements.iter().copied().filter(is_candidate).collect();
        let segment = |at: At| self.of(at.chain).get(at.element).map(|e| e.segment);
        let index = BoxIndex::new(candidates.iter().filter_map(|&at| segment(at)).map(|s| s.bounds()));
        let tolerance = self.joined.tolerance.max(ROUNDING);
        let mut found: Vec<(At, f64, At, f64)> = Vec::new();
        let (mut boxes, mut pairs) = (self.boxes, self.pairs);
        for (i, &a) in candidates.iter().enumerate() {
            let Some(first) = segment(a) else { continue };
            index.visit(first.bounds(), |j| {
                let mut goes_on = boxes.take();
                if j > i
                    && let Some(second) = segment(candidates[j])
                {
                    goes_on &= pairs.take();
                    let meetings = intersect(&first, &second, tolerance).points;
                    found.extend(meetings.into_iter().map(|m| (a, m.a, candidates[j], m.b)));
                }
                goes_on
            });
            let at = first.at(0.5);
            if let Some(stopped) = TooMany::spent(&boxes, at).or_else(|| TooMany::spent(&pairs, at)) {
                self.stopped = self.stopped.or(Some(stopped));
                return;
            }
        }
        for (a, fa, b, fb) in found {
            let (pa, pb) = (self.place(a, fa), self.place(b, fb));
            // Ends have been found already; neighbours meet in their common corner.
            if self.is_end(a.chain, pa) || self.is_end(b.chain, pb) || (a.chain == b.chain && pa == pb) {
                continue;
            }
            let node = self.new_node();
            self.at(a.chain, pa, node);
            self.at(b.chain, pb, node);
            self.sets.join(a.chain, b.chain);
        }
    }

    /// Nodes where corners of different chains meet although neither chain ends there.
    fn corners(&mut self, touched: &[u32]) {
        let active = self.active(touched);
        let mut corners: Vec<(u32, Place)> = Vec::new();
        let mut points: Vec<DVec2> = Vec::new();
        for (chain, c) in (0_u32..).zip(&self.joined.chains.chains) {
            let elements = self.joined.chains.of(c);
            // The start of a full circle is no corner.
            if !active[self.sets.root(chain) as usize] || (c.closed && elements.len() == 1) {
                continue;
            }
            for (element, e) in elements.iter().enumerate() {
                corners.push((chain, Place { element, fraction: 0.0 }));
                points.push(e.segment.start());
            }
        }
        let at = cluster(&points, 2.0 * ROUNDING);
        let mut order: Vec<usize> = (0..corners.len()).collect();
        sort_by(&mut order, |&k| [at[k].into(), k as u64, 0]);
        for group in order.chunk_by(|a, b| at[*a] == at[*b]) {
            let (first, _) = corners[group[0]];
            if group.iter().all(|&k| corners[k].0 == first) {
                continue;
            }
            let node = self.new_node();
            for &k in group {
                let (chain, place) = corners[k];
                let own = self.at(chain, place, node);
                self.union.join(node, own);
                self.sets.join(first, chain);
            }
        }
    }

    /// For the first chain of each set, whether the set holds anything to be found.
    fn active(&mut self, touched: &[u32]) -> Vec<bool> {
        let mut active = vec![false; self.joined.roles.len()];
        for (chain, role) in (0_u32..).zip(&self.joined.roles) {
            active[self.sets.root(chain) as usize] |= matches!(role, Role::Candidate | Role::Rest(_));
        }
        for &c in touched {
            active[self.sets.root(c) as usize] = true;
        }
        active
    }

    fn is_end(&self, chain: u32, place: Place) -> bool {
        let closed = self.joined.chain(chain).is_some_and(|c| c.closed);
        !closed && place.fraction <= 0.0 && (place.element == 0 || place.element == self.of(chain).len())
    }

    /// Unites the nodes at equal places and adds the ends of open chains.
    fn finish(mut self, touched: &[u32]) -> Result<Net, TooMany> {
        if let Some(stopped) = self.stopped {
            return Err(stopped);
        }
        let joined = self.joined;
        for (chain, c) in (0_u32..).zip(&joined.chains.chains) {
            if !c.closed {
                let end = Place { element: c.elements.len(), fraction: 0.0 };
                let start = Place { element: 0, fraction: 0.0 };
                self.breaks.push(Break { chain, place: start, node: 2 * chain });
                self.breaks.push(Break { chain, place: end, node: 2 * chain + 1 });
            }
        }
        sort_by(&mut self.breaks, |b| [b.chain.into(), b.place.element as u64, real(b.place.fraction)]);
        let mut breaks: Vec<Break> = Vec::with_capacity(self.breaks.len());
        for b in std::mem::take(&mut self.breaks) {
            let length = |b: &Break| {
                let element = self.of(b.chain).get(b.place.element);
                b.place.fraction * element.map_or(0.0, |e| e.segment.length())
            };
            match breaks.last() {
                Some(last)
                    if last.chain == b.chain
                        && last.place.element == b.place.element
                        && length(&b) - length(last) <= 2.0 * ROUNDING =>
                {
                    self.union.join(last.node, b.node);
                }
                _ => breaks.push(b),
            }
        }
        for b in &mut breaks {
            b.node = self.union.root(b.node);
        }
        let n = joined.chains.chains.len();
        let set: Vec<u32> = (0..).take(n).map(|c| self.sets.root(c)).collect();
        let active = self.active(touched);
        Ok(Net { breaks, set, active })
    }
}
