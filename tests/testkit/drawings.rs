//! Small DXF files written in one line: group codes and values, white space between.

#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "shared by several test binaries; a test fails by panicking"
)]

use kerfway::drawing::{Drawing, ReadError, ReadOptions};
use kerfway::dxf;
use kerfway::finding::{Code, Finding};
use kerfway::geometry::Path;

/// Words as lines.
pub(crate) fn lines(words: &str) -> String {
    words.split_whitespace().map(|w| format!("{w}\n")).collect()
}

/// A file in millimetres with blocks and entities.
pub(crate) fn file(blocks: &str, entities: &str) -> String {
    lines(&format!(
        "0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 BLOCKS {blocks} 0 ENDSEC \
         0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"
    ))
}

/// Reads text.
pub(crate) fn read(text: &str) -> Result<Drawing, ReadError> {
    dxf::read(text.as_bytes(), &ReadOptions::default())
}

/// The drawing of these entities.
pub(crate) fn entities(entities: &str) -> Drawing {
    read(&file("", entities)).unwrap()
}

/// The drawing of these entities and blocks.
pub(crate) fn blocks(blocks: &str, entities: &str) -> Drawing {
    read(&file(blocks, entities)).unwrap()
}

/// The one shape of this entity.
pub(crate) fn one(entity: &str) -> Path {
    let drawing = entities(entity);
    assert_eq!(drawing.shapes.len(), 1, "{:?}", drawing.findings);
    drawing.shapes[0].path.clone()
}

/// Kind and length of every shape.
pub(crate) fn shapes(drawing: &Drawing) -> Vec<(&'static str, f64)> {
    drawing.shapes.iter().map(|s| (s.kind, s.path.length())).collect()
}

/// Length of all shapes, mm.
pub(crate) fn length(drawing: &Drawing) -> f64 {
    drawing.shapes.iter().map(|s| s.path.length()).sum()
}

/// The first finding of a code.
pub(crate) fn found(drawing: &Drawing, code: Code) -> &Finding {
    let found = drawing.findings.iter().find(|f| f.code == code);
    assert!(found.is_some(), "no {code:?} in {:#?}", drawing.findings);
    found.unwrap()
}

/// Equal but for rounding.
pub(crate) fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}
