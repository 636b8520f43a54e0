//! The leads of the contours of a sheet: which rule, which places, which leads.

use super::inscribed::inscribed;
use super::ladder::{Ladder, Outcome};
use super::run::Lead;
use super::scrap::Scrap;
use super::shape::Spot;
use crate::geometry::Path;
use crate::machine::{LeadKind, LeadPosition, LeadRule, LeadShape, LeadSide, Leads, Profile};
use crate::sheet::{Contour, Operation, Sheet};

/// Number of evenly spaced places that are tried in addition, where the entries of a contour have no room.
const MORE_PLACES: usize = 32;

/// Finds the leads of contours.
pub struct Planner<'s> {
    pub(super) sheet: &'s Sheet,
    machine: &'s Profile,
    pub(super) leads: Leads,
    pub(super) scrap: Scrap<'s>,
}

/// The leads of one contour.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourLeads {
    /// The places where the contour may be entered, in order along it.
    pub entries: Vec<Entry>,
    /// How well its leads fit.
    pub outcome: Outcome,
}

/// A place where a contour may be entered by a lead.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Arc length from the contour's start, mm.
    pub along: f64,
    /// The lead there.
    pub lead: Lead,
}

impl<'s> Planner<'s> {
    /// The planner for a sheet; `None` if the machine has no leads, and cuts nothing again.
    pub fn new(sheet: &'s Sheet, machine: &'s Profile) -> Option<Self> {
        let leads = machine.leads.clone().unwrap_or_default();
        if !sheet.asks_for_leads(machine) && machine.levers.cut_again(f64::INFINITY) <= 0.0 {
            return None;
        }
        // A job that does not lie on the bed is reported elsewhere.
        let bed = machine.bed().filter(|bed| bed.contains_box(&sheet.bounds));
        let scrap = Scrap::new(&sheet.contours, Sheet::lead_clearance(machine), machine.kerf_width, bed);
        Some(Self { sheet, machine, leads, scrap })
    }

    /// The leads of a contour that is entered at one of `places` (mm from its start); `None` if it has none: it is open,
    /// not cut, cut in several passes, crosses itself, or no rule asks for anything there.
    pub fn leads(&self, contour: u32, places: &[f64]) -> Option<ContourLeads> {
        let again = self.machine.levers.cut_again(self.sheet.contours.get(contour as usize)?.length);
        self.by_rule(contour, places, |asked| match asked {
            // What is pierced at speed is cut again, except for a gap, which is pierced at rest.
            Some(rule) if rule.overcut >= 0.0 => {
                Some(LeadRule { overcut: rule.overcut.max(again), ..rule.clone() })
            }
            Some(rule) => Some(rule.clone()),
            None => Some(LeadRule { overcut: again, ..LeadRule::default() }),
        })
    }

    /// The leads of a contour that is pierced at rest, whatever the levers of the machine. `overcut`: instead of that of the
    /// rule, mm.
    pub fn leads_at_rest(&self, contour: u32, places: &[f64], overcut: Option<f64>) -> Option<ContourLeads> {
        self.by_rule(contour, places, |asked| {
            asked.map(|rule| LeadRule { overcut: overcut.unwrap_or(rule.overcut), ..rule.clone() })
        })
    }

    /// The leads by the rule that `rule` makes of the machine's.
    fn by_rule(
        &self,
        contour: u32,
        places: &[f64],
        rule: impl Fn(Option<&LeadRule>) -> Option<LeadRule>,
    ) -> Option<ContourLeads> {
        let known = self.sheet.contours.get(contour as usize)?;
        let path = &known.path;
        if !path.closed || known.operation != Operation::Cut || known.self_crossing || known.length <= 0.0 {
            return None;
        }
        if self.sheet.process_of(known, self.machine).passes > 1 {
            return None;
        }
        let hole = !known.depth.is_multiple_of(2);
        let side = if hole { LeadSide::Hole } else { LeadSide::Outer };
        let asked = self.leads.rule(side, known.bounds.size().max_element(), known.length);
        let base = || asked.or(self.leads.rules.first()).cloned().unwrap_or_default();
        let own = self.sheet.chosen_lead(contour).map(|kind| base().with_lead_in(kind));
        let rule = rule(own.as_ref().or(asked))?;
        let kinds = [rule.lead_in.kind, rule.lead_out.kind];
        if kinds == [LeadKind::None; 2] && rule.overcut.total_cmp(&0.0).is_eq() {
            return None;
        }
        let (mut lead_in, mut lead_out, mut center) = (rule.lead_in, rule.lead_out, None);
        if hole {
            let from_center = lead_in.kind == LeadKind::Center;
            let most = lead_in.size().max(lead_out.size());
            let enough = if from_center { f64::INFINITY } else { most / rule.max_share };
            if let Some((middle, radius)) = inscribed(path, enough) {
                center = from_center.then_some(middle);
                lead_in = limited(lead_in, rule.max_share * radius);
                lead_out = limited(lead_out, rule.max_share * radius);
            }
        }
        let ladder = Ladder { scrap: &self.scrap, contour, path, rule: &rule, lead_in, lead_out, center };
        let is_arc = kinds.iter().any(|k| matches!(k, LeadKind::Arc | LeadKind::LineArc));
        let [wanted, others] = places_of(known, places, rule.position, is_arc);
        let (found, outcome) = ladder.climb(&wanted, &others);
        let entries = found.into_iter().map(|f| Entry { along: f.along, lead: f.lead }).collect();
        Some(ContourLeads { entries, outcome })
    }
}

/// The same lead, no larger than `most` mm. A lead from the centre has the length of the hole's radius in any case.
fn limited(shape: LeadShape, most: f64) -> LeadShape {
    let size = shape.size();
    if shape.kind == LeadKind::Center || size <= most { shape } else { shape.scaled(most / size) }
}

/// The places that the rule wants, and all others that are tried if none of these has room.
fn places_of(contour: &Contour, entries: &[f64], position: LeadPosition, is_arc: bool) -> [Vec<f64>; 2] {
    let path = &contour.path;
    let spots = |list: &[f64]| list.iter().filter_map(|&a| Spot::new(path, a)).collect::<Vec<_>>();
    let corners = || spots(&joints(path)).into_iter().filter(Spot::is_corner).map(|s| s.along);
    let mut wanted: Vec<f64> = match position {
        LeadPosition::Any => entries.to_vec(),
        LeadPosition::Corner => corners().collect(),
        LeadPosition::Side => middles(path),
    };
    if wanted.is_empty() {
        wanted = entries.to_vec();
    }
    if is_arc {
        // An arc cannot be tangent in a corner that turns into the scrap: the element after it has a middle.
        let ends = joints(path);
        for spot in spots(&wanted).iter().filter(|s| s.is_concave()) {
            let next = ends.partition_point(|&e| e <= spot.along + 1e-9);
            let end = ends.get(next).copied().unwrap_or(contour.length);
            wanted.push(0.5 * (spot.along + end));
        }
    }
    let spacing = contour.length / MORE_PLACES as f64;
    let more = (0..MORE_PLACES).map(|k| (k as f64 + 0.5) * spacing);
    let others = more.chain(entries.iter().copied());
    let others: Vec<f64> = others.filter(|a| !wanted.iter().any(|w| (w - a).abs() < 1e-6)).collect();
    [wanted, others].map(sorted)
}

fn sorted(mut places: Vec<f64>) -> Vec<f64> {
    crate::order::sort_by(&mut places, |&a| [crate::order::real(a), 0, 0]);
    places.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    places
}

/// Arc length at which each element with a length starts, mm.
fn joints(path: &Path) -> Vec<f64> {
    let mut at = 0.0;
    let mut all = Vec::with_capacity(path.segments.len());
    for length in path.segments.iter().map(crate::geometry::Segment::length).filter(|&l| l > 0.0) {
        all.push(at);
        at += length;
    }
    all
}

/// The middles of the elements, mm from the start.
fn middles(path: &Path) -> Vec<f64> {
    let joints = joints(path);
    let ends = joints.iter().copied().skip(1).chain([path.length()]);
    joints.iter().zip(ends).map(|(a, b)| 0.5 * (a + b)).collect()
}
