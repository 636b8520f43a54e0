//! A chain of stops put elsewhere: the move that most changes of routes are made of.

use super::super::neighbours::Neighbours;
use super::super::space::Space;
use super::bridges::Bridges;

/// What stays the same during the search.
#[derive(Clone, Copy)]
pub(super) struct Context<'g, 'p> {
    pub(super) space: &'g Space<'p>,
    pub(super) near: &'g Neighbours,
    pub(super) bridges: &'g Bridges,
}

/// Where a chain is put.
#[derive(Clone, Copy)]
pub(super) enum Target {
    /// After a touch.
    After(u32),
    /// On a new child route that hangs from an item at a place.
    Child(u32, u32),
}

/// A chain that is put elsewhere.
#[derive(Clone, Copy)]
pub(super) struct ChainMove {
    pub(super) first: u32,
    pub(super) last: u32,
    /// The chain is reversed.
    pub(super) reversed: bool,
    pub(super) target: Target,
    /// The place where the single stop of the chain is entered; `None` if the chain keeps its entries.
    pub(super) at: Option<u32>,
    /// The stop that is entered: `first`, or a stop of a route that hangs from `first` and changes places with it, see
    /// `swap_with_host.rs`.
    pub(super) enter: u32,
}
