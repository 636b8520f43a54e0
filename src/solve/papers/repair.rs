//! Repairs any order of items so that it keeps precedence. The codes of the papers ignore precedence, but sheets have it.
//!
//! An item that must come before another one, such as a hole before its outer contour, is moved to just before it if it
//! comes later. Otherwise items keep their order. Ranks are cut one after the other, and each group stays together at the
//! position of its first item.

use crate::order::sort_by;
use crate::problem::{ItemId, NodeId, Problem};

/// Makes orders of a problem's items feasible.
pub struct Repair {
    items: usize,
    /// For each item and then each group, the index of the group around it; the last index means no group.
    parent: Vec<usize>,
    /// For each item and group, the ones with the same parent that must come before it.
    first: Vec<Vec<usize>>,
    rank: Vec<u32>,
    /// All ranks, ascending.
    ranks: Vec<u32>,
    start: Option<usize>,
}

/// A step of the depth-first walk through the tree of groups.
enum Turn {
    /// First everything that must come before this item or group, then itself.
    Enter(usize),
    /// The item or group itself.
    Emit(usize),
}

impl Repair {
    /// Prepares the repair for a problem.
    pub fn new(problem: &Problem) -> Self {
        let items = problem.items.len();
        let groups = &problem.groups;
        let root = items + groups.count();
        let mut parent = vec![root; root];
        for id in (0..).take(items) {
            let mut inner = id as usize;
            for group in groups.of(id) {
                parent[inner] = items + group as usize;
                inner = items + group as usize;
            }
        }
        let mut first = vec![Vec::new(); root];
        let inside = (0..).zip(&problem.items).filter_map(|(id, item)| item.before.map(|outer| (id, outer)));
        for (a, b) in inside.chain(problem.pairs.iter().copied()) {
            let top = groups.common(a, b).map_or(root, |g| items + g as usize);
            let side = |mut at: usize| {
                while parent[at] != top {
                    at = parent[at];
                }
                at
            };
            first[side(b as usize)].push(side(a as usize));
        }
        let rank = problem.items.iter().map(|i| i.rank).collect();
        Self { items, parent, first, rank, ranks: ranks(problem), start: problem.start().map(|s| s as usize) }
    }

    /// Prepares the repair for a problem; `None` if every order of its items is feasible.
    pub(super) fn needed(problem: &Problem) -> Option<Self> {
        let free = problem.pairs.is_empty()
            && problem.groups.is_empty()
            && problem.items.iter().all(|i| i.before.is_none() && i.rank == problem.items[0].rank);
        (!free).then(|| Self::new(problem))
    }

    /// The feasible tour closest to a given one. Items keep the nodes at which they are entered.
    pub(super) fn tour(&self, problem: &Problem, tour: &[NodeId]) -> Vec<NodeId> {
        let item = |node: NodeId| problem.nodes[node as usize].item;
        let mut node_of = vec![0; problem.items.len()];
        tour.iter().for_each(|&n| node_of[item(n) as usize] = n);
        let order: Vec<ItemId> = tour.iter().map(|&n| item(n)).collect();
        self.apply(&order).into_iter().map(|i| node_of[i as usize]).collect()
    }

    /// The feasible order closest to `order`, which contains each item at most once. Items that are not in `order` are not
    /// added.
    pub fn apply(&self, order: &[ItemId]) -> Vec<ItemId> {
        let root = self.parent.len();
        let mut out = Vec::with_capacity(order.len());
        let mut done = vec![false; root];
        let mut turns = Vec::new();
        for &rank in &self.ranks {
            let mut children: Vec<Vec<usize>> = vec![Vec::new(); root + 1];
            let begins = order.iter().map(|&i| i as usize).filter(|&i| self.rank[i] == rank);
            let (starts, others): (Vec<usize>, Vec<usize>) = begins.partition(|&i| Some(i) == self.start);
            let mut known = vec![false; root];
            for item in starts.into_iter().chain(others) {
                let mut at = item;
                while at != root && !std::mem::replace(&mut known[at], true) {
                    children[self.parent[at]].push(at);
                    at = self.parent[at];
                }
            }
            // A group may contain items of several ranks, so it may be emitted once for each rank.
            done[self.items..].fill(false);
            turns.extend(children[root].iter().rev().map(|&c| Turn::Enter(c)));
            while let Some(turn) = turns.pop() {
                match turn {
                    Turn::Enter(it) if done[it] || !known[it] => {}
                    Turn::Enter(it) => {
                        done[it] = true;
                        turns.push(Turn::Emit(it));
                        turns.extend(self.first[it].iter().rev().map(|&f| Turn::Enter(f)));
                    }
                    Turn::Emit(it) if it < self.items => out.extend(ItemId::try_from(it)),
                    Turn::Emit(it) => turns.extend(children[it].iter().rev().map(|&c| Turn::Enter(c))),
                }
            }
        }
        debug_assert_eq!(out.len(), order.len(), "every item has its place");
        out
    }
}

/// All ranks of a problem, ascending.
pub(super) fn ranks(problem: &Problem) -> Vec<u32> {
    let mut ranks: Vec<u32> = problem.items.iter().map(|i| i.rank).collect();
    sort_by(&mut ranks, |&r| [r.into(), 0, 0]);
    ranks.dedup();
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine;
    use crate::problem::{Groups, Item};
    use glam::DVec2;

    fn problem(before: &[Option<u32>], ranks: &[u32], groups: Groups) -> Problem {
        let item = |(&before, &rank): (&Option<u32>, &u32)| Item { before, rank, ..Item::default() };
        let items = before.iter().zip(ranks).map(item).collect();
        let machine = machine::presets().into_iter().next().unwrap();
        let (home, closed) = (DVec2::ZERO, true);
        Problem { items, nodes: vec![], home, closed, groups, ..Problem::empty(machine) }
    }

    #[test]
    fn what_lies_inside_comes_just_before_its_outer_contour() {
        // Item 1 lies in 0, item 2 in 1; item 3 is free.
        let p = problem(&[None, Some(0), Some(1), None], &[0; 4], Groups::default());
        let repair = Repair::new(&p);
        assert_eq!(repair.apply(&[0, 3, 1, 2]), [2, 1, 0, 3]);
        assert_eq!(repair.apply(&[3, 2, 1, 0]), [3, 2, 1, 0], "an allowed order stays");
    }

    #[test]
    fn ranks_groups_and_pairs_are_kept() {
        let groups = Groups::new(vec![Some(0), Some(0), Some(1), Some(1), None], vec![None, None]);
        let mut p = problem(&[None, Some(0), None, Some(2), None], &[1, 1, 1, 1, 0], groups);
        p.pairs = vec![(2, 1)];
        // Group 0 comes first, but its item 1 waits for item 2 of group 1, which waits for item 3.
        assert_eq!(Repair::new(&p).apply(&[0, 3, 1, 2, 4]), [4, 3, 2, 1, 0]);
    }
}
