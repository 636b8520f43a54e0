//! What lies in what, at any depth: rings around each other, a contour that crosses some of them, and one in a notch.
#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

use super::planted::{planned, take_out};
use crate::testkit::sheets::{Builder, circle, machine, p, polygon};
use kerfway::plan::{self, Violation};
use kerfway::sheet::Sheet;

const RINGS: u32 = 40;

/// The radius of a ring, 83 down to 5.
fn radius(ring: u32) -> f64 {
    83.0 - 2.0 * f64::from(ring)
}

/// The distance from the middle and the radius of a circle across the rings with radii from 26 to 34.
const ACROSS: (f64, f64) = (30.0, 4.5);

/// 0 to 39 rings, 40 a circle across some of them, 41 a triangle beside them, in the box of the largest.
fn rings() -> Sheet {
    let middle = p(200.0, 200.0);
    let mut b = Builder::new();
    for ring in 0..RINGS {
        b.cut(circle(middle, radius(ring)), ring.checked_sub(1));
    }
    let smallest = (0..RINGS).rev().find(|&ring| holds_across(ring));
    b.cut(circle(middle + p(ACROSS.0, 0.0), ACROSS.1), smallest);
    let corner = middle + p(80.0, 80.0);
    b.cut(polygon(&[corner, corner + p(3.0, 0.0), corner + p(0.0, 3.0)]), None);
    b.sheet
}

fn holds_across(ring: u32) -> bool {
    radius(ring) > ACROSS.0 + ACROSS.1
}

#[test]
fn of_rings_around_each_other_everything_inside_comes_before_each() {
    let (sheet, machine) = (rings(), machine("co2-100w"));
    let good = planned(&sheet, &machine);
    assert_eq!(plan::check(&sheet, &machine, &good), Ok(()));
    for outer in 0..RINGS {
        let mut plan = good.clone();
        let ring = take_out(&mut plan.moves, outer);
        plan.moves.splice(0..0, ring);
        let parts = plan.summary.parts;
        plan.summary = plan::evaluate(&plan.moves, &sheet, &machine);
        plan.summary.parts = parts;
        let found = plan::check(&sheet, &machine, &plan).err().unwrap_or_default();
        let free: Vec<Violation> =
            found.into_iter().filter(|v| matches!(v, Violation::CutFree { .. })).collect();
        let inside = (outer + 1..RINGS).chain(holds_across(outer).then_some(RINGS));
        let wanted: Vec<Violation> = inside.map(|inner| Violation::CutFree { outer, inner }).collect();
        assert_eq!(free, wanted, "ring {outer} first");
    }
}
