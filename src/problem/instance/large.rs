//! Instances in the plane with more nodes than a table of costs may have.
//!
//! They become problems of points whose cost of travel is the length itself, so that neighbours are found by a grid and no cost
//! is stored. Three things differ from the instance:
//!
//! - TSPLIB rounds every distance to a whole number, the search does not. Lengths of tours are computed with the rounding
//!   ([`super::check`]). Over many legs the rounding cancels out.
//! - Where coordinates are larger than [`WIDE`], the search works on them divided by a power of two, which rounds nothing: its limits,
//!   such as the least gain, are meant for lengths of sheets, and the rounding of longer ones would pass for gains.
//! - A path of points begins at a point. So the first node of the set at which the cycle starts is home. When a tour is asked for,
//!   the best node of that set takes its place ([`super::Instance::tour`]).

use super::costs::{self, Plane};
use super::error::InstanceError;
use super::file::File;
use super::model::Instance;
use super::sets::Sets;
use crate::machine;
use crate::problem::{Item, Node, NodeId, Problem};
use glam::DVec2;

/// Largest coordinate that the search is given: above those of TSPLIB, so that its instances are searched as they are.
const WIDE: f64 = 4_194_304.0;

/// A large instance. The nodes of the start are the last of its numbers and no nodes of the problem.
pub(super) fn instance(file: &File, nodes: usize, mut sets: Sets) -> Result<Instance, InstanceError> {
    for key in ["FIXED_EDGES_SECTION", "GTSP_SET_ORDERING"] {
        if let Some(part) = file.part(key) {
            let what = format!("{key} is not read for more than {} nodes.", crate::problem::Table::MOST);
            return Err(InstanceError::at(part.line, what));
        }
    }
    let Some(machine) = machine::preset("length") else {
        return Err(InstanceError::whole("The machine that charges lengths is missing.".into()));
    };
    let plane = costs::plane(file, nodes)?;
    let start = sets.members.remove(sets.start);
    let id = |n: usize| NodeId::try_from(n).unwrap_or(NodeId::MAX);
    let widest = plane.at.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let mut shrink = 1.0;
    while widest * shrink > WIDE {
        shrink *= 0.5;
    }
    let place = |n: usize| plane.at.get(n).map_or(DVec2::ZERO, |&[x, y]| DVec2::new(x, y) * shrink);
    let (mut items, mut list) = (Vec::with_capacity(sets.members.len()), Vec::with_capacity(nodes));
    for (members, item) in sets.members.iter().zip(0..) {
        let first = id(list.len());
        for (&n, twin) in members.iter().zip(first..) {
            list.push(Node { item, entry: place(n), exit: place(n), along: 0.0, reversed: false, twin });
        }
        items.push(Item { nodes: first..id(list.len()), ..Item::default() });
    }
    let order: Vec<usize> = sets.members.iter().flatten().chain(&start).copied().collect();
    let home = start.first().map_or(DVec2::ZERO, |&n| place(n));
    Ok(Instance {
        name: file.name(),
        problem: Problem { items, nodes: list, home, closed: true, ..Problem::empty(machine) },
        numbers: order.iter().map(|&n| id(n) + 1).collect(),
        fixed: Vec::new(),
        lowered: 0.0,
        whole: true,
        plane: Some(plane.sorted(&order)),
    })
}

impl Plane {
    /// The same nodes in another order.
    fn sorted(mut self, order: &[usize]) -> Self {
        self.at = order.iter().filter_map(|&n| self.at.get(n).copied()).collect();
        self
    }
}
