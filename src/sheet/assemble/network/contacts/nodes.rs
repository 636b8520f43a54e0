//! The nodes of a network: at the ends of open chains, where chains cross, and where their corners meet.

use super::super::joined::Role;
use super::search::{At, Place, Search, TooMany};
use crate::geometry::{BoxIndex, DVec2, intersect};
use crate::order::sort_by;
use crate::sheet::cluster::cluster;
use crate::sheet::element::{Element, ROUNDING};

/// A chain that returns to its own end within this many tolerances of length does not touch itself there.
const OWN_END: f64 = 4.0;

impl Search<'_> {
    /// Nodes where open chains end.
    pub(super) fn ends(&mut self) {
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
    pub(super) fn crossings(&mut self) {
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
    pub(super) fn corners(&mut self, touched: &[u32]) {
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
}
