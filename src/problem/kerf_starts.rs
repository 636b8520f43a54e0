//! Starts without piercing (`levers.chains.edge_starts`): the head moves to a kerf, or to the edge of the sheet, with the beam off, and the beam
//! cuts from there through waste to a contour.
//!
//! Those at the edge are places of entry of their own, beside those at which the contour is pierced. Those on the kerf of another contour may be used
//! once that one is cut (`starts.rs`). Skeleton cuts begin where they meet the edge or each other (`skeleton_starts.rs`).

use super::chains::{Candidates, Neighbour};
use super::entries::entries;
use super::ids::NodeId;
use super::leads::{EdgeStart, ItemLeads, LeadNode};
use super::model::{Item, Node};
use super::starts::Start;
use crate::geometry::{DVec2, Path, Segment};
use crate::lead::starts_moving;
use crate::machine::{CornerKind, Profile, cut_time};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Sheet};

/// Most starts of a contour at the edge of the sheet, the quickest ones: with its other places they are about as many as the gates of the search.
const FROM_EDGE: usize = 4;
/// Most starts of a node on kerfs, the quickest ones: as many as a part of a nest has neighbours.
const FROM_KERFS: usize = 8;
/// Least seconds that one saves on piercing, and least length of its cut, mm: less is rounding.
const LEAST: f64 = 1e-9;

/// The edge of a sheet and the kerfs on it, and where cuts may begin there.
pub(super) struct KerfStarts<'c, 's> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    candidates: &'c Candidates<'s>,
    edge: Option<&'s Path>,
    /// Whether contours are cut all around, so that there is a kerf wherever one is looked for.
    no_gaps: bool,
}

impl<'c, 's> KerfStarts<'c, 's> {
    /// Those of a sheet on a machine with edge starts.
    pub(super) fn new(
        sheet: &'s Sheet,
        machine: &'s Profile,
        candidates: Option<&'c Candidates<'s>>,
    ) -> Option<Self> {
        let candidates = candidates.filter(|c| c.lever().edge_starts)?;
        let no_gaps = machine.leads.as_ref().is_none_or(|l| l.rules.iter().all(|r| r.overcut >= 0.0));
        // A place of entry is there whatever has tipped beside it by then.
        let edge = sheet.edge().filter(|_| !machine.levers.avoid_tips());
        Some(Self { sheet, machine, candidates, edge, no_gaps })
    }

    /// Adds nodes at the edge of the sheet to a contour with leads. Returns by how many seconds its cheapest node is cheaper than before.
    pub(super) fn add_edge(&self, id: u32, leads: &mut ItemLeads, nodes: &mut Vec<LeadNode>) -> f64 {
        let own = self.sheet.contours.get(id as usize).filter(|_| self.candidates.holds(id));
        let pierced = |c: &&Contour| !leads.start_moving(self.sheet, self.machine, c);
        let (Some(contour), Some(edge)) = (own.filter(pierced).filter(|c| c.inside.is_none()), self.edge)
        else {
            return 0.0;
        };
        let mut found = Vec::new();
        for (k, node) in nodes.iter().enumerate() {
            let nearest = edge.segments.iter().map(|s| s.at(s.nearest(node.entry).0));
            found.extend(nearest.filter_map(|from| {
                let seconds = self.quick(contour, from, node.entry)?;
                let approach = Segment::line(from, node.entry);
                let fits = self.candidates.scrap().leads_in(id, from, node.entry);
                fits.then_some(EdgeStart { node: k, approach, seconds })
            }));
        }
        sort_by(&mut found, |s| [real(s.seconds), s.node as u64, 0]);
        found.truncate(FROM_EDGE);
        leads.add_starts(nodes, &found, self.machine.pierce_time)
    }

    /// The same for a contour without leads, which is pierced at these places, or where contours usually are; `None` if it has no starts at the
    /// edge. With the seconds of the cheapest node.
    pub(super) fn bare_at_edge(
        &self,
        id: u32,
        contour: &Contour,
        places: Option<&[(f64, DVec2)]>,
    ) -> Option<(ItemLeads, Vec<LeadNode>, f64)> {
        self.edge.filter(|_| contour.inside.is_none() && self.candidates.holds(id))?;
        let usual = places.is_none().then(|| entries(&contour.path));
        let places = places.or(usual.as_deref())?;
        let process = self.sheet.process_of(contour, self.machine);
        let (mut leads, mut nodes, least) = ItemLeads::bare(self.machine, &process, &contour.path, places);
        let less = self.add_edge(id, &mut leads, &mut nodes);
        (nodes.len() > places.len()).then_some((leads, nodes, least - less))
    }

    /// Seconds of a straight cut to a contour, if it saves time on piercing.
    fn quick(&self, contour: &Contour, from: DVec2, to: DVec2) -> Option<f64> {
        let process = self.sheet.process_of(contour, self.machine);
        let seconds = cut_time(self.machine, &process, &[Segment::line(from, to)]);
        let length = from.distance(to);
        let fits = length > LEAST
            && length <= self.candidates.lever().reach
            && from != self.machine.home()
            && seconds < self.machine.pierce_time - LEAST;
        fits.then_some(seconds)
    }

    /// The starts on kerfs of all nodes.
    pub(super) fn on_kerfs(&self, items: &[Item], nodes: &[Node]) -> Vec<(NodeId, Start)> {
        let mut all = Vec::new();
        for ((id, contour), item) in (0..).zip(&self.sheet.contours).zip(items) {
            if !self.no_gaps || !self.candidates.holds(id) || self.begins_moving(contour, item) {
                continue;
            }
            let beside: Vec<Neighbour<'_, '_>> =
                self.candidates.beside(id).into_iter().filter(|n| !self.is_rounded(n.contour)).collect();
            for n in item.nodes.clone() {
                let Some(node) = nodes.get(n as usize) else { continue };
                let lead = item.lead(n).map(|l| l.0);
                if lead.is_some_and(|l| l.approach.is_some()) {
                    continue;
                }
                let bare = lead.is_none_or(|l| l.is_bare());
                let mut own: Vec<Start> =
                    beside.iter().filter_map(|other| self.on_kerf(id, contour, node, bare, other)).collect();
                sort_by(&mut own, |s| [real(s.seconds), s.kerf.unwrap_or(u32::MAX).into(), 0]);
                own.truncate(FROM_KERFS);
                all.extend(own.into_iter().map(|start| (n, start)));
            }
        }
        all
    }

    /// The start of a node on the kerf of another contour. `bare`: whether the cut through waste ends on the contour itself.
    fn on_kerf(
        &self,
        id: u32,
        contour: &Contour,
        node: &Node,
        bare: bool,
        other: &Neighbour<'_, '_>,
    ) -> Option<Start> {
        let end = (bare.then_some((&contour.path, node.along)), node.entry);
        let start = |from: DVec2| {
            let seconds = self.quick(contour, from, node.entry)? - self.machine.pierce_time;
            let fits = self.candidates.joins([other.contour, id], (other.path, from), end);
            fits.then_some(Start { kerf: Some(other.contour), from, seconds })
        };
        // The head is moved quickly, and cuts slowly: the nearest place is the best one, if it has room.
        let nearest = other.path.nearest(node.entry).and_then(|(_, place)| start(place));
        nearest.or_else(|| {
            let places = other.places.iter().filter_map(|&(_, place)| start(place));
            places.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
        })
    }

    /// Whether a contour is not pierced anyway.
    fn begins_moving(&self, contour: &Contour, item: &Item) -> bool {
        match &item.leads {
            Some(leads) => leads.start_moving(self.sheet, self.machine, contour),
            None => starts_moving(self.sheet, self.machine, contour, None),
        }
    }

    /// Whether corners of a contour are cut as arcs beside it, so that its kerf is not where it is drawn.
    fn is_rounded(&self, id: u32) -> bool {
        let rule = self.machine.levers.corners.map(|corners| {
            let hole = self.sheet.contours.get(id as usize).is_some_and(|c| c.depth % 2 == 1);
            if hole { corners.hole } else { corners.outer }
        });
        rule.is_some_and(|rule| self.sheet.chosen_corners(id).unwrap_or(rule) == CornerKind::Round)
    }
}
