//! Bridges: the cheapest way from an item's neighbour to the item and back. That is the cost of a child route with one stop.
//!
//! From the cheapest pair of coarse places each end moves in turn to the best place for the other. The result is exact for
//! items with few places, and nearly always within the spacing for rings. Bridges are built item by item, so that a worker
//! can stop in between.

use super::super::config::CONFIG;
use super::super::index::index;
use super::super::neighbours::Neighbours;
use super::super::ring::GATES;
use super::super::space::Space;
use super::super::travel::Gap;

/// The cheapest way between two items and back.
#[derive(Clone, Copy)]
pub(super) struct Bridge {
    /// Place on the item.
    pub(super) from: u32,
    /// Place on the neighbour.
    pub(super) to: u32,
    /// Seconds there and back, with the extra seconds of both places.
    pub(super) seconds: f64,
}

/// Bridges by item, in the order of its neighbour list.
#[derive(Default)]
pub(super) struct Bridges {
    by_item: Vec<Vec<Bridge>>,
}

impl Bridges {
    /// Finds the bridges of the next item; false when all are found.
    pub(super) fn extend(&mut self, space: &Space, near: &Neighbours) -> bool {
        let item = index(self.by_item.len());
        if item >= space.home {
            return false;
        }
        self.by_item.push(near.of_item(item).iter().map(|&other| bridge(space, item, other)).collect());
        true
    }

    /// The bridge from an item to its k-th neighbour.
    pub(super) fn of(&self, item: u32, k: usize) -> Bridge {
        self.by_item[item as usize][k]
    }
}

fn bridge(space: &Space, item: u32, other: u32) -> Bridge {
    let step = |i: u32| if space.is_ring(i) { space.places(i).len() / GATES } else { 1 };
    let around = |i: u32, at: u32| Gap { from: space.places(i).at(at), to: Some(space.places(i).at(at)) };
    let mut best = Bridge { from: 0, to: 0, seconds: f64::INFINITY };
    for from in (0..index(space.places(item).len())).step_by(step(item)) {
        for to in (0..index(space.places(other).len())).step_by(step(other)) {
            let seconds = space.through(other, to, around(item, from)) + space.extra(item, from);
            if seconds < best.seconds {
                best = Bridge { from, to, seconds };
            }
        }
    }
    for _ in 0..CONFIG.children.bridge_turns {
        let (to, seconds) = space.best_entry(other, around(item, best.from), f64::INFINITY);
        if seconds + space.extra(item, best.from) < best.seconds {
            best = Bridge { to, seconds: seconds + space.extra(item, best.from), ..best };
        }
        let (from, seconds) = space.best_entry(item, around(other, best.to), f64::INFINITY);
        if seconds + space.extra(other, best.to) < best.seconds {
            best = Bridge { from, seconds: seconds + space.extra(other, best.to), ..best };
        }
    }
    best
}
