//! Turns each stop of a solution into moves.

use super::head::{Head, with_turns};
use crate::geometry::{Path, Segment};
use crate::joint::{ContourJoints, divided};
use crate::lead::{Lead, Run, starts_moving};
use crate::machine::{JointKind, PLANS_ALL_LEVERS};
use crate::plan::model::{Leads, Move};
use crate::problem::{Item, Link, Node, NodeId, Problem, Start, begins_on_kerf};
use crate::sheet::{Contour, Sheet};
use crate::solve::{Begun, Stop};

/// The visits so far.
pub(super) struct Visits<'p> {
    sheet: &'p Sheet,
    problem: &'p Problem,
    head: Head<'p>,
    /// For each contour, the place where it was begun.
    begun_at: Vec<Option<f64>>,
    /// The node of the last visit.
    last: Option<NodeId>,
}

/// A visit, and what is visited.
struct Visit<'p> {
    stop: &'p Stop,
    node: &'p Node,
    contour: &'p Contour,
    item: Option<&'p Item>,
}

impl<'p> Visits<'p> {
    /// Before the first of `count` visits, at home.
    pub(super) fn new(sheet: &'p Sheet, problem: &'p Problem, count: usize) -> Self {
        Self {
            sheet,
            problem,
            head: Head::new(&problem.machine, problem.home, 3 * count + 1),
            begun_at: vec![None; sheet.contours.len()],
            last: None,
        }
    }

    /// Makes the next visit. `how`: how its cut is begun, in builds that know more than one way.
    pub(super) fn make(&mut self, stop: &Stop, how: Option<Begun>) {
        let problem = self.problem;
        let Some(node) = problem.nodes.get(stop.node as usize) else { return };
        let before = self.last.replace(stop.node);
        let Some(contour) = self.sheet.contours.get(node.item as usize) else { return };
        let item = problem.items.get(node.item as usize);
        let visit = Visit { stop, node, contour, item };
        if let Some(path) = item.and_then(|i| i.path(stop.node)) {
            if let Some((from, to)) = stop.ends(problem) {
                self.head.go(from);
                let lead = path.lead_in.filter(|_| stop.along == 0.0);
                self.head.through(lead, &path.stretch(stop.along, stop.until));
                self.head.at = to;
            }
            return;
        }
        if let Some((lead, joints)) = item.and_then(|i| with_joints(i, stop)) {
            self.with_joints(&visit, lead, joints);
            return;
        }
        let start = how.and_then(Begun::start);
        if let Some(start) = start.filter(|_| contour.skeleton) {
            self.skeleton_cut(node, start);
            return;
        }
        let link = before.and_then(|before| problem.links.between(before, stop.node));
        self.contour(&visit, link.filter(|_| how.is_none_or(|how| how == Begun::Linked)), start);
    }

    /// Returns home, if the machine does. Returns all moves.
    pub(super) fn finish(mut self) -> Vec<Move> {
        if self.problem.closed {
            self.head.go(self.problem.home);
        }
        self.head.moves
    }

    /// Cuts a contour with joints.
    fn with_joints(&mut self, visit: &Visit, lead: &Lead, joints: &ContourJoints) {
        let cut = divided(lead, &visit.contour.path, visit.stop.along, &joints.joints);
        let Some(entry) = cut.stretches.first().and_then(|s| s.path.first()).map(Segment::start) else {
            return;
        };
        self.head.go(entry);
        let corners = visit.item.map(|i| i.turns(visit.stop.node)).unwrap_or_default();
        self.head.over_joints(visit.node.item, cut, joints.kind == JointKind::Flying, corners);
    }

    /// Cuts a skeleton cut that begins without piercing at a place: at its end, or on another one that it crosses, from where it is cut to
    /// both ends.
    fn skeleton_cut(&mut self, node: &Node, start: Start) {
        for to in [node.entry, node.exit].into_iter().filter(|&to| to != start.from) {
            self.head.go(start.from);
            self.head.run(node.item, vec![Segment::line(start.from, to)], false, Leads::default());
        }
    }

    /// Cuts or marks a contour, or a stretch of it, in all of its passes. It begins by a link from the visit before, at a start
    /// elsewhere, by the approach of its lead, or where it is entered.
    fn contour(&mut self, visit: &Visit, link: Option<&Link>, start: Option<Start>) {
        let Visit { stop, node, contour, item } = *visit;
        let machine = &self.problem.machine;
        let id = node.item;
        let lead = item.and_then(|i| i.lead(stop.node)).map(|l| l.0);
        let approach = lead.and_then(|lead| lead.approach).filter(|_| PLANS_ALL_LEVERS);
        let (path, leads) = match lead.filter(|lead| approach.is_none() || !lead.is_bare()) {
            Some(lead) => with_leads(lead, &contour.path, stop.along),
            None => (path_of(&contour.path, stop, node.reversed), Leads::default()),
        };
        let Some(entry) = path.first().map(Segment::start) else { return };
        let (path, turns) = with_turns(path, leads, item.map(|i| i.turns(stop.node)).unwrap_or_default());
        let chain = link
            .map(|link| Segment::line(link.via.unwrap_or(self.head.at), entry))
            .or(approach)
            .or(start.map(|start| Segment::line(start.from, entry)));
        match chain {
            Some(chain) => self.head.chain(chain),
            None => self.head.go(entry),
        }
        let resumed = self.begun_at[id as usize].is_some();
        let beam = if resumed || chain.is_some() { None } else { self.beam_on(visit, lead) };
        let mut lowered = false;
        for pass in 0..self.sheet.passes_at_once(contour, machine) {
            lowered |= self.head.lower(contour.pass + pass, &self.sheet.process_of(contour, machine));
            // An open contour is run there and back.
            let back = !contour.path.closed && !pass.is_multiple_of(2);
            let path = if back { Path::new(path.clone(), false).reversed().segments } else { path.clone() };
            self.head.moves.extend(beam.clone());
            if contour.is_mark() {
                self.head.run(id, path, true, leads);
            } else {
                self.head.cut(id, &path, leads, &turns);
            }
        }
        if lowered {
            self.head.moves.push(Move::Height { z: 0.0 });
        }
        self.leave(visit);
    }

    /// What switches the beam on for a contour that is entered after an air move; `None`: the cut itself does.
    fn beam_on(&self, visit: &Visit, lead: Option<&Lead>) -> Option<Move> {
        let (sheet, problem, machine) = (self.sheet, self.problem, &self.problem.machine);
        if PLANS_ALL_LEVERS && begins_on_kerf(sheet, machine, &problem.items, visit.contour) {
            return None;
        }
        let may_move = visit.item.is_none_or(|i| i.joints.is_none());
        if may_move && starts_moving(sheet, machine, visit.contour, lead) {
            return Some(Move::MovingStart);
        }
        (!visit.contour.is_mark()).then_some(Move::Pierce)
    }

    /// Leaves a contour: unfinished after a pre-cut, if the machine charges for these.
    fn leave(&mut self, visit: &Visit) {
        let Visit { stop, node, contour, .. } = *visit;
        let start = *self.begun_at[node.item as usize].get_or_insert(stop.along);
        #[expect(clippy::float_cmp, reason = "the last visit ends where the first began, bit for bit")]
        let left = stop.until != start;
        if left && self.problem.machine.charges_for_pre_cuts() {
            self.head.pre_cut(node.item, contour.path.between(stop.until, start));
        }
    }
}

/// The lead and the joints of a visit of a contour that has joints.
fn with_joints<'p>(item: &'p Item, stop: &Stop) -> Option<(&'p Lead, &'p ContourJoints)> {
    let joints = item.joints.as_deref().filter(|j| !j.joints.is_empty())?;
    Some((item.lead(stop.node)?.0, joints))
}

/// The elements of a cut with its leads.
fn with_leads(lead: &Lead, contour: &Path, along: f64) -> (Vec<Segment>, Leads) {
    let Run { path, lead_in, overcut, lead_out } = lead.run(contour, along);
    (path, Leads { lead_in, overcut, lead_out })
}

/// The elements of a visit. A visit of a whole contour may run against its direction.
fn path_of(path: &Path, stop: &Stop, reversed: bool) -> Vec<Segment> {
    if !stop.is_whole() {
        return path.between(stop.along, stop.until);
    }
    let from_entry = path.starting_at(stop.along);
    if reversed { from_entry.reversed().segments } else { from_entry.segments }
}
