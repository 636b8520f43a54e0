//! The solver of pierce groups: finds the paths through a group of contours that share cuts.
//!
//! A path enters a group at one node of its net and leaves it at another. For each such pair there is one path through all
//! elements ([`SubPath`]): it pierces once and then cuts element by element, with air moves and pre-cuts in between (Dewil
//! et al., 2014, section 4.7). Every path comes with a path back, so that a route may be reversed. Large groups get only a
//! few pairs, spread around them.
//!
//! * [`net`]: the elements and their possible orders. [`follow`]: the cost of an order.
//! * [`insertion`]: the element insertion heuristic of the paper. [`exact`]: every order, for small groups.
//!   [`beam`] and [`anneal`]: ours for larger ones.
//! * [`bridged`]: orders with air moves that contours beside the group bridge.
//! * [`strokes`]: an order as what the head does, the exact seconds of it, and where it may be left for other items.

mod anneal;
mod beam;
mod bridged;
mod exact;
mod follow;
mod insertion;
mod mixed;
mod net;
mod strokes;

use crate::geometry::DVec2;
use crate::machine::PLANS_ALL_LEVERS;
use crate::order::{real, sort_by};
use crate::problem::{GroupMethod, GroupProblems, Stroke, SubPath};
pub use insertion::MOST as MOST_BY_INSERTION;
use net::{Net, Order};

/// Most pairs of ends of a larger group: with the paths back, as many nodes as neighbour lists look at.
const PAIRS: usize = 8;
/// Nodes that are tried as ends of a larger group, spread over it: more take longer than they gain.
const ENDS: usize = 6;
/// Orders that the beam search contributes for each end.
const WAYS: usize = 2;
/// Orders of a group that is the only item: the head comes from home, so that few ends are useful.
const CHEAPEST: usize = 3;

/// Most pairs of paths with bridged air moves: the search over all items tries each when it looks for another path.
const BRIDGED: usize = 4;

/// The paths through each group, in pairs of forth and back; none for a group through which no path was found.
pub fn paths(problems: &GroupProblems) -> Vec<Vec<SubPath>> {
    // The nets solved so far with their orders: the same group often occurs many times on a sheet.
    let mut known: Vec<(Net, Vec<Order>)> = Vec::new();
    let mut bridged = Bridged::default();
    let through = |group| {
        let net = Net::new(group, problems.machine, problems.is_all);
        let inserts = PLANS_ALL_LEVERS && problems.method == GroupMethod::Insertion;
        if inserts && net.len() <= MOST_BY_INSERTION {
            let by_insertion = inserted(&net);
            if !by_insertion.is_empty() {
                return by_insertion;
            }
        }
        let old = known.iter().position(|known| known.0.is_like(&net));
        let at = old.unwrap_or(known.len());
        if old.is_none() {
            let orders = orders(&net);
            known.push((net.clone(), orders));
        }
        let paths =
            known.get(at).map(|known| best(&net, &known.1, problems.from_outside)).unwrap_or_default();
        bridged.added(&net, paths)
    };
    problems.groups.iter().map(through).collect()
}

/// The nets solved so far with their orders whose air moves contours beside them bridge.
#[derive(Default)]
struct Bridged<'s> {
    known: Vec<(Net<'s>, Vec<Order>)>,
}

impl<'s> Bridged<'s> {
    /// The paths of a group and, in pairs of forth and back, those with bridged air moves.
    fn added(&mut self, net: &Net<'s>, mut paths: Vec<SubPath>) -> Vec<SubPath> {
        let Some(bridged) = net.bridged() else { return paths };
        if !self.known.iter().any(|k| k.0.is_like(net) && k.0.is_bridged_like(net)) {
            self.known.push((net.clone(), orders(&bridged)));
        }
        let known = self.known.iter().find(|k| k.0.is_like(net) && k.0.is_bridged_like(net));
        let mut found: Vec<(f64, [SubPath; 2])> = Vec::new();
        for order in known.iter().flat_map(|k| &k.1) {
            let way = strokes::sub_path(net, order);
            let Some(back) = back(net, &paths, [way.ends[1], way.ends[0]]) else { continue };
            if !paths.iter().any(|p| p.strokes == way.strokes) {
                found.push((bridged.cost(order), [strokes::priced(net, way), back]));
            }
        }
        sort_by(&mut found, |f| [real(f.0), 0, 0]);
        paths.extend(found.into_iter().take(BRIDGED).flat_map(|f| f.1));
        paths
    }
}

/// Extends a path to other ends, by an air move from the new entry and one to the new exit.
fn between(net: &Net, mut path: SubPath, [entry, exit]: [DVec2; 2]) -> SubPath {
    let [first, last] = path.ends;
    path.seconds += net.air.seconds(entry, first) + net.air.seconds(last, exit);
    if entry != first {
        path.strokes.insert(0, Stroke::Air(first));
        path.leave_points.iter_mut().for_each(|p| p.strokes += 1);
    }
    if last != exit {
        path.strokes.push(Stroke::Air(exit));
    }
    path.ends = [entry, exit];
    path
}

/// Orders between all ends of a small group, and between some ends of a larger one. If the group is the only item, all ends
/// are searched together with the air moves from and to home, which gives faster paths in less time. Beside other items,
/// ends that are spread over the group are as good.
fn orders(net: &Net) -> Vec<Order> {
    if net.len() <= exact::MOST {
        return exact::all(net);
    }
    let search = beam::Search::new(net);
    let orders: Vec<Order> = if net.is_all {
        search.orders(&ends(net)).into_iter().take(CHEAPEST).collect()
    } else {
        spread(net).into_iter().flat_map(|to| search.orders(&[to]).into_iter().take(WAYS)).collect()
    };
    orders.into_iter().map(|order| anneal::annealed(net, order)).collect()
}

/// The paths that may be useful in a route: a path is dropped if another with air moves from and to its ends takes no
/// longer. `from_outside`: those that begin beside the area around the group, if there are any. In pairs of forth and back, the cheapest first; for a small group all of them.
fn best(net: &Net, orders: &[Order], from_outside: bool) -> Vec<SubPath> {
    let begins_outside = |order: &&Order| from_outside && net.is_outside(net.ends(order)[0]);
    let outside: Vec<&Order> = orders.iter().filter(begins_outside).collect();
    let useful = if outside.is_empty() { orders.iter().collect() } else { outside };
    let all: Vec<SubPath> = useful.into_iter().map(|order| strokes::sub_path(net, order)).collect();
    let is_of_use =
        |way: &SubPath| !all.iter().any(|w| w.ends != way.ends && as_long(net, w, way.ends) <= way.seconds);
    let mut found: Vec<[SubPath; 2]> = Vec::new();
    for way in all.iter().filter(|way| is_of_use(way)) {
        let ends = [way.ends[1], way.ends[0]];
        if found.iter().any(|pair| pair[0].ends == ends) {
            continue;
        }
        // A path may begin at an area in the middle but not end there, so the path back may be another one.
        found.extend(back(net, &all, ends).map(|back| [way.clone(), back]));
    }
    sort_by(&mut found, |f| [real(f[0].seconds + f[1].seconds), 0, 0]);
    if net.len() > exact::MOST {
        found.truncate(PAIRS);
    }
    found.into_iter().flatten().map(|path| strokes::priced(net, path)).collect()
}

/// Seconds of a path with air moves from and to other ends.
fn as_long(net: &Net, way: &SubPath, [entry, exit]: [DVec2; 2]) -> f64 {
    way.seconds + net.air.seconds(entry, way.ends[0]) + net.air.seconds(way.ends[1], exit)
}

/// The fastest of some paths between two ends, extended to them.
fn back(net: &Net, all: &[SubPath], ends: [DVec2; 2]) -> Option<SubPath> {
    let fastest = all.iter().reduce(|a, b| if as_long(net, b, ends) < as_long(net, a, ends) { b } else { a });
    fastest.map(|way| between(net, way.clone(), ends))
}

/// The paths of the insertion heuristic, in pairs of forth and back, the cheapest first; empty if it finds none.
fn inserted(net: &Net) -> Vec<SubPath> {
    let ends = spread(net);
    let mut found: Vec<(f64, [Order; 2])> = Vec::new();
    for (i, &a) in ends.iter().enumerate() {
        // Without an air move a path returns to its beginning only if every node is even.
        for &b in ends[i..].iter().filter(|&&b| a != b || net.is_even()) {
            if let (Some(out), Some(back)) = (insertion::order(net, a, b), insertion::order(net, b, a)) {
                found.push((net.cost(&out) + net.cost(&back), [out, back]));
            }
        }
    }
    sort_by(&mut found, |f| [real(f.0), 0, 0]);
    found.truncate(PAIRS);
    let path = |order: Order| strokes::priced(net, strokes::sub_path(net, &order));
    found.into_iter().flat_map(|f| f.1).map(path).collect()
}

/// Candidates for the ends of a path: where an odd number of elements meet, a trail must begin or end anyway.
fn ends(net: &Net) -> Vec<u32> {
    let odd: Vec<u32> = net.nodes().filter(|&n| net.is_odd(n)).collect();
    if odd.is_empty() { net.nodes().collect() } else { odd }
}

/// Some of these candidates, each as far as possible from those before it.
fn spread(net: &Net) -> Vec<u32> {
    let mut left = ends(net);
    if left.len() <= ENDS {
        return left;
    }
    let mut taken = vec![left.swap_remove(0)];
    while taken.len() < ENDS && !left.is_empty() {
        let room =
            |n: u32| taken.iter().map(|&t| net.place(t).distance(net.place(n))).fold(f64::INFINITY, f64::min);
        let farthest =
            (1..left.len()).fold(0, |best, k| if room(left[k]) > room(left[best]) { k } else { best });
        taken.push(left.swap_remove(farthest));
    }
    taken
}
