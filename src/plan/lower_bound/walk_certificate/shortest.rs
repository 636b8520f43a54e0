//! The shortest walk, in whole numbers: one pass from home, stop by stop, over all states and knots.

use super::super::certificate::units;
use super::super::fault::CertificateFault;
use super::super::net::Item;
use super::super::order::Order;
use super::super::pairs::{Pairs, box_seconds};
use super::super::priced_cuts::Cuts;
use super::super::prices::Prices;
use super::states::{States, Step};
use std::collections::BTreeMap;

/// Most numbers in a row of values: 32 MB.
const MOST_WIDTH: usize = 4_000_000;
/// No walk comes here. Values of walks are less than half of it, because larger charges and prices are refused.
pub(super) const NONE: i64 = 1 << 62;

/// How much a check may take.
pub(super) struct Most {
    /// Numbers in all tables of legs, 8 bytes each.
    legs: u128,
    /// Sums.
    work: u128,
}

impl Most {
    /// 128 MB, and about twenty seconds in wasm.
    pub(super) const OF_WALKS: Self = Self { legs: 16_000_000, work: 20_000_000_000 };
    /// 384 MB, and about a minute: Qu and Du's 43 contours, entered anywhere, have 40 million legs, because the certificate has every knot that the search ever had.
    pub(super) const OF_ORDERS: Self = Self { legs: 48_000_000, work: 100_000_000_000 };
}

/// The walks of a certificate.
pub(super) struct Walks<'c> {
    pub(super) items: &'c [Item],
    /// Index of the first contour; the items before it are home.
    pub(super) first: usize,
    pub(super) prices: &'c Prices,
    pub(super) order: &'c Order,
    /// For each item the later ones that it is near.
    pub(super) near: &'c [Vec<usize>],
    pub(super) states: &'c States,
}

/// What legs cost, in units, less what they are given by cuts.
pub(super) struct Legs {
    /// Tables between items that are near, a row for each knot of the item that is named first.
    tables: BTreeMap<[usize; 2], Vec<i64>>,
    directed: bool,
    /// For each item those that are not near and from where a walk may come, with the units between their boxes.
    pub(super) far: Vec<Vec<(usize, i64)>>,
}

/// What walks pay: their legs, and for each knot of each item a stop there.
pub(super) struct Costs {
    pub(super) legs: Legs,
    pub(super) pays: Vec<Vec<i64>>,
    /// Where the knots of each state begin in a row of values, and its length.
    pub(super) at: Vec<usize>,
    pub(super) width: usize,
}

impl Legs {
    /// The table of legs, and whether its rows are those of the item left.
    pub(super) fn between(&self, from: usize, to: usize) -> (&[i64], bool) {
        let rows_left = self.directed || from < to;
        let table = self.tables.get(&if rows_left { [from, to] } else { [to, from] });
        (table.map_or(&[], Vec::as_slice), rows_left)
    }
}

impl Walks<'_> {
    /// Whether the check ends soon: counts numbers before any of them is made. `cuts`: how many there are; `rows`: how often all legs are looked at.
    pub(super) fn are_few(&self, most: &Most, cuts: usize, rows: usize) -> Result<(), CertificateFault> {
        let knots = |item: usize| self.items[item].knots;
        let width: usize = self.states.item.iter().map(|&item| knots(item)).sum();
        if width > MOST_WIDTH {
            return Err(CertificateFault::TooMuch("knots in states of walks"));
        }
        let numbers: u128 = self.pairs().map(|[a, b]| knots(a) as u128 * knots(b) as u128).sum();
        if numbers > most.legs {
            return Err(CertificateFault::TooMuch("legs between knots"));
        }
        let step = |s: &Step| {
            knots(s.from) as u128 * (s.sources.len() as u128 + knots(self.states.item[s.to]) as u128)
        };
        let row = self.states.steps.iter().map(step).sum::<u128>() + width as u128;
        let work = row * (rows as u128) + (numbers + 1) * (cuts as u128);
        if work > most.work { Err(CertificateFault::TooMuch("sums of legs")) } else { Ok(()) }
    }

    /// The pairs of items with tables.
    fn pairs(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let (contours, both) = (self.first..self.items.len(), self.prices.directed());
        let of_home = (0..self.first).flat_map(move |home| contours.clone().map(move |b| [home, b]));
        let near = self.near.iter().enumerate().flat_map(|(a, list)| list.iter().map(move |&b| [a, b]));
        of_home.chain(near).flat_map(move |[a, b]| [Some([a, b]), both.then_some([b, a])]).flatten()
    }

    /// The cost of all legs; `None` if it does not fit into 64 bits.
    pub(super) fn legs(&self, (power, guard): (i32, f64), cuts: &Cuts) -> Option<Legs> {
        let mut tables = BTreeMap::new();
        for ends in self.pairs() {
            let [n, m] = ends.map(|k| self.items[k].knots);
            let mut pairs = Pairs::new(self.items.len());
            pairs.add(self.items, self.prices, ends, true);
            let given = cuts.between(ends, [n, m]);
            let seconds = pairs.table(pairs.list.first()?, n * m).iter();
            let less = |(&s, given): (&f64, i128)| i64::try_from(i128::from(units(s - guard, power)) - given);
            tables.insert(ends, seconds.zip(given).map(less).collect::<Result<_, _>>().ok()?);
        }
        let gap = |from: usize, to: usize| {
            let (p, q) = (self.items[from].around, self.items[to].around);
            let seconds = units(box_seconds(self.prices, p.min, p.max, q.min, q.max) - guard, power);
            Some((from, i64::try_from(i128::from(seconds) - cuts.most_between([from, to])).ok()?))
        };
        let of_item = |(to, list): (usize, &Vec<usize>)| list.iter().map(|&from| gap(from, to)).collect();
        let far = self.states.far.iter().enumerate().map(of_item).collect::<Option<_>>()?;
        Some(Legs { tables, directed: self.prices.directed(), far })
    }

    /// What walks pay with charges and prices.
    pub(super) fn costs(
        &self,
        unit: (i32, f64),
        charges: &[i64],
        cuts: &Cuts,
    ) -> Result<Costs, CertificateFault> {
        let (legs, pays) =
            self.legs(unit, cuts).zip(of_stops(charges, cuts)).ok_or(CertificateFault::Shape("cuts"))?;
        let mut at = Vec::with_capacity(self.states.item.len());
        let mut width = 0;
        for &item in &self.states.item {
            at.push(width);
            width += self.items[item].knots;
        }
        Ok(Costs { legs, pays, at, width })
    }

    /// What the shortest walk costs, in units.
    pub(super) fn shortest(&self, costs: &Costs) -> Result<i64, CertificateFault> {
        let mut row = Vec::new();
        for stop in 1..=self.items.len() - self.first {
            row = self.row(&row, stop, costs);
        }
        let end = self.first - 1;
        let mut ends = vec![NONE; self.items[end].knots];
        for (&item, &at) in self.states.item.iter().zip(&costs.at) {
            let left = self.left(item, &row[at..at + self.items[item].knots]);
            lower(&mut ends, &left, costs.legs.between(item, end));
        }
        let least = ends.into_iter().min().filter(|&least| least < NONE / 2);
        least.ok_or(CertificateFault::Problem)
    }

    /// For each knot of each state, the least cost of a walk that ends there with its stop number `stop`, including that stop. `before`: the row of the stop
    /// before, which the first stop does not need.
    pub(super) fn row(&self, before: &[i64], stop: usize, costs: &Costs) -> Vec<i64> {
        let Costs { legs, pays, at, width } = costs;
        let mut row = vec![NONE; *width];
        if stop == 1 {
            for item in self.first..self.items.len() {
                let start = at[self.states.fresh[item]];
                let homes = vec![0; self.items[0].knots];
                lower(&mut row[start..start + self.items[item].knots], &homes, legs.between(0, item));
            }
        } else {
            self.advance(before, &mut row, at, legs);
        }
        self.end_row(&mut row, at, pays, stop);
        row
    }

    /// Adds a stop to all walks.
    fn advance(&self, row: &[i64], next: &mut [i64], at: &[usize], legs: &Legs) {
        let mut of_items = vec![NONE; self.items.len()];
        for (&item, &at) in self.states.item.iter().zip(at) {
            let least = row[at..at + self.items[item].knots].iter().copied().min().unwrap_or(NONE);
            of_items[item] = of_items[item].min(least);
        }
        let mut least: Vec<i64> = Vec::new();
        for step in &self.states.steps {
            let (from, to) = (step.from, self.states.item[step.to]);
            least.clear();
            least.resize(self.items[from].knots, NONE);
            for &source in &self.states.sources[step.sources.clone()] {
                least.iter_mut().zip(&row[at[source]..]).for_each(|(l, &v)| *l = v.min(*l));
            }
            let start = at[step.to];
            let left = self.left(from, &least);
            lower(&mut next[start..start + self.items[to].knots], &left, legs.between(from, to));
        }
        for (to, far) in legs.far.iter().enumerate().filter(|f| !f.1.is_empty()) {
            let start = at[self.states.fresh[to]];
            let values = far.iter().map(|&(from, gap)| of_items[from] + gap);
            let least = values.min().unwrap_or(NONE);
            next[start..start + self.items[to].knots].iter_mut().for_each(|v| *v = least.min(*v));
        }
    }

    /// The values of the knots where an item is left, from those where it is arrived at.
    pub(super) fn left(&self, item: usize, values: &[i64]) -> Vec<i64> {
        let mut left = values.to_vec();
        if self.items[item].paired {
            left.chunks_exact_mut(2).for_each(|ends| ends.swap(0, 1));
        }
        left
    }

    /// Adds what stops pay, and removes walks that stop too early or too late for a tour.
    fn end_row(&self, row: &mut [i64], at: &[usize], pays: &[Vec<i64>], stop: usize) {
        for (&item, &at) in self.states.item.iter().zip(at) {
            let [low, high] = self.order.places[item];
            let is_open = (low..=high).contains(&stop);
            for (value, pay) in row[at..].iter_mut().zip(&pays[item]) {
                *value = if is_open && *value < NONE / 2 { *value + pay } else { NONE };
            }
        }
    }
}

/// For each knot of each item what a stop there pays; `None` if it does not fit into 64 bits.
fn of_stops(charges: &[i64], cuts: &Cuts) -> Option<Vec<Vec<i64>>> {
    let of_item = |(&charge, pay): (&i64, &Vec<i128>)| {
        pay.iter().map(|pay| i64::try_from(i128::from(charge) + pay).ok()).collect()
    };
    charges.iter().zip(&cuts.pay).map(of_item).collect()
}

/// Lowers values by legs from other values: their table, and whether its rows are those of the values left.
pub(super) fn lower(values: &mut [i64], left: &[i64], (table, rows_left): (&[i64], bool)) {
    if rows_left {
        for (&base, row) in left.iter().zip(table.chunks_exact(values.len().max(1))) {
            if base < NONE / 2 {
                values.iter_mut().zip(row).for_each(|(v, leg)| *v = (base + leg).min(*v));
            }
        }
    } else {
        for (value, row) in values.iter_mut().zip(table.chunks_exact(left.len().max(1))) {
            let sums = left.iter().zip(row).map(|(base, leg)| base + leg);
            *value = sums.fold(*value, i64::min);
        }
    }
}
