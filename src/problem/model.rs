//! The problem: items (contours), nodes (entries), travel costs in seconds, precedence.
//!
//! An item is entered at one of its nodes and left at that node's exit: the same point for closed contours, the
//! other end for open ones. The tour starts at home and, when `closed`, comes back.

use crate::geometry::Path;
use crate::machine::{Process, Profile, cut_time};
use glam::DVec2;

/// Index of an item; for sheets, the contour's id.
pub type ItemId = u32;
/// Index of a node.
pub type NodeId = u32;

/// A place where an item may be entered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The item it belongs to.
    pub item: ItemId,
    /// Where the head arrives, mm.
    pub entry: DVec2,
    /// Where the head leaves, mm.
    pub exit: DVec2,
    /// Place on the contour: arc length from its start, mm.
    pub along: f64,
    /// Runs the contour against its stored direction.
    pub reversed: bool,
    /// The node that runs the same item the other way between the same two points (itself for closed contours).
    pub twin: NodeId,
}

/// Something to be visited once.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Its nodes: a range of [`Problem::nodes`].
    pub nodes: std::ops::Range<NodeId>,
    /// The item it must be finished before (the contour around it).
    pub before: Option<ItemId>,
    /// Items of a lower rank come first, all of them (order by layer; marks before cuts).
    pub rank: u32,
    /// Seconds it costs wherever it is entered: pierce, cut.
    pub fixed: f64,
    /// A closed path along which it may be entered anywhere, not at its nodes only; its nodes lie on it.
    pub track: Option<Track>,
}

/// A closed path to be entered anywhere, and how it is run.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The contour.
    pub path: Path,
    /// Speed and acceleration along it: they decide what standing still at the entry costs.
    pub process: Process,
}

/// Items, nodes, travel, precedence.
#[derive(Clone, Debug)]
pub struct Problem {
    /// What is to be visited.
    pub items: Vec<Item>,
    /// Where.
    pub nodes: Vec<Node>,
    /// Start, mm.
    pub home: DVec2,
    /// Comes back home.
    pub closed: bool,
    /// The machine whose air time is the cost of travel.
    pub machine: Profile,
}

impl Problem {
    /// Seconds along an item's track when it is entered `along` mm from its start: an entry in a corner, where the
    /// head slows down anyway, costs less than one on a straight. 0 for items without a track.
    pub fn run_seconds(&self, item: ItemId, along: f64) -> f64 {
        let track = self.items.get(item as usize).and_then(|i| i.track.as_ref());
        track.map_or(0.0, |t| cut_time(&self.machine, &t.process, &t.path.starting_at(along).segments))
    }
}
