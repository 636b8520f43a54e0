//! What a way costs: the machine's air time between two points, or a table's entry for two nodes.
//!
//! The search handles places without looking into them. In a problem with a table a place holds a node's number in
//! the bits of its x: one type, one price function with a branch that always goes the same way, and no second copy
//! of the search (measured on sheets of 100 and 500 contours: as many moves a second as without the branch).
//!
//! A few points to choose from get a table of their own, in which the costs to all points of an item are side by side.
//!
//! Beside the table stand the least costs from every node to every item and back, which tell at once that an item
//! is too far: for sets of many nodes that saves most of the work.

use super::index::index;
use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{NodeId, Problem, Table};
use std::borrow::Cow;

/// Most nodes in the plane for a table of travel of their own: it takes 1.3 MB, which stays near the processor.
const MOST_NODES: usize = 400;

/// Where the head is: a point, or a node of a table.
pub(super) type Place = DVec2;

/// Where a stop lies between its neighbours: where the head comes from, and where it goes (`None`: nowhere, the last
/// stop of a path without return).
#[derive(Clone, Copy)]
pub(super) struct Gap {
    pub(super) from: Place,
    pub(super) to: Option<Place>,
}

/// Prices of ways.
pub(super) struct Travel<'p> {
    air: AirTime,
    table: Option<Cow<'p, Table>>,
    /// Least cost from a node to an item, by item and node, and from an item to a node (empty where it is the same).
    /// Both empty without a table, and where items have so few nodes that looking through them is as quick. Item by
    /// item, as a search asks for one item at many nodes: the row is then at hand.
    least: [Vec<f64>; 2],
    /// A way costs the same in both directions.
    pub(super) symmetric: bool,
}

/// The place of a node of a table.
pub(super) fn node_place(node: NodeId) -> Place {
    DVec2::new(f64::from_bits(node.into()), 0.0)
}

/// The node of such a place.
#[expect(clippy::cast_possible_truncation, reason = "made from a NodeId")]
pub(super) fn node_at(place: Place) -> NodeId {
    place.x.to_bits() as NodeId
}

impl<'p> Travel<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let air = AirTime::new(&problem.machine);
        let table = problem.table().map(Cow::Borrowed).or_else(|| of_points(problem, &air).map(Cow::Owned));
        let symmetric = table.as_ref().is_none_or(|t| t.is_symmetric());
        let mut travel = Self { air, table, least: [Vec::new(), Vec::new()], symmetric };
        let Some(all) = travel.table.as_ref().map(|t| t.nodes()) else { return travel };
        if all >= 2 * problem.items.len() {
            let (mut out, mut back) = (Vec::new(), Vec::new());
            // Home too, where it is no item of the problem.
            let home = index(problem.nodes.len())..index(all);
            for nodes in problem.items.iter().map(|i| i.nodes.clone()).chain([home]) {
                let places: Vec<Place> = nodes.map(node_place).collect();
                for node in 0..index(all) {
                    out.push(travel.least(node_place(node), 0, &places, false));
                    if !travel.symmetric {
                        back.push(travel.least(node_place(node), 0, &places, true));
                    }
                }
            }
            travel.least = [out, back];
        }
        travel
    }

    /// Seconds, or what the table says, from one place to another.
    pub(super) fn seconds(&self, from: Place, to: Place) -> f64 {
        self.seconds_here(from, to)
    }

    /// The same, for where it is asked most: in wasm the calls took a quarter of all time.
    #[inline(always)]
    pub(super) fn seconds_here(&self, from: Place, to: Place) -> f64 {
        match &self.table {
            Some(table) => table.cost(node_at(from), node_at(to)),
            _ => self.air.seconds_here(from, to),
        }
    }

    /// Seconds that a move of at least `d` mm along an axis takes at least.
    pub(super) fn seconds_at_least(&self, d: f64) -> f64 {
        self.air.seconds_at_least(d)
    }

    /// The least costs from every node to (`back`: to every node from) any place of an item, where a table has them at hand.
    pub(super) fn leasts(&self, item: u32, back: bool) -> Option<&[f64]> {
        let nodes = self.table.as_ref()?.nodes();
        let first = item as usize * nodes;
        self.least[usize::from(back && !self.symmetric)].get(first..first + nodes)
    }

    /// The least cost from `p` to (`back`: to `p` from) any of an item's places, by the table.
    pub(super) fn least(&self, p: Place, item: u32, places: &[Place], back: bool) -> f64 {
        if let Some(least) = self.leasts(item, back) {
            return least[node_at(p) as usize];
        }
        places
            .iter()
            .map(|&q| if back { self.seconds(q, p) } else { self.seconds(p, q) })
            .fold(f64::INFINITY, f64::min)
    }

    /// Seconds from a place to each of an item's places.
    pub(super) fn fan(&self, from: Place, places: &[Place], mut each: impl FnMut(usize, f64)) {
        match (&self.table, places) {
            // Nodes of an item follow one another.
            (Some(table), [first, ..]) => {
                let row = table.row(node_at(from), node_at(*first), places.len());
                row.iter().enumerate().for_each(|(k, &cost)| each(k, cost));
            }
            _ => places.iter().enumerate().for_each(|(k, &to)| each(k, self.air.seconds(from, to))),
        }
    }

    /// Costs from `from`, and back to `to`, of each of an item's places, where a table says them and ways back cost the
    /// same: two rows that lie at hand, while a column does not.
    pub(super) fn both_ways(&self, from: Place, to: Place, places: &[Place]) -> Option<[&[f64]; 2]> {
        let (table, first) = (self.table.as_ref().filter(|_| self.symmetric)?, node_at(*places.first()?));
        Some([from, to].map(|p| table.row(node_at(p), first, places.len())))
    }

    /// Whether costs come from a table.
    pub(super) fn by_table(&self) -> bool {
        self.table.is_some()
    }
}

/// The seconds between all nodes, and home after them, of a problem with a choice of points to enter items at, none of
/// which is left unfinished. No sheet is one: closed contours have tracks, open ones two ends, and points no choice.
fn of_points(problem: &Problem, air: &AirTime) -> Option<Table> {
    let points = (problem.items.len() + 1..=MOST_NODES).contains(&problem.nodes.len())
        && problem.items.iter().all(|item| item.track.is_none() && item.leave.is_none() && !item.is_uneven())
        && (0..).zip(&problem.nodes).all(|(id, node)| node.twin == id);
    if !points {
        return None;
    }
    let places: Vec<DVec2> = problem.nodes.iter().map(|n| n.entry).chain([problem.home]).collect();
    let seconds = places.iter().flat_map(|&p| places.iter().map(move |&q| air.seconds(p, q)));
    Table::new(places.len(), seconds.collect())
}
