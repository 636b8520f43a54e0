//! Contours that keep their drawn line, and machines that are refused: each is reported, with a place.

use super::made::{KERF, kerfed, machine, told};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::finding::Code;
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, PlanOptions};
use kerfway::sheet::Operation;

#[test]
fn outlines_that_are_too_narrow_keep_their_line_and_are_reported() {
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
        let c = &job.beam_sheet().contours[id];
        assert_eq!((&c.path, &c.drawn), (&job.sheet().contours[id].path, &None));
        assert!(f.message.contains("narrower here than the kerf of 0.4 mm"), "{}", f.message);
        let at = f.at.unwrap();
        let near = outline.iter().map(|p| p.distance(at)).fold(f64::INFINITY, f64::min);
        assert!(near < 20.0, "{at}");
    }
    assert!(job.beam_sheet().contours[0].drawn.is_some(), "the others are moved");
}

#[test]
fn parts_with_less_than_a_kerf_between_them_keep_their_lines() {
    for (gap, words) in [(0.0, "in common"), (0.2, "Only 0.2 mm")] {
        let parts = [
            rectangle([0.0, 0.0, 10.0, 10.0]),
            rectangle([10.0 + gap, 0.0, 10.0, 10.0]),
            rectangle([30.0, 0.0, 5.0, 5.0]),
        ];
        let job = kerfed(&parts);
        let found = told(&job);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found.iter().any(|f| f.message.contains(words)), "{found:?}");
        let moved: Vec<bool> = job.beam_sheet().contours.iter().map(|c| c.drawn.is_some()).collect();
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
    let load =
        LoadOptions { layers: vec![LayerChoice::new("MARK", Operation::Mark)], ..LoadOptions::default() };
    let mut job = Job::load(text.into_bytes(), "open.dxf", &load).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine(KERF)));
    job.start(&PlanOptions { machine, ..PlanOptions::default() }).unwrap();
    job.plan().unwrap();
    let moved: Vec<bool> = job.beam_sheet().contours.iter().map(|c| c.drawn.is_some()).collect();
    assert_eq!(moved, [true, false, false, false]);
    let found = told(&job);
    assert_eq!((found.len(), found[0].count), (1, 2));
    assert_eq!(found[0].at, Some(DVec2::new(3.0, 20.0)));
}

#[test]
fn a_kerf_out_of_range_is_refused() {
    for (kerf_width, fits) in
        [(0.0, true), (0.02, true), (10.0, true), (0.01, false), (-0.1, false), (f64::NAN, false)]
    {
        assert_eq!(machine(kerf_width).validate().is_ok(), fits, "{kerf_width}");
    }
    let said = machine(11.0).validate().unwrap_err().to_string();
    assert!(said.contains("\"kerf_width\" is 11. Give a number from 0.02 to 10 mm, or 0: "), "{said}");
}

/// A contour that looks like the border of the sheet is cut as a part unless it is skipped. That parts then count as holes is reported.
#[test]
fn the_border_of_the_sheet_can_be_ignored() {
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
        let side = |id: usize| job.beam_sheet().contours[id].boundary().unwrap().bounds().size().x;
        let found = &job.run().unwrap().findings;
        let told =
            found.iter().any(|f| f.code == Code::SheetOutline && f.message.contains("smaller by a kerf"));
        (told, [0, 1, 2, 3, 4].map(|id| (side(id) * 1e6).round() / 1e6))
    };
    assert_eq!(sides(false), (true, [200.4, 39.6, 10.4, 39.6, 10.4]));
    assert_eq!(sides(true), (false, [200.0, 40.4, 9.6, 40.4, 9.6]));
}
