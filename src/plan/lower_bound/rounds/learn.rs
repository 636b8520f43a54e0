//! How the bound learns of paths, and prices legs by the mixtures of the best one.

use super::super::known_path::{Entry, KnownPath};
use super::super::level::level;
use super::super::mixtures::Mixtures;
use super::super::net::Item;
use super::super::walks::Visit;
use super::Strong;
use super::known::Known;

/// Paths whose seconds differ by a smaller share are the same.
const SAME_PATH: f64 = 1e-9;
/// After an enumeration that mixtures made too large, they are taken again when the gap has fallen to this share: after one or two enumerations
/// without them.
const AGAIN: f64 = 0.25;

impl Strong {
    /// Whether mixtures of a known path price legs.
    pub(in super::super) fn learns_of_paths(&self) -> bool {
        self.ground.prices.minorant.limits.is_some()
    }

    /// Learns of a path. Once all orders are enumerated, these show better ones themselves. Returns whether it is the first one and walks have not begun.
    pub(in super::super) fn knows(&mut self, path: &[Entry]) -> bool {
        if self.enumerations.has_begun || self.ground.prices.given() {
            return false;
        }
        let items = &self.ground.items;
        let visit = |entry: &Entry| {
            let item = self.ground.first + entry.contour;
            items.get(item).map(|of| Visit { item, knot: nearest(of, entry) })
        };
        let walk = path.iter().map(visit).collect::<Option<Vec<_>>>();
        let is_new = walk.is_some_and(|walk| self.learn(&[walk]));
        let is_first = is_new && self.work == 0 && !self.known.from_start;
        self.known.from_start |= is_first;
        is_first
    }

    /// The best path that is known.
    pub(in super::super) fn known(&self) -> &KnownPath {
        &self.known.path
    }

    /// Finds the best entries of these orders. Returns whether one of the paths is the best so far.
    fn learn(&mut self, orders: &[Vec<Visit>]) -> bool {
        let levels = orders.iter().filter_map(|walk| level(&self.ground, walk));
        let best = levels.min_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let Some(best) = best.filter(|b| b.seconds < self.known.path.seconds * (1.0 - SAME_PATH)) else {
            return false;
        };
        let path = KnownPath { seconds: best.seconds, entries: best.entries };
        self.known = Known { path, mixtures: Some(best.mixtures), ..self.known };
        true
    }

    /// The same for the orders that an enumeration leaves. Legs are priced by the mixtures of the best path from now on; returns whether they are new. `gap`: between
    /// the known path and the bound, s.
    pub(super) fn learn_from_orders(&mut self, orders: &[Vec<Visit>], gap: f64) -> bool {
        self.learn(orders);
        gap <= self.known.wait_for && self.take_mixtures()
    }

    /// Prices legs by the mixtures of the best path, if they are new. Returns whether they are: tables must be made again.
    fn take_mixtures(&mut self) -> bool {
        let Some(mixtures) = self.known.mixtures.take() else { return false };
        self.ground.prices.mixtures = mixtures;
        true
    }

    /// The same between rounds, if walks use mixtures.
    pub(super) fn take_in_round(&mut self) -> bool {
        self.known.from_start && self.take_mixtures()
    }

    /// Whether the known path is proven optimal, as far as orders are enumerated, and rounding.
    pub(in super::super) fn has_proven(&self, upper: f64) -> bool {
        self.best >= upper.min(self.known.path.seconds) * (1.0 - 2.0 * self.exact())
    }

    /// Goes on in place of a bound whose walks used mixtures from the start and came to no end. Nothing has been done yet.
    pub(in super::super) fn take_over(&mut self, first: &mut Self) {
        (self.best, self.record) = (first.best, first.record.take());
        let mixtures =
            first.known.mixtures.take().or_else(|| Some(std::mem::take(&mut first.ground.prices.mixtures)));
        let path = std::mem::take(&mut first.known.path);
        self.known = Known { path, mixtures, ..Known::default() };
    }

    /// After an enumeration that was given up: goes on without mixtures, if there are any, and takes them again when the gap is smaller. On large pieces they lie lower
    /// than the closest functions, so that more orders may be left than there is room for.
    pub(super) fn drop_mixtures(&mut self, gap: f64) -> bool {
        if self.known.from_start {
            return false;
        }
        let dropped = std::mem::take(&mut self.ground.prices.mixtures);
        let had_any = dropped != Mixtures::default();
        if had_any {
            self.known.wait_for = AGAIN * gap;
            self.known.mixtures.get_or_insert(dropped);
            self.enumerations.begin_again(&mut self.ground.items);
            self.prepare(true);
        }
        had_any
    }
}

/// The knot of an item that is nearest to where the head arrives at a stop.
fn nearest(item: &Item, entry: &Entry) -> usize {
    let far = |knot: usize| {
        let at = item.along.get(knot);
        at.map_or(item.place(knot).distance(entry.places[0]), |at| (at - entry.along).abs())
    };
    (0..item.knots).min_by(|&a, &b| far(a).total_cmp(&far(b))).unwrap_or(0)
}
