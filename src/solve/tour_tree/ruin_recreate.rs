//! Ruin and recreate: some items are taken out together and put back one by one, each where it costs least.
//!
//! This is the kick for tours that exchanges of stretches do not change enough: with many precedences most exchanges are
//! forbidden, and in small problems the same few are tried again and again. A kick takes out a stretch, or items near each
//! other, or random items. It puts them back in random order, each in the best of all allowed gaps, of which a few are
//! overlooked. After Christiaens & Vanden Berghe, Transportation Science 54 (2020), and Smith & Imeson, Computers &
//! Operations Research 87 (2017).

use super::config::CONFIG;
use super::neighbours::Neighbours;
use super::queue::Queue;
use super::space::Space;
use super::tour::Tour;
use crate::solve::rng::{Draw, Rng};

/// Takes some items out, puts them back and queues what changed. Returns the extra cost in seconds; `None` if precedence
/// left an item no gap: the journal then takes the tour back.
pub(super) fn ruin_recreate(
    tour: &mut Tour,
    near: &Neighbours,
    queue: &mut Queue,
    rng: &mut Rng,
) -> Option<f64> {
    let mut removed = drawn(tour, near, rng);
    let mut rest = PartialTour::without(tour, &removed, queue);
    for k in (1..removed.len()).rev() {
        removed.swap(k, rng.below(k + 1));
    }
    for item in removed {
        let found = rest.cheapest(tour, rng, item)?;
        rest.put(tour, queue, item, found);
    }
    tour.reorder(rest.order, rest.legs);
    Some(rest.change)
}

/// Draws the items to be taken out.
fn drawn(tour: &Tour, near: &Neighbours, rng: &mut Rng) -> Vec<u32> {
    let count = rng.log_uniform(CONFIG.ruin.most_items.min(tour.last()));
    let mut removed = Vec::with_capacity(count);
    match rng.below(3) {
        0 => {
            let from = 1 + rng.below(tour.last() + 1 - count);
            removed.extend((from..from + count).map(|p| tour.item(p)));
        }
        kind => {
            removed.push(tour.item(1 + rng.below(tour.last())));
            // All items near those may be out already: then fewer are taken out.
            for _ in 0..4 * count {
                if removed.len() == count {
                    break;
                }
                let next = if kind == 1 {
                    let list = near.of_item(removed[rng.below(removed.len())]);
                    list[rng.below(list.len())]
                } else {
                    tour.item(1 + rng.below(tour.last()))
                };
                if next != tour.space.home && !removed.contains(&next) {
                    removed.push(next);
                }
            }
        }
    }
    removed
}

/// Where an item is put back.
struct Insertion {
    /// Its position in the order.
    position: usize,
    /// The place at which it is entered.
    at: u32,
    /// Extra cost, s.
    cost: f64,
}

/// The tour without the items that are out.
struct PartialTour {
    order: Vec<u32>,
    /// Seconds from each item to the next; the last leg goes home.
    legs: Vec<f64>,
    out: Vec<bool>,
    /// Cost relative to the whole tour, s.
    change: f64,
    /// Items that bound where another may be put: see [`PartialTour::bounds`].
    marked: Vec<bool>,
}

impl PartialTour {
    /// Takes items out of the tour; home must not be one of them.
    fn without(tour: &Tour, removed: &[u32], queue: &mut Queue) -> Self {
        let mut out = vec![false; tour.space.home as usize + 1];
        for &item in removed {
            out[item as usize] = true;
            for touched in [item, tour.previous(item), tour.next(item)] {
                queue.push(touched);
            }
        }
        let left = tour.last() + 1 - removed.len();
        let (mut order, mut legs) =
            (Vec::with_capacity(tour.last() + 1), Vec::with_capacity(tour.last() + 1));
        let mut change = 0.0;
        for p in 0..=tour.last() {
            let item = tour.item(p);
            let way = tour.leg_after(item);
            if out[item as usize] {
                change -= way + tour.extra(item);
                continue;
            }
            legs.push(way);
            order.push(item);
        }
        debug_assert_eq!(order.len(), left);
        for p in 0..left {
            let (item, next) = (order[p], order.get(p + 1).copied().unwrap_or(tour.space.home));
            if out[tour.next(item) as usize] {
                let way = tour.edge(item, next);
                change += way - legs[p];
                legs[p] = way;
            }
        }
        Self { order, legs, out, change, marked: Vec::new() }
    }

    fn put(&mut self, tour: &mut Tour, queue: &mut Queue, item: u32, found: Insertion) {
        let Insertion { position, at, cost } = found;
        let (before, after) =
            (self.order[position - 1], self.order.get(position).copied().unwrap_or(tour.space.home));
        tour.enter(item, at);
        queue.push(before);
        queue.push(after);
        self.legs[position - 1] = tour.edge(before, item);
        self.legs.insert(position, tour.edge(item, after));
        self.order.insert(position, item);
        self.out[item as usize] = false;
        self.change += cost;
    }

    /// The cheapest gap for an item that is out, and its best entry there.
    fn cheapest(&mut self, tour: &mut Tour, rng: &mut Rng, item: u32) -> Option<Insertion> {
        let space = &tour.space;
        let (first, last) = self.bounds(space, tour.ignores_nesting, item);
        let (reaching, rank) = (space.reaching(item), |i: u32| space.rank[i as usize]);
        let mut best = None;
        let mut least = f64::INFINITY;
        tour.priced += (last + 1).saturating_sub(first) as u64;
        for position in first..=last {
            let (from, to) =
                (self.order[position - 1], self.order.get(position).copied().unwrap_or(space.home));
            let ranked = (position == 1 || rank(from) <= rank(item))
                && (position == self.order.len() || rank(item) <= rank(to));
            if !ranked {
                continue;
            }
            let given = self.legs[position - 1];
            // Most gaps are too far away by the leg to the item alone.
            let there = reaching.at_least(tour.exit(from), false);
            if there - given >= least {
                continue;
            }
            let gap = tour.gap(from, to);
            let on = gap.to.map_or(0.0, |q| reaching.at_least(q, true));
            if there + on - given >= least || rng.below(CONFIG.ruin.blink) == 0 {
                continue;
            }
            let (at, seconds) = space.best_entry(item, gap, least + given);
            if seconds - given < least {
                least = seconds - given;
                best = Some(Insertion { position, at, cost: least });
            }
        }
        best
    }

    /// The first and last position that precedence leaves an item: after everything it must follow and before everything
    /// that must follow it, also where items that are out stand in between.
    fn bounds(&mut self, space: &Space, ignores_nesting: bool, item: u32) -> (usize, usize) {
        let mut places = (1, self.order.len());
        let p = &space.precedence;
        if ignores_nesting || !p.any {
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
