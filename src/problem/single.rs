//! Items of contours that are cut by themselves: neither with a pierce group nor on the run.

use super::bridge_cuts::begins_on_kerf;
use super::chains::Candidates;
use super::entries::entries;
use super::ids::ItemId;
use super::kerf_starts::KerfStarts;
use super::leads::{ItemLeads, LeadNode, Planners};
use super::model::{Item, Node, count};
use super::pierce_groups::PierceGroups;
use super::seconds::{leave_seconds, seconds, start_seconds};
use crate::geometry::DVec2;
use crate::joint::ContourJoints;
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::sheet::{Contour, Sheet};

/// Makes the items of contours that are cut by themselves.
pub(super) struct Singles<'p, 's> {
    pub(super) sheet: &'s Sheet,
    pub(super) machine: &'s Profile,
    pub(super) planners: &'p Planners<'s>,
    pub(super) joined: &'p PierceGroups<'s>,
    pub(super) chained: Option<&'p Candidates<'s>>,
    pub(super) starts: Option<&'p KerfStarts<'p, 's>>,
    /// Whether contours are kept together, so that none is left for another.
    pub(super) keeps_together: bool,
}

impl Singles<'_, '_> {
    /// The item of a contour; its nodes are added to `nodes`. `others`: the items of the contours before it.
    pub(super) fn item(
        &self,
        id: ItemId,
        contour: &Contour,
        rank: u32,
        others: &[Item],
        nodes: &mut Vec<Node>,
    ) -> Item {
        let first = count(nodes);
        let joints = self.planners.joints(id).map(Box::new);
        let item = match self.leads(id, contour, joints.as_deref()) {
            Some((leads, places, least)) => {
                push_leads(nodes, id, places);
                let moving = joints.is_none() && leads.start_moving(self.sheet, self.machine, contour);
                let fixed = start_seconds(self.machine, false, moving) + least;
                Item { fixed, leads: Some(leads), ..Item::default() }
            }
            None => self.bare(id, contour, joints.is_none(), others, nodes),
        };
        Item {
            nodes: first..count(nodes),
            before: self.joined.before(id),
            area: self.joined.area(id),
            rank,
            joints,
            ..item
        }
    }

    /// The leads of a contour with their nodes, and the seconds of the cheapest, if it has leads, joints, corners that are cut otherwise, or
    /// is near the edge of the sheet, from which it is entered as well.
    fn leads(
        &self,
        id: ItemId,
        contour: &Contour,
        joints: Option<&ContourJoints>,
    ) -> Option<(ItemLeads, Vec<LeadNode>, f64)> {
        let starts = self.starts.filter(|_| PLANS_ALL_LEVERS && joints.is_none());
        let Some((mut leads, mut places, mut least)) = ItemLeads::new(self.planners, id, contour, joints)
        else {
            return starts.filter(|_| contour.path.closed)?.bare_at_edge(id, contour, self.places(id));
        };
        if let Some(starts) = starts {
            least -= starts.add_edge(id, &mut leads, &mut places);
        }
        Some((leads, places, least))
    }

    /// The item of a contour that is cut or marked from its own places of entry.
    fn bare(
        &self,
        id: ItemId,
        contour: &Contour,
        may_move: bool,
        others: &[Item],
        nodes: &mut Vec<Node>,
    ) -> Item {
        let (sheet, machine) = (self.sheet, self.machine);
        let passes = sheet.passes_at_once(contour, machine);
        match self.places(id) {
            Some(places) => push_places(nodes, id, places),
            None => push_nodes(nodes, id, contour, passes),
        }
        let (fixed, run) = seconds(sheet, machine, contour, passes, may_move);
        let on_kerf = PLANS_ALL_LEVERS && begins_on_kerf(sheet, machine, others, contour);
        Item {
            fixed: if on_kerf { fixed - f64::from(passes) * machine.pierce_time } else { fixed },
            run,
            leave: leave_seconds(machine, contour)
                .filter(|_| !self.keeps_together && passes == 1 && contour.pass == 0)
                .filter(|_| self.planners.leads.is_none() && !sheet.has_turn(contour)),
            track: contour.path.closed.then(|| contour.path.clone()),
            ..Item::default()
        }
    }

    /// The places where a contour may be entered that is near others that it may be joined to.
    fn places(&self, id: ItemId) -> Option<&[(f64, DVec2)]> {
        self.chained.filter(|_| PLANS_ALL_LEVERS)?.places(id)
    }
}

/// The nodes of a contour. Several passes over an open contour run there and back: after an even number, the head is where it began.
fn push_nodes(nodes: &mut Vec<Node>, item: ItemId, contour: &Contour, passes: u32) {
    let path = &contour.path;
    if !path.closed
        && let (Some(start), Some(end)) = (path.start(), path.end())
    {
        let (ahead, back) = (count(nodes), count(nodes) + 1);
        let node = |entry, exit, reversed, twin| Node { item, entry, exit, along: 0.0, reversed, twin };
        if passes.is_multiple_of(2) {
            nodes.push(node(start, start, false, ahead));
            nodes.push(node(end, end, true, back));
            return;
        }
        nodes.push(node(start, end, false, back));
        nodes.push(node(end, start, true, ahead));
        return;
    }
    push_places(nodes, item, &entries(path));
}

/// A node at each of these places of a closed contour.
fn push_places(nodes: &mut Vec<Node>, item: ItemId, places: &[(f64, DVec2)]) {
    for &(along, entry) in places {
        let twin = count(nodes);
        nodes.push(Node { item, entry, exit: entry, along, reversed: false, twin });
    }
}

/// A node for each lead-in of a closed contour.
fn push_leads(nodes: &mut Vec<Node>, item: ItemId, places: Vec<LeadNode>) {
    for LeadNode { along, entry, exit } in places {
        let twin = count(nodes);
        nodes.push(Node { item, entry, exit, along, reversed: false, twin });
    }
}
