//! A problem as the local search sees it: lengths, near items, and whether stretches may be reversed.

use super::super::legs::Legs;
use super::near::NearItems;
use crate::problem::{ItemId, NodeId, Problem};

/// What the local search needs to know about a problem.
pub(in super::super) struct SearchSpace<'p> {
    /// Lengths between nodes.
    pub(in super::super) legs: Legs<'p>,
    /// Near items of each item.
    pub(in super::super) near: NearItems,
    /// Whether stretches may be reversed.
    pub(in super::super) turns: bool,
}

impl<'p> SearchSpace<'p> {
    /// Starts with near items whose lists are not filled yet.
    pub(in super::super) fn new(legs: Legs<'p>, near: NearItems) -> Self {
        let turns = legs.problem().table().is_none_or(crate::problem::Table::is_symmetric);
        Self { legs, near, turns }
    }

    pub(super) fn problem(&self) -> &'p Problem {
        self.legs.problem()
    }

    pub(super) fn item(&self, node: NodeId) -> ItemId {
        self.problem().nodes[node as usize].item
    }

    /// The node at which a reversed stretch enters the item of this node.
    pub(super) fn twin(&self, node: NodeId) -> NodeId {
        if self.problem().table().is_some() { node } else { self.problem().nodes[node as usize].twin }
    }
}
