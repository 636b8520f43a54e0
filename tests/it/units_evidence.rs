//! The unit of drawings that do not say it: what speaks for inches and what for millimetres.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::{drawings, files, fixtures, name};
use kerfway::drawing::{ReadOptions, Unit, Units};
use kerfway::dxf;
use std::fmt::Write;

/// A plate with holes on a layer, without or with a header.
fn plate(size: [f64; 2], holes: &[f64], layer: &str, header: &str) -> Units {
    let [w, h] = size;
    let mut entities = String::new();
    for [x0, y0, x1, y1] in [[0.0, 0.0, w, 0.0], [w, 0.0, w, h], [w, h, 0.0, h], [0.0, h, 0.0, 0.0]] {
        let _ = write!(entities, "0 LINE 8 OUTLINE 10 {x0} 20 {y0} 11 {x1} 21 {y1} ");
    }
    for (k, d) in holes.iter().enumerate() {
        let x = w * (k as f64 + 1.0) / (holes.len() as f64 + 1.0);
        let _ = write!(entities, "0 CIRCLE 8 {layer} 10 {x} 20 {} 40 {} ", h / 2.0, d / 2.0);
    }
    let text = drawings::lines(&format!(
        "0 SECTION 2 HEADER {header} 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    ));
    dxf::read(text.as_bytes(), &ReadOptions::default()).unwrap().units
}

#[test]
fn small_drawings_with_inch_holes_are_inches() {
    let units = plate([9.75, 6.5], &[0.116, 0.257], "HOLES", "");
    assert_eq!((units.unit, units.doubtful), (Unit::In, false), "{}", units.reason);
    assert!(
        units.reason.contains("0.116, 0.257") && units.reason.contains("drill sizes in inches"),
        "{}",
        units.reason
    );
    assert!(units.confidence > 0.95, "{}", units.confidence);
    let named = plate([17.0, 6.0], &[0.2], "4-40", "");
    assert_eq!((named.unit, named.doubtful), (Unit::In, false), "{}", named.reason);
    assert!(named.reason.contains("4-40"), "{}", named.reason);
}

#[test]
fn small_drawings_with_metric_holes_are_millimetres() {
    let units = plate([15.0, 12.0], &[3.2, 6.6], "M3", "");
    assert_eq!(units.unit, Unit::Mm, "{}", units.reason);
    let large = plate([150.0, 120.0], &[3.2, 6.6], "M3", "");
    assert_eq!((large.unit, large.doubtful), (Unit::Mm, false), "{}", large.reason);
    assert!(large.reason.contains("3.2, 6.6"), "{}", large.reason);
}

#[test]
fn a_sheet_size_in_a_layer_name_contradicts_the_header() {
    // 2440 inches are 62 m.
    let units = plate([240.0, 120.0], &[5.3], "2440x1220", "9 $INSUNITS 70 1");
    assert_eq!((units.unit, units.doubtful), (Unit::In, true), "{}", units.reason);
    let right = plate([2400.0, 1200.0], &[5.3], "2440x1220", "9 $INSUNITS 70 4");
    assert_eq!((right.unit, right.doubtful), (Unit::Mm, false), "{}", right.reason);
}

#[test]
fn a_washer_whose_header_is_metric_throughout_is_not_in_doubt() {
    let washer = plate([10.0, 10.0], &[4.3], "0", "9 $INSUNITS 70 4 9 $MEASUREMENT 70 1");
    assert_eq!((washer.unit, washer.doubtful), (Unit::Mm, false), "{}", washer.reason);
    assert!(washer.confidence > 0.9, "{}", washer.confidence);
    // Millimetres alone may come from a template, and a drawing of 10 mm is more often one of 10 in.
    let unsure = plate([10.0, 7.0], &[0.25, 0.116], "0", "9 $INSUNITS 70 4");
    assert_eq!((unsure.unit, unsure.doubtful), (Unit::Mm, true), "{}", unsure.reason);
    let speck = plate([1.0, 1.0], &[0.5], "0", "9 $INSUNITS 70 4 9 $MEASUREMENT 70 1");
    assert_eq!((speck.unit, speck.doubtful), (Unit::Mm, true), "{}", speck.reason);
}

#[test]
fn holes_contradict_a_header_from_a_template() {
    let units = plate([100.0, 80.0], &[3.2, 4.3, 6.6], "M3", "9 $INSUNITS 70 1 9 $MEASUREMENT 70 1");
    assert_eq!((units.unit, units.doubtful), (Unit::In, true), "{}", units.reason);
    assert!(units.reason.contains("3.2, 4.3"), "{}", units.reason);
}

/// Every drawing of `tests/fixtures/dxf-dev` with the unit that is right, where it is known, and whether it is taken
/// without doubt. The units of the others are not known.
#[test]
#[allow(clippy::print_stdout, reason = "a table for people")]
fn no_real_drawing_is_taken_in_a_wrong_unit_without_doubt() {
    // From the repositories of the drawings: their README, the parts that they fit, or a second file of the same part.
    const INCHES: [&str; 2] = ["skymakerolof_dxf__arrayed-holes.dxf", "skymakerolof_dxf__issue53.dxf"];
    let mut table = String::new();
    for path in files(&fixtures().join("dxf-dev"), "dxf") {
        let name = name(&path);
        let Ok(drawing) = dxf::read(&std::fs::read(&path).unwrap(), &ReadOptions::default()) else {
            continue;
        };
        let units = &drawing.units;
        let right = if INCHES.contains(&name.as_str()) { Unit::In } else { Unit::Mm };
        let _ = writeln!(
            table,
            "{name}: {:?}, {:.2}, doubt {}: {}",
            units.unit, units.confidence, units.doubtful, units.reason
        );
        assert!(units.unit == right || units.doubtful, "{name}: {units:?}");
    }
    println!("{table}");
}
