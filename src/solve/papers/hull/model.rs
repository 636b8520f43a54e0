//! The model of partial cutting: contours are divided into segments, which are cut in any order and direction (section 3.2
//! of the paper).
//!
//! A segment lies between two consecutive nodes of a contour. Where a contour may not be left, the first of its segments in
//! the order represents all of it, and the contour is cut whole from the start of that segment. An open contour has one
//! segment.

use super::super::legs::Legs;
use crate::problem::{ItemId, NodeId, Problem};

/// A segment and its cutting direction: twice its index, plus one if it is cut against the stored direction.
pub(super) type Gene = u32;

/// A place without a gene.
pub(super) const BLANK: Gene = Gene::MAX;

/// A visit, from the node where a contour is entered to the node where it is left. If both are the same, the visit cuts the
/// whole contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visit {
    pub(super) enter: NodeId,
    pub(super) leave: NodeId,
}

/// The segments of a problem.
pub(super) struct Model<'p> {
    pub(super) legs: Legs<'p>,
    /// For each gene, the nodes between which it cuts.
    cuts: Vec<Visit>,
    /// For each item, whether it may be left and resumed.
    split: Vec<bool>,
    /// For each item, its first segment.
    first: Vec<u32>,
    /// Number of segments of each contour, the l_m of the paper.
    pub(super) sizes: Vec<u32>,
    /// Whether some contours are cut whole, so that some of their genes cut nothing.
    mixed: bool,
}

impl<'p> Model<'p> {
    /// If `whole` is set, no contour is left unfinished, whatever the machine allows.
    pub(super) fn new(legs: Legs<'p>, whole: bool) -> Self {
        let problem = legs.problem();
        let (mut cuts, mut split) = (Vec::new(), Vec::new());
        let (mut first, mut sizes) = (Vec::new(), Vec::new());
        let count = |cuts: &[Visit]| u32::try_from(cuts.len() / 2).unwrap_or(u32::MAX);
        for item in &problem.items {
            let splits = item.leave.is_some() && item.nodes.len() > 1 && !whole;
            split.push(splits);
            first.push(count(&cuts));
            for node in item.nodes.clone() {
                let twin = problem.nodes[node as usize].twin;
                let next = if node + 1 < item.nodes.end { node + 1 } else { item.nodes.start };
                if splits {
                    cuts.extend([Visit { enter: node, leave: next }, Visit { enter: next, leave: node }]);
                } else if node <= twin {
                    let back = if twin == node { next } else { twin };
                    cuts.extend([node, back].map(|n| Visit { enter: n, leave: n }));
                }
            }
            if !item.nodes.is_empty() {
                sizes.push(count(&cuts) - first[first.len() - 1]);
            }
        }
        let mixed = problem.items.iter().zip(&split).any(|(i, &s)| !s && !i.nodes.is_empty());
        Self { legs, cuts, split, first, sizes, mixed }
    }

    pub(super) fn problem(&self) -> &'p Problem {
        self.legs.problem()
    }

    /// Number of segments, the N of the paper.
    pub(super) fn segments(&self) -> usize {
        self.cuts.len() / 2
    }

    /// The visit of a gene.
    pub(super) fn cut(&self, gene: Gene) -> Visit {
        self.cuts[gene as usize]
    }

    /// The gene that continues from the end of a gene without an air move; `None` if its contour may not be left.
    pub(super) fn goes_on(&self, gene: Gene) -> Option<Gene> {
        let item = self.item(self.cut(gene).enter) as usize;
        let (first, count) = (self.first[item], u32::try_from(self.problem().items[item].nodes.len()).ok()?);
        let (place, back) = (gene / 2 - first, gene % 2);
        let next = (place + if back == 0 { 1 } else { count - 1 }) % count;
        self.split[item].then_some(2 * (first + next) + back)
    }

    /// The contour of a node.
    pub(super) fn item(&self, node: NodeId) -> ItemId {
        self.problem().nodes[node as usize].item
    }

    /// Whether a contour may be left and resumed.
    pub(super) fn splits(&self, item: ItemId) -> bool {
        self.split[item as usize]
    }

    /// Length of the air move between two visits; `None` is before the first or after the last.
    pub(super) fn gap(&self, from: Option<NodeId>, to: Option<NodeId>) -> f64 {
        match (from, to) {
            (Some(from), Some(to)) => self.legs.leg(from, to),
            (None, Some(to)) => self.legs.from_home(to),
            // With a table of costs, the cycle is closed elsewhere.
            (Some(from), None) if self.problem().table().is_none() => self.legs.to_end(from, from),
            _ => 0.0,
        }
    }

    /// The visits of a chromosome in its order. A contour that may not be left is visited at its first gene only.
    pub(super) fn visits(&self, genes: &[Gene]) -> Vec<Visit> {
        let mut done = vec![false; if self.mixed { self.split.len() } else { 0 }];
        let cuts = genes.iter().map(|&g| self.cut(g));
        cuts.filter(|v| {
            let item = if self.mixed { self.item(v.enter) as usize } else { return true };
            self.split[item] || !std::mem::replace(&mut done[item], true)
        })
        .collect()
    }

    /// Empty travel, eq. (1): from the origin through all air moves and back.
    pub(super) fn travel(&self, visits: &[Visit]) -> f64 {
        let (Some(first), Some(last)) = (visits.first(), visits.last()) else { return 0.0 };
        let gaps: f64 = visits.windows(2).map(|w| self.legs.leg(w[0].leave, w[1].enter)).sum();
        self.legs.from_home(first.enter) + gaps + self.legs.to_end(last.leave, first.enter)
    }
}
