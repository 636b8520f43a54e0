//! The tour: an order of items from home, where each is entered, and a journal that takes changes back.
//!
//! Held as an array with positions, so succession and "between" are looked up at once. Every change of order is a
//! sequence of reversals, which undo themselves: a kick that did not pay is taken back by its journal. An open
//! contour in a reversed stretch is run the other way.

mod change;
mod journal;

use super::kept::Kept;
use super::space::Space;
use super::travel::{Gap, Place};
use crate::geometry::DVec2;
use journal::Change;

/// An order of items with entries.
pub(super) struct Tour<'p> {
    pub(super) space: Space<'p>,
    now: Kept,
    /// Position by item.
    position: Vec<u32>,
    /// Where the head enters and leaves, by item.
    entry: Vec<Place>,
    exit: Vec<Place>,
    /// Seconds from each to the one after it, by position; the last goes home.
    ways: Vec<f64>,
    /// Items known to be entered best where they stand.
    best_entered: Vec<bool>,
    journal: Vec<Change>,
    /// Orders before others, with their ways.
    orders: Vec<(Vec<u32>, Vec<f64>)>,
    /// Heeds ranks, but not what lies inside what: see `anneal/cycles.rs`.
    pub(super) free: bool,
    /// Moves priced so far.
    pub(super) priced: u64,
}

impl<'p> Tour<'p> {
    /// The tour over `kept`, which holds every item of the space that has nodes once, home first.
    pub(super) fn new(space: Space<'p>, kept: Kept) -> Self {
        let n = kept.at.len();
        let mut tour = Self {
            space,
            now: kept,
            position: vec![0; n],
            entry: vec![Place::from(DVec2::ZERO); n],
            exit: vec![Place::from(DVec2::ZERO); n],
            ways: Vec::new(),
            best_entered: vec![false; n],
            journal: Vec::new(),
            orders: Vec::new(),
            free: false,
            priced: 0,
        };
        tour.settle();
        tour
    }

    /// Takes over another order with entries; the journal starts anew.
    pub(super) fn put(&mut self, kept: Kept) {
        self.now = kept;
        self.settle();
    }

    fn settle(&mut self) {
        self.commit();
        self.number();
        for position in 0..self.now.order.len() {
            self.place(self.now.order[position]);
        }
        self.ways = self.ways_of(&self.now.order);
    }

    /// Seconds from each to the one after it in an order, entered as they are now.
    pub(super) fn ways_of(&self, order: &[u32]) -> Vec<f64> {
        let next = order.iter().skip(1).chain([&self.space.home]);
        order.iter().zip(next).map(|(&from, &to)| self.edge(from, to)).collect()
    }

    fn number(&mut self) {
        for (position, &item) in (0..).zip(&self.now.order) {
            self.position[item as usize] = position;
            self.best_entered[item as usize] = false;
        }
    }

    /// Looks up where the head enters and leaves an item.
    fn place(&mut self, item: u32) {
        let at = self.now.at[item as usize];
        self.entry[item as usize] = self.space.places(item).at(at);
        self.exit[item as usize] = self.space.exit(item, at);
        for touched in [self.previous(item), item, self.next(item)] {
            self.best_entered[touched as usize] = false;
        }
    }

    /// Enters an item at another place.
    fn moved(&mut self, item: u32, at: u32) {
        self.now.at[item as usize] = at;
        self.place(item);
        let here = self.position(item);
        self.price(if here == 0 { self.last() } else { here - 1 });
        self.price(here);
    }

    /// Prices the way from a position on.
    fn price(&mut self, position: usize) {
        self.ways[position] = self.edge(self.item(position), self.item(position + 1));
    }

    /// Whether an item is known to be entered where that costs least between its neighbours as they are.
    pub(super) fn is_entered_best(&self, item: u32) -> bool {
        self.best_entered[item as usize]
    }

    /// Nothing better was found for an item where it stands.
    pub(super) fn entered_best(&mut self, item: u32) {
        self.best_entered[item as usize] = true;
    }

    /// Order and entries as they are now.
    pub(super) fn now(&self) -> &Kept {
        &self.now
    }

    /// Order and entries as they were when the journal began.
    pub(super) fn before(&self) -> Kept {
        let mut kept = self.now.clone();
        let mut orders = self.orders.iter().rev();
        for change in self.journal.iter().rev() {
            match *change {
                Change::Reversed(from, to) => {
                    kept.order[from..=to].reverse();
                    for &item in kept.order[from..=to].iter().filter(|&&i| self.space.two_ends(i)) {
                        kept.at[item as usize] ^= 1;
                    }
                }
                Change::Entered(item, at) => kept.at[item as usize] = at,
                Change::Reordered => orders.next().into_iter().for_each(|o| kept.order.clone_from(&o.0)),
            }
        }
        kept
    }

    /// Last position.
    pub(super) fn last(&self) -> usize {
        self.now.order.len() - 1
    }

    /// Item at a position; one past the last is home again.
    #[inline]
    pub(super) fn item(&self, position: usize) -> u32 {
        self.now.order.get(position).copied().unwrap_or(self.space.home)
    }

    #[inline]
    pub(super) fn position(&self, item: u32) -> usize {
        self.position[item as usize] as usize
    }

    #[inline]
    pub(super) fn next(&self, item: u32) -> u32 {
        self.item(self.position(item) + 1)
    }

    #[inline]
    pub(super) fn previous(&self, item: u32) -> u32 {
        let p = self.position(item);
        self.now.order[if p == 0 { self.last() } else { p - 1 }]
    }

    #[inline]
    pub(super) fn at(&self, item: u32) -> u32 {
        self.now.at[item as usize]
    }

    #[inline]
    pub(super) fn entry(&self, item: u32) -> Place {
        self.entry[item as usize]
    }

    #[inline]
    pub(super) fn exit(&self, item: u32) -> Place {
        self.exit[item as usize]
    }

    /// Seconds from `p` into `item` at point `q`; home costs nothing when the path does not return.
    #[inline(always)]
    pub(super) fn way(&self, p: Place, item: u32, q: Place) -> f64 {
        if item == self.space.home && !self.space.problem.closed {
            0.0
        } else {
            self.space.travel.seconds_here(p, q)
        }
    }

    /// Seconds from one item to another, if that came after it.
    pub(super) fn edge(&self, from: u32, to: u32) -> f64 {
        self.edge_here(from, to)
    }

    /// The same, for where it is asked most.
    #[inline(always)]
    pub(super) fn edge_here(&self, from: u32, to: u32) -> f64 {
        self.way(self.exit(from), to, self.entry(to))
    }

    /// Seconds from an item on to the one after it.
    #[inline]
    pub(super) fn way_on(&self, item: u32) -> f64 {
        self.ways[self.position(item)]
    }

    /// Seconds to an item from the one before it.
    #[inline]
    pub(super) fn way_to(&self, item: u32) -> f64 {
        let p = self.position(item);
        self.ways[if p == 0 { self.last() } else { p - 1 }]
    }

    /// Seconds on top of an item's fixed ones for being entered where it is.
    #[inline]
    pub(super) fn extra(&self, item: u32) -> f64 {
        self.space.extra(item, self.at(item))
    }

    /// Seconds of the whole tour: travel and entries.
    pub(super) fn cost(&self) -> f64 {
        let seconds = |p| self.edge(self.item(p), self.item(p + 1)) + self.extra(self.item(p));
        (0..=self.last()).map(seconds).sum()
    }

    /// Whether the tour takes `seconds`, but for rounding: for debug assertions.
    pub(super) fn cost_is(&self, seconds: f64) -> bool {
        let cost = self.cost();
        let near = |a: f64| (cost - a).abs() <= 1e-6 * cost.max(1.0);
        let extra = |p| self.extra(self.item(p));
        near(seconds) && near(self.ways.iter().sum::<f64>() + (0..=self.last()).map(extra).sum::<f64>())
    }

    /// The gap between two items that follow each other, or would.
    #[inline(always)]
    pub(super) fn gap(&self, from: u32, to: u32) -> Gap {
        let ends = to == self.space.home && !self.space.problem.closed;
        Gap { from: self.exit(from), to: (!ends).then(|| self.entry(to)) }
    }

    /// Seconds that a stretch costs more when run the other way round: none, unless ways cost more than the ways back.
    /// Looks at the whole stretch then, so it is asked last.
    pub(super) fn turning(&self, from: usize, to: usize) -> f64 {
        if self.space.travel.symmetric {
            return self.turning_over(from, to);
        }
        let pairs = self.now.order[from..=to].windows(2);
        pairs.map(|p| self.edge(p[1], p[0]) - self.edge(p[0], p[1])).sum()
    }

    /// The same of pierce groups in the stretch alone: ways out and back through them differ.
    fn turning_over(&self, from: usize, to: usize) -> f64 {
        let within = |&&i: &&u32| (from..=to).contains(&self.position(i));
        let over = |&i: &u32| self.space.extra(i, self.at(i) ^ 1) - self.extra(i);
        self.space.lopsided.iter().filter(within).map(over).sum()
    }
}
