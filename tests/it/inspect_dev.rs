//! Real drawings against their audit by ezdxf (`manifest.json` beside them): length as drawn, cut length, closed and
//! open contours. Every difference is in the table of `tests/fixtures/README.md` with who is right and why; the
//! test reads that table, so a difference that is not explained fails, and so does an explanation of none.
//!
//! Drawings under licences we may not carry are read from the folder of shared data when it is there.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use kerfway::drawing::{ReadOptions, Unit};
use kerfway::dxf;
use kerfway::sheet::{self, Operation, SheetOptions};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Relative difference of lengths that needs no explanation.
const LENGTH_TOLERANCE: f64 = 1e-3;

#[derive(serde::Deserialize)]
struct Entry {
    file: String,
    audit: Audit,
}

#[derive(serde::Deserialize)]
struct Audit {
    insunits: Option<u32>,
    cut_len_mm: Option<f64>,
    #[serde(rename = "join_0.01")]
    join: Option<Join>,
}

/// Contours after joining ends nearer than 0.01 mm; `branch` are those with ends where more than two meet.
#[derive(serde::Deserialize)]
struct Join {
    closed: u32,
    open: u32,
    branch: u32,
}

/// (file, quantity) -> (ours, ezdxf's), as printed.
type Table = BTreeMap<(String, String), (String, String)>;

/// The rows of the table of differences: `| file | quantity | Kerfway | ezdxf | who is right, and why |`.
fn explained() -> Table {
    let text = std::fs::read_to_string(crate::testkit::fixtures().join("README.md")).unwrap();
    let mut out = Table::new();
    for row in text.lines().filter(|l| l.starts_with("| `")) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [file, quantity, ours, theirs, why] = cells[..] else { continue };
        assert!(why.len() > 20, "no reason given: {row}");
        let key = (file.trim_matches('`').to_owned(), quantity.to_owned());
        assert!(out.insert(key, (ours.to_owned(), theirs.to_owned())).is_none(), "twice: {row}");
    }
    out
}

/// What differs in one drawing: quantity -> (ours, ezdxf's).
fn differences(folder: &Path, entry: &Entry) -> Vec<(&'static str, String, String)> {
    let bytes = std::fs::read(folder.join(&entry.file)).unwrap();
    // Where the file does not say, the audit took millimetres.
    let silent = matches!(entry.audit.insunits, None | Some(0));
    let guess = dxf::read(&bytes, &ReadOptions::default()).unwrap_or_else(|e| panic!("{}: {e}", entry.file));
    let unit = if silent { Some(Unit::Mm) } else { None };
    let drawing = dxf::read(&bytes, &ReadOptions { unit, ..ReadOptions::default() }).unwrap();
    // The audit counted every layer.
    let cut_all = drawing.layers.iter().map(|l| (l.name.clone(), Some(Operation::Cut))).collect();
    let sheet = sheet::build(&drawing, &SheetOptions { layers: cut_all, ..SheetOptions::default() });

    let drawn: f64 = drawing.shapes.iter().map(|s| s.path.length()).sum();
    let cut: f64 = sheet.contours.iter().map(|c| c.length).sum();
    let closed = sheet.contours.iter().filter(|c| c.path.closed).count();
    let open = sheet.contours.len() - closed;

    let mut out = Vec::new();
    let length = |out: &mut Vec<_>, name, ours: f64| match entry.audit.cut_len_mm {
        Some(theirs) if (ours - theirs).abs() <= LENGTH_TOLERANCE * theirs => {}
        Some(theirs) => out.push((name, format!("{ours:.1}"), format!("{theirs:.1}"))),
        None => out.push((name, format!("{ours:.1}"), "none".to_owned())),
    };
    if silent && guess.units.unit != Unit::Mm {
        out.push(("unit", format!("{:?}", guess.units.unit), "Mm".to_owned()));
    }
    length(&mut out, "length drawn", drawn);
    length(&mut out, "length cut", cut);
    let theirs = entry.audit.join.as_ref().map_or("none".to_owned(), |j| match j.branch {
        0 => format!("{} + {}", j.closed, j.open),
        b => format!("{} + {} + {b} branched", j.closed, j.open),
    });
    let ours = format!("{closed} + {open}");
    if ours != theirs {
        out.push(("closed + open", ours, theirs));
    }
    out
}

fn manifest(folder: &Path) -> Vec<Entry> {
    serde_json::from_slice(&std::fs::read(folder.join("manifest.json")).unwrap()).unwrap()
}

#[test]
fn real_drawings_agree_with_their_audit_or_the_difference_is_explained() {
    let carried = crate::testkit::fixtures().join("dxf-dev");
    let shared: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/dxf-dev");
    let mut entries: Vec<(PathBuf, Entry)> =
        manifest(&carried).into_iter().map(|e| (carried.clone(), e)).collect();
    assert_eq!(entries.len(), 18);
    if shared.join("manifest.json").exists() {
        let known: Vec<String> = entries.iter().map(|(_, e)| e.file.clone()).collect();
        let more = manifest(&shared).into_iter().filter(|e| !known.contains(&e.file));
        entries.extend(more.map(|e| (shared.clone(), e)));
        assert_eq!(entries.len(), 31);
    } else {
        println!("Skipped 13 drawings that may not be carried: {} is not there.", shared.display());
    }
    let mut explained = explained();
    let mut report = String::new();
    for (folder, entry) in &entries {
        for (quantity, ours, theirs) in differences(folder, entry) {
            let row = format!("| `{}` | {quantity} | {ours} | {theirs} |", entry.file);
            match explained.remove(&(entry.file.clone(), quantity.to_owned())) {
                Some(said) if said == (ours, theirs) => {}
                Some((ours, theirs)) => report += &format!("{row} but the table says {ours} and {theirs}\n"),
                None => report += &format!("{row} is not explained\n"),
            }
        }
    }
    for ((file, quantity), _) in explained {
        if entries.iter().any(|(_, e)| e.file == file) {
            report += &format!("`{file}` {quantity}: explained, but there is no difference\n");
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

#[test]
fn every_entity_is_drawn_or_counted() {
    let folder = crate::testkit::fixtures().join("dxf-dev");
    for entry in manifest(&folder) {
        let drawing =
            dxf::read(&std::fs::read(folder.join(&entry.file)).unwrap(), &ReadOptions::default()).unwrap();
        for kind in drawing.entities.iter().filter(|k| !k.supported) {
            let counted: u32 = drawing
                .findings
                .iter()
                .filter(|f| {
                    f.code == kerfway::finding::Code::UnsupportedEntity && f.message.contains(&kind.kind)
                })
                .map(|f| f.count)
                .sum();
            assert!(
                counted >= kind.count,
                "{}: {} {} but {counted} reported",
                entry.file,
                kind.count,
                kind.kind
            );
        }
    }
}
