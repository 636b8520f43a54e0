//! Ruin and recreate: some items are taken out together and put back one by one, each where it costs least.
//!
//! A kick for tours that exchanging stretches does not loosen: with precedence all over an exchange is mostly
//! forbidden, and in small problems the same few are tried again and again. Taken out is a stretch, or items near to
//! one another, or any; put back in random order, best of all allowed places, of which one in [`BLINK`] is
//! overlooked. After Christiaens & Vanden Berghe, Transportation Science 54 (2020), and Smith & Imeson, Computers &
//! Operations Research 87 (2017).

use super::neighbours::Neighbours;
use super::queue::Queue;
use super::space::Space;
use super::tour::Tour;
use crate::solve::rng::{Draw, Rng};

/// One place in this many is overlooked, as in Christiaens & Vanden Berghe.
const BLINK: usize = 100;
/// Most items taken out at once, drawn evenly on a log scale: fewer never leave some local optima.
const MOST: usize = 40;

/// Takes out up to [`MOST`] items and puts them back; gives the seconds that costs. Touched items are queued. `None`
/// when precedence left an item no place: the journal then takes the tour back.
pub(super) fn rebuild(tour: &mut Tour, near: &Neighbours, queue: &mut Queue, rng: &mut Rng) -> Option<f64> {
    let mut gone = chosen(tour, near, rng);
    let mut rest = Rest::without(tour, &gone, queue);
    for k in (1..gone.len()).rev() {
        gone.swap(k, rng.below(k + 1));
    }
    for item in gone {
        let found = rest.cheapest(tour, rng, item)?;
        rest.put(tour, queue, item, found);
    }
    tour.reorder(rest.order, rest.ways);
    Some(rest.change)
}

/// Items to be taken out.
fn chosen(tour: &Tour, near: &Neighbours, rng: &mut Rng) -> Vec<u32> {
    let count = rng.log_uniform(MOST.min(tour.last()));
    let mut gone = Vec::with_capacity(count);
    match rng.below(3) {
        0 => {
            let from = 1 + rng.below(tour.last() + 1 - count);
            gone.extend((from..from + count).map(|p| tour.item(p)));
        }
        way => {
            gone.push(tour.item(1 + rng.below(tour.last())));
            // Near ones may all be out already: then fewer go.
            for _ in 0..4 * count {
                if gone.len() == count {
                    break;
                }
                let next = if way == 1 {
                    let list = near.of_item(gone[rng.below(gone.len())]);
                    list[rng.below(list.len())]
                } else {
                    tour.item(1 + rng.below(tour.last()))
                };
                if next != tour.space.home && !gone.contains(&next) {
                    gone.push(next);
                }
            }
        }
    }
    gone
}

/// A gap in the order: the item at `place` would move on for one that is entered at `at`.
struct Found {
    place: usize,
    at: u32,
    /// Seconds on top.
    more: f64,
}

/// What is left of the tour while items are out.
struct Rest {
    order: Vec<u32>,
    /// Seconds from each to the one after it; the last goes home.
    ways: Vec<f64>,
    out: Vec<bool>,
    /// Seconds more than the tour had.
    change: f64,
    /// Items that bound where one may go: see [`Rest::bounds`].
    marked: Vec<bool>,
}

impl Rest {
    /// The tour without some items, home not one of them.
    fn without(tour: &Tour, gone: &[u32], queue: &mut Queue) -> Self {
        let mut out = vec![false; tour.space.home as usize + 1];
        for &item in gone {
            out[item as usize] = true;
            for touched in [item, tour.previous(item), tour.next(item)] {
                queue.push(touched);
            }
        }
        let left = tour.last() + 1 - gone.len();
        let (mut order, mut ways) =
            (Vec::with_capacity(tour.last() + 1), Vec::with_capacity(tour.last() + 1));
        let mut change = 0.0;
        for p in 0..=tour.last() {
            let item = tour.item(p);
            let way = tour.way_on(item);
            if out[item as usize] {
                change -= way + tour.extra(item);
                continue;
            }
            ways.push(way);
            order.push(item);
        }
        debug_assert_eq!(order.len(), left);
        for p in 0..left {
            let (item, next) = (order[p], order.get(p + 1).copied().unwrap_or(tour.space.home));
            if out[tour.next(item) as usize] {
                let way = tour.edge(item, next);
                change += way - ways[p];
                ways[p] = way;
            }
        }
        Self { order, ways, out, change, marked: Vec::new() }
    }

    fn put(&mut self, tour: &mut Tour, queue: &mut Queue, item: u32, found: Found) {
        let Found { place, at, more } = found;
        let (before, after) =
            (self.order[place - 1], self.order.get(place).copied().unwrap_or(tour.space.home));
        tour.enter(item, at);
        queue.push(before);
        queue.push(after);
        self.ways[place - 1] = tour.edge(before, item);
        self.ways.insert(place, tour.edge(item, after));
        self.order.insert(place, item);
        self.out[item as usize] = false;
        self.change += more;
    }

    /// Where an item that is out costs least, and where it is entered there.
    fn cheapest(&mut self, tour: &mut Tour, rng: &mut Rng, item: u32) -> Option<Found> {
        let space = &tour.space;
        let (first, last) = self.bounds(space, tour.free, item);
        let (reaching, rank) = (space.reaching(item), |i: u32| space.rank[i as usize]);
        let mut best = None;
        let mut least = f64::INFINITY;
        tour.priced += (last + 1).saturating_sub(first) as u64;
        for place in first..=last {
            let (from, to) = (self.order[place - 1], self.order.get(place).copied().unwrap_or(space.home));
            let ranked = (place == 1 || rank(from) <= rank(item))
                && (place == self.order.len() || rank(item) <= rank(to));
            if !ranked {
                continue;
            }
            let given = self.ways[place - 1];
            // Most places are too far by the way there alone.
            let there = reaching.at_least(tour.exit(from), false);
            if there - given >= least {
                continue;
            }
            let gap = tour.gap(from, to);
            let on = gap.to.map_or(0.0, |q| reaching.at_least(q, true));
            if there + on - given >= least || rng.below(BLINK) == 0 {
                continue;
            }
            let (at, seconds) = space.best_entry(item, gap, least + given);
            if seconds - given < least {
                least = seconds - given;
                best = Some(Found { place, at, more: least });
            }
        }
        best
    }

    /// The first and the last place that precedence leaves an item: behind what it has to follow, and before what has
    /// to follow it, be it next in line or by way of items that are out themselves.
    fn bounds(&mut self, space: &Space, free: bool, item: u32) -> (usize, usize) {
        let mut places = (1, self.order.len());
        let p = &space.precedence;
        if free || !p.any {
            return places;
        }
        let bound = |i, later| if later { p.after(i) } else { p.before(i) };
        for later in [false, true].into_iter().filter(|&later| !bound(item, later).is_empty()) {
            self.marked.clear();
            self.marked.resize(self.out.len(), false);
            let (mut open, mut any) = (vec![item], false);
            while let Some(next) = open.pop() {
                for &other in bound(next, later) {
                    if !std::mem::replace(&mut self.marked[other as usize], true) {
                        if self.out[other as usize] { open.push(other) } else { any = true }
                    }
                }
            }
            let bounds = |i: &u32| self.marked[*i as usize] && !self.out[*i as usize];
            if any && later {
                places.1 = self.order.iter().position(bounds).unwrap_or(places.1);
            } else if any {
                places.0 = self.order.iter().rposition(bounds).map_or(1, |at| at + 1);
            }
        }
        places
    }
}
