//! Programs and the checker follow the path of the beam, and quotes the drawing.

use super::made::{KERF, bulged, close, kerfed, machine, spaced, started, thick};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::geometry::DVec2;
use kerfway::job::OutputKind;
use kerfway::machine::{Profile, preset};
use kerfway::plan::{Violation, check};
use kerfway::quote::Material;
use kerfway::sheet::Sheet;
use std::f64::consts::{PI, TAU};

/// What the program burns, against the outlines drawn.
#[test]
fn the_program_keeps_half_a_kerf_from_every_outline() {
    let mut parts = spaced(3, 2, KERF);
    parts.push(rectangle([103.0, 103.0, 4.0, 4.0]));
    for machine in [machine(KERF), thick(KERF)] {
        let job = started(drawing(&parts), machine);
        let program = crate::testkit::gcode::run(&job.output(OutputKind::Gcode).unwrap()).unwrap();
        let burnt: Vec<_> = program.motions().filter(|m| m.beam > 0.0).map(|m| m.path).collect();
        for outline in &parts {
            for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
                for k in 1..20 {
                    let p = a.lerp(*b, f64::from(k) / 20.0);
                    let off = burnt.iter().map(|e| e.distance(p)).fold(f64::INFINITY, f64::min);
                    assert!((off - 0.5 * KERF).abs() <= 0.01, "{p} is {off} mm from the beam");
                }
            }
        }
    }
}

#[test]
fn the_checker_finds_a_beam_on_the_outline_or_beyond_it() {
    let parts = [rectangle([10.0, 20.0, 30.0, 15.0]), rectangle([15.0, 25.0, 8.0, 6.0])];
    let job = kerfed(&parts);
    let (sheet, plan) = (job.beam_sheet(), job.plan().unwrap());
    let violations = |sheet: &Sheet, kerf: f64| check(sheet, &machine(kerf), &plan).err().unwrap_or_default();
    let kerf = |v: &[Violation]| v.iter().any(|v| matches!(v, Violation::Kerf { .. }));
    assert!(violations(sheet, KERF).is_empty());
    // Too wide for these lines, and too narrow.
    assert!(kerf(&violations(sheet, 0.5)));
    assert!(kerf(&violations(sheet, 0.05)));
    // The outline is somewhere else, or on the other side: an outer contour that should have been a hole.
    for drawn in [rectangle([10.1, 20.0, 30.0, 15.0]), rectangle([9.6, 19.6, 30.8, 15.8])] {
        let mut other = sheet.clone();
        other.contours[0].drawn = Some(kerfed(&[drawn]).sheet().contours[0].path.clone());
        assert!(kerf(&violations(&other, KERF)));
    }
}

#[test]
fn quotes_take_areas_from_the_outlines() {
    let mut parts = spaced(3, 3, KERF);
    // Drawn in the middle, last: all of its sides are cut with others.
    let middle = parts.remove(4);
    parts.push(middle);
    parts.push(rectangle([123.0, 112.0, 4.0, 4.0]));
    let job = started(drawing(&parts), thick(KERF));
    let material = Material { thickness: Some(2.0), density: Some(7.85), name: None };
    let quote = job.quote(&material.into()).unwrap();
    assert_eq!(quote.part_count, 9);
    assert!(close(quote.net_area, 9.0 * 200.0 - 16.0), "{}", quote.net_area);
    let groups: Vec<_> = quote.parts.iter().map(|g| (g.count, g.holes, g.net_area)).collect();
    assert_eq!(groups.iter().map(|g| g.0).sum::<u32>(), 9);
    assert!(groups.iter().any(|g| g.1 == 1 && close(g.2, 184.0)), "{groups:?}");
    assert!(close(quote.smallest_hole.unwrap().width, 4.0));
    assert!((quote.cut_length - (4.0 * 3.0 * 20.4 + 4.0 * 3.0 * 10.4 + 4.0 * 3.6)).abs() < 1e-6);
    assert!(quote.layers.iter().all(|l| l.open == 0), "rests are no open contours");
}

/// 24 arcs that turn by 0.7 degrees where they meet. The joins between their offsets, 0.001 mm long, turned any way in the
/// program, where they are rounded: it took 0.3 s longer than planned, and was refused.
#[test]
fn a_program_takes_the_time_planned_where_arcs_turn_a_little() {
    const ARCS: u32 = 24;
    let places = (0..ARCS).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(ARCS)) * 10.0);
    // A little flatter than the circle through their ends.
    let bulge = (0.5 * ((PI / f64::from(ARCS)).sin() * 10.0 / 10.5).asin()).tan();
    let flower: Vec<[f64; 3]> = places.map(|p| [p.x + 20.0, p.y + 20.0, bulge]).collect();
    let machine = Profile { kerf_width: 0.2, ..preset("fibre-3kw-thin").unwrap() };
    let job = started(bulged(&[&flower], &[]), machine);
    assert!(job.beam_sheet().contours[0].path.segments.iter().all(|s| s.length() > 1.0));
    let (program, plan) = (job.preflight().unwrap(), job.plan().unwrap());
    let (takes, planned) = (program.seconds, plan.summary.total_time);
    assert!((takes - planned).abs() < 0.001 * planned, "{takes} s instead of {planned} s");
}
