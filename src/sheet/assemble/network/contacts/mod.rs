//! Contacts: where the chains of a network meet. A contact is a node of the network; chains with contacts belong to one set.
//!
//! Open chains have nodes at their ends, and where the ends of others touch them; chains that may be parts of several contours also where they
//! cross each other (`nodes.rs`). `search.rs` finds what lies near a place, within a budget.

mod nodes;
mod search;

use super::joined::Joined;
use crate::geometry::{Path, Segment};
use crate::order::{real, sort_by};
use crate::sheet::element::ROUNDING;
pub(super) use search::Place;
pub(in crate::sheet::assemble) use search::TooMany;
use search::{Break, Search};

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

impl Search<'_> {
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
