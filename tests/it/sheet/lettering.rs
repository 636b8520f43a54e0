//! Lettering and its leaders: recognised, offered, and left as they are until the person chooses.

use super::sketch::*;
use kerfway::finding::{Code, Severity};
use kerfway::geometry::Path;
use kerfway::sheet::{Group, Operation, SheetOptions};

/// Strokes of the letters N, L, V, Z, C of a one-stroke font, 4 mm high, in rows.
fn text(x: f64, y: f64, letters: usize) -> Vec<Path> {
    let glyphs: [&[(f64, f64)]; 5] = [
        &[(0.0, 0.0), (0.0, 4.0), (2.5, 0.0), (2.5, 4.0)],
        &[(0.0, 4.0), (0.0, 0.0), (2.0, 0.0)],
        &[(0.0, 4.0), (1.3, 0.0), (2.6, 4.0)],
        &[(0.0, 4.0), (2.5, 4.0), (0.0, 0.0), (2.5, 0.0)],
        &[(2.4, 3.2), (1.2, 4.0), (0.0, 3.0), (0.0, 1.0), (1.2, 0.0), (2.4, 0.8)],
    ];
    (0..letters)
        .map(|k| {
            let x = x + 4.0 * k as f64;
            let at: Vec<(f64, f64)> = glyphs[k % 5].iter().map(|&(u, v)| (x + u, y + v)).collect();
            polyline(&at, false)
        })
        .collect()
}

fn plate() -> Vec<Path> {
    let mut drawn = vec![rect(0.0, 0.0, 200.0, 80.0), circle(150.0, 40.0, 2.0)];
    drawn.extend(text(20.0, 20.0, 12));
    // A leader from the text to the hole, and a slit that has nothing to do with it.
    drawn.push(line(66.0, 22.0, 147.0, 39.0));
    drawn.push(line(20.0, 60.0, 120.0, 60.0));
    drawn
}

#[test]
fn lettering_and_its_leader_are_offered_and_stay_cut_until_the_person_chooses() {
    let s = sheet(plate());
    let told = findings(&s, Code::Lettering);
    assert_eq!((told.len(), told[0].count, told[0].severity), (1, 12, Severity::Warning));
    assert_eq!((told[0].layer.as_deref(), told[0].at), (Some("0"), Some(p(20.0, 20.0))));
    assert_eq!(findings(&s, Code::Leaders)[0].count, 1);
    let open = findings(&s, Code::OpenContour);
    assert_eq!((open.len(), open[0].at), (1, Some(p(20.0, 60.0))), "the group tells about its strokes");
    assert!(
        s.contours.iter().all(|c| c.operation == Operation::Cut),
        "nothing is changed without being told"
    );
}

#[test]
fn lettering_is_marked_or_ignored_as_one_group() {
    for operation in [Operation::Mark, Operation::Ignore] {
        let groups = vec![(Group::Lettering, operation), (Group::Leaders, Operation::Ignore)];
        let s = sheet_with(plate(), &SheetOptions { groups, ..SheetOptions::default() });
        let of = |operation| s.contours.iter().filter(|c| c.operation == operation).count();
        assert_eq!(of(Operation::Cut), 3, "the plate, its hole and the slit");
        let ignored = if operation == Operation::Ignore { 13 } else { 1 };
        assert_eq!((of(Operation::Ignore), s.ignored.len()), (ignored, ignored));
        assert_eq!(findings(&s, Code::Lettering)[0].severity, Severity::Info);
        assert_eq!(findings(&s, Code::OpenContour).len(), 1, "only the slit is an open cut");
        assert_eq!(s.parts.len(), 1);
    }
}

#[test]
fn a_living_hinge_and_a_few_strokes_are_no_lettering() {
    let slits = (0..200).map(|k| {
        let (x, y) = (f64::from(k % 20) * 3.0, f64::from(k / 20) * 14.0);
        line(x, y, x, y + 12.0)
    });
    assert!(findings(&sheet(slits), Code::Lettering).is_empty());
    assert!(findings(&sheet(text(0.0, 0.0, 6)), Code::Lettering).is_empty());
}
