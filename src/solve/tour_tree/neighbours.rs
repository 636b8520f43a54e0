//! Neighbour lists: for every gate the items nearest to it, and for every item the items nearest to any of its gates.
//!
//! A gate is a coarse place of an item (see `space`). Lists belong to gates and not to items, because what is near the
//! left edge of a frame is of no use when the frame is entered on the right. Nearness is the cost of travel out of a
//! place and, where a leg costs more than the leg back, into it as well. The lists are built item by item, so that a
//! worker can stop in between. Source: Bentley, ORSA Journal on Computing 4 (1992); quadrants: Johnson & McGeoch, Experimental analysis
//! of heuristics for the STSP (2002); in tables, which have no quadrants: the relative neighbourhood of Toussaint, Pattern Recognition 12 (1980).
//!
//! On very large sheets a small item, such as a hole of a perforated plate, has one list for all of its gates, seen from its
//! middle: 16 lists for each hole would take longer than the local search that uses them.

use super::config::CONFIG;
use super::gates::{Gate, Gates};
use super::index::index;
use super::space::Space;
use super::tour::Tour;
use super::travel::Place;
use crate::geometry::{Aabb, DVec2};
use crate::order::{real, sort_by};

/// Items in the list of a gate.
const PER_GATE: usize = CONFIG.neighbours.per_gate;

/// In how many times as many rings of cells as hold the nearest items each quadrant is searched for one: at the border of a sheet some
/// have none.
const QUADRANT_RINGS: usize = 3;

/// Items in a list by the table that need not be the nearest; the value is measured in docs/internals/tuning.md.
const APART: usize = 2;

/// Moves that take as long as the lists of an item with [`super::ring::GATES`] gates, about.
pub(super) const MOVES_PER_ITEM: u64 = 100;
/// The same for an item with one list.
const MOVES_PER_LIST: u64 = 8;

/// Neighbour lists, as far as they are built. All lists are in one array: separate lists were farther apart in memory, and
/// each look waited for it twice.
pub(super) struct Neighbours {
    gates: Gates,
    /// Items to go to and items to come from, gate by gate; the second is empty where it would be the same.
    by_gate: [Vec<u32>; 2],
    /// The list of each gate, where small items have one for all of their gates; empty where every gate has its own.
    list_of: Vec<u32>,
    /// Largest side of the box of a small item, mm; negative where no item counts as small.
    small: f64,
    /// Items in the list of a gate: [`PER_GATE`], or all others where there are fewer.
    stride: usize,
    /// The list of item i: `first[i]..first[i + 1]`.
    by_item: Vec<u32>,
    first: Vec<u32>,
}

impl Neighbours {
    /// Empty lists; [`Neighbours::extend`] fills them.
    pub(super) fn new(space: &Space) -> Self {
        let listed = if space.travel.by_table() { 0 } else { space.home + 1 };
        // A pierce group is near everything for which it may be left.
        let points = |item: u32| {
            let leave = space.leave_places.points(item).iter().copied();
            space.gates(item).map(|place| place.point).chain(leave)
        };
        let gates: Vec<Gate> =
            (0..listed).flat_map(|item| points(item).map(move |point| (item, point))).collect();
        let small = if listed > CONFIG.neighbours.shared_from { gap_on(space) } else { -1.0 };
        let room = space.gate_first.last().map_or(0, |&all| all as usize * PER_GATE);
        Self {
            gates: Gates::new(&gates),
            by_gate: [
                if listed > 0 && small < 0.0 { Vec::with_capacity(room) } else { Vec::new() },
                Vec::new(),
            ],
            list_of: Vec::new(),
            small,
            stride: 0,
            by_item: Vec::new(),
            first: vec![0],
        }
    }

    /// Lists the neighbours of the next item, and returns how many moves take as long; `None` when all are listed.
    pub(super) fn extend(&mut self, space: &Space) -> Option<u64> {
        let item = index(self.first.len() - 1);
        if item > space.home {
            return None;
        }
        let mut all: Vec<(f64, u32)> = Vec::new();
        let whole = &space.whole[item as usize];
        let shared = whole.largest_side() <= self.small;
        let places = space.gates(item).take(if shared { 1 } else { usize::MAX });
        for place in places {
            let place = if shared { Place::from(whole.center()) } else { place };
            for back in [false, true].into_iter().take(1 + usize::from(!space.travel.symmetric)) {
                let nearest = if space.travel.by_table() {
                    nearest_by_table(space, item, place, back)
                } else {
                    self.nearest(space, item, place.point)
                };
                self.stride = nearest.len();
                self.by_gate[usize::from(back)].extend(nearest.iter().map(|n| n.1));
                for n in nearest {
                    merge(&mut all, n);
                }
            }
        }
        self.number_lists(space, item, shared);
        for &point in space.leave_places.points(item) {
            self.nearest(space, item, point).into_iter().for_each(|n| merge(&mut all, n));
        }
        sort_by(&mut all, |n| [real(n.0), n.1.into(), 0]);
        all.truncate(CONFIG.neighbours.per_item);
        self.by_item.extend(all.into_iter().map(|n| n.1));
        self.first.push(index(self.by_item.len()));
        Some(if shared { MOVES_PER_LIST } else { MOVES_PER_ITEM })
    }

    /// Notes which lists the gates of an item have, where some items have one for all.
    fn number_lists(&mut self, space: &Space, item: u32, shared: bool) {
        if self.small < 0.0 {
            return;
        }
        let gates = space.gate_first[item as usize + 1] - space.gate_first[item as usize];
        let lists = if shared { 1 } else { gates };
        let first = index(self.by_gate[0].len() / self.stride.max(1)) - lists.min(gates);
        self.list_of.extend((0..gates).map(|gate| first + if shared { 0 } else { gate }));
    }

    /// The nearest other items with the seconds to them, in this order. For an item that is small beside its distance to the last of them,
    /// the farthest give way to the nearest item of each quadrant that has none among them.
    fn nearest(&self, space: &Space, item: u32, place: DVec2) -> Vec<(f64, u32)> {
        let mut found: Vec<(f64, u32)> = Vec::with_capacity(PER_GATE + 1);
        let mut of_quadrant: [Option<(f64, u32)>; 4] = [None; 4];
        let size = space.travel.seconds_at_least(space.whole[item as usize].largest_side());
        let mut last = None;
        for r in 0..self.gates.rings(place) {
            let least = space.travel.seconds_at_least(self.gates.distance_of_ring(r));
            let farthest = found.get(PER_GATE - 1).map(|n| n.0).filter(|&farthest| farthest <= least);
            if let (None, Some(farthest)) = (last, farthest) {
                if farthest < size {
                    return found;
                }
                last = Some(QUADRANT_RINGS * (r + 1));
            }
            let all = || of_quadrant.iter().all(|n| n.is_some_and(|n| n.0 <= least));
            if last.is_some_and(|last| r > last || all()) {
                break;
            }
            self.gates.ring(place, r, |run| {
                for &(other, there) in run.iter().filter(|gate| gate.0 != item) {
                    let new = (space.travel.air(place, there), other);
                    let nearest = &mut of_quadrant[quadrant(there - place)];
                    if nearest.is_none_or(|old| new < old) {
                        *nearest = Some(new);
                    }
                    insert(&mut found, new);
                }
            });
        }
        let mut apart: Vec<(f64, u32)> = Vec::new();
        for n in of_quadrant.into_iter().flatten().filter(|n| found.iter().all(|f| f.1 != n.1)) {
            merge(&mut apart, n);
        }
        found.truncate(PER_GATE - apart.len());
        apart.into_iter().for_each(|n| insert(&mut found, n));
        found
    }

    /// Items near any gate of an item.
    pub(super) fn of_item(&self, item: u32) -> &[u32] {
        &self.by_item[self.first[item as usize] as usize..self.first[item as usize + 1] as usize]
    }

    /// Items to go to from a gate, or (`back`) to come from.
    fn of_gate(&self, back: bool, gate: usize) -> &[u32] {
        let list = self.list_of.get(gate).map_or(gate, |&list| list as usize);
        &self.by_gate[usize::from(back)][list * self.stride..(list + 1) * self.stride]
    }

    /// Items to go to from a place of an item.
    pub(super) fn of_place(&self, space: &Space, item: u32, at: u32) -> &[u32] {
        self.of_gate(false, space.gate(item, at))
    }

    /// Items to come from to the current entry of an item.
    pub(super) fn of_entry(&self, tour: &Tour, item: u32) -> &[u32] {
        self.of_gate(!tour.space.travel.symmetric, tour.space.gate(item, tour.at(item)))
    }

    /// Items to go to from the current exit of an item.
    pub(super) fn of_exit(&self, tour: &Tour, item: u32) -> &[u32] {
        let at = tour.at(item);
        let at = if tour.space.two_ends(item) { at ^ 1 } else { at };
        self.of_gate(false, tour.space.gate(item, at))
    }
}

/// Side of the square that each item would have to itself if all shared the sheet evenly, mm.
fn gap_on(space: &Space) -> f64 {
    let sheet = space.point.iter().fold(Aabb::EMPTY, |sheet, p| sheet.with(*p)).size();
    (sheet.x * sheet.y / space.whole.len() as f64).sqrt()
}

/// The nearest other items by the table, with the cost to them (`back`: from them), in this order. The last [`APART`] of them are the
/// nearest of those that lie nearer to the place than to any item before them in the list, as far as there are such.
fn nearest_by_table(space: &Space, item: u32, place: Place, back: bool) -> Vec<(f64, u32)> {
    let others = (0..=space.home).filter(|&other| other != item);
    let priced = others.map(|other| (space.at_least(place, other, back), other));
    // What is not worked, such as an ignored border, has no place to go to.
    let mut others: Vec<(f64, u32)> = priced.filter(|n| n.0.is_finite()).collect();
    let by_cost = |n: &(f64, u32)| [real(n.0), n.1.into(), 0];
    sort_by(&mut others, by_cost);
    let mut taken = PER_GATE - APART;
    for k in PER_GATE - APART..others.len() {
        let (cost, other) = others[k];
        let is_nearer = |p| space.at_least(p, other, back) < cost;
        if taken < PER_GATE && !others[..taken].iter().any(|n| space.places(n.1).iter().any(is_nearer)) {
            let apart = others.remove(k);
            others.insert(taken, apart);
            taken += 1;
        }
    }
    others.truncate(PER_GATE);
    sort_by(&mut others, by_cost);
    others
}

/// The number of the quadrant in which a direction lies.
fn quadrant(to: DVec2) -> usize {
    usize::from(to.x > 0.0) + 2 * usize::from(to.y > 0.0)
}

/// Inserts into a sorted list of the [`PER_GATE`] nearest items, which holds each item once, with its least seconds.
fn insert(list: &mut Vec<(f64, u32)>, new: (f64, u32)) {
    // Of two items as near, the one with the lower number comes first. Comparing the seconds alone decides in most cases.
    if let Some(&last) = list.get(PER_GATE - 1)
        && (last.0 < new.0 || last <= new)
    {
        return;
    }
    if let Some(old) = list.iter().position(|old| old.1 == new.1) {
        if list[old].0 <= new.0 {
            return;
        }
        list.remove(old);
    }
    let place = list.iter().position(|old| new < *old).unwrap_or(list.len());
    list.insert(place, new);
    list.truncate(PER_GATE);
}

/// Adds to a list that holds each item once, with its least seconds.
fn merge(list: &mut Vec<(f64, u32)>, new: (f64, u32)) {
    match list.iter_mut().find(|old| old.1 == new.1) {
        Some(old) => old.0 = old.0.min(new.0),
        None => list.push(new),
    }
}
