//! The usual kick: two neighbouring stretches of the tour change places, each in its own direction.
//!
//! This is a segment double bridge. It keeps the direction of every stretch, so that precedence seldom forbids it, and no
//! single local move undoes it. One kick in a few also enters an item at a random place.

use super::config::CONFIG;
use super::improve_entry::improve_entry;
use super::index::index;
use super::queue::Queue;
use super::tour::Tour;
use crate::solve::rng::{Draw, Rng};

/// Two neighbouring stretches of a tour, by the positions of the first item and of the last one of each.
#[derive(Clone, Copy)]
pub(super) struct Stretches {
    pub(super) from: usize,
    pub(super) middle: usize,
    pub(super) to: usize,
}

/// Draws two neighbouring stretches anywhere in the tour, each of at most `longest` items. `None` if they do not fit in.
pub(super) fn draw_stretches(tour: &Tour, rng: &mut Rng, longest: usize) -> Option<Stretches> {
    let last = tour.last();
    // Of two neighbouring stretches one has at most half of the items; but a large group only moves as a whole.
    let most = if tour.space.problem.groups.is_empty() { last / 2 } else { last };
    let longest = longest.min(most).max(1);
    let (one, two) = (rng.log_uniform(longest), rng.log_uniform(longest));
    if one + two > last {
        return None;
    }
    let from = 1 + rng.below(last + 1 - one - two);
    Some(Stretches { from, middle: from + one - 1, to: from + one + two - 1 })
}

/// Exchanges two stretches and returns the extra cost in seconds; `None` if precedence forbids the exchange.
pub(super) fn exchange(
    tour: &mut Tour,
    queue: &mut Queue,
    rng: &mut Rng,
    stretches: Stretches,
) -> Option<f64> {
    let Stretches { from, middle, to } = stretches;
    if !tour.may_exchange(from, middle, to) {
        return None;
    }
    let t = &mut *tour;
    let (a, b, c) = (t.item(from - 1), t.item(from), t.item(middle));
    let (d, e, f) = (t.item(middle + 1), t.item(to), t.item(to + 1));
    let given = t.leg_after(a) + t.leg_after(c) + t.leg_after(e);
    t.exchange(from, middle, to);
    let mut change = t.leg_after(a) + t.leg_after(e) + t.leg_after(c) - given;
    if rng.below(CONFIG.kick.draw_entry) == 0 {
        change += draw_entry(tour, queue, rng, b);
    }
    // Entries are improved first: otherwise 2-opt takes a small kick back before better entries can make it pay. The
    // item with the drawn entry comes last, so that the entries of the others can follow it.
    for item in [a, c, d, e, f].into_iter().filter(|&i| i != b).chain([b]) {
        change -= improve_entry(tour, queue, item).unwrap_or(0.0);
        queue.push(item);
    }
    Some(change)
}

/// Enters an item at a random place and returns the extra cost in seconds.
fn draw_entry(tour: &mut Tour, queue: &mut Queue, rng: &mut Rng, item: u32) -> f64 {
    let at = rng.below(tour.space.places(item).len());
    let t = &mut *tour;
    let (before, after) = (t.previous(item), t.next(item));
    let given = t.leg_before(item) + t.leg_after(item) + t.extra(item);
    t.enter(item, index(at));
    queue.push(before);
    queue.push(after);
    t.leg_before(item) + t.leg_after(item) + t.extra(item) - given
}
