//! Benchmark instances as problems: TSPLIB (symmetric and asymmetric), GTSPLIB, and PCGTSP as PCGLNS writes it.
//!
//! 1. `file.rs` takes the bytes apart into header values and sections of numbers, each with its line.
//! 2. `costs.rs` makes the table of costs from coordinates or explicit weights.
//! 3. `sets.rs` reads the sets of a GTSP, their order and the start, and makes sure that an order exists.
//! 4. Here they become a [`Problem`]: an item a set (a node, where there are no sets), the start last.
//!
//! Instances in the plane with more nodes than a table of costs may have become problems of points (`large.rs`).
//!
//! All tours are closed. A file that names no start group is a cycle without one: its smallest set is taken.
//! In a PCGLNS file the line `3 2 5 -1` under `GTSP_SET_ORDERING` says that set 3 comes before sets 2 and 5, and
//! the cycle starts at the start group and comes back to it (so do the published lengths: the tour that PCGLNS
//! prints for ESC07 costs its published 1730 only with the way back).
//!
//! Sources: G. Reinelt, ORSA J. Computing 3 (1991), and his TSPLIB 95 report for the weights; M. Fischetti,
//! J. J. Salazar, P. Toth, Operations Research 45 (1997), for the sets; M. Khachay, A. Kudriavtsev, A. Petunin,
//! LNCS 12422 (2020), for the order of sets.

mod check;
mod costs;
mod error;
mod file;
mod large;
mod model;
mod sets;

pub use check::{Fault, check};
pub use error::InstanceError;
pub use model::Instance;

use super::ids::NodeId;
use super::model::{Item, Node, Problem};
use super::table::Table;
use crate::machine;
use file::File;
use glam::DVec2;

/// Reads an instance of at most [`Table::MOST`] nodes, or of 100,000 where the costs are distances in the plane (EUC_2D,
/// CEIL_2D).
///
/// Memory: 8 bytes for each pair of nodes, twice that while explicit weights are read, and half as much again in a
/// search over sets; 128 MB for a table of 4,000 nodes.
///
/// # Errors
/// What the file lacks or contradicts, with the line.
pub fn instance(bytes: &[u8]) -> Result<Instance, InstanceError> {
    let text = String::from_utf8_lossy(bytes);
    let file = File::parse(&text)?;
    let nodes = file.dimension()?;
    let mut sets = sets::sets(&file, nodes)?;
    if nodes > Table::MOST {
        return large::instance(&file, nodes, sets);
    }
    let (fixed, lowered) = (sets::fixed_edges(&file, nodes)?, costs::span(&file, nodes)?);
    // The start goes last: see `Problem::table`.
    let start = sets.members.remove(sets.start);
    sets.members.push(start);
    let place = |set: usize| match set.cmp(&sets.start) {
        std::cmp::Ordering::Less => set,
        std::cmp::Ordering::Equal => sets.members.len() - 1,
        std::cmp::Ordering::Greater => set - 1,
    };
    let id = |n: usize| NodeId::try_from(n).unwrap_or(NodeId::MAX);
    let numbers: Vec<u32> = sets.members.iter().flatten().map(|&n| id(n) + 1).collect();
    let costs = costs::costs(&file, &numbers, &fixed, lowered)?;
    let whole = costs.iter().all(|c| c.fract().abs() < f64::MIN_POSITIVE);
    let table =
        Table::new(nodes, costs).ok_or_else(|| InstanceError::whole("A cost is no number.".into()))?;
    let (mut items, mut list) = (Vec::new(), Vec::new());
    for (members, item) in sets.members.iter().zip(0..) {
        let first = id(list.len());
        for twin in (first..).take(members.len()) {
            let (entry, along, reversed) = (DVec2::ZERO, 0.0, false);
            list.push(Node { item, entry, exit: entry, along, reversed, twin });
        }
        items.push(Item { nodes: first..id(list.len()), ..Item::default() });
    }
    // The start is before everything as it is.
    let pairs = sets.pairs.iter().filter(|p| p.0 != sets.start).map(|&(a, b)| (id(place(a)), id(place(b))));
    let problem = Problem {
        items,
        nodes: list,
        home: DVec2::ZERO,
        closed: true,
        pairs: pairs.collect(),
        table: Some(table),
        ..Problem::empty(machine::presets().swap_remove(0))
    };
    Ok(Instance { name: file.name(), problem, numbers, fixed, lowered, whole, plane: None })
}
