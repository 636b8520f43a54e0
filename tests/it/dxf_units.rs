//! Units: from the header, guessed, given, and doubtful.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use super::dxf_files::LINE;
use crate::testkit::drawings::{close, file, found, length, lines, read};
use kerfway::drawing::{Drawing, ReadOptions, Unit, UnitsSource};
use kerfway::finding::Code;

fn with_units(header: &str, size: f64) -> Drawing {
    let text = format!(
        "0 SECTION 2 HEADER {header} 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 0 10 0 20 0 11 {size} 21 0 0 ENDSEC 0 EOF"
    );
    read(&lines(&text)).unwrap()
}

#[test]
fn units_of_the_header_scale_to_mm() {
    let mm = [
        (1, 25.4),
        (2, 304.8),
        (4, 1.0),
        (5, 10.0),
        (6, 1000.0),
        (8, 25.4e-6),
        (9, 0.0254),
        (10, 914.4),
        (13, 0.001),
        (14, 100.0),
    ];
    for (code, factor) in mm {
        // 100 mm in each of them.
        let drawing = with_units(&format!("9 $INSUNITS 70 {code}"), 100.0 / factor);
        assert!((length(&drawing) - 100.0).abs() < 1e-9, "{code}: {}", length(&drawing));
        assert_eq!((drawing.units.source, drawing.units.doubtful), (UnitsSource::Header, false), "{code}");
    }
}

#[test]
fn units_that_do_not_fit_the_size_are_doubtful() {
    let inches = with_units("9 $INSUNITS 70 1", 400.0);
    assert_eq!((inches.units.unit, inches.units.doubtful), (Unit::In, true));
    assert!(
        inches.units.reason.contains("10.2 m") && inches.units.reason.contains("400 mm"),
        "{}",
        inches.units.reason
    );
    assert_eq!(found(&inches, Code::UnitsDoubtful).message, inches.units.reason);
    let small = with_units("9 $INSUNITS 70 4", 12.0);
    assert_eq!((small.units.unit, small.units.doubtful), (Unit::Mm, true));
    // Settings that contradict are not enough: templates have them in every second file.
    assert!(!with_units("9 $INSUNITS 70 4 9 $MEASUREMENT 70 0", 100.0).units.doubtful);
    assert!(!with_units("9 $INSUNITS 70 4 9 $MEASUREMENT 70 0", 1000.0).units.doubtful);
    assert!(!with_units("9 $INSUNITS 70 4 9 $MEASUREMENT 70 1", 100.0).units.doubtful);
}

#[test]
fn a_size_of_300_digits_is_not_written_out() {
    let line = |x: f64| format!("0 LINE 8 0 10 0 20 0 11 {x} 21 0");
    let text = format!(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 ENTITIES {} {} 0 ENDSEC 0 EOF",
        line(100.0),
        line(1e300)
    );
    let drawing = read(&lines(&text)).unwrap();
    assert_eq!(
        found(&drawing, Code::UnitsDoubtful).message,
        "The file says millimetres, but then the drawing is over 1 km large. Check the units."
    );
}

#[test]
fn units_that_are_missing_are_guessed_with_a_reason() {
    let guess = |header: &str, size: f64| {
        let units = with_units(header, size).units;
        assert_eq!(units.source, UnitsSource::Guessed);
        assert!(units.reason.starts_with("The file names"), "{}", units.reason);
        (units.unit, units.doubtful)
    };
    assert_eq!(guess("9 $INSUNITS 70 0", 1000.0), (Unit::Mm, false));
    assert_eq!(guess("9 $INSUNITS 70 0", 100.0), (Unit::Mm, true));
    assert_eq!(guess("9 $MEASUREMENT 70 1", 100.0), (Unit::Mm, false));
    assert_eq!(guess("9 $MEASUREMENT 70 0", 12.0), (Unit::In, false));
    assert_eq!(guess("9 $LUNITS 70 4", 12.0), (Unit::In, false));
    assert_eq!(guess("9 $ACADVER 1 AC1009", 12.0), (Unit::In, true));
    assert_eq!(guess("9 $INSUNITS 70 20", 1000.0), (Unit::Mm, false));
}

#[test]
fn units_given_by_the_person_win() {
    let text = file("", LINE);
    let options = ReadOptions { unit: Some(Unit::In), ..ReadOptions::default() };
    let drawing = kerfway::dxf::read(text.as_bytes(), &options).unwrap();
    close(length(&drawing), 50.0 * 25.4);
    assert_eq!((drawing.units.source, drawing.units.doubtful), (UnitsSource::Given, false));
}

/// The circles and texts of a title block on a paper layout made inches of a drawing in millimetres.
#[test]
fn what_is_on_paper_says_nothing_about_the_unit() {
    let circle = |x: f64, d: f64, paper: &str| format!("0 CIRCLE 8 0 {paper} 10 {x} 20 0 40 {} ", d / 2.0);
    let title_block = |paper: &str| {
        let holes: String = (1..9).map(|k| circle(f64::from(3 * k), f64::from(k) / 8.0, paper)).collect();
        holes + &format!("0 TEXT 8 INCH {paper} 10 0 20 0 40 0.125 1 A ").repeat(9)
    };
    let units = |layout: &str, more: &str| {
        let holes: String = [(0.0, 3.17), (7.3, 5.31), (14.6, 7.77)].map(|(x, d)| circle(x, d, "")).concat();
        let text = format!(
            "0 SECTION 2 BLOCKS {layout} 0 ENDSEC 0 SECTION 2 ENTITIES {holes} {more} 0 ENDSEC 0 EOF"
        );
        read(&lines(&text)).unwrap().units
    };
    let alone = units("", "");
    assert_eq!(alone.unit, Unit::Mm, "{}", alone.reason);
    let layout = format!("0 BLOCK 2 *Paper_Space 10 0 20 0 {} 0 ENDBLK", title_block(""));
    assert_eq!(units(&layout, ""), alone);
    assert_eq!(units("", &title_block("67 1")), alone);
    // In the model, the same is evidence.
    assert_ne!(units("", &title_block("")), alone);
}
