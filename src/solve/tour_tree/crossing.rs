//! Two tours crossed: stretches of the same items, in an order and with entries of the other tour where those cost less.
//!
//! A cycle of kicks ends in a tour with a flaw here and a flaw there, the next cycle in one with flaws elsewhere.
//! Where both tours visit the same items in a stretch, in whatever order, one may take over the other's way through
//! it, and what comes of it is as good as both in every such stretch. Precedence is kept: what is in the stretch has
//! the other's order, and what is outside stays before or behind. Groups are not heeded.
//! After the partition crossover of Whitley, Hains & Howe (GECCO 2009), with common intervals in place of components.

use super::improve::EPSILON;
use super::space::index;
use super::tour::{Kept, Tour};
use std::collections::VecDeque;

/// Tours kept to cross with: the last of this many cycles.
const MOST: usize = 8;

/// What the last cycles ended in.
#[derive(Default)]
pub(super) struct Elites {
    kept: VecDeque<Kept>,
}

impl Elites {
    /// Crosses a tour with each of them, and with the best; gives the seconds gained.
    pub(super) fn cross(&self, tour: &mut Tour, best: &Kept) -> f64 {
        self.kept.iter().chain([best]).map(|other| cross(tour, other)).sum()
    }

    /// One more, in place of the oldest.
    pub(super) fn keep(&mut self, kept: Kept) {
        self.kept.truncate(MOST - 1);
        self.kept.push_front(kept);
    }
}

/// A stretch that costs less the other's way.
struct Stretch {
    /// Positions in the tour, and the position in the other where it begins.
    from: usize,
    to: usize,
    there: usize,
    turned: bool,
    gain: f64,
}

/// Takes over from `other` whatever stretch costs less there, the best first; gives the seconds gained.
pub(super) fn cross(tour: &mut Tour, other: &Kept) -> f64 {
    let mut total = 0.0;
    while let Some(best) = best_stretch(tour, other) {
        let mut order: Vec<u32> = (0..=tour.last()).map(|p| tour.item(p)).collect();
        let length = best.to - best.from + 1;
        let part = &mut order[best.from..=best.to];
        part.copy_from_slice(&other.order[best.there..best.there + length]);
        if best.turned {
            part.reverse();
        }
        tour.reorder(order);
        for p in best.from..=best.to {
            let item = tour.item(p);
            tour.enter(item, other.at[item as usize]);
        }
        total += best.gain;
    }
    total
}

fn best_stretch(tour: &mut Tour, other: &Kept) -> Option<Stretch> {
    let space = &tour.space;
    let last = tour.last();
    let mut position = vec![0; other.at.len()];
    for (p, &item) in (0..).zip(&other.order) {
        position[item as usize] = p;
    }
    let entry = |item: u32| space.places(item)[other.at[item as usize] as usize];
    let exit = |item: u32| space.exit(item, other.at[item as usize]);
    // Seconds from the first item to the one at a position, entries included, here and there.
    let mut here = vec![0.0; last + 1];
    let mut there = vec![0.0; last + 1];
    for p in 1..=last {
        let (a, b) = (tour.item(p - 1), tour.item(p));
        here[p] = here[p - 1] + tour.edge(a, b) + tour.extra(b);
        let (a, b) = (other.order[p - 1], other.order[p]);
        there[p] =
            there[p - 1] + space.travel.seconds(exit(a), entry(b)) + space.extra(b, other.at[b as usize]);
    }
    let may_turn =
        space.travel.symmetric && !space.precedence.any && !(0..space.home).any(|i| space.two_ends(i));
    let mut best: Option<Stretch> = None;
    let mut most = EPSILON;
    for from in 1..=last {
        let (mut low, mut high) = (usize::MAX, 0);
        for to in from..=last {
            let p = position[tour.item(to) as usize];
            (low, high) = (low.min(p), high.max(p));
            if high - low != to - from {
                continue;
            }
            let (before, after) = (tour.item(from - 1), tour.item(to + 1));
            let now = tour.edge(before, tour.item(from)) + tour.extra(tour.item(from)) + here[to]
                - here[from]
                + tour.edge(tour.item(to), after);
            let (first, end) = (other.order[low], other.order[high]);
            let inner = space.extra(first, other.at[first as usize]) + there[high] - there[low];
            for turned in [false, true].into_iter().take(1 + usize::from(may_turn)) {
                if turned && space.rank[first as usize] != space.rank[end as usize] {
                    continue;
                }
                let (a, b) = if turned { (end, first) } else { (first, end) };
                let then = space.travel.seconds(tour.exit(before), entry(a))
                    + inner
                    + tour.way(exit(b), after, tour.entry(after));
                if now - then > most {
                    most = now - then;
                    best = Some(Stretch { from, to, there: low, turned, gain: most });
                }
            }
        }
    }
    tour.priced += u64::from(index(last * last / 16));
    best
}
