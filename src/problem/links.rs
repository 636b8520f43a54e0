//! Links: pairs of nodes between which the machine does something quicker than switch the beam off, move and pierce.

use super::ids::NodeId;
use crate::geometry::DVec2;
use crate::order::sort_by;

/// The links of a problem: from a node to a node of another item. It has none by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Links {
    /// Links of node n: `all[first[n]..first[n + 1]]`; empty without links.
    first: Vec<u32>,
    all: Vec<Link>,
    /// The nodes at which links begin or end, in order.
    ends: Vec<NodeId>,
    /// By item: most seconds that a link to it saves on its air move.
    saved: Vec<f64>,
}

/// A link from one node to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The node that it leads to.
    pub to: NodeId,
    /// Where the head moves with the beam off before the cut that leads to the node begins; `None`: the cut begins where the
    /// head is, with the beam still on.
    pub via: Option<DVec2>,
    /// What it takes in place of the air move, s: less than that, and negative where it saves the piercing that the item's own
    /// seconds contain.
    pub seconds: f64,
    /// Seconds less than those of the air move.
    pub saved: f64,
}

impl Links {
    /// The links between `nodes` nodes, from each node to another; `item` gives the item of a node.
    pub(super) fn new(
        nodes: usize,
        mut links: Vec<(NodeId, Link)>,
        item: impl Fn(NodeId) -> Option<u32>,
    ) -> Self {
        if links.is_empty() {
            return Self::default();
        }
        sort_by(&mut links, |(from, link)| [u64::from(*from) << 32 | u64::from(link.to), 0, 0]);
        let mut first = vec![0_u32; nodes + 1];
        let mut saved: Vec<f64> = Vec::new();
        for (from, link) in &links {
            if let Some(count) = first.get_mut(*from as usize + 1) {
                *count += 1;
            }
            if let Some(item) = item(link.to).map(|i| i as usize) {
                saved.resize(saved.len().max(item + 1), 0.0);
                if let Some(most) = saved.get_mut(item) {
                    *most = link.saved.max(*most);
                }
            }
        }
        let mut sum = 0;
        for count in &mut first {
            sum += *count;
            *count = sum;
        }
        let mut ends: Vec<NodeId> = links.iter().flat_map(|(from, link)| [*from, link.to]).collect();
        sort_by(&mut ends, |&n| [n.into(), 0, 0]);
        ends.dedup();
        Self { first, all: links.into_iter().map(|l| l.1).collect(), ends, saved }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Whether every link costs the same both ways.
    #[expect(clippy::float_cmp, reason = "the same sums, or others")]
    pub fn are_symmetric(&self) -> bool {
        let same = |from: NodeId, link: &Link| {
            self.between(link.to, from).is_some_and(|back| back.seconds == link.seconds)
        };
        (0..).take(self.first.len()).all(|from| self.from(from).iter().all(|link| same(from, link)))
    }

    /// Those from a node, in the order of the nodes that they lead to.
    pub fn from(&self, node: NodeId) -> &[Link] {
        let at = |n: usize| self.first.get(n).map(|&f| f as usize);
        let range = at(node as usize).zip(at(node as usize + 1)).map(|(from, to)| from..to);
        range.and_then(|r| self.all.get(r)).unwrap_or_default()
    }

    /// The link from one node to another.
    pub fn between(&self, from: NodeId, to: NodeId) -> Option<&Link> {
        let links = self.from(from);
        links.get(links.binary_search_by_key(&to, |l| l.to).ok()?)
    }

    /// Whether a link begins or ends at a node.
    pub(super) fn touch(&self, node: NodeId) -> bool {
        self.ends.binary_search(&node).is_ok()
    }

    /// No plan saves more by its links than this, s: every item is reached once.
    pub fn most_saved(&self) -> f64 {
        self.saved.iter().sum()
    }

    /// Most seconds that a link to an item saves.
    pub(super) fn saved(&self, item: u32) -> f64 {
        self.saved.get(item as usize).copied().unwrap_or(0.0)
    }
}
