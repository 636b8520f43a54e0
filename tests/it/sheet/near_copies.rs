//! Drawings that lie over themselves a little off: what is a copy, what is reported, and what is meant to be two.

use super::metamorphic::{mapped, similar};
use super::sketch::*;
use kerfway::finding::{Code, Severity};
use kerfway::geometry::{DVec2, Path, math};
use kerfway::sheet::{Operation, Sheet, SheetOptions, build};

/// A plate with fifteen holes.
fn plate() -> Vec<Path> {
    let holes = (0..15).map(|k| circle(10.0 + 18.0 * f64::from(k % 5), 10.0 + 18.0 * f64::from(k / 5), 4.0));
    [rect(0.0, 0.0, 100.0, 60.0)].into_iter().chain(holes).collect()
}

/// The paths turned around the origin and then moved.
fn placed(paths: &[Path], angle: f64, by: DVec2) -> Vec<Path> {
    mapped(paths, |s| similar(s, 1.0, angle, false, by))
}

/// The paths, and after them the same paths moved.
fn twice(paths: &[Path], by: DVec2) -> Vec<Path> {
    paths.iter().cloned().chain(placed(paths, 0.0, by)).collect()
}

/// The sheet of a drawing that lies over itself. Which of two outlines of one size lies in the other is in doubt, so it is not checked.
fn unchecked(paths: impl IntoIterator<Item = Path>) -> Sheet {
    build(&drawing(paths.into_iter().map(|path| ("0", path))), &SheetOptions::default())
}

fn with_copy_tolerance(paths: &[Path], copy_tolerance: f64) -> Sheet {
    // The joining tolerance limits the copy tolerance.
    let join_tolerance = copy_tolerance.max(0.05);
    sheet_with(
        paths.iter().cloned(),
        &SheetOptions { copy_tolerance, join_tolerance, ..SheetOptions::default() },
    )
}

/// The number of contours that the finding of near copies counts, and the tolerance that it suggests, mm.
fn reported(s: &Sheet) -> Option<(u32, f64)> {
    let found = findings(s, Code::NearCopy);
    assert!(found.len() <= 1, "they are summed up: {found:?}");
    let found = found.first()?;
    assert_eq!(found.severity, Severity::Warning);
    assert!(found.at.is_some() && found.handle.is_some(), "{found:?}");
    let enough = found.message.strip_suffix(" mm.")?.rsplit(' ').next()?.parse().ok()?;
    Some((found.count, enough))
}

#[test]
fn a_drawing_pasted_over_itself_beyond_the_tolerance_is_reported_with_the_one_that_helps() {
    let cases = [
        (0.012, 0.0, 0.012),
        (0.02, 0.0, 0.02),
        (0.04, 0.0, 0.04),
        (0.0, 0.03, 0.03),
        (0.01, 0.01, 0.015),
        (0.02, 0.02, 0.029),
        (0.03, 0.03, 0.043),
        (0.04, 0.04, 0.057),
    ];
    for (x, y, wanted) in cases {
        let paths = twice(&plate(), p(x, y));
        let s = unchecked(paths.iter().cloned());
        let (number, enough) = reported(&s).unwrap_or_default();
        // Of the outline that is no farther off than the tolerance sideways nothing is left.
        assert_eq!(number, if x.max(y) > 0.011 { 16 } else { 15 }, "{x}, {y}");
        close(enough, wanted);
        let s = with_copy_tolerance(&paths, enough);
        assert_eq!((counts(&s), s.parts.len()), ((16, 0), 1), "{x}, {y}");
        assert_eq!(reported(&s), None);
    }
    let s = unchecked(twice(&plate()[1..2], p(0.02, 0.0)));
    assert_eq!(
        findings(&s, Code::NearCopy)[0].message,
        "1 contour lies within 0.02 mm of another one and would be cut twice. If it is a copy, raise the copy tolerance to 0.02 mm."
    );
}

#[test]
fn near_copies_are_the_same_wherever_the_drawing_lies_and_however_it_is_drawn() {
    for (angle, at) in [(0.0, p(1e4 / 3.0, -77.7)), (0.3, p(0.0, 0.0)), (-2.1, p(512.3, 1e3))] {
        let paths = placed(&twice(&plate(), p(0.02, 0.0)), angle, at);
        assert_eq!(reported(&unchecked(paths.iter().cloned())), Some((16, 0.02)), "{angle}, {at}");
        let reversed = paths.iter().map(Path::reversed);
        assert_eq!(reported(&unchecked(reversed)), Some((16, 0.02)), "{angle}, {at}");
    }
}

/// At exactly 0.01 mm, rounding decided which circles are copies: 9 of 15 were cut twice.
#[test]
fn copies_exactly_as_far_off_as_the_tolerance_are_removed_whatever_their_shape() {
    for tolerance in [0.01, 0.02] {
        for (angle, at) in
            [(0.0, p(0.0, 0.0)), (0.0, p(1e3 / 3.0, 9e3 / 7.0)), (0.3, p(0.0, 0.0)), (-2.1, p(-512.3, 1e3))]
        {
            let along = math::unit(angle) * tolerance;
            let once = placed(&plate(), angle, at);
            let s = with_copy_tolerance(&twice(&once, along), tolerance);
            assert_eq!((counts(&s), s.parts.len()), ((16, 0), 1), "{tolerance}, {angle}, {at}");
            assert!(findings(&s, Code::Crossing).is_empty());
            assert_eq!(reported(&s), None);
        }
    }
}

#[test]
fn three_drawings_over_each_other_have_two_copies_of_each_contour() {
    let mut paths = twice(&plate(), p(0.02, 0.0));
    paths.extend(placed(&plate(), 0.0, p(0.0, 0.02)));
    assert_eq!(reported(&unchecked(paths)).map(|(number, _)| number), Some(32));
}

#[test]
fn lines_that_are_meant_to_be_two_are_no_near_copies() {
    let ring = |width: f64| vec![circle(0.0, 0.0, 10.0), circle(0.0, 0.0, 10.0 - width)];
    let tiles = (0..25).map(|k| rect(20.0 * f64::from(k % 5), 10.0 * f64::from(k / 5), 20.0, 10.0)).collect();
    let meant: [(&str, Vec<Path>); 7] = [
        ("a thin ring", ring(0.5)),
        ("a ring as thin as the finest beam", ring(0.1)),
        ("parts one kerf apart", vec![rect(0.0, 0.0, 50.0, 20.0), rect(50.1, 0.0, 50.0, 20.0)]),
        (
            "an outline, and the same widened by a kerf",
            vec![rect(0.0, 0.0, 50.0, 20.0), rect(-0.1, -0.1, 50.2, 20.2)],
        ),
        ("parts that share sides", tiles),
        ("a circle that touches a line", vec![circle(0.0, 20.0, 20.0), line(-50.0, 0.0, 50.0, 0.0)]),
        ("a short line across another one", vec![line(0.0, 0.0, 10.0, 0.0), line(5.0, -0.04, 5.0, 0.04)]),
    ];
    for (what, paths) in meant {
        assert_eq!(reported(&sheet(paths)), None, "{what}");
    }
    // A slit is cut by one contour, there and back.
    let slit = [
        (0.0, 0.0),
        (50.0, 0.0),
        (50.0, 9.98),
        (10.0, 9.98),
        (10.0, 10.0),
        (50.0, 10.0),
        (50.0, 20.0),
        (0.0, 20.0),
    ];
    assert_eq!(reported(&sheet([polyline(&slit, true)])), None);
    let fill = (0..200).map(|k| ("ENGRAVE", line(0.0, 0.03 * f64::from(k), 20.0, 0.03 * f64::from(k))));
    let marks = SheetOptions {
        layers: vec![("ENGRAVE".to_owned(), Some(Operation::Mark))],
        ..SheetOptions::default()
    };
    assert_eq!(reported(&built(&drawing(fill), &marks)), None, "a filled area that is marked");
}

#[test]
fn a_tolerance_that_the_joining_tolerance_would_limit_is_suggested_with_it() {
    let paths = twice(&plate(), p(0.04, 0.0));
    let narrow = SheetOptions { join_tolerance: 0.02, ..SheetOptions::default() };
    let s = build(&drawing(paths.iter().map(|path| ("0", path.clone()))), &narrow);
    let message = &findings(&s, Code::NearCopy)[0].message;
    assert!(message.ends_with("raise the copy tolerance and the joining tolerance to 0.04 mm."), "{message}");
    let both = SheetOptions { join_tolerance: 0.04, copy_tolerance: 0.04, ..SheetOptions::default() };
    let s = sheet_with(paths, &both);
    assert_eq!((counts(&s), s.parts.len()), ((16, 0), 1));
}

#[test]
fn hostile_thousands_of_circles_almost_on_each_other_are_compared_in_part() {
    let at = |k: u32| 0.01 * f64::from(k % 97) * f64::from(k % 89) % 0.05;
    let s = unchecked((0..20_000).map(|k| circle(at(k), at(k / 7), 10.0 + at(k / 3))));
    let (number, enough) = reported(&s).unwrap_or_default();
    assert!(number > 0 && enough <= 0.06, "{number}, {enough}");
    assert!(findings(&s, Code::NotAllChecked).iter().any(|f| f.message.contains("near copies")));
}
