//! Local search from a queue of touched items, until no move of theirs gains.
//!
//! For an item, in this order: a better entry; moving it elsewhere, entered anew; reversing a stretch so that it
//! meets a near item (2-opt); exchanging two neighbouring stretches (the Or-3opt that keeps directions, which is the
//! move that precedence likes best); moving a chain of 2 or 3 that starts or ends with it, also turned round.
//! Candidates come from the neighbour lists of the gate where the item is entered or left now, and are dropped as
//! soon as the first new way is no shorter than the one given up (the gain criterion of Lin and Kernighan, 1973).
//! A move is priced in constant time; whether precedence allows it is looked up only when it gains.
//!
//! Chains of reversals after Lin and Kernighan were tried and take longer than they gain: `docs/internals/tuning.md`.

use super::chain::move_chain;
use super::neighbours::Neighbours;
use super::queue::Queue;
use super::reenter::reenter;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;

/// Improves the tour around one item until no move of its gains; gives the seconds gained.
pub(super) fn improve(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, item: u32) -> f64 {
    let mut total = 0.0;
    loop {
        let gain = reenter(tour, queue, item)
            .or_else(|| relocate(tour, near, queue, item))
            .or_else(|| turn_ahead(tour, near, queue, item))
            .or_else(|| turn_behind(tour, near, queue, item))
            .or_else(|| exchange(tour, near, queue, item))
            .or_else(|| move_chain(tour, near, queue, item));
        match gain {
            Some(g) => total += g,
            None => return total,
        }
    }
}

/// The item taken out and put in elsewhere, at its best entry there: the best of all candidates.
fn relocate(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, item: u32) -> Option<f64> {
    if item == tour.space.home {
        return None;
    }
    let here = tour.position(item);
    let (before, after) = (tour.previous(item), tour.next(item));
    let freed = tour.way_to(item) + tour.way_on(item) + tour.extra(item) - tour.edge_here(before, after);
    let reaching = tour.space.reaching(item);
    let mut best: Option<(u32, u32, u32)> = None;
    let mut most = EPSILON;
    for &b in near.of_item(item) {
        for (from, to) in [(b, tour.next(b)), (tour.previous(b), b)] {
            if from == item || to == item {
                continue;
            }
            tour.priced += 1;
            let given = freed + tour.way_on(from);
            // Most places are too far by the way there alone.
            let left = given - reaching.at_least(tour.exit(from), false);
            if left <= most {
                continue;
            }
            let gap = tour.gap(from, to);
            if left - gap.to.map_or(0.0, |q| reaching.at_least(q, true)) <= most {
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

/// 2-opt: the stretch between `a` and a near `b` reversed, so that one leaves for the other's exit.
fn turn_ahead(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    let here = tour.position(a);
    let after_a = tour.next(a);
    let given = tour.way_on(a);
    for &b in near.of_exit(tour, a) {
        let taken = tour.space.travel.seconds_here(tour.exit(a), tour.exit(b));
        if taken >= given - EPSILON {
            continue;
        }
        tour.priced += 1;
        let after_b = tour.next(b);
        let there = tour.position(b);
        let (from, to) = (here.min(there) + 1, here.max(there));
        // The first of the stretch becomes its last and goes on to what follows.
        let (first, follows) = if here < there { (after_a, after_b) } else { (after_b, after_a) };
        let on = tour.way(tour.entry(first), follows, tour.entry(follows));
        // Into the stretch the way is from the earlier of the two, whichever is nearer to go to.
        let into = if here < there { taken } else { tour.space.travel.seconds(tour.exit(b), tour.exit(a)) };
        let gain = given + tour.way_on(b) - into - on;
        if gain <= EPSILON || from >= to || !tour.may_reverse(from, to) {
            continue;
        }
        let gain = gain - tour.turning(from, to);
        if gain > EPSILON {
            tour.reverse(from, to);
            queue.push_all(&[a, b, after_a, after_b]);
            return Some(gain);
        }
    }
    None
}

/// 2-opt: the stretch between `a` and a near `b` reversed, so that one is entered from the other's entry.
fn turn_behind(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    // Coming back home is the end of the tour here.
    let end = |tour: &Tour, i: u32| if i == tour.space.home { tour.last() + 1 } else { tour.position(i) };
    let here = end(tour, a);
    let before_a = tour.previous(a);
    let given = tour.way_to(a);
    for &b in near.of_entry(tour, a) {
        let there = end(tour, b);
        let (first, follows) = if here < there { (a, b) } else { (b, a) };
        let taken = tour.way(tour.entry(first), follows, tour.entry(follows));
        if taken >= given - EPSILON {
            continue;
        }
        tour.priced += 1;
        let before_b = tour.previous(b);
        let (u, w) = if here < there { (before_a, before_b) } else { (before_b, before_a) };
        let into = tour.space.travel.seconds(tour.exit(u), tour.exit(w));
        let gain = given + tour.way_to(b) - taken - into;
        let (from, to) = (here.min(there), here.max(there) - 1);
        if gain <= EPSILON || from >= to || !tour.may_reverse(from, to) {
            continue;
        }
        let gain = gain - tour.turning(from, to);
        if gain > EPSILON {
            tour.reverse(from, to);
            queue.push_all(&[a, b, before_a, before_b]);
            return Some(gain);
        }
    }
    None
}

/// Or-3opt: `a` leaves for a near `b`, a near `c` leaves for what followed `a`: two neighbouring stretches change
/// places, each in its own direction.
fn exchange(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, a: u32) -> Option<f64> {
    let here = tour.position(a);
    let after_a = tour.next(a);
    let given = tour.way_on(a);
    for &b in near.of_exit(tour, a) {
        let left = given - tour.edge_here(a, b);
        if left <= EPSILON {
            continue;
        }
        if b == after_a || b == tour.space.home {
            continue;
        }
        let (there, before_b) = (tour.position(b), tour.previous(b));
        let left = left + tour.way_to(b);
        for &c in near.of_entry(tour, after_a) {
            let left = left - tour.edge_here(c, after_a);
            if left <= EPSILON {
                continue;
            }
            tour.priced += 1;
            let after_c = tour.next(c);
            let on = tour.way(tour.exit(before_b), after_c, tour.entry(after_c));
            let gain = left + tour.way_on(c) - on;
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
