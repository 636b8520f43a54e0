//! When all orders are enumerated, and what follows from those that are left.

use super::super::charges::HAS_CUTS;
use super::super::net::Item;
use super::super::orders::{Left, Orders};
#[cfg(feature = "research")]
use super::Record;
use super::enumerations::ENUMERATES_ORDERS;
use super::{MOST_NUMBERS, Strong, Task};

/// All orders are enumerated when the bound is within this share of the known path: with more, too many are left.
const NEAR: f64 = 0.03;
/// After an enumeration that was given up, the next one begins when the gap has shrunk to this share.
const NEARER: f64 = 0.7;
/// Share of the known travel that may be left between it and the bound: the rest of a path that entries anywhere make.
const EXACT: f64 = 1e-7;
/// The same where all entries are given points: rounding.
const EXACT_POINTS: f64 = 1e-10;

impl Strong {
    /// Begins to enumerate all orders, if that is likely to come to an end. Returns whether it does.
    pub(super) fn begin_orders(&mut self, upper: f64, last: bool) -> bool {
        if !ENUMERATES_ORDERS {
            return false;
        }
        let gap = upper - self.best;
        let near = self.enumerations.given_up_at == 0.0 || gap <= NEARER * self.enumerations.given_up_at;
        let wanted = if last { !self.enumerations.is_last } else { near && self.on_orders <= self.work / 2 };
        let rows = self.ground.spaces.last().map_or(0, |s| s.width) * self.ground.count();
        if !wanted || !upper.is_finite() || gap > NEAR * upper || rows > MOST_NUMBERS {
            return false;
        }
        if HAS_CUTS && !self.bundle.best.cuts().is_empty() {
            // With cuts, orders may seem to take less than they do. The walks come near without them, too.
            self.without_cuts = true;
            self.bundle.drop_cuts();
            return false;
        }
        self.enumerations.is_last = last;
        self.enumerations.until = if last { u64::MAX } else { self.on_orders + self.work / 2 };
        self.task = Task::Orders;
        true
    }

    /// The share of the known travel that may be left below it.
    pub(super) fn exact(&self) -> f64 {
        if self.ground.items.iter().any(Item::can_halve) { EXACT } else { EXACT_POINTS }
    }

    /// A piece of the enumeration of all orders. Returns the work done.
    pub(super) fn enumerate_orders(&mut self, upper: f64) -> u64 {
        let goal = upper * (1.0 - self.exact());
        let orders = match self.orders.take() {
            Some(orders) => Some(orders),
            None => Orders::new(&self.ground, &self.bundle.best, goal, MOST_NUMBERS).map(Box::new),
        };
        let Some(mut orders) = orders else {
            self.give_up(upper);
            return 1;
        };
        let (work, left) = orders.once(&self.ground);
        self.on_orders += work;
        let goal = orders.goal();
        match left {
            None if self.on_orders > self.enumerations.until => self.give_up(upper),
            None => self.orders = Some(orders),
            Some(Left::TooMany) => self.give_up(upper),
            Some(Left::Nothing) => {
                self.no_less_than(goal);
                self.task = Task::Nothing;
            }
            Some(Left::Orders(better)) => {
                self.no_less_than(better.seconds);
                #[cfg(feature = "research")]
                let is_new = self.learn_from_orders(&better.walks, upper - self.best);
                #[cfg(not(feature = "research"))]
                let is_new = false;
                self.walks = better.walks.into_iter().map(|walk| (1.0, walk)).collect();
                (self.enumerations.has_begun, self.enumerations.until) = (true, u64::MAX);
                let goal = upper * (1.0 - self.exact());
                if self.best < goal && (self.refine_orders(upper, &better.in_use) || is_new) {
                    if is_new {
                        self.enumerations.begin_again(&mut self.ground.items);
                    }
                    self.prepare(true);
                } else {
                    self.task = Task::Nothing;
                }
            }
        }
        work
    }

    /// No order takes less than this many seconds of travel, but for rounding.
    fn no_less_than(&mut self, seconds: f64) {
        self.enumerations.add_knots(&self.ground.items);
        let value = seconds - self.guard(&self.bundle.best, seconds);
        #[cfg(feature = "research")]
        if value > self.best {
            let record = Record::new(value, &self.ground, &self.bundle.best);
            self.record = Some(Box::new(record.of_all_orders(&self.enumerations.knots, self.record.take())));
        }
        self.best = self.best.max(value);
    }

    /// Goes on without an enumeration.
    fn give_up(&mut self, upper: f64) {
        self.enumerations.given_up_at = upper - self.best;
        #[cfg(feature = "research")]
        if self.enumerations.has_begun && self.drop_mixtures(upper - self.best) {
            return;
        }
        if self.enumerations.is_last || self.enumerations.has_begun {
            self.task = Task::Nothing;
        } else {
            self.sharpen(upper);
        }
    }
}
