//! The element insertion heuristic: inserts one element after the other, always the cheapest insertion that keeps the order
//! possible.
//!
//! Dewil et al. use it for sub paths (section 4.7) and describe it in an earlier paper (2014a), which was not at our
//! disposal. Our reading: the order begins with the elements at the given ends, and the cost of an insertion is the change
//! of air seconds and starts between its neighbours.

use super::net::{Net, Order, Step};
use crate::order::{real, sort_by};

/// An order from node to node; `None` if none was found.
pub(super) fn order(net: &Net, from: u32, to: u32) -> Option<Order> {
    let steps = net.steps();
    let first = steps.clone().find(|&s| net.step(s)[0] == from)?;
    let last = steps.clone().find(|&s| net.step(s)[1] == to && s / 2 != first / 2);
    let mut order: Order = std::iter::once(first).chain(last).collect();
    let mut left: Vec<u32> = net.elements().filter(|e| !order.iter().any(|s| s / 2 == *e)).collect();
    let gap = |a: u32, b: u32| if a == b { 0.0 } else { net.way(a, b) + net.start() + net.pre_cut() };
    while !left.is_empty() {
        let mut ways: Vec<(f64, usize, usize, Step)> = Vec::new();
        for (which, &e) in left.iter().enumerate() {
            for step in [2 * e, 2 * e + 1] {
                let [a, b] = net.step(step);
                // Never before the first element, and never after the last if there are two.
                for k in 1..order.len().max(2) {
                    let before = net.step(order[k - 1])[1];
                    let after = order.get(k).map(|&s| net.step(s)[0]);
                    let more = gap(before, a) + after.map_or(0.0, |n| gap(b, n) - gap(before, n));
                    ways.push((more, which, k, step));
                }
            }
        }
        sort_by(&mut ways, |w| [real(w.0), (w.1 as u64) << 32 | w.2 as u64, w.3.into()]);
        let (which, grown) = ways.into_iter().find_map(|(_, which, k, step)| {
            let mut grown = order.clone();
            grown.insert(k, step);
            net.is_possible_so_far(&grown, &left).then_some((which, grown))
        })?;
        order = grown;
        left.swap_remove(which);
    }
    (net.ends(&order) == [from, to] && net.is_possible(&order)).then_some(order)
}

impl Net<'_> {
    /// Whether an order of some elements can be extended to all: the missing ones may be cut last.
    fn is_possible_so_far(&self, order: &[Step], missing: &[u32]) -> bool {
        let mut held = self.held();
        // All missing elements hold, in whatever order they are put back.
        for _ in 0..self.group.faces {
            for &e in missing.iter().filter(|e| !order.iter().any(|s| s / 2 == **e)) {
                self.put_back(&mut held, 2 * e);
            }
        }
        order.iter().rev().all(|&s| self.put_back(&mut held, s))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, Path, Segment};
    use crate::machine::preset;
    use crate::problem::{Element, GroupProblem};

    /// Two parts of 20 by 10 that share the side between nodes 0 and 1. `shared` is the number of that side among the three
    /// elements; the outline of the left part comes before that of the right one.
    fn two_parts(shared: usize) -> GroupProblem {
        let place = |p: [f64; 2]| DVec2::from(p);
        let path = |points: &[[f64; 2]]| {
            let line = |w: &[[f64; 2]]| Segment::line(place(w[0]), place(w[1]));
            Path::new(points.windows(2).map(line).collect(), false)
        };
        let element = |points: &[[f64; 2]], faces| Element {
            contour: 0,
            from: 0.0,
            to: 0.0,
            ends: [0, 1],
            faces,
            path: path(points),
        };
        let side = element(&[[20.0, 0.0], [20.0, 10.0]], [1, 2]);
        let left = element(&[[20.0, 0.0], [0.0, 0.0], [0.0, 10.0], [20.0, 10.0]], [0, 1]);
        let right = element(&[[20.0, 0.0], [40.0, 0.0], [40.0, 10.0], [20.0, 10.0]], [2, 0]);
        let mut elements = vec![left, right];
        elements.insert(shared, side);
        GroupProblem {
            nodes: vec![place([20.0, 0.0]), place([20.0, 10.0])],
            elements,
            faces: 3,
            beside: Vec::new(),
        }
    }

    #[test]
    fn the_cheapest_insertion_that_keeps_the_order_possible_by_hand() {
        let machine = preset("fibre-6kw-thick").unwrap();
        let group = two_parts(0);
        let net = Net::new(&group, &machine, false);
        // The order begins with the shared side upwards and ends with the left outline, both from 0 to 1. The right outline
        // goes between them: downwards, from 1 to 0, it takes away the air move from 1 to 0; upwards it would add another.
        assert_eq!(order(&net, 0, 1), Some(vec![0, 5, 2]));
        // From 1 to 0 all directions are turned.
        assert_eq!(order(&net, 1, 0), Some(vec![1, 4, 3]));
        // Every node has an odd number of elements: without an air move nothing leads back to where it began, so the cheapest
        // insertion has one, upwards from 0 after the head has come to 1.
        let back = order(&net, 0, 0).unwrap();
        assert_eq!((net.ends(&back), back.len()), ([0, 0], 3));

        // If the order would end with the shared side, both of its parts had fallen out before: there is no such order.
        let group = two_parts(1);
        let net = Net::new(&group, &machine, false);
        assert_eq!(order(&net, 0, 1), None);
    }
}
