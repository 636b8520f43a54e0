//! When all orders are looked at, and what follows from those that are left.

use super::super::charges::HAS_CUTS;
use super::super::net::Item;
use super::super::orders::{Left, Orders};
#[cfg(feature = "research")]
use super::Record;
use super::looks::LOOKS_AT_ORDERS;
use super::{MOST_NUMBERS, Strong, Task};

/// All orders are looked at when the bound is within this share of the known path: with more, too many are left.
const NEAR: f64 = 0.03;
/// After a look that was given up, the next one begins when the gap has shrunk to this share.
const NEARER: f64 = 0.7;
/// Share of the known travel that may be left between it and the bound: the rest of a path that entries anywhere make.
const EXACT: f64 = 1e-7;
/// The same where all entries are given points: rounding.
const EXACT_POINTS: f64 = 1e-10;

impl Strong {
    /// Begins to look at all orders, if that is likely to come to an end. Returns whether it does.
    pub(super) fn begin_orders(&mut self, upper: f64, last: bool) -> bool {
        if !LOOKS_AT_ORDERS {
            return false;
        }
        let gap = upper - self.best;
        let near = self.looked.given_up_at == 0.0 || gap <= NEARER * self.looked.given_up_at;
        let wanted = if last { !self.looked.is_last } else { near && self.on_orders <= self.work / 2 };
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
        self.looked.is_last = last;
        self.looked.until = if last { u64::MAX } else { self.on_orders + self.work / 2 };
        self.task = Task::Orders;
        true
    }

    /// The share of the known travel that may be left below it.
    pub(super) fn exact(&self) -> f64 {
        if self.ground.items.iter().any(Item::can_halve) { EXACT } else { EXACT_POINTS }
    }

    /// A piece of the look at all orders. Returns the work done.
    pub(super) fn look_at_orders(&mut self, upper: f64) -> u64 {
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
            None if self.on_orders > self.looked.until => self.give_up(upper),
            None => self.orders = Some(orders),
            Some(Left::TooMany) => self.give_up(upper),
            Some(Left::Nothing) => {
                self.no_less_than(goal);
                self.task = Task::Nothing;
            }
            Some(Left::Orders(better)) => {
                self.no_less_than(better.seconds);
                #[cfg(feature = "research")]
                let is_new = self.learn_in_look(&better.walks, upper - self.best);
                #[cfg(not(feature = "research"))]
                let is_new = false;
                self.walks = better.walks.into_iter().map(|walk| (1.0, walk)).collect();
                (self.looked.has_begun, self.looked.until) = (true, u64::MAX);
                let goal = upper * (1.0 - self.exact());
                if self.best < goal && (self.refine_orders(upper, &better.in_use) || is_new) {
                    if is_new {
                        self.looked.begin_again(&mut self.ground.items);
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
        self.looked.add_knots(&self.ground.items);
        let value = seconds - self.guard(&self.bundle.best, seconds);
        #[cfg(feature = "research")]
        if value > self.best {
            let record = Record::new(value, &self.ground, &self.bundle.best);
            self.record = Some(Box::new(record.of_all_orders(&self.looked.knots, self.record.take())));
        }
        self.best = self.best.max(value);
    }

    /// Goes on without a look at all orders.
    fn give_up(&mut self, upper: f64) {
        self.looked.given_up_at = upper - self.best;
        #[cfg(feature = "research")]
        if self.looked.has_begun && self.drop_mixtures(upper - self.best) {
            return;
        }
        if self.looked.is_last || self.looked.has_begun {
            self.task = Task::Nothing;
        } else {
            self.sharpen(upper);
        }
    }
}
