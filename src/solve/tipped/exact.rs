//! The exact optimum of small problems over their nodes: dynamic programming over sets of items (Held & Karp, 1962).
//!
//! What a leg costs depends on the set of items that have been cut before it, and not on their order, so the states are the
//! same as without tipped pieces.

use crate::geometry::DVec2;
use crate::problem::{Item, ItemId, NodeId, Problem};
use crate::solve::traits::Stop;
use crate::tipping::{Piece, Zones};

/// Most items. Each doubles the work: with 16 entries each, six take about 300,000 legs, a few tenths of a second.
const MOST_ITEMS: usize = 6;
/// Most nodes, for the same reason.
const MOST_NODES: usize = 120;

/// The best order of all items and the best node of each, with the number of moves priced; `None` for larger problems.
pub(super) fn optimum(problem: &Problem, zones: &Zones) -> Option<(Vec<Stop>, u64)> {
    let items: Vec<ItemId> =
        (0..).zip(&problem.items).filter(|(_, i)| !i.nodes.is_empty()).map(|(id, _)| id).collect();
    if items.is_empty()
        || items.len() > MOST_ITEMS
        || problem.nodes.len() > MOST_NODES
        || problem.items.iter().any(Item::may_be_left)
        || !problem.groups.is_empty()
    {
        return None;
    }
    Sets { problem, zones, items }.solve()
}

struct Sets<'p> {
    problem: &'p Problem,
    zones: &'p Zones,
    items: Vec<ItemId>,
}

/// The least seconds to a state, and the node before it.
#[derive(Clone, Copy)]
struct Best {
    seconds: f64,
    before: Option<NodeId>,
}

impl Sets<'_> {
    /// The items that must come before the item at a place in the list, as bits.
    fn earlier(&self, place: usize) -> Option<usize> {
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

    fn leg(&self, from: DVec2, to: DVec2, cut: usize) -> f64 {
        let is_cut = |c: &u32| self.items.iter().position(|i| i == c).is_some_and(|k| cut >> k & 1 == 1);
        self.zones.leg(from, to, |piece: &Piece| piece.cut_by.iter().all(is_cut)).seconds
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
                        found.seconds = extra + self.leg(problem.home, known.entry, set);
                        priced += 1;
                    }
                    for before in self.items.iter().enumerate().filter(|(b, _)| set >> b & 1 == 1) {
                        for last in problem.items.get(*before.1 as usize)?.nodes.clone() {
                            let so_far = best.get(state(set, last))?.seconds;
                            let from = problem.nodes.get(last as usize)?.exit;
                            if so_far + extra + self.zones.least(from, known.entry) < found.seconds {
                                let seconds = so_far + extra + self.leg(from, known.entry, set);
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
            let home = if problem.closed { self.leg(exit, problem.home, all) } else { 0.0 };
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
