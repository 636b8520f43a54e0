//! Junctions: ends that meet in one point, and branches.

use super::ends::{Ends, NONE};
use crate::geometry::{DVec2, math};
use crate::order;
use crate::sheet::cluster::cluster;
use crate::sheet::element::ROUNDING;

/// A point where more than two ends meet.
pub(super) struct Branch {
    /// The point, mm.
    pub(super) at: DVec2,
    /// Number of ends that meet there.
    pub(super) ends: usize,
    /// One of these ends.
    pub(super) end: u32,
}

/// Largest number of ends at a branch for which all pairs are compared. Beyond it, only nearly opposite ends are.
const MAX_ALL_PAIRS: usize = 16;
/// Number of ends on either side of the opposite direction that are compared at a very large branch.
const OPPOSITE_ENDS: usize = 4;

/// Joins ends within rounding of each other; returns the branches.
pub(super) fn join(ends: &mut Ends) -> Vec<Branch> {
    let free = ends.all_free();
    let points: Vec<DVec2> = free.iter().map(|&e| ends.point[e as usize]).collect();
    let node_of = cluster(&points, 2.0 * ROUNDING);
    // Rests of one shape only meet each other.
    let shape = |e: u32| ends.rest_of[e as usize].map_or(0, |of| of + 1);
    let mut by_node: Vec<((u32, u32), u32)> =
        node_of.into_iter().zip(free).map(|(n, e)| ((n, shape(e)), e)).collect();
    order::sort_by(&mut by_node, |n| [n.0.0.into(), n.0.1.into(), n.1.into()]);
    let nodes = || by_node.chunk_by(|a, b| a.0 == b.0);
    for node in nodes() {
        if let [(_, a), (_, b)] = *node
            && ends.may_join(a, b)
        {
            ends.join(a, b);
        }
    }
    let mut branches = Vec::new();
    for node in nodes().filter(|n| n.len() > 2) {
        let members: Vec<u32> = node.iter().map(|&(_, e)| e).collect();
        branches.push(Branch { at: ends.point[members[0] as usize], ends: members.len(), end: members[0] });
        for &e in &members {
            ends.at_branch[e as usize] = true;
        }
        pair_up(ends, &members);
    }
    branches
}

/// Joins the ends of a branch in pairs.
fn pair_up(ends: &mut Ends, members: &[u32]) {
    // `members` is sorted, so membership is a binary search.
    for &a in members {
        let b = ends.far[a as usize];
        if b != NONE && members.binary_search(&b).is_ok() && ends.may_join(a, b) {
            ends.join(a, b);
        }
    }
    let left: Vec<u32> = members.iter().copied().filter(|&e| ends.free(e)).collect();
    let pairs = if left.len() <= MAX_ALL_PAIRS { all_pairs(&left) } else { opposite_pairs(ends, &left) };
    // Tails come last, because a chain that continues may become part of a closed contour.
    let tails = |a, b| u64::from(ends.is_tail(a)) + u64::from(ends.is_tail(b));
    let key = |a, b| {
        let [bend, names] = ends.preference(a, b);
        [tails(a, b), bend, names]
    };
    let keyed = pairs.into_iter().map(|(a, b)| (key(a, b), a, b)).collect();
    ends.join_in_order(keyed);
    if left.len() > MAX_ALL_PAIRS {
        pair_rest(ends, &left);
    }
}

fn all_pairs(of: &[u32]) -> Vec<(u32, u32)> {
    let later = |i: usize| of[i + 1..].iter().copied();
    of.iter().enumerate().flat_map(|(i, &a)| later(i).map(move |b| (a, b))).collect()
}

/// For each end, the few ends of its layer whose directions are most nearly opposite.
fn opposite_pairs(ends: &Ends, of: &[u32]) -> Vec<(u32, u32)> {
    let mut pairs = Vec::new();
    for layer in by_angle(ends, of).chunk_by(|a, b| a.0 == b.0) {
        let n = layer.len();
        for &(_, angle, a) in layer {
            let opposite = math::wrap_pi(angle + std::f64::consts::PI);
            let from = layer.partition_point(|m| m.1 < opposite) + n;
            let near = (from.saturating_sub(OPPOSITE_ENDS)..from + OPPOSITE_ENDS).map(|k| layer[k % n].2);
            pairs.extend(near.filter(|&b| b != a).map(|b| (a, b)));
        }
    }
    pairs
}

/// Joins the remaining free ends of a very large branch, each with the one half a turn farther on.
fn pair_rest(ends: &mut Ends, of: &[u32]) {
    let left: Vec<u32> = of.iter().copied().filter(|&e| ends.free(e)).collect();
    let left = by_angle(ends, &left);
    let (near, far) = left.split_at(left.len() / 2);
    for (&(_, _, a), &(_, _, b)) in near.iter().zip(far) {
        if ends.may_join(a, b) {
            ends.join(a, b);
        }
    }
}

/// Layer, outward direction and index of the ends, sorted by layer and direction.
fn by_angle(ends: &Ends, of: &[u32]) -> Vec<(u32, f64, u32)> {
    let angle = |e: u32| math::angle_of(ends.out[e as usize]);
    let mut sorted: Vec<_> = of.iter().map(|&e| (ends.layer[e as usize], angle(e), e)).collect();
    order::sort_by(&mut sorted, |e| [e.0.into(), order::real(e.1), e.2.into()]);
    sorted
}
