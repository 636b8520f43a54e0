//! Kerf width: the beam follows outlines half a kerf aside, and what lies one kerf apart is cut once.
#![cfg(not(target_arch = "wasm32"))]
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    dead_code,
    unreachable_pub,
    reason = "a test fails by panicking"
)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours; the product's arithmetic is not to judge itself"
)]

#[path = "support/gcode.rs"]
mod gcode;
#[path = "support/outlines.rs"]
mod outlines;
#[path = "support/paths.rs"]
mod paths;
#[path = "support/plates.rs"]
mod plates;
#[path = "support/rng.rs"]
mod rng;

use kerfway::finding::{Code, Finding, Severity};
use kerfway::geometry::{DVec2, Path, Segment};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{Profile, preset};
use kerfway::sheet::{CommonCuts, Operation};
use outlines::drawing;
use plates::rectangle;
use rng::Rng;
use std::f64::consts::PI;

const KERF: f64 = 0.4;

fn machine(kerf_width: f64) -> Profile {
    Profile { kerf_width, ..preset("co2-100w").unwrap() }
}

fn thick(kerf_width: f64) -> Profile {
    Profile { kerf_width, ..plates::thick() }
}

fn started(bytes: Vec<u8>, machine: Profile) -> Job {
    let mut job = Job::load(bytes, "kerf.dxf", &LoadOptions::default()).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, seed: 1, ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(2_000);
    // Checked.
    job.plan().unwrap();
    job
}

fn kerfed(outlines: &[Vec<DVec2>]) -> Job {
    started(drawing(outlines), machine(KERF))
}

/// Polylines of x, y and bulge, and circles of x, y and radius, as a drawing.
fn bulged(polylines: &[&[[f64; 3]]], circles: &[[f64; 3]]) -> Vec<u8> {
    let mut text =
        String::from("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    for line in polylines {
        text += &format!("0\nLWPOLYLINE\n8\n0\n90\n{}\n70\n1\n", line.len());
        for [x, y, b] in *line {
            text += &format!("10\n{x}\n20\n{y}\n42\n{b}\n");
        }
    }
    for [x, y, r] in circles {
        text += &format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n{r}\n");
    }
    (text + "0\nENDSEC\n0\nEOF\n").into_bytes()
}

fn points(path: &Path) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> =
        path.segments.iter().map(|s| s.start().to_array().map(|v| (v * 1e6).round() / 1e6)).collect();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all
}

fn told(job: &Job) -> Vec<&Finding> {
    job.run().unwrap().findings.iter().filter(|f| f.code == Code::KerfNotApplied).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

#[test]
fn without_a_kerf_the_drawing_is_the_path() {
    let job = started(drawing(&[rectangle([0.0, 0.0, 10.0, 5.0])]), machine(0.0));
    assert_eq!(job.worked().contours, job.sheet().contours);
    assert!(job.beside().is_none());
}

#[test]
fn squares_grow_and_holes_shrink_by_half_a_kerf() {
    let job = kerfed(&[rectangle([10.0, 20.0, 30.0, 15.0]), rectangle([15.0, 25.0, 8.0, 6.0])]);
    let [outer, hole] = &job.worked().contours[..] else { panic!() };
    assert_eq!(points(&outer.path), [[9.8, 19.8], [9.8, 35.2], [40.2, 19.8], [40.2, 35.2]]);
    assert_eq!(points(&hole.path), [[15.2, 25.2], [15.2, 30.8], [22.8, 25.2], [22.8, 30.8]]);
    assert!(close(outer.length, 2.0 * (30.4 + 15.4)) && close(hole.length, 2.0 * (7.6 + 5.6)));
    assert!(close(outer.path.area(), 30.4 * 15.4) && close(hole.path.area(), -7.6 * 5.6));
    // What is made is as drawn.
    assert!(close(outer.area, 450.0) && close(hole.area, 48.0));
    assert_eq!((hole.inside, job.worked().parts.clone()), (Some(0), job.sheet().parts.clone()));
    let plan = job.plan().unwrap();
    assert!(close(plan.summary.cut_length, 91.6 + 26.4));
    assert_eq!(told(&job), Vec::<&Finding>::new());
}

#[test]
fn circles_stay_circles() {
    let job =
        started(bulged(&[], &[[50.0, 40.0, 10.0], [50.0, 40.0, 4.0], [80.0, 40.0, 0.3]]), machine(KERF));
    let radii: Vec<f64> = job
        .worked()
        .contours
        .iter()
        .map(|c| match c.path.segments[..] {
            [Segment::Arc(a)] if a.is_circle() => a.radius(),
            _ => panic!("{:?}", c.path),
        })
        .collect();
    assert!(radii.iter().zip([10.2, 3.8, 0.5]).all(|(a, b)| close(*a, b)), "{radii:?}");
    assert!(close(job.worked().contours[1].length, 2.0 * PI * 3.8));
}

/// A rectangle with rounded corners by its lower left corner, size and radius.
fn rounded([x, y, w, h, r]: [f64; 5]) -> Vec<[f64; 3]> {
    let b = (PI / 8.0).tan();
    vec![
        [x + r, y, 0.0],
        [x + w - r, y, b],
        [x + w, y + r, 0.0],
        [x + w, y + h - r, b],
        [x + w - r, y + h, 0.0],
        [x + r, y + h, b],
        [x, y + h - r, 0.0],
        [x, y + r, b],
    ]
}

#[test]
fn rounded_rectangles_keep_their_arcs() {
    let (outer, hole) = (rounded([0.0, 0.0, 40.0, 30.0, 5.0]), rounded([10.0, 10.0, 20.0, 8.0, 2.0]));
    let job = started(bulged(&[&outer, &hole], &[]), machine(KERF));
    let length = |w: f64, h: f64, r: f64| 2.0 * (w + h) - 8.0 * r + 2.0 * PI * r;
    let area = |w: f64, h: f64, r: f64| w * h - (4.0 - PI) * r * r;
    for (c, [w, h, r], sign) in [
        (&job.worked().contours[0], [40.4, 30.4, 5.2], 1.0),
        (&job.worked().contours[1], [19.6, 7.6, 1.8], -1.0),
    ] {
        assert_eq!(c.path.segments.len(), 8);
        assert!(close(c.length, length(w, h, r)), "{} {}", c.length, length(w, h, r));
        assert!(close(c.path.area(), sign * area(w, h, r)));
        let arcs = c
            .path
            .segments
            .iter()
            .filter_map(|s| if let Segment::Arc(a) = s { Some(a.radius()) } else { None });
        assert!(arcs.into_iter().all(|found| close(found, r)));
    }
}

#[test]
fn an_l_has_a_corner_inside() {
    let l: Vec<DVec2> = [(0.0, 0.0), (30.0, 0.0), (30.0, 10.0), (10.0, 10.0), (10.0, 40.0), (0.0, 40.0)]
        .map(|(x, y)| DVec2::new(x, y))
        .to_vec();
    let c = &kerfed(&[l]).worked().contours[0].clone();
    let wanted = [[-0.2, -0.2], [-0.2, 40.2], [10.2, 10.2], [10.2, 40.2], [30.2, -0.2], [30.2, 10.2]];
    assert_eq!(points(&c.path), wanted);
    // As long as the box around it.
    assert!(close(c.length, 2.0 * (30.4 + 40.4)));
    assert!(close(c.path.area(), 30.4 * 10.4 + 10.4 * 30.0));
}

#[test]
fn sharp_corners_are_rounded_beyond_the_limit() {
    // Points of 40 and of 20 degrees: 2.92 and 5.76 halves of a kerf.
    for (degrees, rounds) in [(40.0_f64, 0), (20.0, 1)] {
        let half = (degrees / 2.0).to_radians();
        let outline = vec![
            DVec2::new(0.0, 0.0),
            DVec2::new(50.0, -50.0 * half.tan()),
            DVec2::new(50.0, 50.0 * half.tan()),
        ];
        let c = &kerfed(&[outline]).worked().contours[0].clone();
        let arcs = c.path.segments.iter().filter(|s| matches!(s, Segment::Arc(_))).count();
        assert_eq!(arcs, rounds, "{degrees}");
        let tip = c.bounds.min.x;
        let wanted = if rounds == 0 { -0.2 / half.sin() } else { -0.2 };
        assert!(close(tip, wanted), "{tip} {wanted}");
    }
}

/// m by n rectangles of 20 by 10 that far apart.
fn spaced(m: usize, n: usize, gap: f64) -> Vec<Vec<DVec2>> {
    let cell = |k: usize| {
        let (x, y) = ((k % m) as f64, (k / m) as f64);
        rectangle([100.0 + (20.0 + gap) * x, 100.0 + (10.0 + gap) * y, 20.0, 10.0])
    };
    (0..m * n).map(cell).collect()
}

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
            assert_eq!(job.worked().groups.len(), 1, "{m} x {n}");
            assert_eq!(job.worked().groups[0].faces as usize, m * n + 1);
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
    assert_eq!((job.worked().groups.len(), job.worked().groups[0].faces, plan.summary.pierces), (1, 10, 1));
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
    assert_eq!(job.worked().parts.len(), 2);
    let saved: Vec<_> =
        job.run().unwrap().findings.iter().filter(|f| f.code == Code::OverlapRemoved).collect();
    assert!(saved[0].message.contains("61.575 mm"), "{saved:?}");
}

/// Ids stay; what a contour is left in comes last.
#[test]
fn contours_keep_their_ids() {
    // The last one is drawn in the middle: others cut all of its sides.
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
        let (drawn, worked) = (job.sheet(), job.worked());
        for (a, b) in drawn.contours.iter().zip(&worked.contours) {
            assert_eq!((Some(&a.path), a.layer, a.depth), (b.drawn.as_ref(), b.layer, b.depth));
            assert!(close(a.area, b.area));
        }
        assert_eq!(worked.contours[8].operation, Operation::Ignore, "nothing of it is left");
        assert_eq!(plan.summary.parts, 9);
        let all: f64 = worked.contours.iter().filter(|c| c.is_worked()).map(|c| c.length).sum();
        assert!((all - (4.0 * 3.0 * 20.4 + 4.0 * 3.0 * 10.4 + 4.0 * 3.6)).abs() < 1e-6, "{all}");
    }
    // Between two others, drawn last: above and below something is left.
    let row = [0.0, 20.8, 10.4].map(|x| rectangle([x, 0.0, 10.0, 5.0]));
    let job = kerfed(&row);
    let worked = job.worked();
    assert_eq!((job.sheet().contours.len(), worked.contours.len()), (3, 4));
    assert_eq!(worked.contours.iter().map(|c| c.path.closed).collect::<Vec<_>>(), [true, true, false, false]);
    assert!(close(worked.contours[2].area, 50.0) && close(worked.contours[3].area, 0.0));
    assert!(worked.contours[2].outline.is_some() && worked.contours[3].outline.is_none());
    assert_eq!(worked.parts[2].holes, [3], "worked with its part");
    assert!(worked.contours[2..].iter().all(|c| close(c.length, 10.4)));
}

#[test]
fn what_is_too_narrow_keeps_its_line_and_is_told() {
    // A slit that vanishes, a hole like a dumbbell whose neck does, a part with a slot whose mouth does.
    let plate = rectangle([0.0, 0.0, 100.0, 60.0]);
    let slit = rectangle([10.0, 10.0, 0.3, 20.0]);
    let p = |all: &[[f64; 2]]| all.iter().map(|p| DVec2::from_array(*p)).collect::<Vec<_>>();
    let dumbbell = p(&[
        [30.0, 10.0],
        [40.0, 10.0],
        [40.0, 14.9],
        [50.0, 14.9],
        [50.0, 10.0],
        [60.0, 10.0],
        [60.0, 20.0],
        [50.0, 20.0],
        [50.0, 15.1],
        [40.0, 15.1],
        [40.0, 20.0],
        [30.0, 20.0],
    ]);
    let slotted = p(&[
        [0.0, 100.0],
        [30.0, 100.0],
        [30.0, 120.0],
        [15.1, 120.0],
        [15.1, 105.0],
        [14.9, 105.0],
        [14.9, 120.0],
        [0.0, 120.0],
    ]);
    let job = kerfed(&[plate, slit.clone(), dumbbell.clone(), slotted.clone()]);
    let found = told(&job);
    assert_eq!(found.len(), 3, "{found:?}");
    for ((f, id), outline) in found.iter().zip([1, 2, 3]).zip([slit, dumbbell, slotted]) {
        let c = &job.worked().contours[id];
        assert_eq!((&c.path, &c.drawn), (&job.sheet().contours[id].path, &None));
        assert!(f.message.contains("narrower here than the kerf of 0.4 mm"), "{}", f.message);
        let at = f.at.unwrap();
        let near = outline.iter().map(|p| p.distance(at)).fold(f64::INFINITY, f64::min);
        assert!(near < 20.0, "{at}");
    }
    assert!(job.worked().contours[0].drawn.is_some(), "the others are moved");
}

#[test]
fn parts_with_less_than_a_kerf_between_them_keep_their_lines() {
    for (gap, words) in [(0.0, "in common"), (0.2, "Only 0.200 mm")] {
        let parts = [
            rectangle([0.0, 0.0, 10.0, 10.0]),
            rectangle([10.0 + gap, 0.0, 10.0, 10.0]),
            rectangle([30.0, 0.0, 5.0, 5.0]),
        ];
        let job = kerfed(&parts);
        let found = told(&job);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found.iter().any(|f| f.message.contains(words)), "{found:?}");
        let moved: Vec<bool> = job.worked().contours.iter().map(|c| c.drawn.is_some()).collect();
        assert_eq!(moved, [false, false, true]);
    }
    // A web is no waste: a hole may be as near to the edge as it likes.
    let job = kerfed(&[rectangle([0.0, 0.0, 10.0, 10.0]), rectangle([0.1, 2.0, 5.0, 5.0])]);
    assert!(told(&job).is_empty());
}

#[test]
fn open_contours_and_marks_keep_their_lines() {
    let mut text = String::from_utf8(drawing(&[rectangle([0.0, 0.0, 10.0, 10.0])])).unwrap();
    let line = |x: f64, layer: &str| format!("0\nLINE\n8\n{layer}\n10\n{x}\n20\n20\n11\n{x}\n21\n30\n");
    let circle = "0\nCIRCLE\n8\nMARK\n10\n5\n20\n5\n40\n1\n".to_owned();
    let more = line(3.0, "0") + &line(6.0, "0") + &circle;
    text = text.replace("0\nENDSEC\n0\nEOF", &(more + "0\nENDSEC\n0\nEOF"));
    let load = LoadOptions {
        layers: vec![kerfway::job::LayerChoice { name: "MARK".into(), operation: Operation::Mark }],
        ..LoadOptions::default()
    };
    let mut job = Job::load(text.into_bytes(), "open.dxf", &load).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine(KERF)));
    job.start(&PlanOptions { machine, ..PlanOptions::default() }).unwrap();
    job.plan().unwrap();
    let moved: Vec<bool> = job.worked().contours.iter().map(|c| c.drawn.is_some()).collect();
    assert_eq!(moved, [true, false, false, false]);
    let found = told(&job);
    assert_eq!((found.len(), found[0].count), (1, 2));
    assert_eq!(found[0].at, Some(DVec2::new(3.0, 20.0)));
}

#[test]
fn moved_turned_and_mirrored_drawings_give_the_same_lines() {
    let triangle = vec![DVec2::new(0.0, 0.0), DVec2::new(31.0, 4.0), DVec2::new(12.0, 23.0)];
    let mut outlines = spaced(2, 2, KERF);
    outlines.push(triangle);
    let length = |f: &dyn Fn(DVec2) -> DVec2| {
        let all: Vec<Vec<DVec2>> = outlines.iter().map(|o| o.iter().map(|p| f(*p)).collect()).collect();
        let job = kerfed(&all);
        assert!(told(&job).is_empty());
        (job.worked().groups[0].faces, job.plan().unwrap().summary.cut_length)
    };
    let wanted = length(&|p| p);
    let (sin, cos) = 0.3_f64.sin_cos();
    let ways: [&dyn Fn(DVec2) -> DVec2; 4] = [
        &|p| p + DVec2::new(-317.3, 44.1),
        &|p| DVec2::new(500.0 - p.x, p.y),
        &|p| DVec2::new(-p.y, p.x),
        &|p| DVec2::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos),
    ];
    for way in ways {
        let (faces, found) = length(way);
        assert_eq!(faces, wanted.0);
        assert!((found - wanted.1).abs() < 1e-6, "{found} {}", wanted.1);
    }
}

/// What the program burns, against the outlines drawn.
#[test]
fn the_program_keeps_half_a_kerf_from_every_outline() {
    let mut parts = spaced(3, 2, KERF);
    parts.push(rectangle([103.0, 103.0, 4.0, 4.0]));
    for machine in [machine(KERF), thick(KERF)] {
        let job = started(drawing(&parts), machine);
        let program = gcode::run(&job.output(OutputKind::Gcode).unwrap()).unwrap();
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
    let (sheet, plan) = (job.worked(), job.plan().unwrap());
    let violations = |sheet: &kerfway::sheet::Sheet, kerf: f64| {
        kerfway::plan::check(sheet, &machine(kerf), &plan).err().unwrap_or_default()
    };
    let kerf =
        |v: &[kerfway::plan::Violation]| v.iter().any(|v| matches!(v, kerfway::plan::Violation::Kerf { .. }));
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
fn a_kerf_out_of_range_is_refused() {
    for (kerf_width, fits) in
        [(0.0, true), (0.02, true), (10.0, true), (0.01, false), (-0.1, false), (f64::NAN, false)]
    {
        assert_eq!(machine(kerf_width).validate().is_ok(), fits, "{kerf_width}");
    }
    let said = machine(11.0).validate().unwrap_err().to_string();
    assert!(said.contains("kerf_width = 11; it must be 0, or from 0.02 to 10, in mm"), "{said}");
}

/// What looks like the sheet is cut as a part as long as nobody leaves it out; that parts are then holes is told.
#[test]
fn the_border_of_the_sheet_is_to_be_left_out() {
    let parts = [
        rectangle([0.0, 0.0, 200.0, 100.0]),
        rectangle([20.0, 20.0, 40.0, 40.0]),
        rectangle([30.0, 30.0, 10.0, 10.0]),
        rectangle([60.0 + KERF, 20.0, 40.0, 40.0]),
        rectangle([80.0, 30.0, 10.0, 10.0]),
    ];
    let sides = |ignore_outline: bool| {
        let load = LoadOptions { ignore_outline, ..LoadOptions::default() };
        let mut job = Job::load(drawing(&parts), "border.dxf", &load).unwrap();
        let machine = MachineChoice::Profile(Box::new(machine(KERF)));
        job.start(&PlanOptions { machine, ..PlanOptions::default() }).unwrap();
        job.plan().unwrap();
        let side = |id: usize| job.worked().contours[id].boundary().unwrap().bounds().size().x;
        let found = &job.run().unwrap().findings;
        let told =
            found.iter().any(|f| f.code == Code::SheetOutline && f.message.contains("smaller by a kerf"));
        (told, [0, 1, 2, 3, 4].map(|id| (side(id) * 1e6).round() / 1e6))
    };
    assert_eq!(sides(false), (true, [200.4, 39.6, 10.4, 39.6, 10.4]));
    assert_eq!(sides(true), (false, [200.0, 40.4, 9.6, 40.4, 9.6]));
}

#[test]
fn quotes_take_areas_from_the_outlines() {
    let mut parts = spaced(3, 3, KERF);
    // Drawn in the middle, last: all of its sides are cut with others.
    let middle = parts.remove(4);
    parts.push(middle);
    parts.push(rectangle([123.0, 112.0, 4.0, 4.0]));
    let job = started(drawing(&parts), thick(KERF));
    let material = kerfway::quote::Material { thickness: Some(2.0), density: Some(7.85), name: None };
    let quote = kerfway::quote::quote(&job.output(OutputKind::Json).unwrap(), &material).unwrap();
    assert_eq!(quote.part_count, 9);
    assert!(close(quote.net_area, 9.0 * 200.0 - 16.0), "{}", quote.net_area);
    let groups: Vec<_> = quote.parts.iter().map(|g| (g.count, g.holes, g.net_area)).collect();
    assert_eq!(groups.iter().map(|g| g.0).sum::<u32>(), 9);
    assert!(groups.iter().any(|g| g.1 == 1 && close(g.2, 184.0)), "{groups:?}");
    assert!(close(quote.smallest_hole.unwrap().width, 4.0));
    assert!((quote.cut_length - (4.0 * 3.0 * 20.4 + 4.0 * 3.0 * 10.4 + 4.0 * 3.6)).abs() < 1e-6);
    assert!(quote.layers.iter().all(|l| l.open == 0), "rests are no open contours");
}

/// Outlines around a middle, whose distance from it jumps about, some sides bent.
fn jagged(rng: &mut Rng, corners: usize, at: DVec2) -> Vec<[f64; 3]> {
    let turn = 2.0 * PI / corners as f64;
    (0..corners)
        .map(|k| {
            let angle = turn * (k as f64 + 0.6 * rng.range(0.0, 1.0));
            let far = 3.0 + 17.0 * rng.range(0.0, 1.0) * rng.range(0.0, 1.0);
            let bulge = if rng.range(0.0, 1.0) < 0.4 { 0.6 * rng.range(0.0, 1.0) - 0.3 } else { 0.0 };
            [at.x + far * angle.cos(), at.y + far * angle.sin(), bulge]
        })
        .collect()
}

#[test]
fn outlines_of_all_kinds_are_moved_or_told() {
    let mut rng = Rng::new(11);
    let (mut moved, mut kept) = (0, 0);
    for _ in 0..40 {
        let outlines: Vec<Vec<[f64; 3]>> = (0..12)
            .map(|k| {
                let corners = 3 + (rng.range(0.0, 1.0) * rng.range(0.0, 1.0) * 60.0) as usize;
                jagged(&mut rng, corners, DVec2::new(50.0 * f64::from(k), 0.0))
            })
            .collect();
        let slices: Vec<&[[f64; 3]]> = outlines.iter().map(Vec::as_slice).collect();
        let kerf = 0.05 + 2.0 * rng.range(0.0, 1.0) * rng.range(0.0, 1.0);
        // Checked, place by place.
        let job = started(bulged(&slices, &[]), machine(kerf));
        let closed = job.worked().contours.iter().filter(|c| c.boundary().is_some());
        let (some, none): (Vec<_>, Vec<_>) = closed.partition(|c| c.drawn.is_some());
        assert_eq!(told(&job).iter().filter(|f| f.severity == Severity::Warning).count(), none.len());
        for c in &some {
            let drawn = c.drawn.as_ref().unwrap();
            assert!(c.path.area() > drawn.area() && c.path.closed);
        }
        moved += some.len();
        kept += none.len();
    }
    assert!(moved > 300 && kept > 10, "{moved} {kept}");
}

/// Hostile: thousands of spikes from one place, and a comb of thousands of teeth.
#[test]
fn dense_outlines_end_in_time() {
    let began = std::time::Instant::now();
    let n = 10_000;
    let star: Vec<DVec2> = (0..2 * n)
        .map(|k| {
            let angle = PI * f64::from(k) / f64::from(n);
            DVec2::new(angle.cos(), angle.sin()) * if k % 2 == 0 { 100.0 } else { 0.01 }
        })
        .collect();
    let mut comb: Vec<DVec2> = vec![DVec2::new(200.0, -10.0), DVec2::new(400.0, -10.0)];
    comb.extend((0..n).rev().flat_map(|k| {
        let x = 200.0 + 200.0 * f64::from(k) / f64::from(n);
        [DVec2::new(x + 0.01, 50.0), DVec2::new(x, 0.0)]
    }));
    let job = started(drawing(&[star, comb]), machine(5.0));
    assert!(job.worked().contours.iter().all(|c| c.drawn.is_none()));
    // A guard against what never ends, not a target: alone it takes 9 s, beside two builds 25.
    assert!(began.elapsed().as_secs() < 120, "{:?}", began.elapsed());
}
