//! The best order and nodes of small problems in which cuts heat each other and may begin in several ways.
//!
//! What is due before a cut depends on when those near it ended, and so on the whole order: sets of items are no states. So all orders and nodes are
//! searched depth first, and a beginning is dropped if it cannot lead to a better plan even if nothing is hot from then on. What that takes is known
//! by dynamic programming over sets, from the last stop backwards.

use super::begin::{Head, cold, hot};
use super::exact::{Sets, is_small};
use super::visit::Visit;
use crate::heat::Cooling;
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use crate::solve::traits::Stop;

/// Most legs that are priced depth first: where all cuts wait for each other, many plans take as long, and most of them would be looked at.
const MOST: u64 = 400_000;

/// The best stops of a small problem, if they take less than `most` seconds, with the number of moves priced.
pub(super) fn optimum(problem: &Problem, cooling: &Cooling, most: f64) -> (Option<Vec<Stop>>, u64) {
    if !is_small(problem) {
        return (None, 0);
    }
    let sets = Sets::new(problem);
    let (to_go, backwards) = to_go(&sets).unwrap_or_default();
    let mut search =
        Depth { sets, cooling, to_go, stops: Vec::new(), ended: Vec::new(), best: (most, None), left: MOST };
    search.go_on(0, Head { at: problem.home, left: None }, 0.0);
    (search.best.1, backwards + MOST - search.left)
}

/// By set of items and the node that was cut last: the least seconds to the end where nothing is hot; and the number of legs priced.
fn to_go(sets: &Sets) -> Option<(Vec<f64>, u64)> {
    let (problem, count) = (sets.problem, sets.items.len());
    let nodes = problem.nodes.len();
    let all = (1_usize << count) - 1;
    let mut to_go = vec![f64::INFINITY; nodes << count];
    let mut priced = 0;
    for set in (1..=all).rev() {
        let next = after(sets, set)?;
        for (_, &id) in sets.items.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1) {
            for last in problem.items.get(id as usize)?.nodes.clone() {
                let head = Head { at: problem.nodes.get(last as usize)?.exit, left: Some(last) };
                let mut least = f64::INFINITY;
                if set == all {
                    least = if problem.closed { sets.leg(head, None, problem.home, all) } else { 0.0 };
                }
                for next in &next {
                    let rest = *to_go.get((set | 1 << next.place) * nodes + next.visit.stop.node as usize)?;
                    let leg = sets.way(head, (next.visit.stop.node, next.visit.entry), set, cold);
                    least = least.min(leg.seconds + next.visit.extra + rest);
                    priced += 1;
                }
                *to_go.get_mut(set * nodes + last as usize)? = least;
            }
        }
    }
    Some((to_go, priced))
}

/// A visit that may come next.
struct Next {
    /// The place of its item in the list.
    place: usize,
    visit: Visit,
}

/// The visits that may come after a set of items.
fn after(sets: &Sets, set: usize) -> Option<Vec<Next>> {
    let mut all = Vec::new();
    for (place, &id) in sets.items.iter().enumerate() {
        if set >> place & 1 == 1 || sets.earlier(place)? & !set != 0 {
            continue;
        }
        let nodes = sets.problem.items.get(id as usize)?.nodes.clone();
        let visit = |node: NodeId| Visit::new(sets.problem, Stop::at(sets.problem, node));
        all.extend(nodes.filter_map(visit).map(|visit| Next { place, visit }));
    }
    Some(all)
}

/// The search, depth first.
struct Depth<'p> {
    sets: Sets<'p>,
    cooling: &'p Cooling,
    to_go: Vec<f64>,
    stops: Vec<Stop>,
    /// The items cut so far with the seconds at which they ended.
    ended: Vec<(ItemId, f64)>,
    best: (f64, Option<Vec<Stop>>),
    /// Number of legs that may still be priced.
    left: u64,
}

impl Depth<'_> {
    /// Goes on after a set of items that took `cost` seconds.
    fn go_on(&mut self, set: usize, head: Head, cost: f64) {
        let nodes = self.sets.problem.nodes.len();
        let now = self.ended.last().map_or(0.0, |e| e.1);
        let mut found = Vec::new();
        for next in after(&self.sets, set).unwrap_or_default() {
            if self.left == 0 {
                return;
            }
            self.left -= 1;
            let (node, extra) = (next.visit.stop.node, next.visit.extra);
            let with = set | 1 << next.place;
            let rest = self.to_go.get(with * nodes + node as usize).copied().unwrap_or(f64::INFINITY);
            let price = hot(self.cooling, next.visit.item, now, self.ended.iter().rev().copied());
            let way = self.sets.way(head, (node, next.visit.entry), set, price);
            let end = way.end(self.cooling, now, next.visit.seconds);
            let cost = cost + way.price + extra;
            found.push((cost + rest, cost, with, end, next.visit));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (least, cost, with, end, visit) in found {
            if least >= self.best.0 - EPSILON {
                return;
            }
            self.stops.push(visit.stop);
            self.ended.push((visit.item, end));
            if self.stops.len() == self.sets.items.len() {
                self.best = (least, Some(self.stops.clone()));
            } else {
                self.go_on(with, Head { at: visit.exit, left: Some(visit.stop.node) }, cost);
            }
            self.stops.pop();
            self.ended.pop();
        }
    }
}
