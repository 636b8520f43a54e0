//! Differential test of the reader against ezdxf: every drawing of `fixtures/oracle`, each entity within 0.01 mm of
//! the reference, both ways. The fixtures and their references are made by `tests/oracle/generate.py`;
//! `KERFWAY_ORACLE=FOLDER` takes others made by it.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use crate::testkit::compare::{Polyline, comes_back, hausdorff};
use kerfway::drawing::{ReadOptions, Unit};
use kerfway::dxf;
use kerfway::geometry::DVec2;

/// Largest distance from the reference, mm: 0.005 by the reader's own tolerance for splines and ellipses, 0.0015 by
/// the reference's chords, and some for two ways of rounding.
const TOLERANCE: f64 = 0.01;

/// Steps of the reference per mm.
const GRID: f64 = 10_000.0;

#[derive(serde::Deserialize)]
struct Reference {
    unit: Option<Unit>,
    paths: Vec<RefPath>,
}

#[derive(serde::Deserialize)]
struct RefPath {
    kind: String,
    layer: String,
    closed: bool,
    points: Vec<i64>,
}

impl RefPath {
    fn polyline(&self) -> Polyline {
        let mut at = (0_i64, 0_i64);
        let points = self.points.chunks_exact(2).map(|d| {
            at = (at.0 + d[0], at.1 + d[1]);
            DVec2::new(at.0 as f64, at.1 as f64) / GRID
        });
        Polyline::new(points.collect(), self.closed)
    }
}

/// Whatever in one drawing does not agree with its reference, a line each.
fn differences(file: &std::path::Path) -> Vec<String> {
    let reference: Reference =
        serde_json::from_slice(&std::fs::read(file.with_extension("json")).unwrap()).unwrap();
    let options = ReadOptions { unit: reference.unit, ..ReadOptions::default() };
    let drawing = match dxf::read(&std::fs::read(file).unwrap(), &options) {
        Ok(d) => d,
        Err(e) => return vec![format!("not read: {e}")],
    };
    let mut out = Vec::new();
    let mut left: Vec<usize> = (0..drawing.shapes.len()).collect();
    for (i, wanted) in reference.paths.iter().enumerate() {
        let polyline = wanted.polyline();
        let bounds = polyline.bounds().grown(1.0);
        let mut nearest = (f64::INFINITY, None);
        for (k, &s) in left.iter().enumerate() {
            let shape = &drawing.shapes[s];
            if shape.kind != wanted.kind || !bounds.contains_box(&shape.path.bounds()) {
                continue;
            }
            let d = hausdorff(&shape.path, &polyline);
            if d < nearest.0 {
                nearest = (d, Some(k));
            }
            if d <= TOLERANCE {
                break;
            }
        }
        let what = format!("{} {i} on {:?}", wanted.kind, wanted.layer);
        let (distance, Some(k)) = nearest else {
            out.push(format!("{what}: missing ({:.3} mm long)", polyline.length()));
            continue;
        };
        if distance > TOLERANCE {
            out.push(format!("{what}: {distance:.4} mm off"));
            continue;
        }
        let shape = &drawing.shapes[left.remove(k)];
        let (ours, theirs) = (shape.path.length(), polyline.length());
        if (ours - theirs).abs() > 1e-3 * theirs + 0.01 {
            out.push(format!("{what}: {ours:.4} mm long instead of {theirs:.4}"));
        }
        if comes_back(&shape.path) != wanted.closed {
            out.push(format!("{what}: closed should be {}", wanted.closed));
        }
        let layer = &drawing.layers[shape.layer as usize].name;
        if *layer != wanted.layer {
            out.push(format!("{what}: on layer {layer:?}"));
        }
        if shape.path.largest_gap() > 0.0 {
            out.push(format!("{what}: elements do not join by {:e} mm", shape.path.largest_gap()));
        }
    }
    for s in left {
        let shape = &drawing.shapes[s];
        out.push(format!(
            "{} too many: {:.3} mm at {:?}",
            shape.kind,
            shape.path.length(),
            shape.path.start()
        ));
    }
    out
}

#[test]
fn every_entity_lies_where_ezdxf_puts_it() {
    let folder =
        std::env::var_os("KERFWAY_ORACLE").map_or(crate::testkit::fixtures().join("oracle"), Into::into);
    let files = crate::testkit::files(&folder, "dxf");
    assert!(files.len() >= 50, "fixtures are missing");
    let mut report = String::new();
    for file in &files {
        for line in differences(file) {
            report += &format!("{}: {line}\n", crate::testkit::name(file));
        }
    }
    assert!(report.is_empty(), "\n{report}");
}
