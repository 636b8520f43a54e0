//! Pairs of items with the seconds between their knots.
//!
//! Small problems have all pairs. In large ones each item is paired with its nearest items and with every item whose box
//! overlaps its own (nested contours); all other pairs are at least as far apart as their boxes. Pairs can be added later.

use super::net::{Item, Piece};
use super::prices::Prices;
use crate::geometry::{BoxIndex, DVec2};
use crate::order::{real, sort_by};

/// Most items for which every pair has a table: half a million numbers. More cost memory.
const COMPLETE: usize = 64;
/// Nearest items that each item is paired with: missing pairs are added later, more cost memory now.
const NEAREST: usize = 10;

/// Two items with the seconds between their knots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) items: [usize; 2],
    /// Where the table starts: a row for each knot of the first item.
    table: usize,
    /// Least seconds of the table.
    pub(super) least: f64,
}

/// Pairs with their tables.
#[derive(Clone, Debug, Default)]
pub(super) struct Pairs {
    pub(super) list: Vec<Pair>,
    tables: Vec<f64>,
    /// For each item its pairs, and which of the two it is.
    pub(super) of: Vec<Vec<(usize, usize)>>,
}

impl Pairs {
    pub(super) fn new(items: usize) -> Self {
        Self { of: vec![Vec::new(); items], ..Self::default() }
    }

    /// The first pairs, with their tables: of near items, and of home with every item.
    #[cfg(feature = "research")]
    pub(super) fn first(items: &[Item], first: usize, prices: &Prices) -> Self {
        let mut scan = Scan::new(items, first);
        while scan.next(items, first, prices).is_some() {}
        let mut pairs = Self::new(items.len());
        for ends in scan.wanted(first, items.len()) {
            pairs.add(items, prices, ends, true);
        }
        pairs
    }

    /// Adds a new pair, with its table (`keep`) or only the minimum of it.
    pub(super) fn add(&mut self, items: &[Item], prices: &Prices, [a, b]: [usize; 2], keep: bool) {
        let table = self.tables.len();
        self.fill(items, prices, [a, b]);
        if !keep && prices.directed() {
            self.fill(items, prices, [b, a]);
        }
        // Coarse pieces of jagged contours may give negative numbers; no leg takes less than 0.
        let least = self.tables[table..].iter().fold(f64::INFINITY, |m, &s| m.min(s));
        let least = if prices.given() { least } else { least.max(0.0) };
        if !keep {
            self.tables.truncate(table);
        }
        self.of[a].push((self.list.len(), 0));
        self.of[b].push((self.list.len(), 1));
        self.list.push(Pair { items: [a, b], table, least });
    }

    /// Appends the table of two items.
    fn fill(&mut self, items: &[Item], prices: &Prices, [a, b]: [usize; 2]) {
        let start = self.tables.len();
        let columns = items[b].knots;
        self.tables.resize(start + items[a].knots * columns, f64::INFINITY);
        let numbers = &mut self.tables[start..];
        for p in &items[a].pieces {
            for q in &items[b].pieces {
                let corners = prices.corners([a, b], p, q);
                for (i, row) in p.knots.iter().zip(corners) {
                    for (j, seconds) in q.knots.iter().zip(row) {
                        let entry = &mut numbers[i * columns + j];
                        *entry = entry.min(seconds);
                    }
                }
            }
        }
    }

    /// The first numbers of a pair's table, row by row.
    pub(super) fn table(&self, pair: &Pair, numbers: usize) -> &[f64] {
        &self.tables[pair.table..pair.table + numbers]
    }
}

/// The search for the first pairs, item by item.
#[derive(Debug)]
pub(super) struct Scan {
    index: BoxIndex,
    spacing: f64,
    next: usize,
    found: Vec<[usize; 2]>,
    /// Least seconds from each item to any other.
    pub(super) nearest: Vec<f64>,
}

impl Scan {
    pub(super) fn new(items: &[Item], first: usize) -> Self {
        let count = items.len() as f64;
        let sheet = items.iter().fold(items[0].around, |b, i| b.union(i.around)).size();
        // Side of the square that each item would have to itself; on a line, its share of the length.
        let spacing = (sheet.x * sheet.y / count).sqrt().max(sheet.max_element() / count);
        Self {
            index: BoxIndex::new(items.iter().map(|i| i.around)),
            spacing: if spacing > 0.0 { spacing } else { 1.0 },
            next: first,
            found: Vec::new(),
            nearest: vec![0.0; items.len()],
        }
    }

    /// Looks around the next item and returns the work done; `None` when all are done.
    pub(super) fn next(&mut self, items: &[Item], first: usize, prices: &Prices) -> Option<u64> {
        let a = self.next;
        let item = items.get(a)?;
        self.next += 1;
        if items.len() <= COMPLETE || prices.given() {
            self.found.extend((a + 1..items.len()).map(|b| [a, b]));
            let near =
                items[first..].iter().zip(first..).filter(|n| n.1 != a).map(|n| apart(prices, item, n.0));
            self.nearest[a] = if prices.given() { 0.0 } else { near.fold(f64::INFINITY, f64::min) };
            return Some(items.len() as u64);
        }
        let mut reach = self.spacing;
        let near = loop {
            let near = self.index.query(item.around.grown(reach));
            if near.len() > NEAREST + 2 {
                break near;
            }
            reach *= 2.0;
        };
        let beyond = prices.minorant.air().seconds_at_least(reach);
        let mut near: Vec<(usize, f64)> = near
            .into_iter()
            .filter(|&b| b != a && b >= first)
            .map(|b| (b, apart(prices, item, &items[b])))
            .collect();
        let work = 1 + near.iter().map(|n| item.pieces.len() * items[n.0].pieces.len()).sum::<usize>();
        sort_by(&mut near, |n| [real(n.1), n.0 as u64, 0]);
        self.nearest[a] = near.first().map_or(beyond, |n| n.1.min(beyond));
        let wanted = |k: usize, b: usize| k < NEAREST || items[b].around.overlaps(&item.around);
        let chosen = near.iter().enumerate().filter(|&(k, n)| wanted(k, n.0)).map(|(_, n)| n.0);
        self.found.extend(chosen.map(|b| [a.min(b), a.max(b)]));
        Some(work as u64)
    }

    /// All pairs found, and home's with every item.
    pub(super) fn wanted(&mut self, first: usize, count: usize) -> Vec<[usize; 2]> {
        let mut wanted: Vec<[usize; 2]> =
            (0..first).flat_map(|home| (first..count).map(move |b| [home, b])).collect();
        sort_by(&mut self.found, |p| [p[0] as u64, p[1] as u64, 0]);
        self.found.dedup();
        wanted.append(&mut self.found);
        wanted
    }
}

/// A lower bound of the seconds between two items, by the boxes of their pieces.
fn apart(prices: &Prices, a: &Item, b: &Item) -> f64 {
    let seconds =
        |p: &Piece, q: &Piece| box_seconds(prices, p.around.min, p.around.max, q.around.min, q.around.max);
    a.pieces.iter().flat_map(|p| b.pieces.iter().map(move |q| seconds(p, q))).fold(f64::INFINITY, f64::min)
}

/// A lower bound of the seconds between two boxes.
pub(super) fn box_seconds(prices: &Prices, amin: DVec2, amax: DVec2, bmin: DVec2, bmax: DVec2) -> f64 {
    let gap = (bmin - amax).max(amin - bmax).max(DVec2::ZERO);
    prices.minorant.air().seconds(DVec2::ZERO, gap)
}
