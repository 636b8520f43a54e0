//! The tour: an order of items from home, the entry of each, and a journal that takes changes back.
//!
//! The order is an array with positions, so that successors and "between" are looked up in constant time. Every change of
//! order is a sequence of reversals, which undo themselves: the journal takes a rejected kick back. An open contour in a
//! reversed stretch is run the other way.

mod change;
mod journal;

use super::gap::Reaching;
use super::snapshot::TourSnapshot;
use super::space::Space;
use super::travel::{Gap, Place};
use crate::geometry::DVec2;
use journal::Change;

/// An order of items with their entries.
pub(super) struct Tour<'p> {
    pub(super) space: Space<'p>,
    current: TourSnapshot,
    /// Position by item.
    position: Vec<u32>,
    /// Where the head enters and leaves, by item.
    entry: Vec<Place>,
    exit: Vec<Place>,
    /// Seconds from each item to the next, by position; the last leg goes home.
    legs: Vec<f64>,
    /// Items whose entry is known to be the best between their neighbours.
    best_entered: Vec<bool>,
    journal: Vec<Change>,
    /// Orders that the journal can restore, with their legs.
    orders: Vec<(Vec<u32>, Vec<f64>)>,
    /// The tour keeps ranks but may ignore nesting, see `anneal/cycles.rs`.
    pub(super) ignores_nesting: bool,
    /// Moves priced so far.
    pub(super) priced: u64,
}

impl<'p> Tour<'p> {
    /// A tour from a snapshot, which holds home first and then every item with nodes once.
    pub(super) fn new(space: Space<'p>, snapshot: TourSnapshot) -> Self {
        let n = snapshot.at.len();
        let mut tour = Self {
            space,
            current: snapshot,
            position: vec![0; n],
            entry: vec![Place::from(DVec2::ZERO); n],
            exit: vec![Place::from(DVec2::ZERO); n],
            legs: Vec::new(),
            best_entered: vec![false; n],
            journal: Vec::new(),
            orders: Vec::new(),
            ignores_nesting: false,
            priced: 0,
        };
        tour.settle();
        tour
    }

    /// Restores a snapshot; the journal is emptied.
    pub(super) fn restore(&mut self, snapshot: TourSnapshot) {
        self.current = snapshot;
        self.settle();
    }

    fn settle(&mut self) {
        self.commit();
        self.number();
        for position in 0..self.current.order.len() {
            self.place(self.current.order[position]);
        }
        self.legs = self.legs_of(&self.current.order);
    }

    /// Seconds from each item to the next in an order, with the current entries.
    pub(super) fn legs_of(&self, order: &[u32]) -> Vec<f64> {
        let next = order.iter().skip(1).chain([&self.space.home]);
        order.iter().zip(next).map(|(&from, &to)| self.edge(from, to)).collect()
    }

    /// Stores the positions of all items.
    fn number(&mut self) {
        for (position, &item) in (0..).zip(&self.current.order) {
            self.position[item as usize] = position;
            self.best_entered[item as usize] = false;
        }
    }

    /// Stores where the head enters and leaves an item.
    fn place(&mut self, item: u32) {
        let at = self.current.at[item as usize];
        self.entry[item as usize] = self.space.places(item).at(at);
        self.exit[item as usize] = self.space.exit(item, at);
        for touched in [self.previous(item), item, self.next(item)] {
            self.best_entered[touched as usize] = false;
        }
    }

    /// Enters an item at another place.
    fn moved(&mut self, item: u32, at: u32) {
        self.current.at[item as usize] = at;
        self.place(item);
        let here = self.position(item);
        self.price(if here == 0 { self.last() } else { here - 1 });
        self.price(here);
    }

    /// Prices the leg from a position to the next.
    fn price(&mut self, position: usize) {
        self.legs[position] = self.edge(self.item(position), self.item(position + 1));
    }

    /// Whether the entry of an item is known to be the best between its current neighbours.
    pub(super) fn is_entered_best(&self, item: u32) -> bool {
        self.best_entered[item as usize]
    }

    /// Notes that no better entry was found for an item.
    pub(super) fn set_entered_best(&mut self, item: u32) {
        self.best_entered[item as usize] = true;
    }

    /// The current order and entries.
    pub(super) fn current(&self) -> &TourSnapshot {
        &self.current
    }

    /// The order and entries before the changes in the journal.
    pub(super) fn before_journal(&self) -> TourSnapshot {
        let mut snapshot = self.current.clone();
        let mut orders = self.orders.iter().rev();
        for change in self.journal.iter().rev() {
            match *change {
                Change::Reversed(from, to) => {
                    snapshot.order[from..=to].reverse();
                    for &item in snapshot.order[from..=to].iter().filter(|&&i| self.space.two_ends(i)) {
                        snapshot.at[item as usize] ^= 1;
                    }
                }
                Change::Entered(item, at) => snapshot.at[item as usize] = at,
                Change::Reordered => orders.next().into_iter().for_each(|o| snapshot.order.clone_from(&o.0)),
            }
        }
        snapshot
    }

    /// Last position.
    pub(super) fn last(&self) -> usize {
        self.current.order.len() - 1
    }

    /// The item at a position; the one past the last is home again.
    #[inline]
    pub(super) fn item(&self, position: usize) -> u32 {
        self.current.order.get(position).copied().unwrap_or(self.space.home)
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
        self.current.order[if p == 0 { self.last() } else { p - 1 }]
    }

    #[inline]
    pub(super) fn at(&self, item: u32) -> u32 {
        self.current.at[item as usize]
    }

    #[inline]
    pub(super) fn entry(&self, item: u32) -> Place {
        self.entry[item as usize]
    }

    #[inline]
    pub(super) fn exit(&self, item: u32) -> Place {
        self.exit[item as usize]
    }

    /// Where the head would enter an item in a reversed stretch: a contour with leads is entered at its lead-in all the same.
    #[inline]
    pub(super) fn entry_reversed(&self, item: u32) -> Place {
        if self.space.is_directed(item) { self.entry(item) } else { self.exit(item) }
    }

    /// Where the head would leave an item in a reversed stretch.
    #[inline]
    pub(super) fn exit_reversed(&self, item: u32) -> Place {
        if self.space.is_directed(item) { self.exit(item) } else { self.entry(item) }
    }

    /// Seconds from `p` into `item` at `q`; coming home costs nothing when the path does not return.
    #[inline(always)]
    pub(super) fn leg_seconds(&self, p: Place, item: u32, q: Place) -> f64 {
        if item == self.space.home && !self.space.problem.closed {
            0.0
        } else {
            self.space.travel.seconds_here(p, q)
        }
    }

    /// Seconds from one item to another, if it came next.
    pub(super) fn edge(&self, from: u32, to: u32) -> f64 {
        self.edge_here(from, to)
    }

    /// The same, inlined for the hottest loops.
    #[inline(always)]
    pub(super) fn edge_here(&self, from: u32, to: u32) -> f64 {
        self.leg_seconds(self.exit(from), to, self.entry(to))
    }

    /// Seconds from an item to the next.
    #[inline]
    pub(super) fn leg_after(&self, item: u32) -> f64 {
        self.legs[self.position(item)]
    }

    /// Seconds from the item at a position to the next.
    pub(super) fn leg_from(&self, position: usize) -> f64 {
        self.legs[position]
    }

    /// Seconds to an item from the previous one.
    #[inline]
    pub(super) fn leg_before(&self, item: u32) -> f64 {
        let p = self.position(item);
        self.legs[if p == 0 { self.last() } else { p - 1 }]
    }

    /// Extra seconds of the current entry of an item.
    #[inline]
    pub(super) fn extra(&self, item: u32) -> f64 {
        self.space.extra(item, self.at(item))
    }

    /// Cost of the whole tour, s: travel and extra seconds of entries.
    pub(super) fn cost(&self) -> f64 {
        let seconds = |p| self.edge(self.item(p), self.item(p + 1)) + self.extra(self.item(p));
        (0..=self.last()).map(seconds).sum()
    }

    /// The seconds of a leg on average in the tour, which costs `cost`. A link that saves more than it takes counts by its size, as
    /// it is about as much that a move gains or loses.
    pub(super) fn mean_leg(&self, cost: f64) -> f64 {
        let saved: f64 = self.legs.iter().map(|leg| leg.min(0.0)).sum();
        (cost - 2.0 * saved) / self.last().max(1) as f64
    }

    /// Whether the tour costs `seconds`, up to rounding. For debug assertions.
    pub(super) fn cost_is(&self, seconds: f64) -> bool {
        let cost = self.cost();
        let near = |a: f64| (cost - a).abs() <= 1e-6 * cost.max(1.0);
        let extra = |p| self.extra(self.item(p));
        near(seconds) && near(self.legs.iter().sum::<f64>() + (0..=self.last()).map(extra).sum::<f64>())
    }

    /// The gap between two items, if they were neighbours.
    #[inline(always)]
    pub(super) fn gap(&self, from: u32, to: u32) -> Gap {
        let ends = to == self.space.home && !self.space.problem.closed;
        Gap { from: self.exit(from), to: (!ends).then(|| self.entry(to)) }
    }

    /// Lower bounds of the legs from an item of the tour to another item, and from there to the item of the tour.
    #[inline(always)]
    pub(super) fn least_legs(&self, other: &Reaching, item: u32) -> [f64; 2] {
        let out = other.at_least(self.exit(item), false);
        let back = if item == self.space.home && !self.space.problem.closed {
            0.0
        } else if self.space.is_entered_where_left(item) {
            out
        } else {
            other.at_least(self.entry(item), true)
        };
        [out, back]
    }

    /// Extra cost of a stretch when it is reversed, s: none unless legs cost more one way than the other. It looks at the
    /// whole stretch, so that it is asked last.
    pub(super) fn reversal_cost(&self, from: usize, to: usize) -> f64 {
        if self.space.travel.symmetric {
            return self.reversal_cost_of_groups(from, to);
        }
        let back = |from, to| self.leg_seconds(self.exit_reversed(from), to, self.entry_reversed(to));
        let pairs = self.current.order[from..=to].windows(2);
        let legs: f64 = pairs.map(|p| back(p[1], p[0]) - self.edge(p[0], p[1])).sum();
        legs + self.reversal_cost_of_groups(from, to)
    }

    /// The same for the pierce groups in the stretch alone: paths forth and back through them differ.
    fn reversal_cost_of_groups(&self, from: usize, to: usize) -> f64 {
        let within = |&&i: &&u32| (from..=to).contains(&self.position(i));
        let over = |&i: &u32| self.space.extra(i, self.at(i) ^ 1) - self.extra(i);
        self.space.direction_dependent.iter().filter(within).map(over).sum()
    }
}
