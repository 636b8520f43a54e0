//! Machines with leads.

use kerfway::machine::{LeadKind, LeadRule, LeadShape, LeadSide, Leads, Profile, preset};
use kerfway::sheet::Sheet;
use std::f64::consts::FRAC_PI_2;

/// A lead of 3 mm and 1.5 mm at right angles.
pub fn shape(kind: LeadKind) -> LeadShape {
    LeadShape { kind, length: 3.0, radius: 1.5, angle: FRAC_PI_2 }
}

/// Small holes from their centres, other holes and parts by `kind` in and out, with an overcut.
pub fn leads(kind: LeadKind, clearance: f64, overcut: f64) -> Leads {
    let small = LeadRule {
        side: Some(LeadSide::Hole),
        diameter_below: Some(6.0),
        lead_in: shape(LeadKind::Center),
        overcut,
        ..LeadRule::default()
    };
    let others = LeadRule { lead_in: shape(kind), lead_out: shape(kind), overcut, ..LeadRule::default() };
    Leads { clearance, rules: vec![small, others] }
}

/// The machine with these leads.
pub fn with_leads(machine: Profile, leads: Leads) -> Profile {
    Profile { leads: Some(leads), ..machine }
}

/// The sheet with outlines of parts counter-clockwise and holes clockwise, as sheets are read.
pub fn oriented(mut sheet: Sheet) -> Sheet {
    for c in sheet.contours.iter_mut().filter(|c| c.path.closed) {
        if (c.path.area() > 0.0) != c.depth.is_multiple_of(2) {
            c.path = c.path.reversed();
        }
    }
    sheet
}

/// A machine with one rule for everything.
pub fn one_rule(name: &str, clearance: f64, rule: LeadRule) -> Profile {
    with_leads(preset(name).unwrap(), Leads { clearance, rules: vec![rule] })
}
