//! The ends of chains, and which of them are joined.

use super::super::cluster::cluster;
use super::super::element::{Chains, ROUNDING};
use crate::geometry::DVec2;
use crate::order::{Key, sort_by};

/// No end, as the partner of a free end.
pub(super) const NONE: u32 = u32::MAX;

/// The ends of all chains. Chain `c` starts at end `2 c` and ends at end `2 c + 1`.
pub(super) struct Ends {
    /// Position of each end, mm.
    pub(super) point: Vec<DVec2>,
    /// Unit direction out of the chain at each end.
    pub(super) out: Vec<DVec2>,
    /// Layer of the element at each end.
    pub(super) layer: Vec<u32>,
    /// Index of the shape of the element at each end.
    pub(super) shape: Vec<u32>,
    /// The end it is joined to, or [`NONE`]. The ends of closed chains count as joined to themselves.
    pub(super) mate: Vec<u32>,
    /// For a free end: the free end at the other side of all chains joined to it so far.
    pub(super) far: Vec<u32>,
    /// For a free end: the length of those chains, mm.
    pub(super) length: Vec<f64>,
    /// Whether more than two ends meet here. A finding has already reported that.
    pub(super) at_branch: Vec<bool>,
    /// Whether no other end is near enough to be joined to it.
    pub(super) isolated: Vec<bool>,
    /// For an end of the rest of a closed shape: the index of that shape's outline. Such an end is joined only to other
    /// rests of the same shape.
    pub(super) rest_of: Vec<Option<u32>>,
}

impl Ends {
    pub(super) fn new(chains: &Chains, tolerance: f64) -> Self {
        let n = chains.chains.len() * 2;
        let mut ends = Self {
            point: Vec::with_capacity(n),
            out: Vec::with_capacity(n),
            layer: Vec::with_capacity(n),
            shape: Vec::with_capacity(n),
            mate: Vec::with_capacity(n),
            far: Vec::with_capacity(n),
            length: Vec::with_capacity(n),
            at_branch: vec![false; n],
            isolated: Vec::new(),
            rest_of: Vec::with_capacity(n),
        };
        let mut next = 0_u32;
        for chain in &chains.chains {
            // Chains are never empty, because cleaning builds each around an element that it keeps.
            let ([first, .., last] | [first @ last]) = chains.of(chain) else { continue };
            let length = chains.of(chain).iter().map(|e| e.segment.length()).sum();
            let (start, end) = (next, next + 1);
            for (element, point, out, own, far) in [
                (first, first.segment.start(), -first.segment.tangent(0.0), start, end),
                (last, last.segment.end(), last.segment.tangent(1.0), end, start),
            ] {
                ends.point.push(point);
                ends.out.push(out);
                ends.layer.push(element.layer);
                ends.shape.push(element.shape);
                ends.mate.push(if chain.closed { own } else { NONE });
                ends.far.push(far);
                ends.length.push(length);
                ends.rest_of.push(chain.rest_of);
            }
            next += 2;
        }
        ends.find_isolated(tolerance);
        ends
    }

    pub(super) fn find_isolated(&mut self, tolerance: f64) {
        let together = cluster(&self.point, 2.0 * tolerance.max(ROUNDING));
        let mut size = vec![0_u32; self.point.len()];
        for &c in &together {
            size[c as usize] += 1;
        }
        self.isolated = together.iter().map(|&c| size[c as usize] == 1).collect();
    }

    /// Whether no chain continues at the other side of this end.
    pub(super) fn is_tail(&self, end: u32) -> bool {
        self.isolated[self.far[end as usize] as usize]
    }

    pub(super) fn free(&self, end: u32) -> bool {
        self.mate[end as usize] == NONE
    }

    /// All free ends, in ascending order.
    pub(super) fn all_free(&self) -> Vec<u32> {
        (0_u32..).zip(&self.mate).filter(|(_, m)| **m == NONE).map(|(e, _)| e).collect()
    }

    pub(super) fn gap(&self, a: u32, b: u32) -> f64 {
        self.point[a as usize].distance(self.point[b as usize])
    }

    /// Whether both ends belong to ordinary chains, or both to rests of the same shape.
    pub(super) fn compatible(&self, a: u32, b: u32) -> bool {
        self.rest_of[a as usize] == self.rest_of[b as usize]
    }

    /// Whether two ends may be joined. A chain may close on itself only when it is clearly longer than the gap, so that
    /// a short line is not folded onto itself.
    pub(super) fn may_join(&self, a: u32, b: u32) -> bool {
        let closes = self.far[a as usize] == b;
        a != b
            && self.compatible(a, b)
            && self.free(a)
            && self.free(b)
            && (!closes || self.length[a as usize] > 4.0 * self.gap(a, b))
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (x, y) = (self.far[a as usize], self.far[b as usize]);
        let length = self.length[a as usize] + self.length[b as usize];
        self.mate[a as usize] = b;
        self.mate[b as usize] = a;
        self.far[x as usize] = y;
        self.far[y as usize] = x;
        self.length[x as usize] = length;
        self.length[y as usize] = length;
    }

    /// Rank of a join among those of equal distance; the smallest is best. A join on one layer comes first, then the
    /// straighter continuation (0 straight on, 2 straight back, in steps of 1e-9 so that rounding does not decide). The
    /// layer comes first because contours of different layers often touch in a corner with sides in line, and are still
    /// two contours. Remaining ties are decided by drawing order.
    pub(super) fn preference(&self, a: u32, b: u32) -> [u64; 2] {
        let (i, j) = (a as usize, b as usize);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 2e9")]
        let bend = ((1.0 + self.out[i].dot(self.out[j])) * 1e9).round() as u64;
        let other_layer = u64::from(self.layer[i] != self.layer[j]);
        [other_layer << 32 | bend, u64::from(a.min(b)) << 32 | u64::from(a.max(b))]
    }

    /// Joins the pairs in the order of their keys, as long as both ends are still free.
    pub(super) fn join_in_order(&mut self, mut pairs: Vec<(Key, u32, u32)>) {
        sort_by(&mut pairs, |p| p.0);
        for (_, a, b) in pairs {
            if self.may_join(a, b) {
                self.join(a, b);
            }
        }
    }
}
