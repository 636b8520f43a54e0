//! Machines with leads, and "plan, then attach leads". `benches/solve` includes this file.
#![allow(dead_code, unreachable_pub, reason = "shared by tests and a bench, each of which uses its part")]
#![allow(clippy::unwrap_used, reason = "test data")]

use kerfway::machine::{LeadKind, LeadRule, LeadShape, LeadSide, Leads, Profile, preset};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;
use kerfway::solve::{Solution, Stop};
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

/// The cost of a path that was planned without leads, with leads at the places nearest to its entries.
pub fn attached(with: &Problem, without: &Problem, planned: &Solution) -> f64 {
    let stops = planned.stops.iter().map(|stop| {
        let item = without.nodes[stop.node as usize].item as usize;
        let (before, after) = (&without.items[item], &with.items[item]);
        if after.leads.is_none() {
            let node = after.nodes.start + (stop.node - before.nodes.start);
            return Stop { node, ..*stop };
        }
        let length = before.track.as_ref().unwrap().length();
        let off = |n: u32| {
            let d = (with.nodes[n as usize].along - stop.along).abs();
            d.min(length - d)
        };
        let nearest = after.nodes.clone().min_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap();
        Stop::at(with, nearest)
    });
    Solution::new(with, stops.collect()).cost
}
