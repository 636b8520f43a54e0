//! Nodes that begin on a kerf: each may be used only if the item whose kerf that is has been cut before.
//!
//! What is cut before depends on the order, which a method that prices moves by their ends does not know: for it, such a node is like
//! any other, and what it finds takes at most as long as the real plan. `solve::tipped` knows the real seconds.

use super::ids::{ItemId, NodeId};
use crate::geometry::DVec2;
use std::ops::Range;

/// The nodes of a problem that begin on kerfs. It has none by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Starts {
    /// By node: the item on whose kerf it begins; empty without such nodes.
    kerfs: Vec<Option<ItemId>>,
    /// The nodes of items with such nodes, those next to each other that leave their item at one place.
    alike: Vec<NodeId>,
    /// By node: the stretch of `alike` that it is in.
    stretches: Vec<Range<u32>>,
}

impl Starts {
    /// Those of a problem; `kerfs` has the nodes that begin on kerfs, each with the item that has to be cut before, `items` the nodes of each
    /// item, and `exits` where each node leaves its item.
    pub(super) fn new(
        items: impl Iterator<Item = Range<NodeId>>,
        exits: &[DVec2],
        kerfs: &[(NodeId, ItemId)],
    ) -> Self {
        if kerfs.is_empty() {
            return Self::default();
        }
        let (kerf, stretch) = (vec![None; exits.len()], vec![0..0; exits.len()]);
        let mut new = Self { kerfs: kerf, alike: Vec::new(), stretches: stretch };
        for &(node, item) in kerfs {
            if let Some(kerf) = new.kerfs.get_mut(node as usize) {
                *kerf = Some(item);
            }
        }
        for item in items {
            let mut rest: Vec<NodeId> = item.collect();
            if !rest.iter().any(|&n| new.kerf(n).is_some()) {
                continue;
            }
            while let Some(exit) = rest.first().and_then(|&n| exits.get(n as usize)) {
                let leaves = |n: &NodeId| exits.get(*n as usize) == Some(exit);
                let (here, others): (Vec<NodeId>, Vec<NodeId>) = rest.into_iter().partition(leaves);
                let length = |list: &[NodeId]| u32::try_from(list.len()).unwrap_or(u32::MAX);
                let first = length(&new.alike);
                let stretch = first..first + length(&here);
                for &n in &here {
                    if let Some(known) = new.stretches.get_mut(n as usize) {
                        *known = stretch.clone();
                    }
                }
                new.alike.extend(here);
                rest = others;
            }
        }
        new
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.kerfs.is_empty()
    }

    /// The item on whose kerf a node begins; `None` if it may be used at any time.
    pub fn kerf(&self, node: NodeId) -> Option<ItemId> {
        self.kerfs.get(node as usize).copied().flatten()
    }

    /// The nodes that leave the same item at the same place as a node does, if some node of the item begins on a kerf: other ways to begin the same
    /// cut.
    pub fn alike(&self, node: NodeId) -> &[NodeId] {
        let stretch = self.stretches.get(node as usize).map(|s| s.start as usize..s.end as usize);
        stretch.and_then(|s| self.alike.get(s)).unwrap_or_default()
    }
}
