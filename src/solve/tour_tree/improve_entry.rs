//! The local move that improves the entry of an item; if the item slides along its ring, its neighbours follow.

use super::queue::Queue;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;

/// Enters an item at its best place between its neighbours; returns the seconds gained.
pub(super) fn improve_entry(tour: &mut Tour, queue: &mut Queue, item: u32) -> Option<f64> {
    if tour.space.places(item).len() == 1 || tour.is_entered_best(item) {
        return None;
    }
    let (before, after) = (tour.previous(item), tour.next(item));
    let gap = tour.gap(before, after);
    tour.priced += 1;
    let now = tour.space.through(item, tour.at(item), gap);
    let near = tour.space.better_near(item, (tour.at(item), now), gap);
    let best = tour.space.best_entry(item, gap, near.1);
    let best = if best.1 < near.1 { best } else { near };
    if best.1 >= now - EPSILON {
        tour.set_entered_best(item);
        return None;
    }
    let steps = tour.space.steps(item, tour.at(item), best.0);
    tour.enter(item, best.0);
    tour.set_entered_best(item);
    queue.push_all(&[item, before, after]);
    let gain = now - best.1;
    Some(gain + slide_on(tour, queue, [item, before], steps) + slide_on(tour, queue, [item, after], steps))
}

/// Slides two neighbouring items together. `item` has slid some steps along its ring; `other` follows, and both go on with
/// doubled steps as long as that gains. If they moved in turn only, they would pass sides that face each other place by
/// place, which took three quarters of the first milliseconds on sheets of large parts. Returns the seconds gained.
fn slide_on(tour: &mut Tour, queue: &mut Queue, [item, other]: [u32; 2], steps: i32) -> f64 {
    if steps == 0 || item == other {
        return 0.0;
    }
    let space = &tour.space;
    let gap = tour.gap(tour.previous(other), tour.next(other));
    let now = space.through(other, tour.at(other), gap);
    let near = space.better_near(other, (tour.at(other), now), gap);
    let follow = space.steps(other, tour.at(other), near.0);
    tour.priced += 1;
    if follow == 0 || near.1 >= now - EPSILON {
        return 0.0;
    }
    let space = &tour.space;
    let [first, last] = if tour.next(item) == other { [item, other] } else { [other, item] };
    let (before, after) = (tour.previous(first), tour.next(last));
    let price = |[own, others]: [u32; 2]| {
        let [a, b] = if first == item { [own, others] } else { [others, own] };
        let (p, q) = (space.places(first).at(a), space.places(last).at(b));
        let (into, on) =
            (tour.leg_seconds(tour.exit(before), first, p), tour.leg_seconds(q, after, tour.entry(after)));
        into + space.extra(first, a) + space.travel.seconds(p, q) + space.extra(last, b) + on
    };
    let start = [tour.at(item), near.0];
    let mut best = (start, price(start));
    let from = price([tour.at(item), tour.at(other)]);
    let (mut on, mut looked) = ([steps, follow], 0);
    loop {
        let there = [space.stepped(item, start[0], on[0]), space.stepped(other, start[1], on[1])];
        let seconds = price(there);
        looked += 1;
        if seconds >= best.1 - EPSILON {
            break;
        }
        best = (there, seconds);
        on = on.map(|steps| 2 * steps);
    }
    tour.priced += looked;
    if from - best.1 <= EPSILON {
        return 0.0;
    }
    tour.enter(item, best.0[0]);
    tour.enter(other, best.0[1]);
    queue.push_all(&[before, first, last, after]);
    from - best.1
}
