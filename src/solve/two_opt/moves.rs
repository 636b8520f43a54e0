//! The moves around one stop: other entry, 2-opt, Or-opt, each with a new entry for the contour met.
//!
//! Every move but the first makes a new leg from the stop `u` to a node of one of its neighbours `c`, in either
//! direction along the tour. To write each once, the tour is looked at in a *view*: forwards or backwards. In a
//! view a node has a point `enters` and a point `leaves`, and `next` is the position after another.
//!
//! With the legs u-un, cp-c and c-cn of the view (p: previous, n: next), the moves are
//!
//! ```text
//! 2-opt           u c .. un cn        the stops between run the other way
//! Or-opt, c's     u [c .. e] un       up to three stops from c on are put after u
//!                 u [c .. f] un       the same, ending at c, turned round
//! Or-opt, u's     cp [f .. u] c       up to three stops ending at u are put before c
//!                 c [u .. f] cn       the same, after c, turned round
//! ```
//!
//! All are priced in O(1). A move is looked at only when its first new leg is shorter than the leg it replaces (the
//! usual pruning: some rotation of every gainful exchange begins so).

use super::tour::{Change, Tour};
use crate::problem::{ItemId, Neighbours, NodeId};

/// Stops moved at once by Or-opt: one to three, as in I. Or's thesis (1976).
const SEGMENT: usize = 3;
/// Gains below this are noise of additions, s.
pub(super) const NOISE: f64 = 1e-9;

/// A move that gains, as changes in order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gain {
    pub(super) seconds: f64,
    /// First the contour met is entered at this node.
    enter: Option<(usize, NodeId)>,
    reverse: Option<(usize, usize)>,
    swap: Option<(usize, usize, usize)>,
}

impl Gain {
    /// Does the move; the items whose legs it changes go to `touched`.
    pub(super) fn apply(&self, tour: &mut Tour, touched: &mut Vec<ItemId>) {
        let mut ends = Vec::with_capacity(12);
        if let Some((p, node)) = self.enter {
            ends.extend([p - 1, p, p + 1]);
            tour.apply(Change::Enter(p, node));
        }
        if let Some((lo, hi)) = self.reverse {
            ends.extend([lo - 1, lo, hi, hi + 1]);
        }
        if let Some((lo, mid, hi)) = self.swap {
            ends.extend([lo - 1, lo, mid - 1, mid, hi, hi + 1]);
        }
        touched.extend(ends.into_iter().filter_map(|p| tour.item_at(p)));
        if let Some((lo, hi)) = self.reverse {
            tour.apply(Change::Reverse(lo, hi));
        }
        if let Some((lo, mid, hi)) = self.swap {
            tour.apply(Change::Swap(lo, mid, hi));
        }
    }
}

/// Looks for the best move around one item. `priced` counts what was priced.
pub(super) fn best_move(
    tour: &mut Tour,
    lists: &mut Neighbours,
    item: ItemId,
    priced: &mut u64,
) -> Option<Gain> {
    let position = tour.position(item)?;
    let mut best = other_entry(tour, position, priced);
    for forward in [true, false] {
        let mut view = View { tour, forward, priced, best };
        view.around(position, lists);
        best = view.best;
    }
    best.filter(|g| g.seconds > NOISE)
}

/// The stop entered at the node that is best between its neighbours.
fn other_entry(tour: &Tour, position: usize, priced: &mut u64) -> Option<Gain> {
    let node = tour.at(position);
    let (before, after) = (2 * tour.at(position - 1) + 1, 2 * tour.at(position + 1));
    let price = |n: NodeId| tour.price(before, 2 * n) + tour.price(2 * n + 1, after);
    let now = price(node);
    let mut best = None;
    let mut least = now - NOISE;
    for other in tour.problem.items[tour.problem.nodes[node as usize].item as usize].nodes.clone() {
        *priced += 1;
        let seconds = price(other);
        if seconds < least {
            least = seconds;
            let enter = Some((position, other));
            best = Some(Gain { seconds: now - seconds, enter, reverse: None, swap: None });
        }
    }
    best
}

/// A tour seen forwards or backwards.
struct View<'a, 'p> {
    tour: &'a mut Tour<'p>,
    forward: bool,
    priced: &'a mut u64,
    best: Option<Gain>,
}

impl View<'_, '_> {
    fn next(&self, position: usize) -> usize {
        if self.forward { position + 1 } else { position - 1 }
    }

    fn previous(&self, position: usize) -> usize {
        if self.forward { position - 1 } else { position + 1 }
    }

    /// A stop, not one of the ends.
    fn is_stop(&self, position: usize) -> bool {
        (1..=self.tour.len()).contains(&position)
    }

    fn enters(&self, node: NodeId) -> u32 {
        2 * node + u32::from(!self.forward)
    }

    fn leaves(&self, node: NodeId) -> u32 {
        2 * node + u32::from(self.forward)
    }

    /// Seconds from one node to another in the order of the view.
    fn leg(&self, a: NodeId, b: NodeId) -> f64 {
        self.tour.price(self.leaves(a), self.enters(b))
    }

    /// All moves that make a new leg from the stop at `i`.
    fn around(&mut self, i: usize, lists: &mut Neighbours) {
        let (un_at, u) = (self.next(i), self.tour.at(i));
        let old = self.leg(u, self.tour.at(un_at));
        let list_of = if self.forward { u } else { self.tour.twin(u) };
        if !lists.knows(list_of) {
            // A list costs about as much as pricing this many moves.
            *self.priced += 100;
        }
        for &near in lists.after(list_of) {
            // `v` is entered where u is left; `x`, its twin, is left there.
            let other = self.tour.twin(near);
            let (v, x) = if self.forward { (near, other) } else { (other, near) };
            let new = self.leg(u, v);
            *self.priced += 1;
            if new >= old - NOISE {
                break;
            }
            let c_at = self.tour.position_of(v);
            if c_at != un_at {
                let meeting = Meeting { i, u, un_at, old, c_at, v, x, new };
                self.two_opt(&meeting);
                self.take_theirs(&meeting);
                self.bring_ours(&meeting);
            }
        }
    }

    fn two_opt(&mut self, m: &Meeting) {
        let (cn_at, cp_at) = (self.next(m.c_at), self.previous(m.c_at));
        let (un, c) = (self.tour.at(m.un_at), self.tour.at(m.c_at));
        let (cn, cp) = (self.tour.at(cn_at), self.tour.at(cp_at));
        let ahead = (m.c_at > m.i) == self.forward;
        let (a, b) = if ahead { (m.un_at, m.c_at) } else { (cn_at, m.i) };
        let range = Some((a.min(b), a.max(b)));
        let kept = m.old + self.leg(c, cn) - self.tour.price(self.enters(un), self.enters(cn));
        // With the contour met entered as it is ...
        let as_is = kept - self.tour.price(self.leaves(m.u), self.leaves(c));
        self.consider(as_is, None, range, None);
        // ... or anew at the near node, which also changes the leg before it.
        if m.x != c {
            let entered = kept - m.new + self.leg(cp, c) - self.tour.price(self.leaves(cp), self.enters(m.x));
            self.consider(entered, Some((m.c_at, m.x)), range, None);
        }
    }

    /// Stops from c on, or ending at c, are put between u and un.
    fn take_theirs(&mut self, m: &Meeting) {
        let (cn_at, cp_at) = (self.next(m.c_at), self.previous(m.c_at));
        let (un, c) = (self.tour.at(m.un_at), self.tour.at(m.c_at));
        let (cn, cp) = (self.tour.at(cn_at), self.tour.at(cp_at));
        let (to_c, from_c) = (self.leg(cp, c), self.leg(c, cn));

        let mut e_at = m.c_at;
        for length in 1..=SEGMENT {
            if !self.is_stop(e_at) || e_at == m.i {
                break;
            }
            let e = self.tour.at(e_at);
            let en = self.tour.at(self.next(e_at));
            let removed = to_c + self.leg(e, en) - self.leg(cp, en);
            let added =
                if length == 1 { self.leg(m.v, un) } else { self.leg(m.v, cn) - from_c + self.leg(e, un) };
            let gain = m.old - m.new + removed - added;
            self.consider_move(gain, (m.c_at, m.v), (m.c_at, e_at), m.i.min(m.un_at), false);
            e_at = self.next(e_at);
        }

        let mut f_at = m.c_at;
        for length in 1..=SEGMENT {
            if !self.is_stop(f_at) || f_at == m.i || f_at == m.un_at {
                break;
            }
            let f = self.tour.at(f_at);
            let fp = self.tour.at(self.previous(f_at));
            let removed = from_c + self.leg(fp, f) - self.leg(fp, cn);
            let added = if length == 1 {
                self.tour.price(self.enters(m.x), self.enters(un))
            } else {
                self.tour.price(self.enters(m.x), self.leaves(cp)) - to_c
                    + self.tour.price(self.enters(f), self.enters(un))
            };
            // A closed contour alone is the same turned round.
            if length > 1 || m.x != m.v {
                let gain = m.old - m.new + removed - added;
                self.consider_move(gain, (m.c_at, m.x), (m.c_at, f_at), m.i.min(m.un_at), true);
            }
            f_at = self.previous(f_at);
        }
    }

    /// Stops ending at u are put before or after c.
    fn bring_ours(&mut self, m: &Meeting) {
        let (cn_at, cp_at) = (self.next(m.c_at), self.previous(m.c_at));
        let (un, c) = (self.tour.at(m.un_at), self.tour.at(m.c_at));
        let (cn, cp) = (self.tour.at(cn_at), self.tour.at(cp_at));
        let around_c = self.leg(cp, c) + self.leg(c, cn);
        let mut f_at = m.i;
        for _ in 1..=SEGMENT {
            // With c just before them, the first move would be none, the second a 2-opt.
            if !self.is_stop(f_at) || f_at == m.c_at || self.previous(f_at) == m.c_at {
                break;
            }
            let fp_at = self.previous(f_at);
            let (f, fp) = (self.tour.at(f_at), self.tour.at(fp_at));
            let freed = m.old - m.new + self.leg(fp, f) - self.leg(fp, un) + around_c;
            let before = freed - self.leg(cp, f) - self.leg(m.v, cn);
            self.consider_move(before, (m.c_at, m.v), (f_at, m.i), cp_at.min(m.c_at), false);
            let after = freed
                - self.tour.price(self.leaves(cp), self.enters(m.x))
                - self.tour.price(self.enters(f), self.enters(cn));
            self.consider_move(after, (m.c_at, m.x), (f_at, m.i), cn_at.min(m.c_at), true);
            f_at = fp_at;
        }
    }

    /// The stops of `segment` (positions of its ends) go between the positions `gap` and `gap` + 1.
    fn consider_move(
        &mut self,
        gain: f64,
        enter: (usize, NodeId),
        segment: (usize, usize),
        gap: usize,
        reversed: bool,
    ) {
        let (lo, hi) = (segment.0.min(segment.1), segment.0.max(segment.1));
        let swap = if gap < lo { (gap + 1, lo, hi) } else { (lo, hi + 1, gap) };
        let enter = Some(enter).filter(|&(p, node)| self.tour.at(p) != node);
        self.consider(gain, enter, reversed.then_some((lo, hi)), Some(swap));
    }

    /// Keeps a move that gains most so far and is allowed.
    fn consider(
        &mut self,
        gain: f64,
        enter: Option<(usize, NodeId)>,
        reverse: Option<(usize, usize)>,
        swap: Option<(usize, usize, usize)>,
    ) {
        *self.priced += 1;
        if gain > self.best.map_or(0.0, |b| b.seconds) + NOISE
            && swap.is_none_or(|(lo, mid, hi)| self.tour.may_swap(lo, mid, hi))
            && reverse.is_none_or(|(lo, hi)| self.tour.may_reverse(lo, hi))
        {
            self.best = Some(Gain { seconds: gain, enter, reverse, swap });
        }
    }
}

/// The stop u at `i` meets the contour c, whose node `v` is entered near where u is left.
struct Meeting {
    i: usize,
    u: NodeId,
    un_at: usize,
    /// Seconds of the leg from u that would go.
    old: f64,
    c_at: usize,
    v: NodeId,
    /// The twin of `v`: left where u is left.
    x: NodeId,
    /// Seconds of the leg from u that would come.
    new: f64,
}

#[cfg(test)]
mod tests;
