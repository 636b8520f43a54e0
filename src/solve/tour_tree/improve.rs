//! Local search over a work queue: a move puts the items it changed back on the queue.
//!
//! For an item these moves are tried in this order: a better entry; the item elsewhere, at its best entry there; a stretch
//! reversed so that it meets a near item (2-opt); two neighbouring stretches exchanged (Or-3opt without reversal, the move
//! that precedence allows most often); a chain of two or three items elsewhere, in either direction. Candidates come from
//! the neighbour list of the gate where the item is entered or left. A list is left as soon as the first new leg is no
//! shorter than the one that is given up (the gain criterion of Lin and Kernighan, 1973). A move is priced in constant
//! time; whether precedence allows it is looked up only if it gains.

use super::chain::move_chain;
use super::improve_entry::improve_entry;
use super::neighbours::Neighbours;
use super::queue::Queue;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;

/// Improves the tour around one item until no move of the item gains. Returns the seconds gained.
pub(super) fn improve(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, item: u32) -> f64 {
    let mut total = 0.0;
    loop {
        let gain = improve_entry(tour, queue, item)
            .or_else(|| relocate(tour, near, queue, item))
            .or_else(|| two_opt_after(tour, near, queue, item))
            .or_else(|| two_opt_before(tour, near, queue, item))
            .or_else(|| exchange(tour, near, queue, item))
            .or_else(|| move_chain(tour, near, queue, item));
        match gain {
            Some(g) => total += g,
            None => return total,
        }
    }
}

/// Moves an item to the best of all candidate gaps, with its best entry there.
fn relocate(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, item: u32) -> Option<f64> {
    if item == tour.space.home {
        return None;
    }
    let here = tour.position(item);
    let (before, after) = (tour.previous(item), tour.next(item));
    let freed =
        tour.leg_before(item) + tour.leg_after(item) + tour.extra(item) - tour.edge_here(before, after);
    let reaching = tour.space.reaching(item);
    let mut best: Option<(u32, u32, u32)> = None;
    let mut most = EPSILON;
    for &b in near.of_item(item) {
        // The legs between the item and the near one: each of the two gaps beside it has one of them.
        let [out, back] = tour.least_legs(&reaching, b);
        for (from, to, near_leg) in [(b, tour.next(b), out), (tour.previous(b), b, back)] {
            if from == item || to == item {
                continue;
            }
            tour.priced += 1;
            let given = freed + tour.leg_after(from);
            // Most gaps are too far away by that leg alone.
            if given - near_leg <= most {
                continue;
            }
            let left = given - if from == b { out } else { reaching.at_least(tour.exit(from), false) };
            let gap = tour.gap(from, to);
            let on = if to == b { back } else { gap.to.map_or(0.0, |q| reaching.at_least(q, true)) };
            if left - on <= most {
                continue;
            }
            let (at, seconds) = tour.space.best_entry(item, gap, given - most);
            if given - seconds <= most {
                continue;
            }
            let there = tour.position(from);
            let allowed = if there < here {
                tour.may_exchange(there + 1, here - 1, here)
            } else {
                tour.may_exchange(here, here, there)
            };
            if allowed {
                most = given - seconds;
                best = Some((from, to, at));
            }
        }
    }
    let (from, to, at) = best?;
    let there = tour.position(from);
    if there < here {
        tour.exchange(there + 1, here - 1, here);
    } else {
        tour.exchange(here, here, there);
    }
    tour.enter(item, at);
    queue.push_all(&[item, before, after, from, to]);
    Some(most)
}

/// 2-opt: reverses the stretch between `a` and a near `b` so that the two exits become neighbours.
fn two_opt_after(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    let here = tour.position(a);
    let after_a = tour.next(a);
    let given = tour.leg_after(a);
    for &b in near.of_exit(tour, a) {
        let taken = tour.space.travel.seconds_here(tour.exit(a), tour.entry_reversed(b));
        if taken >= given - EPSILON {
            continue;
        }
        tour.priced += 1;
        let after_b = tour.next(b);
        let there = tour.position(b);
        let (from, to) = (here.min(there) + 1, here.max(there));
        // The first of the stretch becomes its last and goes on to what follows.
        let (first, follows) = if here < there { (after_a, after_b) } else { (after_b, after_a) };
        let on = tour.leg_seconds(tour.exit_reversed(first), follows, tour.entry(follows));
        // The leg into the stretch starts at the earlier of the two items.
        let into = if here < there {
            taken
        } else {
            tour.space.travel.seconds(tour.exit(b), tour.entry_reversed(a))
        };
        let gain = given + tour.leg_after(b) - into - on;
        if gain <= EPSILON || from >= to || !tour.may_reverse(from, to) {
            continue;
        }
        let gain = gain - tour.reversal_cost(from, to);
        if gain > EPSILON {
            tour.reverse(from, to);
            queue.push_all(&[a, b, after_a, after_b]);
            return Some(gain);
        }
    }
    None
}

/// 2-opt: reverses the stretch between `a` and a near `b` so that the two entries become neighbours.
fn two_opt_before(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    // Home counts as the end of the tour here.
    let end = |tour: &Tour, i: u32| if i == tour.space.home { tour.last() + 1 } else { tour.position(i) };
    let here = end(tour, a);
    let before_a = tour.previous(a);
    let given = tour.leg_before(a);
    for &b in near.of_entry(tour, a) {
        let there = end(tour, b);
        let (first, follows) = if here < there { (a, b) } else { (b, a) };
        let taken = tour.leg_seconds(tour.exit_reversed(first), follows, tour.entry(follows));
        if taken >= given - EPSILON {
            continue;
        }
        tour.priced += 1;
        let before_b = tour.previous(b);
        let (u, w) = if here < there { (before_a, before_b) } else { (before_b, before_a) };
        let into = tour.space.travel.seconds(tour.exit(u), tour.entry_reversed(w));
        let gain = given + tour.leg_before(b) - taken - into;
        let (from, to) = (here.min(there), here.max(there) - 1);
        if gain <= EPSILON || from >= to || !tour.may_reverse(from, to) {
            continue;
        }
        let gain = gain - tour.reversal_cost(from, to);
        if gain > EPSILON {
            tour.reverse(from, to);
            queue.push_all(&[a, b, before_a, before_b]);
            return Some(gain);
        }
    }
    None
}

/// Or-3opt without reversal: the head goes from `a` to a near `b`, and from some `c` to what followed `a`. So two
/// neighbouring stretches change places, each in its own direction.
fn exchange(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    let here = tour.position(a);
    let after_a = tour.next(a);
    let given = tour.leg_after(a);
    for &b in near.of_exit(tour, a) {
        let left = given - tour.edge_here(a, b);
        if left <= EPSILON {
            continue;
        }
        if b == after_a || b == tour.space.home {
            continue;
        }
        let (there, before_b) = (tour.position(b), tour.previous(b));
        let left = left + tour.leg_before(b);
        for &c in near.of_entry(tour, after_a) {
            let left = left - tour.edge_here(c, after_a);
            if left <= EPSILON {
                continue;
            }
            tour.priced += 1;
            let after_c = tour.next(c);
            let on = tour.leg_seconds(tour.exit(before_b), after_c, tour.entry(after_c));
            let gain = left + tour.leg_after(c) - on;
            if gain <= EPSILON {
                continue;
            }
            let cut = tour.position(c);
            let (from, middle, to) = if here < there && there <= cut {
                (here + 1, there - 1, cut)
            } else if (1..=here).contains(&there) && there <= cut && cut < here {
                (there, cut, here)
            } else {
                continue;
            };
            if tour.may_exchange(from, middle, to) {
                tour.exchange(from, middle, to);
                queue.push_all(&[a, after_a, before_b, b, c, after_c]);
                return Some(gain);
            }
        }
    }
    None
}
