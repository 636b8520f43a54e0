//! Lines one kerf apart are cut once.

use super::made::{KERF, bulged, close, kerfed, machine, rounded, spaced, started, thick};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::finding::Code;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::sheet::{CommonCuts, Operation};
use std::f64::consts::PI;

#[test]
fn a_grid_one_kerf_apart_is_a_grid_of_lines() {
    for (m, n) in [(2, 1), (2, 2), (3, 3), (5, 4)] {
        let (w, h) = (20.0 + KERF, 10.0 + KERF);
        let union = (n + 1) as f64 * w * m as f64 + (m + 1) as f64 * h * n as f64;
        for machine in [machine(KERF), thick(KERF)] {
            let grouped = machine.makes_pre_cuts();
            let job = started(drawing(&spaced(m, n, KERF)), machine);
            let plan = job.plan().unwrap();
            assert!((plan.summary.cut_length - union).abs() < 1e-6, "{m} x {n}: {}", plan.summary.cut_length);
            assert_eq!(plan.summary.parts as usize, m * n);
            assert_eq!(job.beam_sheet().groups.len(), 1, "{m} x {n}");
            assert_eq!(job.beam_sheet().groups[0].faces as usize, m * n + 1);
            if grouped {
                assert_eq!(plan.summary.pierces, 1, "{m} x {n}");
            }
        }
        // As the same lines drawn with shared sides.
        let lines: Vec<_> = (0..m * n)
            .map(|k| {
                let (x, y) = ((k % m) as f64, (k / m) as f64);
                rectangle([100.0 - 0.2 + w * x, 100.0 - 0.2 + h * y, w, h])
            })
            .collect();
        let drawn = started(drawing(&lines), thick(0.0)).plan().unwrap().summary;
        let made = started(drawing(&spaced(m, n, KERF)), thick(KERF)).plan().unwrap().summary;
        assert!((drawn.cut_length - made.cut_length).abs() < 1e-6);
        assert!(
            (drawn.total_time - made.total_time).abs() < 1e-6,
            "{} {}",
            drawn.total_time,
            made.total_time
        );
    }
}

#[test]
fn bricks_one_kerf_apart_have_t_junctions() {
    // Three rows of three, shifted by half a brick and half a kerf: overlaps in part.
    let (w, h) = (20.0 + KERF, 8.0 + KERF);
    let row = |y: usize| {
        (0..3).map(move |x| {
            rectangle([50.0 + w * x as f64 + 0.5 * w * (y % 2) as f64, 50.0 + h * y as f64, 20.0, 8.0])
        })
    };
    let bricks: Vec<_> = (0..3).flat_map(row).collect();
    let job = started(drawing(&bricks), thick(KERF));
    let plan = job.plan().unwrap();
    let union = 4.0 * 3.0 * w + 2.0 * 0.5 * w + 12.0 * h;
    assert!((plan.summary.cut_length - union).abs() < 1e-6, "{} {union}", plan.summary.cut_length);
    assert_eq!(
        (job.beam_sheet().groups.len(), job.beam_sheet().groups[0].faces, plan.summary.pierces),
        (1, 10, 1)
    );
    assert_eq!(plan.summary.parts, 9);
}

#[test]
fn sides_that_overlap_in_part_are_cut_once() {
    let parts = [rectangle([0.0, 0.0, 10.0, 30.0]), rectangle([10.0 + KERF, 12.0, 15.0, 40.0])];
    let plan = kerfed(&parts).plan().unwrap();
    // In common: from 12 - 0.2 to 30 + 0.2.
    let wanted = 2.0 * (10.4 + 30.4) + 2.0 * (15.4 + 40.4) - 18.4;
    assert!((plan.summary.cut_length - wanted).abs() < 1e-6, "{} {wanted}", plan.summary.cut_length);
}

#[test]
fn arcs_one_kerf_apart_are_one() {
    // A disc in a round hole of a plate, and one more kerf around.
    let plate = rounded([0.0, 0.0, 60.0, 60.0, 5.0]);
    let job = started(bulged(&[&plate], &[[30.0, 30.0, 10.0], [30.0, 30.0, 10.0 - KERF]]), machine(KERF));
    let plan = job.plan().unwrap();
    let wanted = 4.0 * 60.4 - 8.0 * 5.2 + 2.0 * PI * 5.2 + 2.0 * PI * (10.0 - 0.5 * KERF);
    assert!((plan.summary.cut_length - wanted).abs() < 1e-6, "{} {wanted}", plan.summary.cut_length);
    assert_eq!(job.beam_sheet().parts.len(), 2);
    let saved: Vec<_> =
        job.run().unwrap().findings.iter().filter(|f| f.code == Code::OverlapRemoved).collect();
    assert!(saved[0].message.contains("61.575 mm"), "{saved:?}");
}

/// Ids stay; what a contour is left in comes last.
#[test]
fn contours_keep_their_ids() {
    // The last one is drawn in the middle: others cut all of its sides but one, which it gets back.
    let mut parts = spaced(3, 3, KERF);
    let middle = parts.remove(4);
    parts.push(middle);
    parts.push(rectangle([123.0, 112.0, 4.0, 4.0]));
    for options in [CommonCuts::Best, CommonCuts::Off] {
        let load = LoadOptions { common_cuts: options, ..LoadOptions::default() };
        let mut job = Job::load(drawing(&parts), "ids.dxf", &load).unwrap();
        let machine = MachineChoice::Profile(Box::new(thick(KERF)));
        job.start(&PlanOptions { machine, ..PlanOptions::default() }).unwrap();
        job.run_mut().unwrap().step(1_000);
        let plan = job.plan().unwrap();
        let (drawn, worked) = (job.sheet(), job.beam_sheet());
        for (a, b) in drawn.contours.iter().zip(&worked.contours) {
            assert_eq!((Some(&a.path), a.layer, a.depth), (b.drawn.as_ref(), b.layer, b.depth));
            assert!(close(a.area, b.area));
        }
        let last = &worked.contours[8];
        assert!(last.operation == Operation::Cut && close(last.length, 20.4) && last.outline.is_some());
        assert_eq!(plan.summary.parts, 9);
        let all: f64 = worked.contours.iter().filter(|c| c.is_processed()).map(|c| c.length).sum();
        assert!((all - (4.0 * 3.0 * 20.4 + 4.0 * 3.0 * 10.4 + 4.0 * 3.6)).abs() < 1e-6, "{all}");
    }
    // Between two others, drawn last: above and below something is left.
    let row = [0.0, 20.8, 10.4].map(|x| rectangle([x, 0.0, 10.0, 5.0]));
    let job = kerfed(&row);
    let worked = job.beam_sheet();
    assert_eq!((job.sheet().contours.len(), worked.contours.len()), (3, 4));
    assert_eq!(worked.contours.iter().map(|c| c.path.closed).collect::<Vec<_>>(), [true, true, false, false]);
    assert!(close(worked.contours[2].area, 50.0) && close(worked.contours[3].area, 0.0));
    assert!(worked.contours[2].outline.is_some() && worked.contours[3].outline.is_none());
    assert_eq!(worked.parts[2].holes, [3], "worked with its part");
    assert!(worked.contours[2..].iter().all(|c| close(c.length, 10.4)));
}
