//! Starts at the edge of the sheet (`levers.chains.edge_starts`): the head moves there with the beam off, and the beam cuts in through the
//! waste without piercing. They are places of entry of their own, beside those at which the contour is pierced.

use super::entries::entries;
use super::leads::{ItemLeads, LeadNode};
use crate::geometry::{DVec2, Path, Segment};
use crate::lead::{Lead, Scrap};
use crate::machine::{Chains, PLANS_ALL_LEVERS, Profile, cut_time, process_time};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Operation, Sheet};

/// Most such entries of a contour, the quickest ones: with the others they are about as many as the gates of the search.
const MOST: usize = 4;
/// Least seconds that one saves on piercing, and least length of its cut, mm: less is rounding.
const LEAST: f64 = 1e-9;

/// The edge of a sheet, and where cuts may lead in from it.
pub(super) struct Edges<'s> {
    machine: &'s Profile,
    lever: Chains,
    edge: &'s Path,
    scrap: Scrap<'s>,
}

impl<'s> Edges<'s> {
    /// Those of a sheet on a machine with edge starts, if its edge is known. What is cut at other speeds and what is marked has
    /// seconds of its own at every start, so sheets with marks or with settings of layers have none.
    pub(super) fn new(sheet: &'s Sheet, machine: &'s Profile) -> Option<Self> {
        let lever = machine.levers.chains.filter(|l| PLANS_ALL_LEVERS && l.edge_starts)?;
        let plain = sheet.layers.iter().all(|l| l.settings.is_none());
        // What begins moving is not pierced.
        if !plain || machine.levers.moving_pierce.is_some() || sheet.contours.iter().any(Contour::is_mark) {
            return None;
        }
        let edge = sheet.edge()?;
        let scrap = Scrap::new(&sheet.contours, lever.clearance, machine.kerf_width, None);
        Some(Self { machine, lever, edge, scrap })
    }

    /// The entries of a contour, if some of them are at the edge: `places` are those at which it is pierced, if they are not the usual ones. With the least seconds of
    /// piercing and cutting.
    pub(super) fn entries(
        &self,
        id: u32,
        contour: &Contour,
        places: Option<&[(f64, DVec2)]>,
    ) -> Option<(ItemLeads, Vec<LeadNode>, f64)> {
        let once = contour.pass == 0 && contour.next_pass.is_none() && self.machine.cut.passes == 1;
        let is_plain = contour.path.closed && contour.operation == Operation::Cut && !contour.self_crossing;
        if contour.inside.is_some() || !once || !is_plain {
            return None;
        }
        let usual = places.is_none().then(|| entries(&contour.path));
        let places = places.or(usual.as_deref()).unwrap_or_default();
        let cut = |along: f64| {
            let path = contour.path.starting_at(along).segments;
            process_time(self.machine, &self.machine.cut, false, &path)
        };
        let mut from_edge: Vec<(f64, f64, Segment)> = Vec::new();
        for &(along, entry) in places {
            for line in self.edge.segments.iter().map(|s| Segment::line(s.at(s.nearest(entry).0), entry)) {
                let length = line.length();
                let seconds = cut_time(self.machine, &self.machine.cut, &[line]);
                let fits = length > LEAST
                    && length <= self.lever.reach
                    && line.start() != self.machine.home()
                    && seconds < self.machine.pierce_time - LEAST
                    && self.scrap.leads_in(id, line.start(), entry);
                from_edge.extend(fits.then_some((seconds, along, line)));
            }
        }
        if from_edge.is_empty() {
            return None;
        }
        sort_by(&mut from_edge, |e| [real(e.0), real(e.1), 0]);
        from_edge.truncate(MOST);
        let pierced = places.iter().map(|&(along, entry)| {
            let node = LeadNode { along, entry, exit: entry };
            (node, Lead::default(), self.machine.pierce_time + cut(along))
        });
        let led = from_edge.into_iter().map(|(seconds, along, line)| {
            let node = LeadNode { along, entry: line.start(), exit: line.end() };
            let lead = Lead { lead_in: vec![line], from_edge: true, ..Lead::default() };
            (node, lead, seconds + cut(along))
        });
        let all: Vec<_> = pierced.chain(led).collect();
        let least = all.iter().map(|a| a.2).fold(f64::INFINITY, f64::min);
        let (mut nodes, mut leads) = (Vec::with_capacity(all.len()), Vec::with_capacity(all.len()));
        for (node, lead, seconds) in all {
            nodes.push(node);
            leads.push((lead, seconds - least));
        }
        Some((ItemLeads::without_rules(leads), nodes, least))
    }
}
