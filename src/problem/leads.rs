//! The leads of an item: one for each of its nodes, with what it costs. An item with micro-joints has them as well, because
//! the seconds of its cut depend on where it is entered: at a joint it has one stretch less. So has one whose corners are cut in
//! loops or rounded: at a corner it needs no loop there.

use super::entries::entries;
use crate::corner::{self, ContourCorners, Corner, turned};
use crate::geometry::{DVec2, Path, Segment};
use crate::joint::{self, ContourJoints, Divided, Joint, divided};
use crate::lead::{ContourLeads, Entry, Fit, Lead, Outcome, Planner, starts_moving};
use crate::machine::{AirTime, JointKind, PLANS_ALL_LEVERS, Process, Profile, process_time};
use crate::sheet::{Contour, Sheet};

/// Least distance of a joint from leads and overcuts, in lengths of a joint.
const JOINT_APART: f64 = 1.5;

/// The leads of a contour.
#[derive(Clone, Debug, PartialEq)]
pub struct ItemLeads {
    /// The lead of each node, and its seconds beyond those of the cheapest.
    leads: Vec<(Lead, f64)>,
    /// The corners that may be cut in loops or rounded, and what has no room.
    pub corners: ContourCorners,
    /// Of each node, those of these corners that are; empty if there are none at all.
    turns: Vec<Vec<usize>>,
    /// How well they fit; the default if the contour has no leads, but joints.
    pub outcome: Outcome,
}

/// A node of a contour with leads.
pub(super) struct LeadNode {
    pub(super) along: f64,
    pub(super) entry: DVec2,
    pub(super) exit: DVec2,
}

/// A cut through waste from the edge of the sheet, in place of the piercing of a node.
pub(super) struct EdgeStart {
    /// The number of the node among those of its item.
    pub(super) node: usize,
    pub(super) approach: Segment,
    /// Seconds of the cut through waste.
    pub(super) seconds: f64,
}

/// The leads and joints of a sheet.
pub(super) struct Planners<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    pub(super) leads: Option<Planner<'s>>,
    pub(super) joints: Option<joint::Planner<'s>>,
    corners: Option<corner::Planner<'s>>,
}

impl<'s> Planners<'s> {
    pub(super) fn new(sheet: &'s Sheet, machine: &'s Profile) -> Self {
        let (leads, joints) = (Planner::new(sheet, machine), joint::Planner::new(sheet, machine));
        Self {
            sheet,
            machine,
            leads,
            joints,
            corners: if PLANS_ALL_LEVERS { corner::Planner::new(sheet, machine) } else { None },
        }
    }

    /// The corners of a contour that may be cut otherwise.
    fn corners(&self, id: u32) -> ContourCorners {
        self.corners.as_ref().and_then(|p| p.corners(id)).unwrap_or_default()
    }

    /// The joints of a contour, if it may have any.
    pub(super) fn joints(&self, id: u32) -> Option<ContourJoints> {
        self.joints.as_ref()?.joints(id)
    }
}

impl ItemLeads {
    /// The leads of a contour with the nodes that they make, and the seconds of the cheapest; `None` if it has no leads, no
    /// joints, and no corners that are cut otherwise.
    pub(super) fn new(
        planners: &Planners,
        id: u32,
        contour: &Contour,
        joints: Option<&ContourJoints>,
    ) -> Option<(Self, Vec<LeadNode>, f64)> {
        if !contour.path.closed {
            return None;
        }
        let Planners { sheet, machine, .. } = planners;
        let places: Vec<f64> = entries(&contour.path).into_iter().map(|(along, _)| along).collect();
        let found = planners.leads.as_ref().and_then(|p| match joints {
            None => p.leads(id, &places),
            Some(_) => p.leads_at_rest(id, &places, None),
        });
        let joints = joints.filter(|j| !j.joints.is_empty());
        let corners = if PLANS_ALL_LEVERS { planners.corners(id) } else { ContourCorners::default() };
        let bare = found.is_none() && joints.is_none();
        let (entries, outcome) = match (found, joints) {
            (None, None) if !PLANS_ALL_LEVERS || corners == ContourCorners::default() => return None,
            (None, None) => (
                places.iter().map(|&along| Entry { along, lead: Lead::default() }).collect(),
                Outcome::default(),
            ),
            (Some(ContourLeads { entries, outcome }), None) => (entries, outcome),
            (found, Some(joints)) => with_joints(planners, id, contour, &places, found, joints),
        };
        let process = sheet.process_of(contour, machine);
        let (joints, kind) = joints.map_or((&[][..], JointKind::Stop), |j| (j.joints.as_slice(), j.kind));
        let mut nodes = Vec::with_capacity(entries.len());
        let mut leads = Vec::with_capacity(entries.len());
        let mut turns = Vec::new();
        for Entry { along, lead } in entries {
            let mut cut = divided(&lead, &contour.path, along, joints);
            if PLANS_ALL_LEVERS && !corners.corners.is_empty() {
                turns.push(turn(machine, &process, &mut cut, &corners.corners));
            }
            let (first, last) = (cut.stretches.first()?, cut.stretches.last()?);
            let (entry, exit) = (first.path.first()?.start(), last.path.last().map(Segment::end)?);
            nodes.push(LeadNode { along, entry, exit });
            leads.push((lead, seconds(machine, &process, &cut, kind)));
        }
        let least = leads.iter().map(|l| l.1).fold(f64::INFINITY, f64::min);
        leads.iter_mut().for_each(|l| l.1 -= least);
        // Where no corner saves time, the contour is as it would be without them.
        let plain = bare && corners.without_room.is_empty() && turns.iter().all(Vec::is_empty);
        (!plain && !nodes.is_empty()).then_some((Self { leads, corners, turns, outcome }, nodes, least))
    }

    /// A contour that is entered at these places without leads: its nodes, and the seconds of the cheapest.
    pub(super) fn bare(
        machine: &Profile,
        process: &Process,
        path: &Path,
        places: &[(f64, DVec2)],
    ) -> (Self, Vec<LeadNode>, f64) {
        let nodes = places.iter().map(|&(along, entry)| LeadNode { along, entry, exit: entry }).collect();
        let cut = |along: f64| process_time(machine, process, false, &path.starting_at(along).segments);
        let seconds: Vec<f64> = places.iter().map(|&(along, _)| cut(along)).collect();
        let least = seconds.iter().copied().fold(f64::INFINITY, f64::min);
        let leads = seconds.into_iter().map(|s| (Lead::default(), s - least)).collect();
        let (corners, outcome) = (ContourCorners::default(), Outcome::default());
        (Self { leads, corners, turns: Vec::new(), outcome }, nodes, least)
    }

    /// Adds nodes for starts that are not pierced: the lead of a node, and a cut through waste in place of its piercing. Returns by how many
    /// seconds the cheapest node is cheaper than before.
    pub(super) fn add_starts(
        &mut self,
        nodes: &mut Vec<LeadNode>,
        starts: &[EdgeStart],
        pierce_time: f64,
    ) -> f64 {
        for start in starts {
            let (Some((lead, seconds)), Some(node)) = (self.leads.get(start.node), nodes.get(start.node))
            else {
                continue;
            };
            let LeadNode { along, exit, .. } = *node;
            let seconds = seconds - pierce_time + start.seconds;
            self.leads.push((Lead { approach: Some(start.approach), ..lead.clone() }, seconds));
            nodes.push(LeadNode { along, entry: start.approach.start(), exit });
            if let Some(turns) = self.turns.get(start.node).cloned() {
                self.turns.push(turns);
            }
        }
        let least = self.leads.iter().map(|l| l.1).fold(f64::INFINITY, f64::min);
        self.leads.iter_mut().for_each(|l| l.1 -= least);
        -least
    }

    /// Whether the contour's cut begins moving: its leads have one overcut.
    pub(super) fn start_moving(&self, sheet: &Sheet, machine: &Profile, contour: &Contour) -> bool {
        starts_moving(sheet, machine, contour, self.leads.first().map(|l| &l.0))
    }

    /// The corners that a cut from a node does not stop in, by its place in the item: all that may be cut so, and which are.
    pub(super) fn turns(&self, node: usize) -> (&[Corner], &[usize]) {
        (&self.corners.corners, self.turns.get(node).map_or(&[], Vec::as_slice))
    }

    /// The lead of a node, by its place in the item.
    pub(super) fn get(&self, node: usize) -> Option<(&Lead, f64)> {
        self.leads.get(node).map(|(lead, seconds)| (lead, *seconds))
    }
}

/// Cuts those corners of each stretch otherwise that save time; returns which these are.
fn turn(machine: &Profile, process: &Process, cut: &mut Divided, corners: &[Corner]) -> Vec<usize> {
    let mut all = Vec::new();
    for stretch in &mut cut.stretches {
        let on = stretch.on();
        let chosen = corner::chosen(machine, process, &stretch.path, on.clone(), corners);
        stretch.path = turned(&stretch.path, on, corners, &chosen).0;
        all.extend(chosen);
    }
    all
}

/// Seconds of a cut with its joints, without the first piercing.
fn seconds(machine: &Profile, process: &Process, cut: &Divided, kind: JointKind) -> f64 {
    if kind == JointKind::Flying && !cut.joints.is_empty() {
        let joints = cut.joints.iter().map(Vec::as_slice).chain([&[][..]]);
        let whole: Vec<Segment> =
            cut.stretches.iter().zip(joints).flat_map(|(s, j)| s.path.iter().chain(j)).copied().collect();
        return process_time(machine, process, false, &whole);
    }
    let air = AirTime::head_down(machine);
    let over = |joint: &Vec<Segment>| {
        let ends = joint.first().zip(joint.last());
        let seconds = ends.map_or(0.0, |(a, b)| air.seconds(a.start(), b.end()));
        seconds + machine.pierce_time + machine.beam_delays()
    };
    let stretches = cut.stretches.iter().map(|s| process_time(machine, process, false, &s.path));
    stretches.sum::<f64>() + cut.joints.iter().map(over).sum::<f64>()
}

/// The entries of a contour with joints: those whose leads and overcuts are away from joints, and the ends of its joints.
fn with_joints(
    planners: &Planners,
    id: u32,
    contour: &Contour,
    places: &[f64],
    found: Option<ContourLeads>,
    ContourJoints { joints, .. }: &ContourJoints,
) -> (Vec<Entry>, Outcome) {
    let bare = |along, overcut| Entry { along, lead: Lead { overcut, ..Lead::default() } };
    let (mut entries, mut outcome) = match found {
        Some(ContourLeads { entries, outcome }) => (entries, Some(outcome)),
        None => (places.iter().map(|&along| bare(along, 0.0)).collect(), None),
    };
    entries.retain(|e| joints.iter().all(|j| is_apart(e, j, contour.length)));
    for joint in joints {
        let overcut = -joint.length;
        let at_joint = |e: &Entry| (e.along - joint.to).abs() < 1e-9;
        let with_lead = planners.leads.as_ref().and_then(|p| p.leads_at_rest(id, &[joint.to], Some(overcut)));
        match (with_lead, &outcome) {
            (Some(lead), Some(wanted))
                if lead.outcome.lead_in <= wanted.lead_in && lead.outcome.lead_out <= wanted.lead_out =>
            {
                entries.extend(lead.entries.into_iter().filter(at_joint));
            }
            (_, None) => entries.push(bare(joint.to, overcut)),
            _ => {}
        }
    }
    if entries.is_empty() {
        // No lead keeps away from the joints, so the cut begins at one of them.
        entries = joints.iter().map(|j| bare(j.to, -j.length)).collect();
        outcome.iter_mut().for_each(|o| (o.lead_in, o.lead_out) = (Fit::None, Fit::None));
    }
    (entries, outcome.unwrap_or_default())
}

/// Whether the lead and the overcut of an entry are away from a joint.
fn is_apart(entry: &Entry, joint: &Joint, whole: f64) -> bool {
    let least = JOINT_APART * joint.length;
    let around = |d: f64| d.rem_euclid(whole);
    around(entry.along - joint.from) > joint.length
        && around(joint.from - entry.along) >= least + entry.lead.overcut.max(0.0)
        && around(entry.along - joint.to) >= least + (-entry.lead.overcut).max(0.0)
}
