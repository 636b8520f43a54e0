//! All entries of an order at once: the cheapest way through layers of places, one layer an item.
//!
//! A dynamic programme over the order (layer by layer, for each place the least cost so far), once for every place of
//! the item with the fewest, where the cycle is cut open: in benchmark instances that is often one place. Local moves
//! change one entry at a time; this finds what only pays together. Not for items with places all along a track, which
//! slide (`polish.rs`).
//! Source: the cluster optimisation of Fischetti, Salazar & Toth, Operations Research 45 (1997).

use super::index::index;
use super::tour::Tour;
use super::travel::Place;
use crate::solve::epsilon::EPSILON;

/// Room for the layers, kept from one call to the next.
#[derive(Default)]
pub(super) struct Layers {
    /// The items in order, from the one where the cycle is cut open.
    items: Vec<u32>,
    /// What each place of the layer before has cost, where the head leaves it, and the same of the layer after.
    reached: Vec<(Place, f64)>,
    next: Vec<f64>,
    /// The place before each place: layer by layer.
    from: Vec<u32>,
    best: Vec<u32>,
}

impl Layers {
    /// Enters every item where the whole tour costs least; gives the seconds gained. `changed` hears of each item that
    /// is entered elsewhere.
    pub(super) fn enter_best(&mut self, tour: &mut Tour, cost: f64, mut changed: impl FnMut(u32)) -> f64 {
        let count = |p: usize| tour.space.places(tour.item(p)).len();
        // Coming home may cost nothing, which only home's own layer knows: a path is cut open there.
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
                let cost = cost + tour.way(p, first, end);
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

    /// Layer by layer from one place of the first item; gives the moves that this is worth.
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
                space.travel.fan(p, places, |at, way| {
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
        // Rows of costs: 64 of them take about as long as a move.
        looked as u64 / 64
    }

    /// The places of the cheapest way that ends at place `k` of the last item.
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
