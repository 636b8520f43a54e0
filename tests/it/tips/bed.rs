//! Ways around tipped pieces stay on the bed.

use super::{all_tip, tipping};
use crate::testkit::exact::planned;
use crate::testkit::sheets::{Builder, p, rectangle};
use kerfway::geometry::DVec2;
use kerfway::machine::{Profile, Start};
use kerfway::output::{SheetFacts, WorkOrder};
use kerfway::plan::{self, Move, Plan, Way};
use kerfway::sheet::{Pin, Sheet};

/// Three squares of 40 mm in a row, 30 mm apart: the middle one is cut first, and the head then has to get past it.
fn row() -> Sheet {
    let mut b = Builder::new();
    for k in 0..3 {
        b.cut(rectangle(p(50.0 + 70.0 * f64::from(k), 5.0), p(40.0, 40.0)), None);
    }
    b.sheet.contours[1].pin = Pin::First;
    b.sheet
}

/// A machine on which a lift takes longer than a way around, with a bed from y = 0 up to `top`.
fn machine(top: f64) -> Profile {
    Profile { bed: Some([0.0, 0.0, 300.0, top]), ..tipping(20.0, all_tip()) }
}

fn way_points(plan: &Plan) -> Vec<DVec2> {
    let around = |m: &Move| if let Move::Air { to, way: Way::Around } = m { Some(*to) } else { None };
    plan.moves.iter().filter_map(around).collect()
}

#[test]
fn ways_around_tipped_pieces_stay_on_the_bed() {
    let sheet = row();
    // Without a bed, the head goes around where that is shortest: the pieces reach from y 5 to 45, and the nozzle 8 mm farther.
    let free = planned(&sheet, &Profile { bed: None, ..machine(0.0) });
    assert!(way_points(&free).iter().any(|w| w.y < 0.0), "{:?}", way_points(&free));
    for top in [50.0, 55.0, 100.0] {
        let machine = machine(top);
        let plan = planned(&sheet, &machine);
        assert_eq!(plan::check(&sheet, &machine, &plan), Ok(()), "{top}");
        let off: Vec<DVec2> =
            way_points(&plan).into_iter().filter(|w| !(0.0..=top).contains(&w.y) || w.x < 0.0).collect();
        assert_eq!(off, [], "{top}");
        // Between y 0 and 50 there is no room beside the pieces: the head is lifted.
        assert_eq!(way_points(&plan).is_empty(), top < 53.0, "{top}");
        assert!(plan.summary.detours + plan.summary.lifts > 0, "{top}");
    }
}

#[test]
fn a_way_around_that_leaves_the_bed_is_found() {
    let sheet = row();
    let plan = planned(&sheet, &Profile { bed: None, ..machine(0.0) });
    let found = plan::check(&sheet, &machine(55.0), &plan).err().unwrap_or_default();
    let sentences: Vec<String> = found.iter().map(ToString::to_string).collect();
    let off = |(step, m): (usize, &Move)| match m {
        Move::Air { to, way: Way::Around } if to.y < 0.0 => {
            Some(format!("move {step}: the head goes around a tipped piece beyond the bed, at {to}"))
        }
        _ => None,
    };
    let off: Vec<String> = plan.moves.iter().enumerate().filter_map(off).collect();
    assert!(off.len() >= 2, "{:?}", plan.moves);
    assert_eq!(sentences, off);
}

/// The figure of the preflight was that of the cuts alone.
#[test]
fn the_preflight_says_that_the_head_leaves_the_bed_between_cuts() {
    let sheet = row();
    let free = Profile { bed: None, ..machine(0.0) };
    let plan = planned(&sheet, &free);
    let fits = |bed: [f64; 4]| {
        let order = WorkOrder {
            version: String::new(),
            name: "row".into(),
            sha256: String::new(),
            material: None,
            start: Start::Absolute,
            machine: Profile { bed: Some(bed), ..free.clone() },
            plan: plan.clone(),
            sheet: SheetFacts::of(&sheet),
            remainder: Vec::new(),
        };
        let check = order.preflight().unwrap();
        (check.passed, check.fits_bed)
    };
    assert_eq!(fits([-20.0, -20.0, 300.0, 80.0]), (true, Some(true)));
    // Everything that is cut lies on this bed, and a way around does not.
    assert_eq!(fits([0.0, 0.0, 300.0, 55.0]), (true, Some(false)));
}
