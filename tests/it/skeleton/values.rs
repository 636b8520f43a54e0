//! Values by hand: where the cuts are, their sums, their order, and the outline of what remains.

use super::*;
use kerfway::job::OutputKind;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{Fly, Leads, Levers, Lift, MovingPierce, Tips};
use kerfway::plan::document::Document;
use kerfway::sheet::Sheet;
use kerfway::solve;

#[test]
fn lines_divide_the_sheet_evenly_and_keep_away_from_parts() {
    let job = started(square_and_disk(), with(grid(100.0, 120.0))).unwrap();
    let plan = job.plan().unwrap();
    // The disk reaches from x 120 to 180 at y 100, and 2 mm are kept. The square ends at 80.
    let asked = [
        [0.0, 100.0, 118.0, 100.0],
        [100.0, 0.0, 100.0, 200.0],
        [182.0, 100.0, 300.0, 100.0],
        [200.0, 0.0, 200.0, 200.0],
    ];
    assert_lines(&lines(&job, &plan), &asked);
    let s = &plan.summary;
    assert_eq!((s.skeleton_cuts, s.contours, s.open_contours, s.pierces), (4, 3, 0, 7));
    assert!((s.skeleton_length - 636.0).abs() < 1e-4);
    let last = plan.moves.iter().rposition(|m| matches!(m, Move::Cut { contour: 0..=2, .. })).unwrap();
    let first = plan.moves.iter().position(|m| matches!(m, Move::Cut { contour: 3.., .. })).unwrap();
    assert!(last < first);
}

#[test]
fn places_beside_arcs_and_slanted_lines_are_exact() {
    // A diamond around (50, 50), and a half disk, whose flat side is at y 120.
    let diamond = "0\nLWPOLYLINE\n8\nCUT\n90\n4\n70\n1\n10\n20\n20\n50\n10\n50\n20\n20\n10\n80\n20\n50\n10\n50\n20\n80\n";
    let half = "0\nLWPOLYLINE\n8\nCUT\n90\n2\n70\n1\n10\n120\n20\n120\n42\n1\n10\n180\n20\n120\n42\n0\n";
    let plate = rectangle("PLATE", [0.0, 0.0, 240.0, 160.0]);
    let drawn = drawing(&[diamond.to_owned(), half.to_owned(), plate]);
    let skeleton = Skeleton { spacing_x: Some(60.0), clearance: 3.0, ..Skeleton::default() };
    let job = started(drawn, with(skeleton)).unwrap();
    // x 60: the diamond's sides are at y 50 -+ 20, and 3 mm beside them are 3 sqrt 2 along y.
    // x 120 and 180: the ends of the half disk at y 120.
    let s = 3.0 * 2.0_f64.sqrt();
    let asked = [
        [60.0, 0.0, 60.0, 30.0 - s],
        [60.0, 70.0 + s, 60.0, 160.0],
        [120.0, 0.0, 120.0, 120.0 - beside(3.0)],
        [120.0, 123.0, 120.0, 160.0],
        [180.0, 0.0, 180.0, 120.0 - beside(3.0)],
        [180.0, 123.0, 180.0, 160.0],
    ];
    assert_lines(&lines(&job, &job.plan().unwrap()), &asked);
    /// Along the tangent of a circle of 30 mm, where `clearance` from it ends.
    fn beside(clearance: f64) -> f64 {
        (clearance * (60.0 + clearance)).sqrt()
    }
}

#[test]
fn long_cuts_leave_joints_that_are_not_on_crossings() {
    let skeleton = Skeleton { joint_spacing: Some(100.0), joint_width: 2.0, ..grid(150.0, 100.0) };
    let job = started(square_and_disk(), Profile { kerf_width: 0.5, ..with(skeleton) }).unwrap();
    let found = lines(&job, &job.plan().unwrap());
    // One line at x 150 and one at y 100, and a disk at both. With the kerf a joint is 2.5 mm wide.
    let reach = 30.0 + 0.25 + 2.0;
    let (low, high) = (100.0 - reach, 100.0 + reach);
    let upright: Vec<_> = found.iter().filter(|l| l[..1] == l[2..3]).collect();
    assert_lines(
        &upright.into_iter().copied().collect::<Vec<_>>(),
        &[[150.0, 0.0, 150.0, low], [150.0, high, 150.0, 200.0]],
    );
    let level: Vec<_> = found.iter().filter(|l| l[1..2] == l[3..]).copied().collect();
    let (a, b) = (150.0 - reach, 150.0 + reach);
    let middle = (0.5 * a - 1.25, 0.5 * a + 1.25);
    let other = (0.5 * (b + 300.0) - 1.25, 0.5 * (b + 300.0) + 1.25);
    let asked = [
        [0.0, 100.0, middle.0, 100.0],
        [middle.1, 100.0, a, 100.0],
        [b, 100.0, other.0, 100.0],
        [other.1, 100.0, 300.0, 100.0],
    ];
    assert_lines(&level, &asked);
    // A joint in the middle of a line that another one crosses there: there are two instead.
    let plain =
        drawing(&[rectangle("CUT", [5.0, 5.0, 15.0, 15.0]), rectangle("PLATE", [0.0, 0.0, 200.0, 200.0])]);
    let skeleton = Skeleton { joint_spacing: Some(150.0), joint_width: 1.0, ..grid(100.0, 100.0) };
    let job = started(plain, with(skeleton)).unwrap();
    let found = lines(&job, &job.plan().unwrap());
    assert_eq!(found.len(), 6);
    let third = (200.0 - 2.0) / 3.0;
    assert_lines(&found[..1], &[[0.0, 100.0, third, 100.0]]);
}

#[test]
fn a_strip_without_parts_is_cut_off_in_one_piece() {
    let skeleton = Skeleton { remainder: Some(50.0), ..grid(100.0, 300.0) };
    let job = started(square_and_disk(), with(skeleton)).unwrap();
    // The disk ends at x 180, so the strip begins at 182, and one line divides the rest, which meets the disk nowhere.
    let plan = job.plan().unwrap();
    assert_lines(&lines(&job, &plan), &[[91.0, 0.0, 91.0, 200.0], [182.0, 0.0, 182.0, 200.0]]);
    assert_eq!(remainder(&job), vec![("SHEET".to_owned(), 118.0 * 200.0)]);
    // The strip above the parts is larger than that on the right if there is more room.
    let tall = drawing(&[circle([150.0, 100.0, 30.0]), rectangle("PLATE", [0.0, 0.0, 300.0, 400.0])]);
    let skeleton = Skeleton { remainder: Some(50.0), ..Skeleton::default() };
    let job = started(tall.clone(), with(skeleton)).unwrap();
    assert_lines(&lines(&job, &job.plan().unwrap()), &[[0.0, 132.0, 300.0, 132.0]]);
    assert_eq!(remainder(&job), vec![("SHEET".to_owned(), 300.0 * 268.0)]);
    // Nothing is wide enough: the outline of the sheet with what was cut out of it.
    let job = started(tall, with(Skeleton { remainder: Some(300.0), ..skeleton })).unwrap();
    assert_eq!(job.plan().unwrap().summary.skeleton_cuts, 0);
    let left = remainder(&job);
    assert_eq!((left.len(), left[0].1), (2, 120_000.0));
    assert!(left[1].0 == "CUT OUT" && (left[1].1 - 900.0 * std::f64::consts::PI).abs() < 1e-6);
}

/// Layers and areas of the outlines in the file of the remainder.
fn remainder(job: &Job) -> Vec<(String, f64)> {
    let text = job.output(OutputKind::Remainder).unwrap();
    let load = LoadOptions { keep_border: true, ..LoadOptions::default() };
    let read = Job::load(text.into_bytes(), "remainder.dxf", &load).unwrap();
    let sheet = read.sheet();
    (0..).zip(&sheet.contours).map(|(id, c)| (sheet.layer_name(id).to_owned(), c.area)).collect()
}

#[test]
fn the_bed_is_the_sheet_if_no_outline_is_drawn() {
    let drawn = drawing(&[circle([150.0, 100.0, 30.0])]);
    let skeleton = Skeleton { spacing_x: Some(200.0), ..Skeleton::default() };
    let bed = Some([0.0, 0.0, 400.0, 300.0]);
    let job = started(drawn.clone(), Profile { bed, ..with(skeleton) }).unwrap();
    assert_lines(&lines(&job, &job.plan().unwrap()), &[[200.0, 0.0, 200.0, 300.0]]);
    assert_eq!(remainder(&job).len(), 2);
    for (bed, sentence) in [
        (
            None,
            "Skeleton cuts are not possible: the size of the sheet is not known. Draw its outline as a closed line on a layer that is ignored, or give the machine's bed and a program in machine coordinates.",
        ),
        (
            Some([0.0, 0.0, 170.0, 300.0]),
            "Skeleton cuts are not possible: the job reaches beyond the sheet, for which the machine's bed is taken. Draw the outline of the sheet, or place the job on the bed.",
        ),
    ] {
        assert_eq!(
            started(drawn.clone(), Profile { bed, ..with(skeleton) }).err().as_deref(),
            Some(sentence)
        );
    }
    let fine = Skeleton { spacing_x: Some(10.0), ..skeleton };
    let bed = Some([0.0, 0.0, 20_000.0, 300.0]);
    assert_eq!(
        started(drawn, Profile { bed, ..with(fine) }).err().as_deref(),
        Some(
            "Skeleton cuts are not possible: the sheet would be divided more than 1000 times in one direction. Give a larger spacing."
        )
    );
}

/// The paths of the beam of a machine that was refused are not shown as those of a plan.
#[test]
fn a_start_that_fails_leaves_no_paths_of_the_beam() {
    let skeleton = Skeleton { spacing_x: Some(200.0), ..Skeleton::default() };
    let machine = Profile { kerf_width: 0.2, bed: None, ..with(skeleton) };
    let mut job =
        Job::load(drawing(&[circle([150.0, 100.0, 30.0])]), "disk.dxf", &LoadOptions::default()).unwrap();
    for (machine, is_started) in [(Profile { skeleton: None, ..machine.clone() }, true), (machine, false)] {
        let machine = MachineChoice::Profile(Box::new(machine));
        let started = job.start(&PlanOptions { machine, allow_off_bed: true, ..PlanOptions::default() });
        assert_eq!(started.is_ok(), is_started);
        assert_eq!((job.run().is_ok(), job.beam_paths().is_some()), (is_started, is_started));
    }
}

/// Every order and direction of three cuts after the last part: the search finds the least.
#[test]
fn the_search_chooses_order_and_directions() {
    let machine = with(grid(100.0, 300.0));
    let drawn = drawing(&[circle([150.0, 100.0, 30.0]), rectangle("PLATE", [0.0, 0.0, 400.0, 200.0])]);
    let job = started(drawn, machine).unwrap();
    let (machine, sheet): (&Profile, &Sheet) = (&job.run().unwrap().machine, job.beam_sheet());
    let problem = kerfway::job::problem_of(sheet, machine);
    let least = solve::exact(&problem).unwrap();
    let best = kerfway::plan::from_solution(sheet, &problem, &least);
    assert_eq!(best.summary.skeleton_cuts, 3);
    let plan = job.plan().unwrap();
    assert!(plan.summary.total_time <= best.summary.total_time + 1e-9);
}

/// What parts are cut with is not for these cuts: they begin at rest, and are no motion with others.
#[test]
fn levers_and_leads_leave_the_cuts_as_they_are() {
    let levers = Levers {
        moving_pierce: Some(MovingPierce { overcut: 0.5 }),
        lift: Some(Lift { height: 10.0, stay_down: 20.0, at_rest: false }),
        fly: Some(Fly { reach: 50.0, overcut: 0.5 }),
        ..Levers::default()
    };
    let machine = Profile { levers, z_speed: Some(100.0), ..with(grid(100.0, 120.0)) };
    let s = started(square_and_disk(), machine).unwrap().placed_plan().unwrap().summary;
    assert_eq!((s.skeleton_cuts, s.pierces, s.moving_starts + s.fly_cuts), (4, 4, 3));
    assert!((s.skeleton_length - 636.0).abs() < 1e-4);
    let leads: Leads =
        serde_json::from_str(r#"{"clearance":0.5,"rules":[{"lead_in":{"kind":"line"}}]}"#).unwrap();
    let machine = Profile { leads: Some(leads), ..with(grid(100.0, 120.0)) };
    let led = started(square_and_disk(), machine).unwrap().placed_plan().unwrap().summary;
    assert_eq!((led.skeleton_cuts, led.pierces), (4, 7));
    assert!(led.lead_length > 0.0 && (led.skeleton_length - 636.0).abs() < 1e-4);
}

/// Moves between the cuts keep clear of the square and the disk, which have tipped by then.
#[test]
fn moves_between_the_cuts_avoid_tipped_pieces() {
    let lift = Some(Lift { height: 10.0, stay_down: 0.0, at_rest: true });
    let tips = Some(Tips { drops_below: Some(0.0), ..Tips::default() });
    let levers = Levers { lift, tips, ..Levers::default() };
    let machine = Profile { levers, z_speed: Some(100.0), ..with(grid(100.0, 120.0)) };
    let job = started(square_and_disk(), machine).unwrap();
    assert!(job.output(OutputKind::Json).is_ok(), "the checker adds up the same seconds");
    let s = job.placed_plan().unwrap().summary;
    assert_eq!((s.skeleton_cuts, s.crossings), (4, 0));
}

#[test]
fn every_output_has_the_cuts() {
    for dialect in dialects() {
        let name = dialect.name.clone();
        let skeleton = Skeleton { joint_spacing: Some(80.0), ..grid(100.0, 100.0) };
        let machine = Profile { dialect: DialectChoice::Name(name.clone()), ..with(skeleton) };
        let job = started(square_and_disk(), machine).unwrap();
        let gcode = job.output(OutputKind::Gcode).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(gcode.len() > 1000, "{name}");
    }
    let job = started(square_and_disk(), with(grid(100.0, 100.0))).unwrap();
    let dxf = job.output(OutputKind::Dxf).unwrap();
    assert_eq!(dxf.matches("\nSKELETON\n").count(), 1 + 4);
    assert!(job.output(OutputKind::Svg).unwrap().contains("SKELETON"));
    let document = Document::read(&job.output(OutputKind::Json).unwrap()).unwrap();
    assert_eq!(document.contours.iter().filter(|c| c.skeleton).count(), 4);
    assert_eq!(document.summary.skeleton_cuts, 4);
    let quote = job.quote(&kerfway::quote::Terms::default()).unwrap();
    assert_eq!((quote.skeleton_cuts, quote.skeleton_length.round()), (4, 636.0));
    assert!(quote.skeleton_time > 0.0 && quote.layers.iter().all(|l| l.layer != "SKELETON"));
}

#[test]
fn passes_and_parts_one_by_one_keep_the_cuts_last() {
    for part_by_part in [false, true] {
        let load = LoadOptions {
            layers: vec![LayerChoice::new("PLATE", Operation::Ignore)],
            pass_order: kerfway::sheet::PassOrder::Sheet,
            part_by_part,
            order_by_layer: true,
            last: vec![0],
            ..LoadOptions::default()
        };
        let mut machine = with(grid(100.0, 100.0));
        machine.cut.passes = 2;
        let mut job = Job::load(square_and_disk(), "sheet.dxf", &load).unwrap();
        let machine = MachineChoice::Profile(Box::new(machine));
        job.start(&PlanOptions { machine, moves: Some(5_000), ..PlanOptions::default() }).unwrap();
        job.run_mut().unwrap().step(5_000);
        let plan = job.plan().unwrap();
        assert_eq!((plan.summary.skeleton_cuts, plan.summary.contours, plan.summary.pierces), (4, 3, 14));
        assert!((plan.summary.skeleton_length - 2.0 * 636.0).abs() < 1e-4);
    }
}
