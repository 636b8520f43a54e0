//! Recombination of two tours: where both visit the same items in a stretch, the cheaper way through it is taken.
//!
//! A cycle of kicks ends in a tour with some flaws, and the next cycle in one with flaws elsewhere. Where both tours visit
//! the same items in a stretch, in whatever order, one may take over the other's order and entries, and the result is as
//! good as the better one in every such stretch. Precedence is kept: the stretch has the other tour's order, and what is
//! outside stays before or after it. Groups are not respected. After the partition crossover of Whitley, Hains & Howe
//! (GECCO 2009), with common intervals in place of components.

use super::config::CONFIG;
use super::queue::Queue;
use super::snapshot::TourSnapshot;
use super::tour::Tour;

/// The tours that the last cycles ended in, the latest first.
#[derive(Default)]
pub(super) struct Elites {
    tours: Vec<TourSnapshot>,
}

impl Elites {
    /// The partners of a recombination by number: each elite, then the best tour.
    pub(super) fn partner<'k>(&'k self, number: usize, best: &'k TourSnapshot) -> Option<&'k TourSnapshot> {
        if number == self.tours.len() { Some(best) } else { self.tours.get(number) }
    }

    /// Adds a tour, in place of the oldest.
    pub(super) fn add(&mut self, snapshot: TourSnapshot) {
        self.tours.truncate(CONFIG.recombination.elites - 1);
        self.tours.insert(0, snapshot);
    }
}

/// A stretch that costs less in the other tour.
struct Stretch {
    /// First and last position in the tour, and first position in the other.
    from: usize,
    to: usize,
    there: usize,
    reversed: bool,
    gain: f64,
}

/// Takes over stretches that cost less in `other` and do not touch each other, and queues what changed. Returns the
/// seconds gained, 0 if no stretch costs less.
pub(super) fn recombine(tour: &mut Tour, queue: &mut Queue, other: &TourSnapshot) -> f64 {
    let found = stretches(tour, other);
    if found.is_empty() {
        return 0.0;
    }
    let mut order = tour.current().order.clone();
    for s in &found {
        let part = &mut order[s.from..=s.to];
        part.copy_from_slice(&other.order[s.there..=s.there + s.to - s.from]);
        if s.reversed {
            part.reverse();
        }
    }
    for &item in found.iter().flat_map(|s| &order[s.from..=s.to]) {
        tour.enter(item, other.at[item as usize]);
    }
    let legs = tour.legs_of(&order);
    tour.reorder(order, legs);
    for item in found.iter().flat_map(|s| s.from - 1..=s.to + 1).map(|p| tour.item(p)) {
        queue.push(item);
    }
    found.iter().map(|s| s.gain).sum()
}

/// Stretches that cost less in the other tour: for each position the shortest that begins there. Of stretches that touch
/// each other the shorter one is taken, because a gain is exact only while both neighbours of the stretch stay.
fn stretches(tour: &mut Tour, other: &TourSnapshot) -> Vec<Stretch> {
    let space = &tour.space;
    let last = tour.last();
    let mut position = vec![0; other.at.len()];
    for (p, &item) in other.order.iter().enumerate() {
        position[item as usize] = p;
    }
    let entry = |item: u32| space.places(item).at(other.at[item as usize]);
    let exit = |item: u32| space.exit(item, other.at[item as usize]);
    // Seconds from the first item to the one at a position, entries included, in this tour and in the other.
    let mut here = vec![0.0; last + 1];
    let mut there = vec![0.0; last + 1];
    for p in 1..=last {
        let b = tour.item(p);
        here[p] = here[p - 1] + tour.leg_before(b) + tour.extra(b);
        let (a, b) = (other.order[p - 1], other.order[p]);
        there[p] =
            there[p - 1] + space.travel.seconds(exit(a), entry(b)) + space.extra(b, other.at[b as usize]);
    }
    let may_reverse =
        space.travel.symmetric && !space.precedence.any && !(0..space.home).any(|i| space.two_ends(i));
    // Each of the sums that a gain is the difference of is rounded by at most a part of the whole sum.
    let rounding =
        2.0 * CONFIG.recombination.longest.min(last) as f64 * f64::EPSILON * here[last].max(there[last]);
    let least_gain = CONFIG.recombination.least_gain.max(rounding);
    let mut found: Vec<Stretch> = Vec::new();
    let mut looked = 0;
    for from in 1..=last {
        let (before, first) = (tour.item(from - 1), tour.item(from));
        // Where both tours come from the same item and enter this one at the same place, the stretch without it gains
        // as much.
        let alike = position[before as usize] + 1 == position[first as usize]
            && tour.at(first) == other.at[first as usize];
        if alike {
            continue;
        }
        let (mut low, mut high) = (usize::MAX, 0);
        for to in from..=last {
            looked += 1;
            let p = position[tour.item(to) as usize];
            (low, high) = (low.min(p), high.max(p));
            if high - low >= CONFIG.recombination.longest {
                break;
            }
            if high - low != to - from {
                continue;
            }
            let after = tour.item(to + 1);
            let now = tour.leg_before(first) + tour.extra(first) + here[to] - here[from]
                + tour.leg_after(tour.item(to));
            let (start, end) = (other.order[low], other.order[high]);
            let inner = space.extra(start, other.at[start as usize]) + there[high] - there[low];
            let reversible = may_reverse && space.rank[start as usize] == space.rank[end as usize];
            let mut then = (f64::INFINITY, false);
            for (reversed, a, b) in [(false, start, end), (true, end, start)] {
                let seconds = space.travel.seconds(tour.exit(before), entry(a))
                    + tour.leg_seconds(exit(b), after, tour.entry(after));
                if (reversible || !reversed) && seconds < then.0 {
                    then = (seconds, reversed);
                }
            }
            let gain = now - inner - then.0;
            if gain > least_gain {
                let touched = found.last().filter(|s| from <= s.to + 2).map(|s| s.to - s.from);
                if touched.is_some_and(|length| length <= to - from) {
                    break;
                }
                if touched.is_some() {
                    found.pop();
                }
                found.push(Stretch { from, to, there: low, reversed: then.1, gain });
                break;
            }
        }
    }
    // A look takes about a sixteenth of a move.
    tour.priced += looked / 16;
    found
}

#[cfg(test)]
mod tests;
