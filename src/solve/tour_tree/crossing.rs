//! Two tours crossed: stretches of the same items, in an order and with entries of the other tour where those cost less.
//!
//! A cycle of kicks ends in a tour with a flaw here and a flaw there, the next cycle in one with flaws elsewhere.
//! Where both tours visit the same items in a stretch, in whatever order, one may take over the other's way through
//! it, and what comes of it is as good as both in every such stretch. Precedence is kept: what is in the stretch has
//! the other's order, and what is outside stays before or behind. Groups are not respected.
//! What it gains is in `docs/internals/tuning.md`. After the partition crossover of Whitley, Hains & Howe (GECCO 2009), with
//! common intervals in place of components.

use super::kept::Kept;
use super::queue::Queue;
use super::tour::Tour;

/// Tours kept, one for each of the last cycles: more give more to choose from and take longer.
const MOST: usize = 8;
/// Longest stretch that is compared: one look at 10,000 contours stays short.
const LONGEST: usize = 1000;
/// Least gain of a stretch, s: sums along a tour are off by rounding.
const CLEAR: f64 = 1e-7;

/// What the last cycles ended in.
#[derive(Default)]
pub(super) struct Elites {
    kept: Vec<Kept>,
}

impl Elites {
    /// Those to cross with, by number: each of them, then the best tour.
    pub(super) fn partner<'k>(&'k self, number: usize, best: &'k Kept) -> Option<&'k Kept> {
        if number == self.kept.len() { Some(best) } else { self.kept.get(number) }
    }

    /// One more, in place of the oldest.
    pub(super) fn keep(&mut self, kept: Kept) {
        self.kept.truncate(MOST - 1);
        self.kept.insert(0, kept);
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

/// Takes over from `other` stretches that cost less there, as many as leave each other alone; gives the seconds gained:
/// none when there are no more. Touched items are queued.
pub(super) fn cross(tour: &mut Tour, queue: &mut Queue, other: &Kept) -> f64 {
    let found = stretches(tour, other);
    if found.is_empty() {
        return 0.0;
    }
    let mut order = tour.now().order.clone();
    for s in &found {
        let part = &mut order[s.from..=s.to];
        part.copy_from_slice(&other.order[s.there..=s.there + s.to - s.from]);
        if s.turned {
            part.reverse();
        }
    }
    for &item in found.iter().flat_map(|s| &order[s.from..=s.to]) {
        tour.enter(item, other.at[item as usize]);
    }
    let ways = tour.ways_of(&order);
    tour.reorder(order, ways);
    for item in found.iter().flat_map(|s| s.from - 1..=s.to + 1).map(|p| tour.item(p)) {
        queue.push(item);
    }
    found.iter().map(|s| s.gain).sum()
}

/// Stretches that cost less the other's way: of all positions the shortest that begins there, and of those that touch one
/// another short ones, as what one gains is known as long as what it begins and ends at stays.
fn stretches(tour: &mut Tour, other: &Kept) -> Vec<Stretch> {
    let space = &tour.space;
    let last = tour.last();
    let mut position = vec![0; other.at.len()];
    for (p, &item) in other.order.iter().enumerate() {
        position[item as usize] = p;
    }
    let entry = |item: u32| space.places(item).at(other.at[item as usize]);
    let exit = |item: u32| space.exit(item, other.at[item as usize]);
    // Seconds from the first item to the one at a position, entries included, here and there.
    let mut here = vec![0.0; last + 1];
    let mut there = vec![0.0; last + 1];
    for p in 1..=last {
        let b = tour.item(p);
        here[p] = here[p - 1] + tour.way_to(b) + tour.extra(b);
        let (a, b) = (other.order[p - 1], other.order[p]);
        there[p] =
            there[p - 1] + space.travel.seconds(exit(a), entry(b)) + space.extra(b, other.at[b as usize]);
    }
    let may_turn =
        space.travel.symmetric && !space.precedence.any && !(0..space.home).any(|i| space.two_ends(i));
    let mut found: Vec<Stretch> = Vec::new();
    let mut looked = 0;
    for from in 1..=last {
        let (before, first) = (tour.item(from - 1), tour.item(from));
        // Where both come to an item from the same one and enter it alike, the stretch without it gains as much.
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
            if high - low >= LONGEST {
                break;
            }
            if high - low != to - from {
                continue;
            }
            let after = tour.item(to + 1);
            let now =
                tour.way_to(first) + tour.extra(first) + here[to] - here[from] + tour.way_on(tour.item(to));
            let (start, end) = (other.order[low], other.order[high]);
            let inner = space.extra(start, other.at[start as usize]) + there[high] - there[low];
            let turns = may_turn && space.rank[start as usize] == space.rank[end as usize];
            let mut then = (f64::INFINITY, false);
            for (turned, a, b) in [(false, start, end), (true, end, start)] {
                let seconds = space.travel.seconds(tour.exit(before), entry(a))
                    + tour.way(exit(b), after, tour.entry(after));
                if (turns || !turned) && seconds < then.0 {
                    then = (seconds, turned);
                }
            }
            let gain = now - inner - then.0;
            if gain > CLEAR {
                let touched = found.last().filter(|s| from <= s.to + 2).map(|s| s.to - s.from);
                if touched.is_some_and(|length| length <= to - from) {
                    break;
                }
                if touched.is_some() {
                    found.pop();
                }
                found.push(Stretch { from, to, there: low, turned: then.1, gain });
                break;
            }
        }
    }
    // A look is much less than a move.
    tour.priced += looked / 16;
    found
}
