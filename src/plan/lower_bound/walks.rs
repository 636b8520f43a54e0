//! The cheapest walk that starts at home, makes as many stops as there are items, and ends at home.
//!
//! Dynamic programming: for each number of stops, state and knot, the least cost of a walk up to there, with the charge of
//! each stop. Walks from both ends meet in the middle (`meet.rs`).

use super::charges::Charges;
use super::net::Item;
use super::order::Order;
use super::pairs::{Pairs, box_seconds};
use super::prices::Prices;
use super::space::Space;

/// A stop of a walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visit {
    pub(super) item: usize,
    /// The knot where it arrives.
    pub(super) knot: usize,
}

/// The data of the walks.
#[derive(Clone, Debug)]
pub(super) struct Ground {
    pub(super) items: Vec<Item>,
    /// Index of the first contour; the items before it are home.
    pub(super) first: usize,
    pub(super) prices: Prices,
    pub(super) pairs: Pairs,
    pub(super) order: Order,
    /// Which items each item remembers.
    pub(super) ng_sets: Vec<Vec<usize>>,
    /// States forwards from home, and backwards from the end if they differ.
    pub(super) spaces: Vec<Space>,
}

/// The values of all stops so far, from one end.
#[derive(Clone, Debug, Default)]
pub(super) struct Pass {
    /// A row for each number of stops, from 1.
    pub(super) rows: Vec<Vec<f64>>,
    /// For each of these rows the least value of each item.
    pub(super) least: Vec<Vec<f64>>,
}

impl Pass {
    pub(super) fn rows(&self) -> usize {
        self.rows.len()
    }

    /// The least value of each item after this number of stops.
    pub(super) fn least(&self, stops: usize) -> Option<&[f64]> {
        self.least.get(stops.checked_sub(1)?).map(Vec::as_slice)
    }

    /// The row of values after this number of stops.
    pub(super) fn row(&self, stops: usize) -> Option<&[f64]> {
        self.rows.get(stops.checked_sub(1)?).map(Vec::as_slice)
    }
}

impl Ground {
    /// Number of items to visit.
    pub(super) fn count(&self) -> usize {
        self.items.len() - self.first
    }

    /// The states of walks along the order or against it, as the ng-sets now are; `None` when there are too many.
    pub(super) fn space(&self, backwards: bool) -> Option<Space> {
        let directed = self.prices.directed();
        let gap = |from, to| self.gap(from, to);
        Space::new((&self.ng_sets, self.first), &self.order, &self.pairs, [directed, backwards], gap)
    }

    /// The number of stops that the passes from both ends make.
    pub(super) fn stops(&self) -> [usize; 2] {
        let forth = self.count().div_ceil(2);
        let back = self.count() + 1 - forth;
        if self.spaces.len() == 1 { [forth.max(back), 0] } else { [forth, back] }
    }

    /// Work of one more stop.
    pub(super) fn work(&self, side: usize) -> u64 {
        let entries = |s: &super::space::Step| {
            self.items[s.from].knots
                * (s.sources.len() + self.items[self.spaces[side].states[s.to].item].knots)
        };
        let far: usize = self.spaces[side].far.iter().map(Vec::len).sum();
        (1 + far + self.spaces[side].width) as u64
            + self.spaces[side].steps.iter().map(|s| entries(s) as u64).sum::<u64>()
    }

    /// Adds a row to a pass.
    pub(super) fn advance(&self, side: usize, pass: &mut Pass, charges: &Charges) {
        let space = &self.spaces[side];
        let mut row = vec![f64::INFINITY; space.width];
        let stop = pass.rows.len() + 1;
        let open = |item: usize| {
            let [low, high] = self.order.places[item];
            let place = if side == 0 { stop } else { self.count() + 1 - stop };
            (low..=high).contains(&place)
        };
        let Some(last) = pass.rows.last() else {
            let home = if side == 0 { 0 } else { self.first - 1 };
            let homes = self.items[home].knots;
            for &(e, end) in &self.pairs.of[home] {
                let pair = &self.pairs.list[e];
                let item = pair.items[1 - end];
                if item < self.first || !open(item) || (self.prices.directed() && end != side) {
                    continue;
                }
                let at = space.at[space.of[item][0]];
                let knots = self.items[item].knots;
                for (i, seconds) in self.pairs.table(pair, homes * knots).iter().enumerate() {
                    let value = &mut row[at + if end == 0 { i % knots } else { i / homes }];
                    *value = value.min(seconds + charges.of_leg(home, item));
                }
            }
            self.end_row(space, pass, row);
            return;
        };
        let mut least: Vec<f64> = Vec::new();
        for step in &space.steps {
            let item = space.states[step.to].item;
            if !open(item) {
                continue;
            }
            let (from, to) = (&self.items[step.from], &self.items[item]);
            least.clear();
            least.resize(from.knots, f64::INFINITY);
            for &s in &space.sources[step.sources.clone()] {
                for (l, &v) in least.iter_mut().zip(&last[space.at[s]..]) {
                    *l = if v < *l { v } else { *l };
                }
            }
            if from.paired {
                for ends in least.chunks_exact_mut(2) {
                    ends.swap(0, 1);
                }
            }
            let at = space.at[step.to];
            relax(&mut row[at..at + to.knots], &least, charges.of_leg(step.from, item), self.legs(step.pair));
        }
        let least = &pass.least[pass.least.len() - 1];
        for (item, far) in space.far.iter().enumerate().filter(|f| open(f.0) && !f.1.is_empty()) {
            let value = far.iter().map(|&(from, gap)| least[from] + gap + charges.of_leg(from, item));
            let value = value.fold(f64::INFINITY, |m, v| if v < m { v } else { m });
            let at = space.at[space.of[item][0]];
            relax_all(&mut row[at..at + self.items[item].knots], value);
        }
        self.end_row(space, pass, row);
    }

    /// Adds a row with its least values.
    fn end_row(&self, space: &Space, pass: &mut Pass, row: Vec<f64>) {
        let of_item = |(states, item): (&Vec<usize>, &Item)| {
            let values = states.iter().flat_map(|&s| &row[space.at[s]..space.at[s] + item.knots]);
            values.fold(f64::INFINITY, |m, &v| if v < m { v } else { m })
        };
        pass.least.push(space.of.iter().zip(&self.items).map(of_item).collect());
        pass.rows.push(row);
    }

    /// The least seconds between the boxes of two items.
    pub(super) fn gap(&self, from: usize, to: usize) -> f64 {
        let (a, b) = (self.items[from].around, self.items[to].around);
        box_seconds(&self.prices, a.min, a.max, b.min, b.max)
    }

    /// The pair of two items that has a table, and which of them the first is.
    pub(super) fn pair(&self, from: usize, to: usize) -> Option<(usize, usize)> {
        let leads = |&&(e, side): &&(usize, usize)| self.pairs.list[e].items[1 - side] == to;
        let one_way = |&&(_, side): &&(usize, usize)| side == 0 || !self.prices.directed();
        self.pairs.of[from].iter().filter(one_way).find(leads).copied()
    }

    /// What the table of a pair says of a leg between two knots, s; `None` if the items have no table.
    pub(super) fn leg(&self, from: Visit, to: Visit) -> Option<f64> {
        let (table, rows_left) = self.legs(self.pair(from.item, to.item)?);
        let (row, column) = if rows_left { (from, to) } else { (to, from) };
        Some(table[row.knot * self.items[column.item].knots + column.knot])
    }

    /// The table of a leg, and whether its rows are those of the item left.
    pub(super) fn legs(&self, (e, side): (usize, usize)) -> (&[f64], bool) {
        let pair = &self.pairs.list[e];
        let [a, b] = pair.items.map(|k| self.items[k].knots);
        (self.pairs.table(pair, a * b), side == 0)
    }
}

/// Lowers the values of a state by legs from one item: their table, and whether its rows are those of the item left.
pub(super) fn relax(row: &mut [f64], least: &[f64], pay: f64, (table, rows_left): (&[f64], bool)) {
    if rows_left {
        for (&l, seconds) in least.iter().zip(table.chunks_exact(row.len().max(1))) {
            let base = l + pay;
            if base < f64::INFINITY {
                for (value, s) in row.iter_mut().zip(seconds) {
                    let new = base + s;
                    *value = if new < *value { new } else { *value };
                }
            }
        }
        return;
    }
    for (value, seconds) in row.iter_mut().zip(table.chunks_exact(least.len().max(1))) {
        let new =
            least.iter().zip(seconds).fold(f64::INFINITY, |m, (l, s)| if l + s < m { l + s } else { m })
                + pay;
        *value = if new < *value { new } else { *value };
    }
}

/// Lowers the values of a state to a value.
pub(super) fn relax_all(row: &mut [f64], new: f64) {
    for value in row {
        *value = if new < *value { new } else { *value };
    }
}
