//! Starts without piercing: other ways to begin the cut of a node, some of which need a kerf that has been cut before.
//!
//! Which kerfs there are depends on the order, and a method that prices moves by their ends does not know it. So the starts are no nodes: for such
//! a method every cut is pierced or joined to the one before it, and `solve::tipped` begins each cut in the quickest way that there is by then.

use super::ids::{ItemId, NodeId};
use crate::geometry::DVec2;
use crate::machine::PLANS_ALL_LEVERS;
use crate::order::{real, sort_by};

/// The starts of a problem, by node. It has none by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Starts {
    /// Starts of node n: `all[first[n]..first[n + 1]]`; empty without starts.
    first: Vec<u32>,
    all: Vec<Start>,
    /// Most seconds that starts save beyond links, added up over the items.
    most_saved: f64,
}

/// A way to begin the cut of a node without piercing. It is left where the node is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// The item on whose kerf it begins, which has to be cut before; `None`: it begins at the edge of the sheet.
    pub kerf: Option<ItemId>,
    /// Where the head goes with the beam off, mm.
    pub from: DVec2,
    /// Seconds from there on beyond those of the item if it is pierced; negative where it saves the piercing.
    pub seconds: f64,
}

impl Starts {
    /// The starts of `nodes` nodes, each with its node. `saved` gives the most seconds that a start saves, and its item; `by_links` what links save there.
    pub(super) fn new(
        nodes: usize,
        mut found: Vec<(NodeId, Start)>,
        saved: impl Fn(NodeId, &Start) -> Option<(ItemId, f64)>,
        by_links: impl Fn(ItemId) -> f64,
    ) -> Self {
        if found.is_empty() {
            return Self::default();
        }
        sort_by(&mut found, |(node, s)| {
            [(*node).into(), real(s.seconds), s.kerf.map_or(0, |k| 1 + u64::from(k))]
        });
        let mut first = vec![0_u32; nodes + 1];
        let mut most: Vec<f64> = Vec::new();
        for (node, start) in &found {
            if let Some(count) = first.get_mut(*node as usize + 1) {
                *count += 1;
            }
            let Some((item, seconds)) = saved(*node, start) else { continue };
            most.resize(most.len().max(item as usize + 1), 0.0);
            if let Some(most) = most.get_mut(item as usize) {
                *most = seconds.max(*most);
            }
        }
        let mut sum = 0;
        for count in &mut first {
            sum += *count;
            *count = sum;
        }
        let most_saved = (0..).zip(most).map(|(item, most)| (most - by_links(item)).max(0.0)).sum();
        Self { first, all: found.into_iter().map(|f| f.1).collect(), most_saved }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        !PLANS_ALL_LEVERS || self.all.is_empty()
    }

    /// Those of a node, the quickest first.
    pub fn of(&self, node: NodeId) -> &[Start] {
        if self.is_empty() {
            return &[];
        }
        let at = |n: usize| self.first.get(n).map(|&f| f as usize);
        let range = at(node as usize).zip(at(node as usize + 1)).map(|(from, to)| from..to);
        range.and_then(|r| self.all.get(r)).unwrap_or_default()
    }

    /// No plan saves more by its starts than this beyond what it may save by links, s: every item is begun once.
    pub fn most_saved(&self) -> f64 {
        if PLANS_ALL_LEVERS { self.most_saved } else { 0.0 }
    }
}
