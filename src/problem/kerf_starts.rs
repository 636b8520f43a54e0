//! Starts without piercing (`levers.chains.edge_starts`): the head moves to a kerf, or to the edge of the sheet, with the beam off, and the beam
//! cuts from there through waste to a contour.
//!
//! They are places of entry of their own, beside those at which the contour is pierced. Those on the kerf of another contour may be used
//! once that one is cut (`starts.rs`). Skeleton cuts begin where they meet the edge or each other (`skeleton_starts.rs`).

use super::chains::{Candidates, Neighbour};
use super::entries::entries;
use super::leads::{ItemLeads, KerfStart, LeadNode};
use crate::geometry::{DVec2, Path, Segment};
use crate::lead::{Lead, Scrap};
use crate::machine::{CornerKind, Profile, cut_time};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Sheet};

/// Most starts of a contour at the edge of the sheet, the quickest ones.
const FROM_EDGE: usize = 4;
/// Most starts on the kerf of each other contour, and on all of them: they differ in where the contour is left. More of them make the
/// search slower than they make plans better.
const FROM_KERF: usize = 3;
const FROM_KERFS: usize = 12;
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

/// A contour without leads that has starts.
pub(super) struct BareStarts {
    pub(super) leads: ItemLeads,
    pub(super) nodes: Vec<LeadNode>,
    /// Seconds of the cheapest node.
    pub(super) least: f64,
    /// The nodes that begin on kerfs, by their numbers in the item, each with the contour of the kerf.
    pub(super) kerfs: Vec<(u32, u32)>,
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
        Some(Self { sheet, machine, candidates, edge: sheet.edge(), no_gaps })
    }

    /// Adds its starts to a contour with leads. Returns by how many seconds its cheapest node is cheaper than before, and the nodes that
    /// begin on kerfs, by their numbers in the item, each with the contour of the kerf.
    pub(super) fn add(
        &self,
        id: u32,
        leads: &mut ItemLeads,
        nodes: &mut Vec<LeadNode>,
    ) -> (f64, Vec<(u32, u32)>) {
        let own = self.sheet.contours.get(id as usize).filter(|_| self.candidates.holds(id));
        let pierced = |c: &&Contour| !leads.start_moving(self.sheet, self.machine, c);
        let Some(contour) = own.filter(pierced) else { return (0.0, Vec::new()) };
        let mut starts = self.at_edge(id, contour, nodes);
        if self.no_gaps {
            starts.extend(self.on_kerfs(id, contour, nodes, &leads.all()));
        }
        let kerfs = (0..).skip(nodes.len()).zip(&starts).filter_map(|(k, s)| Some((k, s.kerf?))).collect();
        (leads.add_starts(nodes, &starts, self.machine.pierce_time), kerfs)
    }

    /// The same for a contour without leads, which is pierced at these places, or where contours usually are; `None` if it has no starts.
    pub(super) fn bare(
        &self,
        id: u32,
        contour: &Contour,
        places: Option<&[(f64, DVec2)]>,
    ) -> Option<BareStarts> {
        let usual = places.is_none().then(|| entries(&contour.path));
        let places = places.or(usual.as_deref()).filter(|_| self.candidates.holds(id))?;
        let process = self.sheet.process_of(contour, self.machine);
        let (mut leads, mut nodes, least) = ItemLeads::bare(self.machine, &process, &contour.path, places);
        let (less, kerfs) = self.add(id, &mut leads, &mut nodes);
        (nodes.len() > places.len()).then_some(BareStarts { leads, nodes, least: least - less, kerfs })
    }

    /// A straight cut to a node, if it saves time on piercing.
    fn quick(&self, contour: &Contour, node: usize, from: DVec2, to: DVec2) -> Option<KerfStart> {
        let approach = Segment::line(from, to);
        let length = approach.length();
        let seconds = cut_time(self.machine, &self.sheet.process_of(contour, self.machine), &[approach]);
        let fits = length > LEAST
            && length <= self.candidates.lever().reach
            && from != self.machine.home()
            && seconds < self.machine.pierce_time - LEAST;
        fits.then_some(KerfStart { node, approach, kerf: None, seconds })
    }

    fn at_edge(&self, id: u32, contour: &Contour, nodes: &[LeadNode]) -> Vec<KerfStart> {
        let Some(edge) = self.edge.filter(|_| contour.inside.is_none()) else { return Vec::new() };
        let mut found = Vec::new();
        for (k, node) in nodes.iter().enumerate() {
            let nearest = edge.segments.iter().map(|s| s.at(s.nearest(node.entry).0));
            let starts = nearest.filter_map(|from| self.quick(contour, k, from, node.entry));
            found.extend(starts.filter(|s| self.scrap().leads_in(id, s.approach.start(), s.approach.end())));
        }
        sort_by(&mut found, |s| [real(s.seconds), s.node as u64, 0]);
        found.truncate(FROM_EDGE);
        found
    }

    fn on_kerfs(&self, id: u32, contour: &Contour, nodes: &[LeadNode], leads: &[Lead]) -> Vec<KerfStart> {
        let mut found: Vec<(usize, KerfStart)> = Vec::new();
        for Neighbour { contour: kerf, path, places } in self.candidates.beside(id) {
            if self.is_rounded(kerf) {
                continue;
            }
            let mut own: Vec<KerfStart> = Vec::new();
            for (k, (node, lead)) in nodes.iter().zip(leads).enumerate() {
                let from = |from: DVec2| {
                    let start = self.quick(contour, k, from, node.entry)?;
                    let bare = lead.is_bare().then_some((&contour.path, node.along));
                    let fits = self.candidates.joins([kerf, id], (path, from), (bare, node.entry));
                    fits.then_some(KerfStart { kerf: Some(kerf), ..start })
                };
                // The head is moved quickly, and cuts slowly: the nearest place is the best one, if it has room.
                let nearest = path.nearest(node.entry).and_then(|(_, place)| from(place));
                own.extend(nearest.or_else(|| {
                    let others = places.iter().filter_map(|&(_, place)| from(place));
                    others.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
                }));
            }
            sort_by(&mut own, |s| [real(s.seconds), s.node as u64, 0]);
            own.truncate(FROM_KERF);
            found.extend(own.into_iter().enumerate());
        }
        // The quickest of each kerf come first.
        sort_by(&mut found, |(place, s)| [*place as u64, real(s.seconds), s.node as u64]);
        found.truncate(FROM_KERFS);
        found.into_iter().map(|f| f.1).collect()
    }

    /// Whether corners of a contour are cut as arcs beside it, so that its kerf is not where it is drawn.
    fn is_rounded(&self, id: u32) -> bool {
        let rule = self.machine.levers.corners.map(|corners| {
            let hole = self.sheet.contours.get(id as usize).is_some_and(|c| c.depth % 2 == 1);
            if hole { corners.hole } else { corners.outer }
        });
        rule.is_some_and(|rule| self.sheet.chosen_corners(id).unwrap_or(rule) == CornerKind::Round)
    }

    fn scrap(&self) -> &Scrap<'s> {
        self.candidates.scrap()
    }
}
