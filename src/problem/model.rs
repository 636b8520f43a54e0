//! The problem: items (contours), nodes (entries), travel costs in seconds, precedence.
//!
//! An item is entered at one of its nodes and left at that node's exit: the same point for closed contours, the other end
//! for open ones. The tour starts at home and, if `closed`, comes back. Nodes are in the order of their items.
//!
//! The cost of travel is the machine's air time between points, or it is given by a table of costs between nodes. A problem
//! with a table has no home: the tour is a closed cycle that starts at the last item. A path between two ends is such a
//! cycle too, if the legs back to the start cost nothing.

use super::groups::Groups;
use super::ids::{ItemId, NodeId};
use super::leads::ItemLeads;
use super::links::Links;
use super::starts::Starts;
use super::sub_path::SubPath;
use super::table::Table;
use crate::corner::Corner;
use crate::geometry::Path;
use crate::heat::Cooling;
use crate::joint::ContourJoints;
use crate::lead::Lead;
use crate::machine::{ClosedRun, PLANS_ALL_LEVERS, Profile};
use crate::tipping::Zones;
use glam::DVec2;
use std::sync::Arc;

/// A place where an item may be entered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The item it belongs to.
    pub item: ItemId,
    /// Where the head arrives, mm.
    pub entry: DVec2,
    /// Where the head leaves, mm.
    pub exit: DVec2,
    /// Place on the contour where it is entered: arc length from its start, mm; 0 for an open contour and for a pierce group.
    pub along: f64,
    /// Runs the contour against its stored direction.
    pub reversed: bool,
    /// The node that runs the same item the other way between the same two points (itself for closed contours).
    pub twin: NodeId,
}

/// Something to be visited once. By default it has no nodes, costs nothing and may be visited at any time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Item {
    /// Its nodes: a range of [`Problem::nodes`].
    pub nodes: std::ops::Range<NodeId>,
    /// The item it must be finished before (the contour around it).
    pub before: Option<ItemId>,
    /// Items of a lower rank come first, all of them (order by layer; marks before cuts).
    pub rank: u32,
    /// Seconds of piercing and cutting, whatever the entry.
    pub fixed: f64,
    /// The closed run along it, if stopping costs time: it prices the places of entry.
    pub run: Option<ClosedRun>,
    /// Seconds each time it is left unfinished and resumed; `None`: it must not be left. An item that may be left is closed,
    /// and its nodes are in order along it.
    pub leave: Option<f64>,
    /// A closed path along which it may be entered anywhere, not only at its nodes, which lie on the path.
    pub track: Option<Path>,
    /// Of a pierce group, that is contours cut as one: the path through it that each node stands for, in the order of the
    /// nodes. [`Item::fixed`] is the least of their seconds.
    pub paths: Vec<SubPath>,
    /// Of a contour with leads: the lead of each node, in the order of the nodes. Its nodes are entered where the lead-in
    /// begins and left where the lead-out ends.
    pub leads: Option<ItemLeads>,
    /// Of a contour for which micro-joints are asked for: those that it has, and what does not fit. If it has any, its nodes
    /// are those of [`Item::leads`], where a lead may be empty.
    pub joints: Option<Box<ContourJoints>>,
    /// Of an item that comes before a pierce group: the area of the group in which it lies. The group may be left for it
    /// until this area falls out.
    pub area: Option<u32>,
}

impl Item {
    /// Seconds beyond [`Item::fixed`] if it is entered by one of its nodes, `along` mm from the start of its track. Where a
    /// path through a pierce group is resumed, these are the seconds of its leave point. Never negative, except at a leave
    /// point that saves an air move.
    pub fn extra(&self, node: NodeId, along: f64) -> f64 {
        match (self.path(node), self.lead(node)) {
            (Some(path), _) => path.leave_point(along).map_or(path.seconds - self.fixed, |p| p.seconds),
            (None, Some((_, seconds))) => seconds,
            (None, None) => self.run.as_ref().map_or(0.0, |run| run.extra(along)),
        }
    }

    /// Whether it is a pierce group: contours cut as one, by one of several paths.
    pub fn is_pierce_group(&self) -> bool {
        !self.paths.is_empty()
    }

    /// The path through a pierce group that one of its nodes stands for; none for any other item.
    pub fn path(&self, node: NodeId) -> Option<&SubPath> {
        self.paths.get(node.checked_sub(self.nodes.start)? as usize)
    }

    /// The lead of one of its nodes, and its seconds beyond [`Item::fixed`]; none for an item without leads.
    pub fn lead(&self, node: NodeId) -> Option<(&Lead, f64)> {
        self.leads.as_ref()?.get(node.checked_sub(self.nodes.start)? as usize)
    }

    /// The corners of a cut from one of its nodes that are cut in loops or rounded: all that may be, and which of them are.
    pub fn turns(&self, node: NodeId) -> (&[Corner], &[usize]) {
        let of = node.checked_sub(self.nodes.start).zip(self.leads.as_ref());
        of.map_or((&[], &[]), |(node, leads)| leads.turns(node as usize))
    }

    /// Whether it may be left unfinished for other items.
    pub fn may_be_left(&self) -> bool {
        self.leave.is_some() || self.paths.iter().any(|p| !p.leave_points.is_empty())
    }

    /// Seconds that every plan spends on it besides air moves between items, at least. It is [`Item::fixed`], minus what
    /// leaving it may save: pauses in sharp corners, and air moves within a pierce group.
    pub fn least(&self) -> f64 {
        let saved = |p: &SubPath| p.leave_points.iter().map(|p| p.seconds.min(0.0)).sum::<f64>();
        if self.is_pierce_group() {
            return self.paths.iter().map(|p| p.seconds + saved(p)).fold(f64::INFINITY, f64::min);
        }
        let corners = self.run.as_ref().map_or(0.0, |run| run.sharp_corners() as f64);
        self.fixed - if self.leave.is_some() { corners * (-self.resume()).max(0.0) } else { 0.0 }
    }

    /// The same item, cut in one go: it is never left. The paths of a pierce group keep their ends and seconds only.
    pub fn in_one_go(&self) -> Self {
        let bare = |p: &SubPath| SubPath {
            ends: p.ends,
            lead_in: p.lead_in,
            seconds: p.seconds,
            strokes: Vec::new(),
            leave_points: Vec::new(),
            falls: Vec::new(),
        };
        let paths = self.paths.iter().map(bare).collect();
        Self {
            leave: None,
            paths,
            run: self.run.clone(),
            track: self.track.clone(),
            leads: self.leads.clone(),
            joints: self.joints.clone(),
            nodes: self.nodes.clone(),
            ..*self
        }
    }

    /// Whether its seconds depend on the place where it is entered.
    pub fn is_uneven(&self) -> bool {
        self.is_pierce_group() || self.leads.is_some() || self.uneven().is_some()
    }

    /// The run along it, if its seconds depend on the place of entry.
    pub fn uneven(&self) -> Option<&ClosedRun> {
        self.run.as_ref().filter(|run| !run.is_uniform())
    }

    /// Seconds of leaving and resuming it, without [`Item::extra`] of the place: [`Item::leave`] and one more stop of the
    /// head.
    pub fn resume(&self) -> f64 {
        self.leave.unwrap_or(0.0) + self.run.as_ref().map_or(0.0, ClosedRun::stop)
    }
}

/// Items, nodes, travel, precedence.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The items to be visited.
    pub items: Vec<Item>,
    /// The nodes of all items, in the order of the items.
    pub nodes: Vec<Node>,
    /// Start, mm.
    pub home: DVec2,
    /// The head comes back home.
    pub closed: bool,
    /// The machine whose air time is the cost of travel.
    pub machine: Profile,
    /// Pairs of items of which the first is visited before the second, in addition to [`Item::before`]: an order without
    /// cycles.
    pub pairs: Vec<(ItemId, ItemId)>,
    /// Items that are visited without any other item in between; none of them is left unfinished.
    pub groups: Groups,
    /// Costs of travel from node to node, if they are given. Points, home and machine then mean nothing, no item has a
    /// track, and the last item is the start of a closed tour.
    pub table: Option<Table>,
    /// The pieces that may tip, by the items that free them, on a machine with `levers.tips`. Where they are avoided, what a
    /// move costs depends on what has been cut before; the costs of travel here are those of straight moves with the head
    /// down, which are never more.
    pub zones: Option<Arc<Zones>>,
    /// The cuts that heat each other, on a machine with `levers.heat`. What a cut costs then depends on when those near it ended.
    pub cooling: Option<Arc<Cooling>>,
    /// Pairs of nodes with something quicker between them than an air move: chains, on a machine with `levers.chains`. Their items
    /// have no track. Where there is a link, its seconds are the cost of travel.
    pub links: Links,
    /// Other ways to begin the cuts of nodes, without piercing, on a machine with `levers.chains.edge_starts`. Their items have no track either.
    pub starts: Starts,
}

impl Problem {
    /// No items, no levers, and travel from the machine's home and back to it, if the head returns.
    pub fn empty(machine: Profile) -> Self {
        Self {
            items: Vec::new(),
            nodes: Vec::new(),
            home: machine.home(),
            closed: machine.return_home,
            machine,
            pairs: Vec::new(),
            groups: Groups::default(),
            table: None,
            zones: None,
            cooling: None,
            links: Links::default(),
            starts: Starts::default(),
        }
    }

    /// What every plan pays at its items, whatever its travel, s ([`Item::least`]), less what links and starts may save.
    pub fn paid(&self) -> f64 {
        self.payments().sum()
    }

    /// The terms of [`Problem::paid`].
    pub fn payments(&self) -> impl Iterator<Item = f64> {
        let saved = [self.links.most_saved(), self.starts.most_saved()];
        self.items.iter().map(Item::least).chain(saved.map(|seconds| -seconds))
    }

    /// No plan saves more by links and starts than this, s: its cost is no less than its travel less this.
    pub fn most_saved(&self) -> f64 {
        self.links.most_saved() + self.starts.most_saved()
    }

    /// The pieces that may tip, if moves avoid them.
    pub fn avoided(&self) -> Option<&Zones> {
        self.zones.as_deref().filter(|zones| PLANS_ALL_LEVERS && zones.avoids())
    }

    /// Whether what a move costs depends on what has been cut before it.
    pub fn depends_on_the_past(&self) -> bool {
        self.avoided().is_some() || self.cooling().is_some() || !self.starts.is_empty()
    }

    /// The cuts that heat each other, if they do.
    pub fn cooling(&self) -> Option<&Cooling> {
        self.cooling.as_deref().filter(|_| PLANS_ALL_LEVERS)
    }

    /// The table of costs, if travel is given by one, as in benchmark instances.
    pub fn table(&self) -> Option<&Table> {
        self.table.as_ref()
    }

    /// The item at which the cycle of a problem with a table starts: the last one.
    pub fn start(&self) -> Option<ItemId> {
        self.table()?;
        ItemId::try_from(self.items.len()).ok()?.checked_sub(1)
    }
}

/// The number of the next node of a list.
pub(super) fn count(nodes: &[Node]) -> NodeId {
    // The reader's limit of 2,000,000 elements leaves at most 32,000,000 nodes.
    NodeId::try_from(nodes.len()).unwrap_or(NodeId::MAX)
}
