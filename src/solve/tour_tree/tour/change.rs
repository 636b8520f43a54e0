//! Changes of a tour, and how they are taken back.

use super::super::index::index;
use super::Tour;
use super::journal::Change;

impl Tour<'_> {
    /// Enters an item at another place.
    pub(in crate::solve::tour_tree) fn enter(&mut self, item: u32, at: u32) {
        let before = self.at(item);
        if before != at {
            self.journal.push(Change::Entered(item, before));
            self.moved(item, at);
        }
    }

    /// Reverses the stretch between two positions.
    pub(in crate::solve::tour_tree) fn reverse(&mut self, from: usize, to: usize) {
        if from < to || (from == to && self.space.two_ends(self.item(from))) {
            self.journal.push(Change::Reversed(from, to));
            self.turn(from, to);
        }
    }

    fn turn(&mut self, from: usize, to: usize) {
        // The other items keep the same neighbours, unless legs cost more one way than the other.
        for outer in [self.item(from - 1), self.item(from), self.item(to), self.item(to + 1)] {
            self.best_entered[outer as usize] = false;
        }
        self.current.order[from..=to].reverse();
        self.legs[from..to].reverse();
        for (position, &item) in (index(from)..).zip(&self.current.order[from..=to]) {
            let i = item as usize;
            self.position[i] = position;
            self.best_entered[i] &= self.space.travel.symmetric;
            if self.space.two_ends(item) {
                self.current.at[i] ^= 1;
                std::mem::swap(&mut self.entry[i], &mut self.exit[i]);
            }
        }
        self.price(from - 1);
        self.price(to);
        if !self.space.travel.symmetric {
            (from..to).for_each(|p| self.price(p));
        }
    }

    /// Exchanges the stretches `from..=middle` and `middle + 1..=to`, both keeping their direction.
    pub(in crate::solve::tour_tree) fn exchange(&mut self, from: usize, middle: usize, to: usize) {
        let second = to - middle;
        self.reverse(from, to);
        self.reverse(from, from + second - 1);
        self.reverse(from + second, to);
    }

    /// Replaces the order, home first, with the seconds from each item to the next.
    pub(in crate::solve::tour_tree) fn reorder(&mut self, order: Vec<u32>, legs: Vec<f64>) {
        self.journal.push(Change::Reordered);
        let before = std::mem::replace(&mut self.current.order, order);
        self.orders.push((before, std::mem::replace(&mut self.legs, legs)));
        self.number();
    }

    /// Accepts all changes: empties the journal.
    pub(in crate::solve::tour_tree) fn commit(&mut self) {
        self.journal.clear();
        self.orders.clear();
    }

    /// Takes back all changes in the journal.
    pub(in crate::solve::tour_tree) fn undo(&mut self) {
        while let Some(change) = self.journal.pop() {
            match change {
                Change::Reversed(from, to) => self.turn(from, to),
                Change::Entered(item, at) => self.moved(item, at),
                Change::Reordered => {
                    if let Some((order, legs)) = self.orders.pop() {
                        (self.current.order, self.legs) = (order, legs);
                        self.number();
                    }
                }
            }
        }
    }
}
