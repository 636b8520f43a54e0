//! The kick: two neighbouring stretches of the tour change places, each in its own direction.
//!
//! A segment double-bridge: feasible with precedence, and no local move undoes it at once. Now and then an entry is
//! drawn with it.

use super::index::index;
use super::queue::Queue;
use super::reenter::reenter;
use super::tour::Tour;
use crate::solve::rng::{Draw, Rng};

/// Longest stretch that a kick moves, drawn evenly on a log scale: mostly small and cheap, and whole parts still change places.
const LONGEST: usize = 300;

/// One kick in this many also draws an entry: without it, entries that pay only together are never found.
const DRAW_ENTRY: usize = 4;

/// Exchanges two neighbouring stretches; gives the seconds that costs, if precedence allows it.
pub(super) fn exchange(tour: &mut Tour, queue: &mut Queue, rng: &mut Rng) -> Option<f64> {
    let last = tour.last();
    // Of two stretches one is no longer than half of all; but a large group only moves as a whole.
    let most = if tour.space.problem.groups.is_empty() { last / 2 } else { last };
    let longest = LONGEST.min(most).max(1);
    let (one, two) = (rng.log_uniform(longest), rng.log_uniform(longest));
    if one + two > last {
        return None;
    }
    let from = 1 + rng.below(last + 1 - one - two);
    let (middle, to) = (from + one - 1, from + one + two - 1);
    if !tour.may_exchange(from, middle, to) {
        return None;
    }
    let t = &mut *tour;
    let (a, b, c) = (t.item(from - 1), t.item(from), t.item(middle));
    let (d, e, f) = (t.item(middle + 1), t.item(to), t.item(to + 1));
    let given = t.way_on(a) + t.way_on(c) + t.way_on(e);
    t.exchange(from, middle, to);
    let mut change = t.way_on(a) + t.way_on(e) + t.way_on(c) - given;
    if rng.below(DRAW_ENTRY) == 0 {
        change += draw_entry(tour, queue, rng, b);
    }
    // Entries first: otherwise 2-opt takes a small kick back before they could make it pay.
    // The one with an entry drawn comes last, so that the others may settle with it.
    for item in [a, c, d, e, f].into_iter().filter(|&i| i != b).chain([b]) {
        change -= reenter(tour, queue, item).unwrap_or(0.0);
        queue.push(item);
    }
    Some(change)
}

/// Enters an item somewhere; gives the seconds that costs.
fn draw_entry(tour: &mut Tour, queue: &mut Queue, rng: &mut Rng, item: u32) -> f64 {
    let at = rng.below(tour.space.places(item).len());
    let t = &mut *tour;
    let (before, after) = (t.previous(item), t.next(item));
    let given = t.way_to(item) + t.way_on(item) + t.extra(item);
    t.enter(item, index(at));
    queue.push(before);
    queue.push(after);
    t.way_to(item) + t.way_on(item) + t.extra(item) - given
}
