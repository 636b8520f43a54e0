//! The construction heuristic PFr, as described in section 2 of the paper. Its own paper, Dewil et al. 2014, has more
//! variants.
//!
//! The outermost contours come first. In each step the one nearest to the partial path is inserted at the place and with
//! the entry that cost least: between two contours of a route, or as a partition attached to a node of a contour, which is
//! left there. Then the path is followed backwards: at the end of each contour, the contours directly inside it are
//! inserted in the same way, before that end.
//!
//! The paper says "closest to the current partial path i.e. an insertion location, an entry point and an exit point are
//! selected". We interpret this as nearest insertion: the contour nearest by a single air move, at its cheapest place.

use super::forest::{Forest, ROOT};
use super::graph::Graph;
use super::visits::{finished, times};
use crate::problem::{ItemId, NodeId};
use glam::DVec2;

/// A place of a path where a contour may be inserted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Slot {
    /// In a route, before a position.
    Gap { route: u32, pos: usize },
    /// At a node to which nothing is attached.
    Node(NodeId),
}

/// A slot, with the points before and after it.
struct Offer {
    slot: Slot,
    from: DVec2,
    to: Option<DVec2>,
    /// Seconds that do not depend on the inserted contour: the pre-cut, minus the air move that is saved.
    base: f64,
}

/// The construction under way; every piece of work inserts one contour.
pub(super) struct Pfr {
    pub(super) forest: Forest,
    /// Contours to be inserted now.
    waiting: Vec<ItemId>,
    /// For each waiting contour, the seconds to the nearest place of the path.
    nearest: Vec<f64>,
    /// The contour whose inner contours are being inserted; `None` while the outermost ones are.
    outer: Option<ItemId>,
    /// Contours of the path that end after this position have their inner contours.
    behind: Option<usize>,
}

impl Pfr {
    pub(super) fn new(g: &Graph) -> Self {
        let mut pfr = Self {
            forest: Forest::new(g),
            waiting: Vec::new(),
            nearest: vec![f64::INFINITY; g.problem.items.len()],
            outer: None,
            behind: None,
        };
        let is_outermost = |item: &crate::problem::Item| item.before.is_none() && !item.nodes.is_empty();
        pfr.waiting =
            (0..).zip(&g.problem.items).filter(|(_, i)| is_outermost(i)).map(|(id, _)| id).collect();
        for k in 0..pfr.waiting.len() {
            let nodes = g.nodes(pfr.waiting[k]);
            let seconds = nodes.map(|n| g.air(g.problem.home, g.entry(n))).fold(f64::INFINITY, f64::min);
            pfr.nearest[pfr.waiting[k] as usize] = seconds;
        }
        pfr
    }

    /// Inserts the next contour. Returns the cost in moves, or `None` when all are inserted.
    pub(super) fn piece(&mut self, g: &Graph) -> Option<u64> {
        let mut spent = 0;
        while self.waiting.is_empty() {
            spent += self.descend(g)?;
        }
        let next = (0..self.waiting.len())
            .min_by(|&a, &b| self.distance(a).total_cmp(&self.distance(b)))
            .map(|k| self.waiting.remove(k))?;
        spent += insert(g, &mut self.forest, next, self.outer);
        for &other in &self.waiting {
            let own = &mut self.nearest[other as usize];
            for n in g.nodes(next) {
                for m in g.nodes(other) {
                    *own = own.min(g.air(g.exit(n), g.entry(m)));
                    spent += 1;
                }
            }
        }
        Some(spent)
    }

    fn distance(&self, k: usize) -> f64 {
        self.nearest[self.waiting[k] as usize]
    }

    /// Continues with the last contour of the path whose inner contours are missing; `None` at the start of the path.
    fn descend(&mut self, g: &Graph) -> Option<u64> {
        let ends = finished(g, &self.forest);
        let mut order = vec![None; ends.len()];
        for (item, &end) in (0..).zip(&ends) {
            if let Some(place) = order.get_mut(end as usize) {
                *place = Some(item);
            }
        }
        // Contours inserted since then come before the contour around them.
        let from = self.outer.map_or(order.len(), |o| ends[o as usize] as usize);
        let place = (0..self.behind.map_or(order.len(), |_| from)).rev();
        let next = place.filter_map(|k| order[k]).find(|&i| !g.inner[i as usize].is_empty())?;
        self.behind = Some(ends[next as usize] as usize);
        self.outer = Some(next);
        self.waiting.clone_from(&g.inner[next as usize]);
        self.waiting.retain(|&i| !g.nodes(i).is_empty());
        let path: Vec<NodeId> =
            (0..).zip(&ends).filter(|e| *e.1 != u32::MAX).flat_map(|(i, _)| g.nodes(i)).collect();
        for &item in &self.waiting {
            let own = &mut self.nearest[item as usize];
            for m in g.nodes(item) {
                for &n in &path {
                    *own = own.min(g.air(g.exit(n), g.entry(m)));
                }
            }
        }
        Some(1 + (path.len() * self.waiting.len()) as u64)
    }
}

/// Inserts an unassigned contour at the cheapest place before the end of `outer`. Returns the number of places priced.
pub(super) fn insert(g: &Graph, forest: &mut Forest, item: ItemId, outer: Option<ItemId>) -> u64 {
    let offers = offers(g, forest, item, outer);
    let mut best: Option<(f64, usize, NodeId)> = None;
    for node in g.nodes(item) {
        let (entry, exit, extra) = (g.entry(node), g.exit(node), g.extra(node));
        for (k, o) in offers.iter().enumerate() {
            let cost = o.base + extra + g.air(o.from, entry) + o.to.map_or(0.0, |to| g.air(exit, to));
            if best.is_none_or(|b| cost < b.0) {
                best = Some((cost, k, node));
            }
        }
    }
    if let Some((_, k, node)) = best {
        forest.enter(item, node);
        put(g, forest, offers[k].slot, vec![item]);
    }
    (offers.len() * g.nodes(item).len()) as u64
}

/// Inserts unassigned contours into a slot.
pub(super) fn put(g: &Graph, forest: &mut Forest, slot: Slot, items: Vec<ItemId>) {
    match slot {
        Slot::Gap { route, pos } => forest.splice(route, pos, items),
        Slot::Node(node) => {
            let route = forest.open(items);
            forest.hang(g, route, node);
        }
    }
}

/// All slots of the path for a contour, or those before the end of the contour around it. While a pierce group around it is
/// left, those before its area falls out.
fn offers(g: &Graph, forest: &Forest, item: ItemId, outer: Option<ItemId>) -> Vec<Offer> {
    let until = outer.map(|outer| {
        let (passed, ends) = times(g, forest);
        (ends[outer as usize], passed, ends)
    });
    let gap_in_time = |route: u32, pos: usize| {
        until.as_ref().is_none_or(|(until, passed, ends)| {
            let done = match (pos.checked_sub(1), forest.at(route)) {
                (Some(before), _) => ends[forest.items(route)[before] as usize] + 1,
                (None, Some(node)) => passed[node as usize],
                (None, None) => 0,
            };
            done <= *until
        })
    };
    let group = outer.filter(|&o| g.is_group(o));
    let holds = |node: NodeId| group != Some(g.item(node)) || forest.holds_at(g, node, item);
    let mut offers = Vec::new();
    for route in forest.used().chain((forest.items(ROOT).is_empty()).then_some(ROOT)) {
        if !group.and_then(|group| forest.hangs_at(g, route, group)).is_none_or(holds) {
            continue;
        }
        for pos in 0..=forest.items(route).len() {
            if gap_in_time(route, pos) {
                let (from, to) = (forest.before(g, route, pos), forest.after(g, route, pos));
                let base = -to.map_or(0.0, |to| g.air(from, to));
                offers.push(Offer { slot: Slot::Gap { route, pos }, from, to, base });
            }
        }
        for &item in forest.items(route) {
            for node in g.parent_nodes(item).filter(|&n| forest.is_free(g, n) && holds(n)) {
                if until.as_ref().is_none_or(|(until, passed, _)| passed[node as usize] <= *until) {
                    let hook = forest.hook(g, node);
                    let slot = Slot::Node(node);
                    offers.push(Offer { slot, from: hook.out, to: Some(hook.back), base: hook.seconds });
                }
            }
        }
    }
    offers
}
