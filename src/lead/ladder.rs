//! What is tried where the wanted lead does not fit, in a fixed order.
//!
//! 1. the wanted lead at the wanted positions;
//! 2. turned: a line at other angles, an arc with another sweep;
//! 3. moved: at other positions along the contour;
//! 4. shortened, at any position;
//! 5. a line instead of an arc;
//! 6. none.
//!
//! A contour gets the first step at which at least one place fits, and all places that fit at this step become its entries.
//! The lead-out of an entry has a ladder of its own at that place; places with the better lead-out stay.

use super::run::Lead;
use super::scrap::{Joint, Scrap};
use super::shape::{Outwards, Spot, Which};
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{LeadKind, LeadRule, LeadShape};

/// How well a lead fits, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Fit {
    /// As the rule says.
    #[default]
    Wanted,
    /// At another angle or with another sweep.
    Turned,
    /// At another position.
    Moved,
    /// Shorter.
    Shortened,
    /// A line instead of an arc.
    Line,
    /// There is no room.
    None,
}

/// What became of the leads of one contour.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Outcome {
    /// How well its lead-in fits.
    pub lead_in: Fit,
    /// How well its lead-out fits, at the places where the lead-in does.
    pub lead_out: Fit,
    /// Length of the wanted lead-in and of the longest one found, mm.
    pub length: [f64; 2],
    /// Where, mm.
    pub at: DVec2,
}

/// Angles and sweeps that are tried after the wanted one, degrees.
const ANGLES: [f64; 7] = [90.0, 60.0, 120.0, 45.0, 135.0, 30.0, 150.0];
/// Fractions of the wanted lengths that are tried.
const SHORTER: [f64; 3] = [0.7, 0.45, 0.25];

/// Everything that is tried for one contour.
pub(super) struct Ladder<'a, 's> {
    pub(super) scrap: &'a Scrap<'s>,
    pub(super) contour: u32,
    pub(super) path: &'a Path,
    pub(super) rule: &'a LeadRule,
    /// The leads that the rule asks for, limited to their share of a hole.
    pub(super) lead_in: LeadShape,
    pub(super) lead_out: LeadShape,
    /// Centre of the largest circle in a hole.
    pub(super) center: Option<DVec2>,
}

/// A place with its leads.
pub(super) struct Found {
    pub(super) along: f64,
    pub(super) lead: Lead,
    lead_out: Fit,
}

impl Ladder<'_, '_> {
    /// The places with leads, of those `wanted` or of `others` further down the ladder, and how well they fit.
    pub(super) fn climb(&self, wanted: &[f64], others: &[f64]) -> (Vec<Found>, Outcome) {
        let spots = |list: &[f64]| list.iter().filter_map(|&at| Spot::new(self.path, at)).collect::<Vec<_>>();
        let everywhere = spots(wanted);
        let mut wanted = everywhere.clone();
        let at = wanted.first().map_or(DVec2::ZERO, |s| s.at);
        let mut fit = Fit::Wanted;
        let mut found = self.at_all(&wanted, |spot| self.fits(spot, &self.lead_in, Which::In));
        if found.is_empty() && self.lead_in.kind != LeadKind::None {
            // Most places where nothing fits are too near to something for even the shortest line.
            wanted.retain(|s| self.has_room(s));
            fit = Fit::Turned;
            found = self.at_all(&wanted, |spot| self.turned(spot, &self.lead_in, Which::In));
            let mut all = wanted;
            if found.is_empty() {
                fit = Fit::Moved;
                let mut others = spots(others);
                others.retain(|s| self.has_room(s));
                let moved = |spot: &Spot| {
                    let lead = self.fits(spot, &self.lead_in, Which::In);
                    lead.or_else(|| self.turned(spot, &self.lead_in, Which::In))
                };
                found = self.at_all(&others, moved);
                all.extend(others);
            }
            if found.is_empty() {
                fit = Fit::Shortened;
                found = self.at_all(&all, |spot| self.shortened(spot, &self.lead_in, Which::In));
            }
            if found.is_empty() {
                fit = Fit::Line;
                found = self.at_all(&all, |spot| self.line(spot, &self.lead_in, Which::In));
            }
            if found.is_empty() {
                fit = Fit::None;
                found = self.at_all(&everywhere, |_| Some(Outwards::default()));
            }
        }
        let lead_out = found.iter().map(|f| f.lead_out).min().unwrap_or_default();
        found.retain(|f| f.lead_out == lead_out);
        let length = |path: &[Segment]| path.iter().map(Segment::length).sum::<f64>();
        let longest = found.iter().map(|f| length(&f.lead.lead_in)).fold(0.0, f64::max);
        let at = found.first().and_then(|f| self.path.at(f.along)).unwrap_or(at);
        let outcome = Outcome { lead_in: fit, lead_out, length: [self.length(), longest], at };
        (found, outcome)
    }

    /// Length of the wanted lead-in, mm.
    fn length(&self) -> f64 {
        let LeadShape { kind, length, radius, angle } = self.lead_in;
        match kind {
            LeadKind::None => 0.0,
            LeadKind::Line | LeadKind::Center => length,
            LeadKind::Arc => radius * angle,
            LeadKind::LineArc => radius * angle + length,
        }
    }

    /// The places at which `lead_in` finds one, with their lead-outs.
    fn at_all(&self, spots: &[Spot], lead_in: impl Fn(&Spot) -> Option<Outwards>) -> Vec<Found> {
        let found = |spot: &Spot| {
            let lead_in = inwards(&lead_in(spot)?);
            let whole = self.path.length();
            // An overcut or a gap of half of the contour is as much as makes sense.
            let overcut = self.rule.overcut.clamp(-0.5 * whole, 0.5 * whole);
            let exit = Spot::new(self.path, Lead::end(overcut, spot.along, whole)).unwrap_or(*spot);
            let (lead_out, fit) = self.lead_out(&exit);
            Some(Found {
                along: spot.along,
                lead: Lead { lead_in, overcut, lead_out, approach: None },
                lead_out: fit,
            })
        };
        spots.iter().filter_map(found).collect()
    }

    fn lead_out(&self, exit: &Spot) -> (Vec<Segment>, Fit) {
        let (shape, which) = (&self.lead_out, Which::Out);
        if let Some(lead) = self.fits(exit, shape, which) {
            return (lead.path, Fit::Wanted);
        }
        let steps = [
            (Fit::Turned, self.turned(exit, shape, which)),
            (Fit::Shortened, self.shortened(exit, shape, which)),
            (Fit::Line, self.line(exit, shape, which)),
        ];
        let found = steps.into_iter().find_map(|(fit, lead)| Some((lead?.path, fit)));
        found.unwrap_or((Vec::new(), Fit::None))
    }

    fn fits(&self, spot: &Spot, shape: &LeadShape, which: Which) -> Option<Outwards> {
        let lead = spot.lead(shape, which, self.center)?;
        self.scrap.holds(Joint { contour: self.contour, along: spot.along }, &lead).then_some(lead)
    }

    /// Whether the shortest line fits at a place, in the middle of the scrap.
    fn has_room(&self, spot: &Spot) -> bool {
        let size = self.center.map_or(self.lead_in.size(), |c| c.distance(spot.at));
        let length = SHORTER[SHORTER.len() - 1] * size;
        let line = LeadShape { kind: LeadKind::Line, length, angle: spot.middle_angle(), ..self.lead_in };
        self.fits(spot, &line, Which::In).is_some()
    }

    fn turned(&self, spot: &Spot, shape: &LeadShape, which: Which) -> Option<Outwards> {
        if shape.kind == LeadKind::Center {
            return None;
        }
        let line = shape.kind == LeadKind::Line;
        let middle = line.then(|| spot.middle_angle());
        let angles = ANGLES.into_iter().map(f64::to_radians).chain(middle);
        let other = angles.filter(|a| a.total_cmp(&shape.angle).is_ne());
        other.into_iter().find_map(|angle| self.fits(spot, &LeadShape { angle, ..*shape }, which))
    }

    fn shortened(&self, spot: &Spot, shape: &LeadShape, which: Which) -> Option<Outwards> {
        SHORTER.into_iter().find_map(|by| {
            let shorter = match (shape.kind, self.center) {
                // Towards the centre, but not from it.
                (LeadKind::Center, Some(center)) => LeadShape {
                    kind: LeadKind::Line,
                    length: by * center.distance(spot.at),
                    angle: spot.middle_angle(),
                    ..*shape
                },
                _ => shape.scaled(by),
            };
            self.fits(spot, &shorter, which).or_else(|| self.turned(spot, &shorter, which))
        })
    }

    fn line(&self, spot: &Spot, shape: &LeadShape, which: Which) -> Option<Outwards> {
        if !matches!(shape.kind, LeadKind::Arc | LeadKind::LineArc) {
            return None;
        }
        let line =
            LeadShape { kind: LeadKind::Line, length: shape.size(), angle: spot.middle_angle(), ..*shape };
        self.fits(spot, &line, which).or_else(|| self.shortened(spot, &line, which))
    }
}

/// The elements of a lead that is cut towards the contour.
fn inwards(lead: &Outwards) -> Vec<Segment> {
    lead.path.iter().rev().map(Segment::reversed).collect()
}
