//! Short chains moved elsewhere, also turned round.

use super::neighbours::Neighbours;
use super::queue::Queue;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;

/// Longest chain moved by itself; longer ones are moved by exchanging stretches.
const CHAIN: usize = 3;

/// A chain of 2 to [`CHAIN`] items that starts or ends with `a` moved next to a near item, turned round where that
/// brings `a` next to it.
pub(super) fn move_chain(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    let here = tour.position(a);
    if here == 0 {
        return None;
    }
    for more in 1..CHAIN {
        let starts = (here, here + more);
        let ends = (here.saturating_sub(more), here);
        for (from, to) in [starts, ends] {
            if from >= 1 && to <= tour.last() {
                let gain = place_chain(tour, near, queue, a, from, to);
                if gain.is_some() {
                    return gain;
                }
            }
        }
    }
    None
}

/// Moves the chain at positions `from..=to`, which starts or ends with `a`, next to an item near `a`.
fn place_chain(
    tour: &mut Tour,
    near: &Neighbours,
    queue: &mut Queue,
    a: u32,
    from: usize,
    to: usize,
) -> Option<f64> {
    let (first, last) = (tour.item(from), tour.item(to));
    let (before, after) = (tour.item(from - 1), tour.item(to + 1));
    let freed = tour.way_to(first) + tour.way_on(last) - tour.edge_here(before, after);
    if freed <= EPSILON {
        return None;
    }
    let outside = |tour: &Tour, i: u32| !(from..=to).contains(&tour.position(i));
    for behind in [true, false] {
        // Behind a near item the chain starts with `a`, in front of it it ends with `a`.
        let turned = (a == first) != behind;
        let (enter, leave) =
            if turned { (tour.exit(last), tour.entry(first)) } else { (tour.entry(first), tour.exit(last)) };
        let candidates = if (a == first) == turned { near.of_exit(tour, a) } else { near.of_entry(tour, a) };
        for &b in candidates {
            let (u, w) = if behind { (b, tour.next(b)) } else { (tour.previous(b), b) };
            if !outside(tour, u) || !outside(tour, w) {
                continue;
            }
            let link = if behind {
                tour.space.travel.seconds_here(tour.exit(u), enter)
            } else {
                tour.way(leave, w, tour.entry(w))
            };
            if link >= freed - EPSILON {
                continue;
            }
            tour.priced += 1;
            let other = if behind {
                tour.way(leave, w, tour.entry(w))
            } else {
                tour.space.travel.seconds(tour.exit(u), enter)
            };
            let mut gain = freed + tour.way_on(u) - link - other;
            if turned && gain > EPSILON {
                if !tour.may_reverse(from, to) {
                    continue;
                }
                gain -= tour.turning(from, to);
            }
            if gain <= EPSILON {
                continue;
            }
            let there = tour.position(u);
            let stretch = if there < from { (there + 1, from - 1, to) } else { (from, to, there) };
            if tour.may_exchange(stretch.0, stretch.1, stretch.2) {
                if turned {
                    tour.reverse(from, to);
                }
                tour.exchange(stretch.0, stretch.1, stretch.2);
                queue.push_all(&[first, last, before, after, u, w]);
                return Some(gain);
            }
        }
    }
    None
}
