//! The element insertion heuristic: inserts one element after the other, always the cheapest insertion that keeps the order
//! possible.
//!
//! Dewil et al. use it for sub paths (section 4.7) and describe it in an earlier paper (2014a), which was not at our
//! disposal. Our reading: the order begins with the elements at the given ends, and the cost of an insertion is the change
//! of air seconds and starts between its neighbours.

use super::net::{Net, Order, Step};
use crate::geometry::Union;
use crate::order::{Key, real};
use std::ops::Range;

/// Most elements of a group: with the 42 pairs of ends, 880 take 10 s and 1,860 take 80 s, beside two other programs on two cores.
pub const MOST: usize = 1000;

/// Insertions of an element that are known at a time, so that all are seldom compared again when the cheapest is no longer possible.
const KNOWN: usize = 16;

/// An order from node to node; `None` if none was found.
pub(super) fn order(net: &Net, from: u32, to: u32) -> Option<Order> {
    let steps = net.steps();
    let first = steps.clone().find(|&s| net.step(s)[0] == from)?;
    let last = steps.clone().find(|&s| net.step(s)[1] == to && s / 2 != first / 2);
    let mut growing = Growing::new(net, std::iter::once(first).chain(last).collect());
    while !growing.left.is_empty() {
        growing.insert_cheapest()?;
    }
    let order = growing.order;
    (net.ends(&order) == [from, to] && net.is_possible(&order)).then_some(order)
}

/// An insertion of an element into an order.
#[derive(Clone, Copy)]
struct Insertion {
    /// Seconds that it adds.
    more: f64,
    /// Number of steps before it.
    place: usize,
    step: Step,
}

impl Insertion {
    /// What insertions are compared by; `which`: the index of the element among those that are left.
    fn key(&self, which: usize) -> Key {
        [real(self.more), (which as u64) << 32 | self.place as u64, self.step.into()]
    }
}

/// An order to which elements are added.
struct Growing<'n> {
    net: &'n Net<'n>,
    order: Order,
    /// The elements that are not in it, each with its cheapest insertions, the cheapest first, whether they keep the order
    /// possible or not.
    left: Vec<(u32, Vec<Insertion>)>,
}

impl<'n> Growing<'n> {
    fn new(net: &'n Net<'n>, order: Order) -> Self {
        let left =
            net.elements().filter(|e| !order.iter().any(|s| s / 2 == *e)).map(|e| (e, Vec::new())).collect();
        let mut growing = Self { net, order, left };
        for which in 0..growing.left.len() {
            growing.left[which].1 = growing.cheapest(growing.left[which].0, growing.places());
        }
        growing
    }

    /// Where elements may be inserted: never before the first element, and never after the last if there are two.
    fn places(&self) -> Range<usize> {
        1..self.order.len().max(2)
    }

    /// The cheapest insertions of an element at some places, at most [`KNOWN`].
    fn cheapest(&self, element: u32, places: Range<usize>) -> Vec<Insertion> {
        let mut found = Vec::new();
        for place in places {
            [2 * element, 2 * element + 1]
                .iter()
                .for_each(|&step| add(&mut found, self.insertion(step, place)));
        }
        found
    }

    fn insertion(&self, step: Step, place: usize) -> Insertion {
        let net = self.net;
        let gap = |a: u32, b: u32| if a == b { 0.0 } else { net.way(a, b) + net.start() + net.pre_cut() };
        let [a, b] = net.step(step);
        let before = net.step(self.order[place - 1])[1];
        let after = self.order.get(place).map(|&s| net.step(s)[0]);
        let more = gap(before, a) + after.map_or(0.0, |n| gap(b, n) - gap(before, n));
        Insertion { more, place, step }
    }

    /// Makes the cheapest insertion that keeps the order possible; `None` if there is none.
    fn insert_cheapest(&mut self) -> Option<()> {
        let mut ways: Vec<Option<Insertion>> = self.left.iter().map(|l| l.1.first().copied()).collect();
        loop {
            let keys =
                ways.iter().enumerate().filter_map(|(which, way)| Some((way.as_ref()?.key(which), which)));
            let which = keys.min()?.1;
            let (way, possible) = (ways[which]?, self.possible(which));
            if possible.contains(&way.place) {
                self.insert(which, way);
                return Some(());
            }
            let (element, known) = &self.left[which];
            let other = known.iter().find(|k| possible.contains(&k.place)).copied();
            ways[which] = other.or_else(|| self.cheapest(*element, possible).first().copied());
        }
    }

    /// The places at which an element may be inserted so that the order can be extended to all elements: those that are
    /// missing then may be cut last. The order is followed backwards, as in [`Net::is_possible`].
    fn possible(&self, which: usize) -> Range<usize> {
        let net = self.net;
        let element = 2 * self.left[which].0;
        let mut held = self.held_by_others(which);
        let mut without = held.clone();
        // Without the element, all steps from this place on are possible.
        let mut first = self.order.len();
        while first > 0 && net.put_back(&mut without, self.order[first - 1]) {
            first -= 1;
        }
        // The last place: from there on, what is put back holds the element, and with it all steps before have to be possible.
        let mut last = self.order.len();
        while !net.put_back(&mut held, element) {
            if last == first {
                return 0..0;
            }
            last -= 1;
            net.put_back(&mut held, self.order[last]);
        }
        if !self.order[..last].iter().rev().all(|&s| net.put_back(&mut held, s)) {
            return 0..0;
        }
        let places = self.places();
        first.max(places.start)..(last + 1).min(places.end)
    }

    /// The areas that hang on the sheet by the missing elements other than one, in whatever order they are put back.
    fn held_by_others(&self, which: usize) -> Vec<bool> {
        let mut areas = Union::new(self.net.sides.len());
        for (_, left) in self.left.iter().enumerate().filter(|(other, _)| *other != which) {
            let [a, b] = self.net.faces(2 * left.0);
            areas.join(a, b);
        }
        (0..).take(self.net.sides.len()).map(|area| areas.root(area) == 0).collect()
    }

    fn insert(&mut self, which: usize, way: Insertion) {
        self.order.insert(way.place, way.step);
        self.left.swap_remove(which);
        let places = self.places();
        for which in 0..self.left.len() {
            let element = self.left[which].0;
            let mut known = std::mem::take(&mut self.left[which].1);
            known.retain(|k| k.place != way.place);
            known.iter_mut().for_each(|k| k.place += usize::from(k.place > way.place));
            if let Some(last) = known.last().map(|k| k.key(0)) {
                // What costs more than all that are known comes after some that are not known.
                let new = self.cheapest(element, way.place..(way.place + 2).min(places.end));
                new.into_iter().filter(|n| n.key(0) < last).for_each(|n| add(&mut known, n));
            } else {
                known = self.cheapest(element, places.clone());
            }
            self.left[which].1 = known;
        }
    }
}

/// Adds an insertion to the cheapest ones of the same element.
fn add(known: &mut Vec<Insertion>, new: Insertion) {
    if known.len() == KNOWN {
        if known.last().is_some_and(|last| last.key(0) < new.key(0)) {
            return;
        }
        known.pop();
    }
    known.insert(known.partition_point(|k| k.key(0) < new.key(0)), new);
}

#[cfg(test)]
mod tests;
