//! A chain put elsewhere: what moves of routes are made of.

use super::super::neighbours::Neighbours;
use super::super::space::Space;
use super::bridges::Bridges;

/// What stays the same during the search.
#[derive(Clone, Copy)]
pub(super) struct Ground<'g, 'p> {
    pub(super) space: &'g Space<'p>,
    pub(super) near: &'g Neighbours,
    pub(super) bridges: &'g Bridges,
}

/// Where a chain is put.
#[derive(Clone, Copy)]
pub(super) enum Spot {
    /// Behind a touch.
    Behind(u32),
    /// On a route of its own, from a place of an item.
    Child(u32, u32),
}

/// A chain put elsewhere.
#[derive(Clone, Copy)]
pub(super) struct Shift {
    pub(super) first: u32,
    pub(super) last: u32,
    /// The other way round.
    pub(super) turned: bool,
    pub(super) spot: Spot,
    /// The place at which the one that is entered, then the only one of its chain, is entered.
    pub(super) at: Option<u32>,
    /// The stop that is entered: `first`, or one of a route that hangs from it and changes parts with it, see
    /// `flip.rs`.
    pub(super) enter: u32,
}
