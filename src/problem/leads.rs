//! The leads of an item: one for each of its nodes, with what it costs.

use super::entries::entries;
use crate::geometry::{DVec2, Segment};
use crate::lead::{ContourLeads, Entry, Lead, Outcome, Planner, starts_moving};
use crate::machine::{Profile, process_time};
use crate::sheet::{Contour, Sheet};

/// The leads of a contour.
#[derive(Clone, Debug, PartialEq)]
pub struct ItemLeads {
    /// The lead of each node, and its seconds beyond those of the cheapest.
    leads: Vec<(Lead, f64)>,
    /// How well they fit.
    pub outcome: Outcome,
}

/// A node of a contour with leads.
pub(super) struct LeadNode {
    pub(super) along: f64,
    pub(super) entry: DVec2,
    pub(super) exit: DVec2,
}

impl ItemLeads {
    /// The leads of a contour with the nodes that they make, and the seconds of the cheapest; `None` if it has no leads.
    pub(super) fn new(
        planner: &Planner,
        sheet: &Sheet,
        machine: &Profile,
        id: u32,
        contour: &Contour,
    ) -> Option<(Self, Vec<LeadNode>, f64)> {
        let places: Vec<f64> = if contour.path.closed {
            entries(&contour.path).into_iter().map(|(along, _)| along).collect()
        } else {
            return None;
        };
        let ContourLeads { entries, outcome } = planner.leads(id, &places)?;
        let process = sheet.process_of(contour, machine);
        let mut nodes = Vec::with_capacity(entries.len());
        let mut leads = Vec::with_capacity(entries.len());
        for Entry { along, lead } in entries {
            let path = lead.run(&contour.path, along).path;
            let (entry, exit) = (path.first()?.start(), path.last().map(Segment::end)?);
            nodes.push(LeadNode { along, entry, exit });
            leads.push((lead, process_time(machine, &process, false, &path)));
        }
        let least = leads.iter().map(|l| l.1).fold(f64::INFINITY, f64::min);
        leads.iter_mut().for_each(|l| l.1 -= least);
        (!nodes.is_empty()).then_some((Self { leads, outcome }, nodes, least))
    }

    /// Whether the contour's cut begins moving: its leads have one overcut.
    pub(super) fn start_moving(&self, sheet: &Sheet, machine: &Profile, contour: &Contour) -> bool {
        starts_moving(sheet, machine, contour, self.leads.first().map(|l| &l.0))
    }

    /// The lead of a node, by its place in the item.
    pub(super) fn get(&self, node: usize) -> Option<(&Lead, f64)> {
        self.leads.get(node).map(|(lead, seconds)| (lead, *seconds))
    }
}
