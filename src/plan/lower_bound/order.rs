//! What must come before what: containment and ranks, all that follows from them, and the places in a tour it leaves.

use crate::problem::Problem;

/// A relation between items; home is in none.
#[derive(Clone, Debug, Default)]
pub(super) struct Order {
    count: usize,
    /// Whether the row must come before the column; empty when nothing must.
    before: Vec<bool>,
    /// First and last place of each item in a tour, from 1.
    pub places: Vec<[usize; 2]>,
}

impl Order {
    pub fn new(problem: &Problem, first: usize) -> Self {
        let items = &problem.items;
        let count = items.len() + first;
        let mut order = Self { count, before: Vec::new(), places: vec![[1, items.len()]; count] };
        let free = items.iter().all(|i| i.before.is_none() && i.rank == items[0].rank);
        if free {
            return order;
        }
        order.before = vec![false; count * count];
        for (i, item) in items.iter().enumerate() {
            // Bad data could lead round in a circle.
            let mut outer = item.before;
            for _ in 0..items.len() {
                let Some(o) = outer.map(|o| o as usize).filter(|&o| o < items.len() && o != i) else { break };
                order.before[(i + first) * count + o + first] = true;
                outer = items[o].before;
            }
            for (j, other) in items.iter().enumerate().filter(|(_, other)| other.rank > item.rank) {
                let _ = other;
                order.before[(i + first) * count + j + first] = true;
            }
        }
        for i in first..count {
            let earlier = (first..count).filter(|&j| order.before[j * count + i]).count();
            let later = (first..count).filter(|&j| order.before[i * count + j]).count();
            order.places[i] = [1 + earlier, items.len().saturating_sub(later)];
        }
        order
    }

    /// Nothing must come before anything.
    pub fn is_free(&self) -> bool {
        self.before.is_empty()
    }

    /// Whether a tour that has been to `past` may not go to `next` any more; backwards: a tour run from its end.
    pub fn forbids(&self, past: usize, next: usize, backwards: bool) -> bool {
        let (a, b) = if backwards { (past, next) } else { (next, past) };
        self.before.get(a * self.count + b).is_some_and(|&x| x)
    }
}
