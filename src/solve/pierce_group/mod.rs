//! The solver of pierce groups: finds the paths through a group of contours that share cuts.
//!
//! An item is entered at one place and left at another. For a group both are nodes of its net, and for each such pair
//! there is one path through all its elements ([`SubPath`]): it pierces once, then cuts element by element, with air
//! moves and pre-cuts in between (Dewil et al., section 4.7). Every path out comes with a path back, so that a route may
//! be turned round. Large groups get few pairs, spread around them.
//!
//! * [`net`]: elements, which orders of them are possible. [`follow`]: what an order costs.
//! * [`insertion`]: the element insertion heuristic of the paper. [`exact`]: every order, for small groups.
//!   [`beam`] and [`anneal`]: ours for larger ones.
//! * [`strokes`]: an order as what the head does, and the exact seconds of it.

mod anneal;
mod beam;
mod exact;
mod follow;
mod insertion;
mod mixed;
mod net;
mod strokes;

use crate::geometry::DVec2;
use crate::order::{real, sort_by};
use crate::problem::{GroupMethod, GroupProblems, Stroke, SubPath};
use net::{Net, Order};

/// Pairs of ends that a larger group is offered with at most: with their ways back, as many nodes as neighbour lists look at.
const PAIRS: usize = 8;
/// Nodes tried as ends of a larger group, spread over it, and ways to each of them, as the beam search finds them.
const ENDS: usize = 6;
const WAYS: usize = 2;
/// Ways offered where the group is all there is: other ends would do for a head that comes from elsewhere.
const CHEAPEST: usize = 3;

/// The paths through each group, in pairs of out and back; none for a group through which no path was found.
pub fn paths(problems: &GroupProblems) -> Vec<Vec<SubPath>> {
    // Nets solved so far, with orders for them: parts are often nested in the same way again and again.
    let mut known: Vec<(Net, Vec<Order>)> = Vec::new();
    let through = |group| {
        let net = Net::new(group, problems.machine, problems.is_all);
        if problems.method == GroupMethod::Insertion {
            let by_insertion = inserted(&net);
            if !by_insertion.is_empty() {
                return by_insertion;
            }
        }
        if let Some((_, orders)) = known.iter().find(|known| known.0.is_like(&net)) {
            return best(&net, orders);
        }
        let orders = orders(&net);
        let paths = best(&net, &orders);
        known.push((net, orders));
        paths
    };
    problems.groups.iter().map(through).collect()
}

/// A path continued to other ends, with an air move from the new entry and one to the new exit.
fn between(net: &Net, mut path: SubPath, [entry, exit]: [DVec2; 2]) -> SubPath {
    let [first, last] = path.ends;
    path.seconds += net.air.seconds(entry, first) + net.air.seconds(last, exit);
    if entry != first {
        path.strokes.insert(0, Stroke::Air(first));
    }
    if last != exit {
        path.strokes.push(Stroke::Air(exit));
    }
    path.ends = [entry, exit];
    path
}

/// Orders between all ends of a small group, and between some of a larger one: where it is all there is, those that cost
/// least with the air moves from and to home, all ends searched together: faster paths in less time than between ends spread
/// over the group. Beside other items, spread ends are as good.
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

/// Ways through a group that may be of use in a route: none where another one with air moves from and to its ends takes
/// no longer. In pairs of out and back, the cheapest first; of a small group, all there are.
fn best(net: &Net, orders: &[Order]) -> Vec<SubPath> {
    let all: Vec<SubPath> = orders.iter().map(|order| strokes::sub_path(net, order)).collect();
    let as_long = |way: &SubPath, [entry, exit]: [DVec2; 2]| {
        way.seconds + net.air.seconds(entry, way.ends[0]) + net.air.seconds(way.ends[1], exit)
    };
    let is_of_use =
        |way: &SubPath| !all.iter().any(|w| w.ends != way.ends && as_long(w, way.ends) <= way.seconds);
    let mut found: Vec<[SubPath; 2]> = Vec::new();
    for way in all.iter().filter(|way| is_of_use(way)) {
        let ends = [way.ends[1], way.ends[0]];
        if found.iter().any(|pair| pair[0].ends == ends) {
            continue;
        }
        // An area in the middle can be begun in, but not ended in.
        let back = all.iter().reduce(|a, b| if as_long(b, ends) < as_long(a, ends) { b } else { a });
        found.extend(back.map(|back| [way.clone(), between(net, back.clone(), ends)]));
    }
    sort_by(&mut found, |f| [real(f[0].seconds + f[1].seconds), 0, 0]);
    if net.len() > exact::MOST {
        found.truncate(PAIRS);
    }
    found.into_iter().flatten().collect()
}

/// Ways by the insertion heuristic, in pairs of out and back, the cheapest first; none where it finds none.
fn inserted(net: &Net) -> Vec<SubPath> {
    let ends = spread(net);
    let mut found: Vec<(f64, [Order; 2])> = Vec::new();
    for (i, &a) in ends.iter().enumerate() {
        // Without an air move a path comes back to its beginning only where every node is even.
        for &b in ends[i..].iter().filter(|&&b| a != b || net.is_even()) {
            if let (Some(out), Some(back)) = (insertion::order(net, a, b), insertion::order(net, b, a)) {
                found.push((net.cost(&out) + net.cost(&back), [out, back]));
            }
        }
    }
    sort_by(&mut found, |f| [real(f.0), 0, 0]);
    found.truncate(PAIRS);
    found.into_iter().flat_map(|f| f.1).map(|order| strokes::sub_path(net, &order)).collect()
}

/// Nodes to begin and end at: where an odd number of elements meets, a path has to begin or end anyway.
fn ends(net: &Net) -> Vec<u32> {
    let odd: Vec<u32> = net.nodes().filter(|&n| net.is_odd(n)).collect();
    if odd.is_empty() { net.nodes().collect() } else { odd }
}

/// Some of them, farthest first.
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
