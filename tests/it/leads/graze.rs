//! Leads that come back to their own contour near the place where they join it: past a spike, or past a step.

use crate::testkit::exact::planned;
use crate::testkit::leads::{one_rule, oriented, shape};
use crate::testkit::sheets::{Builder, p, polygon};
use kerfway::geometry::{DVec2, Segment};
use kerfway::lead::{Fit, Lead, Planner};
use kerfway::machine::{LeadKind, LeadRule, Profile};
use kerfway::plan::{self, Leads, Move, Violation};
use kerfway::sheet::Sheet;

/// The end of the spike, 1.5 mm below the lower side of the part and `off` mm beside x = 60.
fn spike(off: f64) -> DVec2 {
    p(60.0 + off, 48.5)
}

/// A part with a spike on its lower side, which leans over the place (60, 50) where it is entered.
fn part(off: f64) -> Sheet {
    let corners = [
        p(50.0, 50.0),
        p(61.2, 50.0),
        spike(off),
        p(61.4, 50.0),
        p(80.0, 50.0),
        p(80.0, 80.0),
        p(50.0, 80.0),
    ];
    let mut b = Builder::new();
    b.cut(polygon(&corners), None);
    oriented(b.sheet)
}

/// A straight lead of 3 mm at right angles, with a clearance of 0.5 mm.
fn machine() -> Profile {
    one_rule("co2-100w", 0.5, LeadRule { lead_in: shape(LeadKind::Line), ..LeadRule::default() })
}

/// How near a lead comes to the spike.
fn nearest(lead: &Lead, off: f64) -> f64 {
    lead.lead_in.iter().map(|s| s.nearest(spike(off)).1.sqrt()).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_lead_keeps_its_distance_from_a_spike_of_its_own_contour() {
    for (off, wanted) in [(0.002, false), (0.2, false), (0.45, false), (0.55, true)] {
        let (sheet, machine) = (part(off), machine());
        let leads = Planner::new(&sheet, &machine).unwrap().leads(0, &[10.0]).unwrap();
        assert_eq!(leads.outcome.lead_in == Fit::Wanted, wanted, "{off}: {:?}", leads.outcome);
        // From half of its length on it keeps the clearance, and from a quarter on half of the 0.75 mm that it is deep there.
        assert!(leads.entries.iter().all(|e| nearest(&e.lead, off) >= 0.37), "{off}: {leads:?}");
    }
}

#[test]
fn a_lead_that_grazes_its_own_part_is_found() {
    for (off, expected) in [(0.002, Some("comes back to its contour")), (0.6, None)] {
        let (sheet, machine) = (part(off), machine());
        let mut plan = planned(&sheet, &machine);
        let lead = Lead { lead_in: vec![Segment::line(p(60.0, 47.0), p(60.0, 50.0))], ..Lead::default() };
        let run = lead.run(&sheet.contours[0].path, 10.0);
        for m in &mut plan.moves {
            if let Move::Cut { path, leads, .. } = m {
                *path = run.path.clone();
                *leads = Leads { lead_in: run.lead_in, ..Leads::default() };
            }
        }
        let found = plan::check(&sheet, &machine, &plan).unwrap_err();
        let of_leads = found
            .into_iter()
            .find_map(|v| if let Violation::Lead { what, .. } = v { Some(what) } else { None });
        assert_eq!(of_leads, expected, "{off}");
    }
}
