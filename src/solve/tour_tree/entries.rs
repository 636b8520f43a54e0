//! All entries of an order chosen together: the cheapest path through layers of places, one layer for each item.
//!
//! This is dynamic programming along the order: for each place of a layer, the least cost so far. It runs once for every
//! place of the item with the fewest places, where the cycle is cut open; in benchmark instances that is often one place.
//! Local moves change one entry at a time; this finds what pays only together. It does not serve items with rings, whose
//! entries slide (`polish.rs`). Source: the cluster optimisation of Fischetti, Salazar & Toth, Operations Research 45 (1997).

use super::index::index;
use super::tour::Tour;
use super::travel::Place;
use crate::solve::epsilon::EPSILON;

/// The buffers of the dynamic programme, reused from call to call.
#[derive(Default)]
pub(super) struct Layers {
    /// The items in order, beginning with the one where the cycle is cut open.
    items: Vec<u32>,
    /// By place of the last layer: where the head leaves it, and the least cost up to there.
    reached: Vec<(Place, f64)>,
    /// Least cost by place of the next layer.
    next: Vec<f64>,
    /// Layer by layer: the best place before each place.
    from: Vec<u32>,
    /// The best entry of each item.
    best: Vec<u32>,
}

impl Layers {
    /// Enters every item where the whole tour costs least and returns the seconds gained. Calls `changed` with each item
    /// whose entry changes.
    pub(super) fn enter_best(&mut self, tour: &mut Tour, cost: f64, mut changed: impl FnMut(u32)) -> f64 {
        let count = |p: usize| tour.space.places(tour.item(p)).len();
        // A path without return is cut open at home, because only the layer of home knows that coming home costs nothing.
        let ends = if tour.space.problem.closed { tour.last() } else { 0 };
        let cut = (0..=ends).min_by_key(|&p| count(p)).unwrap_or(0);
        self.items.clear();
        self.items.extend((cut..=tour.last()).chain(0..cut).map(|p| tour.item(p)));
        let mut least = cost - EPSILON;
        self.best.clear();
        let first = self.items[0];
        for start in 0..index(tour.space.places(first).len()) {
            tour.priced += self.pass(tour, start);
            let end = tour.space.places(first).at(start);
            let mut total = (f64::INFINITY, 0);
            for (k, &(p, cost)) in (0..).zip(&self.reached) {
                let cost = cost + tour.leg_seconds(p, first, end);
                if cost < total.0 {
                    total = (cost, k);
                }
            }
            if total.0 < least {
                least = total.0;
                self.trace(tour, start, total.1);
            }
        }
        if self.best.is_empty() {
            return 0.0;
        }
        for (&item, &at) in self.items.iter().zip(&self.best) {
            if tour.at(item) != at {
                tour.enter(item, at);
                changed(item);
            }
        }
        cost - least
    }

    /// One pass through all layers from a place of the first item; returns how many moves the work is worth.
    fn pass(&mut self, tour: &Tour, start: u32) -> u64 {
        let (space, first) = (&tour.space, self.items[0]);
        self.reached.clear();
        self.reached.push((space.exit(first, start), space.extra(first, start)));
        self.from.clear();
        let mut looked = 0;
        for &item in &self.items[1..] {
            let places = space.places(item);
            looked += self.reached.len() * places.len();
            self.next.clear();
            self.next.resize(places.len(), f64::INFINITY);
            let layer = self.from.len();
            self.from.resize(layer + places.len(), 0);
            for (k, &(p, cost)) in (0..).zip(&self.reached) {
                space.travel.to_each(p, places, |at, way| {
                    if cost + way < self.next[at] {
                        self.next[at] = cost + way;
                        self.from[layer + at] = k;
                    }
                });
            }
            self.reached.clear();
            let reached = (0..).zip(&self.next);
            self.reached.extend(reached.map(|(at, c)| (space.exit(item, at), c + space.extra(item, at))));
        }
        // About 64 costs of a row take as long as a move.
        looked as u64 / 64
    }

    /// Stores the places of the cheapest path that ends at place `k` of the last item.
    fn trace(&mut self, tour: &Tour, start: u32, mut k: u32) {
        self.best.clear();
        let mut layer = self.from.len();
        for &item in self.items[1..].iter().rev() {
            layer -= tour.space.places(item).len();
            self.best.push(k);
            k = self.from[layer + k as usize];
        }
        self.best.push(start);
        self.best.reverse();
    }
}
