//! Assembly: chains joined end to end into contours, best match first.
//!
//! 1. **Points** ([`node`]). Ends within rounding of each other are one point. Two ends that meet alone are joined.
//!    Where more than two meet, a *branch*, chains that come back to the point are closed first; then chains that
//!    lead on are paired before those that lead nowhere, those of one layer before others, the straightest first.
//!    What is left over stays open, so all length is still cut.
//! 2. **Gaps** ([`gaps`]). Ends still free are joined over gaps up to the tolerance, globally by ascending distance,
//!    never first come first served; equal distances by same layer, then by the straighter continuation.
//! 3. **Trace** ([`trace`]). Joined chains are walked into paths whose elements meet bit for bit.
//!
//! An end that touches the middle of another contour is no join. Work is bounded whatever the drawing: points are
//! united in linear time, at a branch of n ends O(n log n) pairs are looked at, and gaps are closed in rising steps
//! of distance, each of which leaves free ends too far apart to crowd the next one.

mod close;
mod gaps;
mod node;
mod trace;

use super::cluster::cluster;
use super::element::{Chains, ROUNDING};
use crate::dxf::Drawing;
use crate::finding::Findings;
use crate::geometry::DVec2;
use crate::order::{Key, sort_by};

pub(super) use trace::Assembled;

/// No end.
const NONE: u32 = u32::MAX;

/// Joins the chains. `tolerance` in mm.
pub(super) fn assemble(
    drawing: &Drawing,
    chains: &Chains,
    tolerance: f64,
    findings: &mut Findings,
) -> Vec<Assembled> {
    let mut ends = Ends::new(chains, tolerance);
    let branches = node::join(&mut ends);
    gaps::join(&mut ends, tolerance);
    gaps::report(drawing, &ends, &branches, tolerance, findings);
    trace::contours(drawing, chains, &ends, tolerance, findings)
}

/// The ends of all chains: chain `c` starts at end `2 c` and ends at end `2 c + 1`.
struct Ends {
    /// Where, mm.
    point: Vec<DVec2>,
    /// Unit direction out of the chain.
    out: Vec<DVec2>,
    /// Layer of the element there.
    layer: Vec<u32>,
    /// Index of the shape of the element there.
    shape: Vec<u32>,
    /// The end it is joined to, or [`NONE`]; closed chains count as joined to themselves.
    mate: Vec<u32>,
    /// For a free end: the free end at the far side of all that is joined to it so far.
    far: Vec<u32>,
    /// For a free end: the length up to there, mm.
    length: Vec<f64>,
    /// More than two ends meet here: told already.
    at_branch: Vec<bool>,
    /// No other end is near enough to be joined to.
    lonely: Vec<bool>,
    /// What is left of a closed shape joins nothing else.
    rest_of: Vec<Option<u32>>,
}

impl Ends {
    fn new(chains: &Chains, tolerance: f64) -> Self {
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
            lonely: Vec::new(),
            rest_of: Vec::with_capacity(n),
        };
        let mut next = 0_u32;
        for chain in &chains.chains {
            // Chains are never empty: cleaning makes one around each element it keeps.
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
        ends.find_lonely(tolerance);
        ends
    }

    fn find_lonely(&mut self, tolerance: f64) {
        let together = cluster(&self.point, 2.0 * tolerance.max(ROUNDING));
        let mut size = vec![0_u32; self.point.len()];
        for &c in &together {
            size[c as usize] += 1;
        }
        self.lonely = together.iter().map(|&c| size[c as usize] == 1).collect();
    }

    /// Whether the chain at this end leads nowhere.
    fn is_tail(&self, end: u32) -> bool {
        self.lonely[self.far[end as usize] as usize]
    }

    fn free(&self, end: u32) -> bool {
        self.mate[end as usize] == NONE
    }

    /// All free ends in order.
    fn all_free(&self) -> Vec<u32> {
        (0_u32..).zip(&self.mate).filter(|(_, m)| **m == NONE).map(|(e, _)| e).collect()
    }

    fn gap(&self, a: u32, b: u32) -> f64 {
        self.point[a as usize].distance(self.point[b as usize])
    }

    /// Whether two ends are both of ordinary chains, or of rests of one shape.
    fn akin(&self, a: u32, b: u32) -> bool {
        self.rest_of[a as usize] == self.rest_of[b as usize]
    }

    /// Whether two ends may be joined. A chain may close on itself only when it is clearly longer than the gap:
    /// otherwise a short line would be folded onto itself.
    fn may_join(&self, a: u32, b: u32) -> bool {
        let closes = self.far[a as usize] == b;
        a != b
            && self.akin(a, b)
            && self.free(a)
            && self.free(b)
            && (!closes || self.length[a as usize] > 4.0 * self.gap(a, b))
    }

    fn join(&mut self, a: u32, b: u32) {
        let (x, y) = (self.far[a as usize], self.far[b as usize]);
        let length = self.length[a as usize] + self.length[b as usize];
        self.mate[a as usize] = b;
        self.mate[b as usize] = a;
        self.far[x as usize] = y;
        self.far[y as usize] = x;
        self.length[x as usize] = length;
        self.length[y as usize] = length;
    }

    /// How two ends rank among matches of equal distance, the least being best: same layer before another one,
    /// then the straighter continuation (0 straight on, 2 straight back, in steps of 1e-9 so that the last bit does
    /// not decide), then drawing order. The layer comes first because two contours of different layers often touch
    /// in a corner with sides in line, and are two contours all the same.
    fn preference(&self, a: u32, b: u32) -> [u64; 2] {
        let (i, j) = (a as usize, b as usize);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 2e9")]
        let bend = ((1.0 + self.out[i].dot(self.out[j])) * 1e9).round() as u64;
        let other_layer = u64::from(self.layer[i] != self.layer[j]);
        [other_layer << 32 | bend, u64::from(a.min(b)) << 32 | u64::from(a.max(b))]
    }

    /// Joins the pairs in order of the keys, as far as both ends are still free.
    fn join_in_order(&mut self, mut pairs: Vec<(Key, u32, u32)>) {
        sort_by(&mut pairs, |p| p.0);
        for (_, a, b) in pairs {
            if self.may_join(a, b) {
                self.join(a, b);
            }
        }
    }
}
