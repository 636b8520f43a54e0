//! The cost of travel: the machine's air time between two points, or the entry of a table for two nodes.
//!
//! A [`Place`] carries both its point and the number of its node, and [`Travel::seconds`] uses the one that counts. So one
//! search serves both kinds of problems. The branch always goes the same way, and it costs nothing that could be measured.
//!
//! Small problems of points get a table of their own, in which the costs to all points of an item are next to each other.
//! Beside a table stand the least costs from every node to every item and back: they show at once that an item is too far
//! away, which saves most of the work where sets have many nodes.

use super::config::CONFIG;
use super::index::index;
use crate::geometry::DVec2;
use crate::machine::{AirTime, PLANS_ALL_LEVERS};
use crate::problem::{NodeId, Problem, Table};
use std::borrow::Cow;

/// Where the head is. With a table of costs the node counts, otherwise the point.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) point: DVec2,
    /// Number of the place among all places of a search, which is its node's number where there is a table.
    pub(super) node: NodeId,
}

/// A point by itself, for problems without a table.
impl From<DVec2> for Place {
    fn from(point: DVec2) -> Self {
        Self { point, node: NodeId::MAX }
    }
}

/// The places of an item, whose numbers follow one another.
#[derive(Clone, Copy)]
pub(super) struct Places<'s> {
    pub(super) points: &'s [DVec2],
    /// Number of the first.
    pub(super) first: NodeId,
}

impl<'s> Places<'s> {
    pub(super) fn len(self) -> usize {
        self.points.len()
    }

    pub(super) fn is_empty(self) -> bool {
        self.points.is_empty()
    }

    /// The place with this index on the item.
    #[inline]
    pub(super) fn at(self, at: u32) -> Place {
        Place { point: self.points[at as usize], node: self.first + at }
    }

    pub(super) fn iter(self) -> impl Iterator<Item = Place> + use<'s> {
        self.points.iter().zip(self.first..).map(|(&point, node)| Place { point, node })
    }
}

/// A gap between two stops: where the head comes from and where it goes (`None`: nowhere, at the end of a path without
/// return).
#[derive(Clone, Copy)]
pub(super) struct Gap {
    pub(super) from: Place,
    pub(super) to: Option<Place>,
}

/// Prices of legs.
pub(super) struct Travel<'p> {
    air: AirTime,
    table: Option<Cow<'p, Table>>,
    /// Least cost from a node to an item, by item and node, and from an item to a node (empty where it is the same).
    /// Both are empty without a table, and where items have so few nodes that looking through them is as quick. The rows
    /// belong to items, because the search asks for one item at many nodes.
    least: [Vec<f64>; 2],
    /// By place: the places to which there is a link, in order, with its seconds; empty without links. Set by the space, which
    /// numbers the places.
    pub(super) links: Vec<Vec<(NodeId, f64)>>,
    /// A leg costs the same in both directions.
    pub(super) symmetric: bool,
}

impl<'p> Travel<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let air = AirTime::new(&problem.machine);
        let table = problem.table().map(Cow::Borrowed).or_else(|| of_points(problem, &air).map(Cow::Owned));
        let symmetric = table.as_ref().is_none_or(|t| t.is_symmetric());
        let mut travel = Self { air, table, least: [Vec::new(), Vec::new()], links: Vec::new(), symmetric };
        let Some(table) = &travel.table else { return travel };
        let all = table.nodes();
        if all >= 2 * problem.items.len() {
            let (mut out, mut back) = (Vec::new(), Vec::new());
            // Home counts too where it is no item of the problem.
            let home = index(problem.nodes.len())..index(all);
            for nodes in problem.items.iter().map(|i| i.nodes.clone()).chain([home]) {
                let least =
                    |cost: &dyn Fn(NodeId) -> f64| nodes.clone().map(cost).fold(f64::INFINITY, f64::min);
                for node in 0..index(all) {
                    out.push(least(&|other| table.cost(node, other)));
                    if !travel.symmetric {
                        back.push(least(&|other| table.cost(other, node)));
                    }
                }
            }
            travel.least = [out, back];
        }
        travel
    }

    /// Seconds from one place to another, or the cost by the table.
    pub(super) fn seconds(&self, from: Place, to: Place) -> f64 {
        self.seconds_here(from, to)
    }

    /// The same, inlined for the hottest loops: in wasm the calls took a quarter of all time.
    #[inline(always)]
    pub(super) fn seconds_here(&self, from: Place, to: Place) -> f64 {
        match &self.table {
            Some(table) => table.cost(from.node, to.node),
            None => self.link(from, to).unwrap_or_else(|| self.air.seconds_here(from.point, to.point)),
        }
    }

    /// Seconds of the link from one place to another, if there is one. Not a call, because that would make the loops of all
    /// searches save what they have in registers.
    #[inline(always)]
    fn link(&self, from: Place, to: Place) -> Option<f64> {
        if !PLANS_ALL_LEVERS || self.links.is_empty() {
            return None;
        }
        let links = self.links.get(from.node as usize)?;
        links.iter().find(|link| link.0 == to.node).map(|link| link.1)
    }

    /// Seconds from one point to another, in a problem without a table.
    #[inline(always)]
    pub(super) fn air(&self, from: DVec2, to: DVec2) -> f64 {
        self.air.seconds_here(from, to)
    }

    /// Seconds that a move of at least `d` mm along an axis takes at least.
    pub(super) fn seconds_at_least(&self, d: f64) -> f64 {
        self.air.seconds_at_least(d)
    }

    /// The least costs from every node to any place of an item (`back`: from the item to the node), if they are stored.
    pub(super) fn least_costs(&self, item: u32, back: bool) -> Option<&[f64]> {
        let nodes = self.table.as_ref()?.nodes();
        let first = item as usize * nodes;
        self.least[usize::from(back && !self.symmetric)].get(first..first + nodes)
    }

    /// The least cost from `p` to any place of an item (`back`: from the item to `p`), by the table.
    pub(super) fn least(&self, p: Place, item: u32, places: Places, back: bool) -> f64 {
        if let Some(least) = self.least_costs(item, back) {
            return least[p.node as usize];
        }
        places
            .iter()
            .map(|q| if back { self.seconds(q, p) } else { self.seconds(p, q) })
            .fold(f64::INFINITY, f64::min)
    }

    /// Calls `each` with the index of each place of an item and the seconds to it.
    pub(super) fn to_each(&self, from: Place, places: Places, mut each: impl FnMut(usize, f64)) {
        match &self.table {
            Some(table) => {
                let row = table.row(from.node, places.first, places.len());
                row.iter().enumerate().for_each(|(k, &cost)| each(k, cost));
            }
            None => {
                places.iter().enumerate().for_each(|(k, to)| each(k, self.seconds(from, to)));
            }
        }
    }

    /// The costs from `from` to each place of an item and from each to `to`, where a symmetric table has them: as two
    /// rows, which are contiguous in memory, while a column is not.
    pub(super) fn both_ways(&self, from: Place, to: Place, places: Places) -> Option<[&[f64]; 2]> {
        let table = self.table.as_ref().filter(|_| self.symmetric)?;
        Some([from, to].map(|p| table.row(p.node, places.first, places.len())))
    }

    /// Whether costs come from a table.
    pub(super) fn by_table(&self) -> bool {
        self.table.is_some()
    }
}

/// A table of the seconds between all nodes, with home as the last, for a small problem whose items have several points to
/// enter at and are done in one go. Sheets are not of this kind: closed contours have tracks and open ones two ends.
fn of_points(problem: &Problem, air: &AirTime) -> Option<Table> {
    let points = (problem.items.len() + 1..=CONFIG.table_nodes).contains(&problem.nodes.len())
        && problem.items.iter().all(|item| item.track.is_none() && item.leave.is_none() && !item.is_uneven())
        && problem.links.is_empty()
        && (0..).zip(&problem.nodes).all(|(id, node)| node.twin == id)
        && are_in_order(problem);
    if !points {
        return None;
    }
    let places: Vec<DVec2> = problem.nodes.iter().map(|n| n.entry).chain([problem.home]).collect();
    let seconds = places.iter().flat_map(|&p| places.iter().map(move |&q| air.seconds(p, q)));
    Table::new(places.len(), seconds.collect())
}

/// Whether the nodes are in the order of their items, so that a place has the number of its node.
fn are_in_order(problem: &Problem) -> bool {
    let mut next = 0;
    let mut items = problem.items.iter().filter(|item| !item.nodes.is_empty());
    items.all(|item| item.nodes.start == std::mem::replace(&mut next, item.nodes.end))
}
