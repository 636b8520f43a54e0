//! The local move that puts a short chain of items elsewhere, in either direction (Or-opt).

use super::config::CONFIG;
use super::neighbours::Neighbours;
use super::queue::Queue;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;

/// Moves a chain of at least two items that starts or ends with `a` next to an item near `a`, reversed where that brings
/// `a` next to it.
pub(super) fn move_chain(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    let here = tour.position(a);
    if here == 0 {
        return None;
    }
    for more in 1..CONFIG.longest_chain {
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
    let freed = tour.leg_before(first) + tour.leg_after(last) - tour.edge_here(before, after);
    if freed <= EPSILON {
        return None;
    }
    let outside = |tour: &Tour, i: u32| !(from..=to).contains(&tour.position(i));
    for after_near in [true, false] {
        // After a near item the chain starts with `a`; before it, the chain ends with `a`.
        let reversed = (a == first) != after_near;
        let (enter, leave) = if reversed {
            (tour.entry_reversed(last), tour.exit_reversed(first))
        } else {
            (tour.entry(first), tour.exit(last))
        };
        let candidates =
            if (a == first) == reversed { near.of_exit(tour, a) } else { near.of_entry(tour, a) };
        for &b in candidates {
            let (u, w) = if after_near { (b, tour.next(b)) } else { (tour.previous(b), b) };
            if !outside(tour, u) || !outside(tour, w) {
                continue;
            }
            let link = if after_near {
                tour.space.travel.seconds_here(tour.exit(u), enter)
            } else {
                tour.leg_seconds(leave, w, tour.entry(w))
            };
            if link >= freed - EPSILON {
                continue;
            }
            tour.priced += 1;
            let other = if after_near {
                tour.leg_seconds(leave, w, tour.entry(w))
            } else {
                tour.space.travel.seconds(tour.exit(u), enter)
            };
            let mut gain = freed + tour.leg_after(u) - link - other;
            if reversed && gain > EPSILON {
                if !tour.may_reverse(from, to) {
                    continue;
                }
                gain -= tour.reversal_cost(from, to);
            }
            if gain <= EPSILON {
                continue;
            }
            let there = tour.position(u);
            let stretch = if there < from { (there + 1, from - 1, to) } else { (from, to, there) };
            if tour.may_exchange(stretch.0, stretch.1, stretch.2) {
                if reversed {
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
