//! Precedence: the transitive closure of containment, ranks and given pairs, and the positions in a tour that it leaves.

use crate::problem::Problem;

/// A relation between items; home is in none.
#[derive(Clone, Debug, Default)]
pub(super) struct Order {
    count: usize,
    /// Whether the item of the row must come before that of the column; empty if there is no precedence.
    before: Vec<bool>,
    /// First and last position of each item in a tour, from 1.
    pub(super) places: Vec<[usize; 2]>,
}

impl Order {
    /// The order of a problem's items, numbered from `first` on.
    pub(super) fn new(problem: &Problem, first: usize) -> Self {
        let items = if problem.table().is_some() { problem.items.len() - 1 } else { problem.items.len() };
        let count = items + first;
        let mut order = Self { count, before: vec![false; count * count], places: vec![[1, items]; count] };
        let mut any = false;
        let mut put = |a: usize, b: usize| {
            if a < items && b < items && a != b {
                order.before[(a + first) * count + b + first] = true;
                any = true;
            }
        };
        for (i, item) in problem.items.iter().enumerate() {
            item.before.into_iter().for_each(|outer| put(i, outer as usize));
            (0..items).filter(|&j| problem.items[j].rank > item.rank).for_each(|j| put(i, j));
        }
        problem.pairs.iter().for_each(|&(a, b)| put(a as usize, b as usize));
        if !any {
            order.before.clear();
            return order;
        }
        // Transitive closure (Warshall, 1962).
        for middle in first..count {
            let after: Vec<bool> = order.before[middle * count..][..count].to_vec();
            for row in order.before.chunks_exact_mut(count).filter(|row| row[middle]) {
                row.iter_mut().zip(&after).for_each(|(before, &after)| *before |= after);
            }
        }
        for i in first..count {
            let earlier = (first..count).filter(|&j| order.before[j * count + i]).count();
            let later = (first..count).filter(|&j| order.before[i * count + j]).count();
            order.places[i] = [1 + earlier, items.saturating_sub(later)];
        }
        order
    }

    /// Whether there is no precedence.
    pub(super) fn is_free(&self) -> bool {
        self.before.is_empty()
    }

    /// Whether a tour that has visited `past` must not visit `next`; `backwards`: for a tour from its end.
    pub(super) fn forbids(&self, past: usize, next: usize, backwards: bool) -> bool {
        let (a, b) = if backwards { (past, next) } else { (next, past) };
        self.before.get(a * self.count + b).is_some_and(|&x| x)
    }
}
