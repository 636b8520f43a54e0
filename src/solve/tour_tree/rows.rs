//! Tours row by row for regular patterns: perforated sheets, nests of one part.
//!
//! There all ways to neighbours cost the same. Nearest next then wanders, and local search, which needs a gain at every
//! step, keeps its detours: 10,000 slots in a grid ended after 10 s 7 % longer than from a plain way up and down. So plain ways are
//! tried as well, once, after the first local search. The search goes on from the best of them if it costs less than what
//! the local search came to. On sheets without a pattern nothing is tried and nothing changes.
//!
//! A way runs along bands of one or two rows, forwards and backwards in turn. In a band of two rows it crosses from one
//! row to the other at every column, so that it uses the short ways between them. It comes home along a lane of columns
//! that the bands leave out, or in one straight move.

use super::improve_entry::improve_entry;
use super::queue::Queue;
use super::repair::delayed;
use super::snapshot::TourSnapshot;
use super::space::Space;
use super::tour::Tour;
use super::travel::{Gap, Place};
use crate::geometry::{Aabb, DVec2};
use crate::order::{real, sort_by};

/// Smaller sheets are left to the cycles, which reach the same end within a second.
const FEWEST: usize = 400;
/// Centres no farther apart than this across a row belong to the row, mm: more than drawings are rounded by, less than a
/// machine can resolve.
const SAME: f64 = 0.01;
/// Least mean number of items in a row: scattered items come to one or two by chance.
const PER_ROW: u64 = 8;
/// An item around more than this many others is the sheet or a large part: it is cut after the rows, not in one.
const HOLES: usize = 8;
/// Passes over all entries: the local search goes on from the way that is kept, so the ways need only be compared.
const ROUNDS: usize = 3;

/// Where items stand in rows, and what ways there are along them.
pub(super) struct Rows {
    /// By item: its number along x and along y.
    number: [Vec<u64>; 2],
    /// How many numbers there are along x and along y.
    count: [u64; 2],
    /// The ways still to be laid.
    ways: Vec<Way>,
}

/// One way through all rows.
struct Way {
    /// The axis it runs along: 0 for x.
    along: usize,
    /// Rows side by side in a band.
    rows: u64,
    /// Columns left out for the way home.
    lane: u64,
}

impl Rows {
    /// The rows of a problem; `None` where its items form no regular pattern. `tour` names the items.
    pub(super) fn new(space: &Space, tour: &TourSnapshot) -> Option<Self> {
        let problem = space.problem;
        if tour.order.len() <= FEWEST || space.travel.by_table() || !problem.groups.is_empty() {
            return None;
        }
        let mut rows = Self { number: [Vec::new(), Vec::new()], count: [0; 2], ways: Vec::new() };
        let items: Vec<(u32, DVec2)> = tour.order[1..]
            .iter()
            .filter(|&&item| !is_around(space, item))
            .map(|&item| (item, center(space, item)))
            .collect();
        for axis in 0..2 {
            let on = |p: DVec2| p.to_array()[axis];
            let (number, count) = numbered(tour.at.len(), items.iter().map(|&(i, c)| (on(c), i)).collect());
            if count * PER_ROW > items.len() as u64 {
                return None;
            }
            // The side near home comes first.
            let ends = items.iter().fold(Aabb::EMPTY, |b, i| b.with(i.1));
            let turned = on(problem.home) > on(ends.center());
            rows.number[axis] =
                number.into_iter().map(|n| if turned { (count - 1).saturating_sub(n) } else { n }).collect();
            rows.count[axis] = count;
        }
        for along in [0, 1] {
            for width in [1, 2] {
                rows.ways.extend([0, width, 2 * width].map(|lane| Way { along, rows: width, lane }));
            }
        }
        Some(rows)
    }

    /// Replaces the tour by the next way, with entries chosen for it; false when no way is left.
    pub(super) fn try_next(&mut self, tour: &mut Tour, queue: &mut Queue) -> bool {
        let Some(way) = self.ways.pop() else { return false };
        let order = self.order(&tour.space, tour.current(), &way);
        let at = entered_on_the_way(&tour.space, &order, tour.current().at.clone());
        let kept = delayed(&tour.space, &TourSnapshot { order, at });
        tour.restore(kept);
        let last = tour.last();
        // An entry that is looked at counts as a move; those for the first pass are looked at once more.
        tour.priced += last as u64;
        for position in (0..ROUNDS).flat_map(|_| 1..=last) {
            let item = tour.item(position);
            improve_entry(tour, queue, item);
        }
        while queue.pop().is_some() {}
        tour.commit();
        true
    }

    /// All items along a way.
    fn order(&self, space: &Space, tour: &TourSnapshot, way: &Way) -> Vec<u32> {
        let across = 1 - way.along;
        let mut order = tour.order.clone();
        sort_by(&mut order, |&item| {
            if item == space.home {
                return [0; 3];
            }
            let rank = 1 + u64::from(space.rank[item as usize]);
            // What lies around many others comes after all of them.
            if is_around(space, item) {
                return [rank << 32 | 3 << 30, 0, 0];
            }
            let (column, row) = (self.number[way.along][item as usize], self.number[across][item as usize]);
            let turned = |number: u64, turned: bool, axis: usize| {
                if turned { self.count[axis] - 1 - number } else { number }
            };
            if column < way.lane {
                return [
                    rank << 32 | 1 << 30,
                    turned(row, true, across),
                    turned(column, row % 2 == 1, way.along),
                ];
            }
            let band = row / way.rows;
            [
                rank << 32 | band,
                turned(column, band % 2 == 1, way.along),
                turned(row, column % 2 == 1, across),
            ]
        });
        order
    }
}

/// Whether an item lies around many others.
fn is_around(space: &Space, item: u32) -> bool {
    space.precedence.before(item).len() > HOLES
}

fn center(space: &Space, item: u32) -> DVec2 {
    space.gates(item).fold(Aabb::EMPTY, |b, place| b.with(place.point)).center()
}

/// Numbers items by their place along an axis; items at the same place get the same number. Gives the numbers by item and
/// how many different ones there are.
fn numbered(items: usize, mut places: Vec<(f64, u32)>) -> (Vec<u64>, u64) {
    sort_by(&mut places, |p| [real(p.0), p.1.into(), 0]);
    let mut number = vec![0; items];
    let mut count = 0;
    for same in places.chunk_by(|a, b| b.0 - a.0 <= SAME) {
        for &(_, item) in same {
            number[item as usize] = count;
        }
        count += 1;
    }
    (number, count)
}

/// Entries along an order: each where the way from the last entry towards the next item's centre costs least.
fn entered_on_the_way(space: &Space, order: &[u32], mut at: Vec<u32>) -> Vec<u32> {
    let mut from = Place::from(space.problem.home);
    for pair in order[1..].windows(2) {
        let gap = Gap { from, to: Some(center(space, pair[1]).into()) };
        let (entry, _) = space.best_entry(pair[0], gap, f64::INFINITY);
        at[pair[0] as usize] = entry;
        from = space.exit(pair[0], entry);
    }
    at
}

#[cfg(test)]
mod tests;
