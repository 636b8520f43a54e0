//! A whole intake that must end soon, and entities for it.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use kerfway::drawing::{Drawing, ReadError, ReadOptions};
use kerfway::dxf;
use kerfway::finding::{Code, Finding};
use kerfway::sheet::{self, Sheet, SheetOptions};
use std::time::{Duration, Instant};

/// A guard against hangs, not a speed target. The target is one second on an idle machine; these tests run with
/// assertions and next to others.
pub(super) const SOON: Duration = Duration::from_secs(8);

/// Reads and builds, within [`SOON`].
pub(super) fn intake(text: &str) -> Result<(Drawing, Sheet), ReadError> {
    let start = Instant::now();
    let result = dxf::read(text.as_bytes(), &ReadOptions::default()).map(|drawing| {
        let sheet = sheet::build(&drawing, &SheetOptions::default());
        (drawing, sheet)
    });
    assert!(start.elapsed() < SOON, "took {:?}", start.elapsed());
    result
}

pub(super) fn find(findings: &[Finding], code: Code) -> Option<&Finding> {
    findings.iter().find(|f| f.code == code)
}

pub(super) fn circle(x: f64, y: f64, r: f64) -> String {
    format!("0\nCIRCLE\n8\n0\n10\n{x:?}\n20\n{y:?}\n40\n{r:?}\n")
}

pub(super) fn line(x: f64, y: f64, u: f64, v: f64) -> String {
    format!("0\nLINE\n8\n0\n10\n{x:?}\n20\n{y:?}\n11\n{u:?}\n21\n{v:?}\n")
}
