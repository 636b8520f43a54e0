//! The exact optimum of small problems over their nodes. The tests compare the other methods with it.
//!
//! Dynamic programming over sets of items (Held & Karp, 1962): for each set of visited items and each last node, the least
//! cost up to there. Time and memory double with every item.

use super::traits::{Solution, Stop};
use crate::machine::AirTime;
use crate::problem::{Item, ItemId, NodeId, Problem};

/// Most items.
const MOST_ITEMS: usize = 14;
/// Most numbers in memory: 256 MB.
const MOST_NUMBERS: usize = 1 << 25;

/// Why the exact solver refuses a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TooLarge {
    /// Too many items or nodes.
    #[error("the exact solver takes at most {MOST_ITEMS} items; this problem has {items} with {nodes} nodes")]
    Size {
        /// Its items.
        items: usize,
        /// Its nodes.
        nodes: usize,
    },
    /// Items may be left unfinished: sets of items do not describe such orders.
    #[error("the exact solver does not leave contours unfinished; this problem allows it")]
    Resumes,
}

/// The best order of all items and the best node of each. Items are not left unfinished, and entries stay at nodes. The
/// solution is empty and of infinite cost if no order is allowed.
pub fn exact(problem: &Problem) -> Result<Solution, TooLarge> {
    let (items, nodes) = (problem.items.len(), problem.nodes.len());
    let free = items - usize::from(problem.start().is_some());
    if free > MOST_ITEMS || nodes << free > MOST_NUMBERS {
        return Err(TooLarge::Size { items, nodes });
    }
    if problem.items.iter().any(Item::may_be_left) {
        return Err(TooLarge::Resumes);
    }
    let Some(start) = problem.start() else { return Ok(Sets::new(problem, free, None).solve()) };
    // A cycle returns to the node where it started: each node of the start is tried.
    let looks =
        problem.items[start as usize].nodes.clone().map(|n| Sets::new(problem, free, Some(n)).solve());
    Ok(looks.reduce(|a, b| if b.cost < a.cost { b } else { a }).unwrap_or_default())
}

struct Sets<'p> {
    problem: &'p Problem,
    air: AirTime,
    /// Items to be ordered.
    items: usize,
    /// The node where a cycle starts; `None`: home.
    start: Option<NodeId>,
    /// By item: the items that must come before it, as bits.
    earlier: Vec<usize>,
    /// Least cost by set of visited items and last node.
    least: Vec<f64>,
}

impl<'p> Sets<'p> {
    fn new(problem: &'p Problem, items: usize, start: Option<NodeId>) -> Self {
        let all = &problem.items[..items];
        let earlier = (0..)
            .zip(all)
            .map(|(id, item): (ItemId, _)| {
                let before = |(o, other): (ItemId, &Item)| {
                    other.before == Some(id) || other.rank < item.rank || problem.pairs.contains(&(o, id))
                };
                (0..).zip(all).filter(|&o| before(o)).fold(0, |set, (o, _)| set | 1 << o)
            })
            .collect();
        let least = vec![f64::INFINITY; problem.nodes.len() << items];
        Self { problem, air: AirTime::new(&problem.machine), items, start, earlier, least }
    }

    /// Seconds of a leg after the items in `done`.
    fn leg(&self, from: Option<NodeId>, to: Option<NodeId>, done: usize) -> f64 {
        let (from, to) = (from.or(self.start), to.or(self.start));
        if let (Some(table), Some(a), Some(b)) = (self.problem.table(), from, to) {
            return table.cost(a, b);
        }
        let leave = from.map_or(self.problem.home, |n| self.problem.nodes[n as usize].exit);
        // A cut may begin on the kerf of what is done.
        let starts = to.map_or(&[][..], |n| self.problem.starts.of(n)).iter();
        let starts = starts.filter(|s| s.kerf.is_none_or(|kerf| done >> kerf & 1 == 1));
        let begun = starts.map(|s| self.air.seconds(leave, s.from) + s.seconds).fold(f64::INFINITY, f64::min);
        if let Some(link) = from.zip(to).and_then(|(a, b)| self.problem.links.between(a, b)) {
            return link.seconds.min(begun);
        }
        match to {
            Some(n) => self.air.seconds(leave, self.problem.nodes[n as usize].entry).min(begun),
            None if self.problem.closed => self.air.seconds(leave, self.problem.home),
            None => 0.0,
        }
    }

    /// Whether `next` may follow `last` after the items in `done`.
    fn allowed(&self, done: usize, last: Option<ItemId>, next: ItemId) -> bool {
        if done >> next & 1 == 1 || self.earlier[next as usize] & !done != 0 {
            return false;
        }
        let groups = &self.problem.groups;
        let rank = |i: ItemId| self.problem.items[i as usize].rank;
        last.is_none_or(|last| {
            groups.of(last).all(|g| {
                let holds = |i: ItemId| groups.of(i).any(|h| h == g);
                let left =
                    (0..).take(self.items).any(|i| done >> i & 1 == 0 && rank(i) == rank(last) && holds(i));
                !left || rank(next) != rank(last) || holds(next)
            })
        })
    }

    fn solve(mut self) -> Solution {
        let count = self.problem.nodes.len();
        let all = (1_usize << self.items) - 1;
        for done in 0..=all {
            let ends: Vec<(Option<NodeId>, f64)> = if done == 0 {
                vec![(None, 0.0)]
            } else {
                let row = &self.least[done * count..][..count];
                (0..).zip(row).filter(|e| *e.1 < f64::INFINITY).map(|(n, &c)| (Some(n), c)).collect()
            };
            for (end, cost) in ends {
                let last = end.map(|n| self.problem.nodes[n as usize].item);
                for next in (0..).take(self.items) {
                    if !self.allowed(done, last, next) {
                        continue;
                    }
                    let item = &self.problem.items[next as usize];
                    for n in item.nodes.clone() {
                        let extra = item.extra(n, self.problem.nodes[n as usize].along);
                        let cost = cost + self.leg(end, Some(n), done) + extra;
                        let known = &mut self.least[(done | 1 << next) * count + n as usize];
                        *known = known.min(cost);
                    }
                }
            }
        }
        self.trace(all)
    }

    /// The solution of the best order, traced from its last node back.
    fn trace(&self, mut done: usize) -> Solution {
        let count = self.problem.nodes.len();
        let mut stops = Vec::with_capacity(self.items);
        let (mut next, mut total) = (None, None);
        while done > 0 {
            let mut best: Option<(f64, NodeId)> = None;
            for n in (0..).take(count) {
                let item = self.problem.nodes[n as usize].item;
                let follows =
                    |next: NodeId| self.allowed(done, Some(item), self.problem.nodes[next as usize].item);
                let cost = self.least[done * count + n as usize] + self.leg(Some(n), next, done);
                if cost < f64::INFINITY && next.is_none_or(follows) && best.is_none_or(|b| cost < b.0) {
                    best = Some((cost, n));
                }
            }
            let Some((cost, n)) = best else { return Solution { stops: Vec::new(), cost: f64::INFINITY } };
            total.get_or_insert(cost);
            stops.push(Stop::at(self.problem, n));
            done &= !(1 << self.problem.nodes[n as usize].item);
            next = Some(n);
        }
        stops.extend(self.start.map(|n| Stop::at(self.problem, n)));
        stops.reverse();
        Solution { stops, cost: total.unwrap_or(0.0) }
    }
}
