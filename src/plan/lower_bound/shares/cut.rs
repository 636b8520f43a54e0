//! Cuts with their prices, and legs.

use super::super::places::Places;

/// A leg between two knots of a pair of items.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub(super) i: u32,
    pub(super) j: u32,
    pub(super) seconds: f64,
}

/// Some knots, and the price of legs between them and the others, which stops that count pay twice.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    pub(super) places: Places,
    pub(super) price: f64,
    /// The legs of the smooth solution that cross it, and how many there should be at least.
    pub(super) legs: f64,
    pub(super) target: f64,
    /// The pairs of items all of whose legs cross it, and the active legs of other pairs that do.
    pub(super) pairs: Vec<u32>,
    pub(super) crossing: Vec<u32>,
}

impl Cut {
    pub(super) fn new(places: Places) -> Self {
        Self { places, price: 0.0, legs: 0.0, target: 2.0, pairs: Vec::new(), crossing: Vec::new() }
    }
}
