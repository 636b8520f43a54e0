//! The exact optimum of small problems over their nodes: dynamic programming over sets of items (Held & Karp, 1962).
//!
//! What a leg costs depends on the set of items that have been cut before it, and not on their order, so the states are the
//! same as without tipped pieces. So it is with the kerfs on which a cut may begin.

use super::begin::{Beginning, Head, Ways, begin, cold, straight};
use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{Item, ItemId, NodeId, Problem};
use crate::solve::traits::Stop;
use crate::tipping::{Piece, Zones};

/// Most items. Each doubles the work: with 16 entries each, six take about 300,000 legs, a few tenths of a second.
const MOST_ITEMS: usize = 6;
/// Most nodes, for the same reason. A leg that nothing is in the way of is quickly priced.
const MOST_NODES: usize = 120;
const MOST_NODES_WITHOUT_ZONES: usize = 300;

/// Whether a problem is small enough.
pub(super) fn is_small(problem: &Problem) -> bool {
    let most = if problem.avoided().is_some() { MOST_NODES } else { MOST_NODES_WITHOUT_ZONES };
    let count = problem.items.iter().filter(|i| !i.nodes.is_empty()).take(MOST_ITEMS + 1).count();
    (1..=MOST_ITEMS).contains(&count)
        && problem.nodes.len() <= most
        && !problem.items.iter().any(Item::may_be_left)
        && problem.groups.is_empty()
}

/// The best order of all items and the best node of each, with the number of moves priced; `None` for larger problems.
pub(super) fn optimum(problem: &Problem) -> Option<(Vec<Stop>, u64)> {
    if !is_small(problem) {
        return None;
    }
    Sets::new(problem).solve()
}

/// The sets of items that are cut, as bits by their places in the list.
pub(super) struct Sets<'p> {
    pub(super) problem: &'p Problem,
    zones: Option<&'p Zones>,
    pub(super) items: Vec<ItemId>,
    air: AirTime,
}

/// The least seconds to a state, and the node before it.
#[derive(Clone, Copy)]
struct Best {
    seconds: f64,
    before: Option<NodeId>,
}

impl<'p> Sets<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let visited = (0..).zip(&problem.items).filter(|(_, i)| !i.nodes.is_empty());
        let items = visited.map(|(id, _)| id).collect();
        Self { problem, zones: problem.avoided(), items, air: straight(problem) }
    }

    /// The items that must come before the item at a place in the list, as bits.
    pub(super) fn earlier(&self, place: usize) -> Option<usize> {
        let id = *self.items.get(place)?;
        let item = self.problem.items.get(id as usize)?;
        let mut set = 0;
        for (k, &other) in self.items.iter().enumerate() {
            let known = self.problem.items.get(other as usize)?;
            let comes = known.before == Some(id) || known.rank < item.rank;
            set |= usize::from(comes || self.problem.pairs.contains(&(other, id))) << k;
        }
        Some(set)
    }

    /// Whether an item is in a set.
    fn is_cut(&self, item: ItemId, cut: usize) -> bool {
        self.items.iter().position(|&i| i == item).is_some_and(|k| cut >> k & 1 == 1)
    }

    /// The cheapest way to begin the cut of a node.
    pub(super) fn way(
        &self,
        head: Head,
        to: (NodeId, DVec2),
        cut: usize,
        price: impl Fn(Option<f64>, f64) -> f64,
    ) -> Beginning {
        let ways = Ways { air: &self.air, zones: self.zones };
        begin(self.problem, ways, head, to, |i| self.is_cut(i, cut), price)
    }

    /// Seconds of the leg to a node, or home.
    pub(super) fn leg(&self, head: Head, to: Option<NodeId>, entry: DVec2, cut: usize) -> f64 {
        let is_free = |piece: &Piece| piece.cut_by.iter().all(|&c| self.is_cut(c, cut));
        match (self.zones, to) {
            (_, Some(node)) => self.way(head, (node, entry), cut, cold).seconds,
            (Some(zones), None) => zones.leg(head.at, entry, is_free).seconds,
            (None, None) => self.air.seconds(head.at, entry),
        }
    }

    /// No leg takes less than this, s.
    fn least(&self, from: DVec2, to: DVec2) -> f64 {
        let only_tips = self.problem.starts.is_empty() && self.problem.links.is_empty();
        self.zones.filter(|_| only_tips).map_or(f64::NEG_INFINITY, |zones| zones.least(from, to))
    }

    fn solve(&self) -> Option<(Vec<Stop>, u64)> {
        let (problem, count) = (self.problem, self.items.len());
        let all = (1_usize << count) - 1;
        let nodes = problem.nodes.len();
        let mut best = vec![Best { seconds: f64::INFINITY, before: None }; nodes << count];
        let state = |set: usize, node: NodeId| set * nodes + node as usize;
        let mut priced = 0;
        for set in 0..all {
            for (k, &id) in self.items.iter().enumerate() {
                if set >> k & 1 == 1 || self.earlier(k)? & !set != 0 {
                    continue;
                }
                let item = problem.items.get(id as usize)?;
                for node in item.nodes.clone() {
                    let known = problem.nodes.get(node as usize)?;
                    let extra = item.extra(node, known.along);
                    let mut found = Best { seconds: f64::INFINITY, before: None };
                    if set == 0 {
                        found.seconds = extra
                            + self.leg(Head { at: problem.home, left: None }, Some(node), known.entry, set);
                        priced += 1;
                    }
                    for before in self.items.iter().enumerate().filter(|(b, _)| set >> b & 1 == 1) {
                        for last in problem.items.get(*before.1 as usize)?.nodes.clone() {
                            let so_far = best.get(state(set, last))?.seconds;
                            let from = problem.nodes.get(last as usize)?.exit;
                            if so_far < f64::INFINITY
                                && so_far + extra + self.least(from, known.entry) < found.seconds
                            {
                                let head = Head { at: from, left: Some(last) };
                                let seconds = so_far + extra + self.leg(head, Some(node), known.entry, set);
                                priced += 1;
                                if seconds < found.seconds {
                                    found = Best { seconds, before: Some(last) };
                                }
                            }
                        }
                    }
                    *best.get_mut(state(set | 1 << k, node))? = found;
                }
            }
        }
        let mut last: Option<(f64, NodeId)> = None;
        for node in
            self.items.iter().filter_map(|&i| problem.items.get(i as usize)).flat_map(|i| i.nodes.clone())
        {
            let exit = problem.nodes.get(node as usize)?.exit;
            let head = Head { at: exit, left: Some(node) };
            let home = if problem.closed { self.leg(head, None, problem.home, all) } else { 0.0 };
            let seconds = best.get(state(all, node))?.seconds + home;
            if seconds < last.map_or(f64::INFINITY, |l| l.0) {
                last = Some((seconds, node));
            }
        }
        let mut stops = Vec::with_capacity(count);
        let (mut set, mut at) = (all, last.map(|l| l.1));
        while let Some(node) = at {
            stops.push(Stop::at(problem, node));
            at = best.get(state(set, node))?.before;
            let item = problem.nodes.get(node as usize)?.item;
            set &= !(1 << self.items.iter().position(|&i| i == item)?);
        }
        stops.reverse();
        (stops.len() == count).then_some((stops, priced))
    }
}
