//! Pierce groups as items: which paths there are through a group of contours that share cuts.
//!
//! An item is entered at one place and left at another; for a group that is a node of its net each, and for each such
//! pair there is one path through all its elements ([`SubPath`]): pierced once, then element by element, with air moves
//! and pre-cuts in between (Dewil et al., section 4.7). A path back for every path out, so that a route may be turned
//! round; few pairs for large groups, spread around them.
//!
//! * [`net`]: elements, what an order of them costs, which orders are possible.
//! * [`insertion`]: the element insertion heuristic of the paper. [`exact`]: every order, for small groups.
//!   [`walk`]: ours for larger ones.
//! * [`strokes`]: an order as what the head does, and the exact seconds of it.

mod exact;
mod insertion;
mod net;
mod strokes;
mod walk;

use crate::geometry::DVec2;
use crate::machine::Profile;
use crate::order::{real, sort_by};
use crate::sheet::{CommonCuts, PierceGroup, Sheet};
use net::{Net, Order};
pub use strokes::{Span, Stroke};

/// Pairs of ends that a group is offered with at most: with their ways back, as many nodes as neighbour lists look at.
const PAIRS: usize = 8;
/// Nodes tried as ends of a larger group: 15 pairs to choose from.
const ENDS: usize = 6;

/// A way through all of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct SubPath {
    /// Where the head arrives and leaves, mm.
    pub ends: [DVec2; 2],
    /// What the head does in between.
    pub strokes: Vec<Stroke>,
    /// All its seconds.
    pub seconds: f64,
}

impl SubPath {
    /// The same, with a way back to its beginning.
    fn round(mut self, net: &Net) -> Self {
        let [entry, exit] = self.ends;
        self.seconds += net.air.seconds(exit, entry);
        self.strokes.push(Stroke::Air(entry));
        self.ends = [entry; 2];
        self
    }

    /// The stretches of contours it runs along, in order.
    pub fn spans(&self) -> impl Iterator<Item = &Span> {
        self.strokes
            .iter()
            .flat_map(|s| if let Stroke::Cut { spans, .. } = s { spans.as_slice() } else { &[] })
    }
}

/// The paths through a group, in pairs of out and back.
pub(super) fn sub_paths(sheet: &Sheet, group: &PierceGroup, machine: &Profile) -> Vec<SubPath> {
    let net = Net::new(sheet, group, machine);
    let best =
        |order| if sheet.common_cuts == CommonCuts::Best { walk::annealed(&net, order) } else { order };
    let mut pairs = pairs(&net, sheet.common_cuts);
    pairs.truncate(PAIRS);
    if pairs.is_empty() {
        // Any order at all, and back to where it began: then it is its own way back.
        let round = walk::any(&net).map(|order| strokes::sub_path(&net, &best(order)).round(&net));
        return round.map_or_else(Vec::new, |path| vec![path.clone(), path]);
    }
    pairs.into_iter().flatten().map(|order| strokes::sub_path(&net, &best(order))).collect()
}

/// Pairs of orders, out and back, the cheapest first.
fn pairs(net: &Net, by: CommonCuts) -> Vec<[Order; 2]> {
    let ends = ends(net);
    let by_insertion = by == CommonCuts::Insertion;
    let small = !by_insertion && net.len() <= exact::MOST;
    let mut found: Vec<(f64, [Order; 2])> = Vec::new();
    let all = if small { exact::all(net, &ends) } else { Vec::new() };
    for (i, &a) in ends.iter().enumerate() {
        // Without an air move a path comes back to its beginning only where every node is even.
        for &b in ends[i..].iter().filter(|&&b| a != b || net.is_even()) {
            let of = |from: u32, to: u32| match (small, by_insertion) {
                (true, _) => all.iter().find(|o| net.ends(o) == [from, to]).cloned(),
                (_, true) => insertion::order(net, from, to).or_else(|| walk::order(net, from, to)),
                _ => walk::order(net, from, to),
            };
            if let (Some(out), Some(back)) = (of(a, b), of(b, a)) {
                found.push((net.cost(&out) + net.cost(&back), [out, back]));
            }
        }
    }
    sort_by(&mut found, |f| [real(f.0), 0, 0]);
    found.into_iter().map(|f| f.1).collect()
}

/// Nodes to begin and end at: where an odd number of elements meets, a path has to begin or end anyway. Spread over the
/// group, farthest first.
fn ends(net: &Net) -> Vec<u32> {
    let odd: Vec<u32> = net.nodes().filter(|&n| net.is_odd(n)).collect();
    let mut left = if odd.is_empty() { net.nodes().collect() } else { odd };
    let most = if net.len() <= exact::MOST { exact::MOST } else { ENDS };
    if left.len() <= most {
        return left;
    }
    let mut taken = vec![left.swap_remove(0)];
    while taken.len() < most && !left.is_empty() {
        let room =
            |n: u32| taken.iter().map(|&t| net.place(t).distance(net.place(n))).fold(f64::INFINITY, f64::min);
        let farthest =
            (1..left.len()).fold(0, |best, k| if room(left[k]) > room(left[best]) { k } else { best });
        taken.push(left.swap_remove(farthest));
    }
    taken
}
