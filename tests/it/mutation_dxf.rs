//! Mutation tests of the reader over real drawings: lines lost, doubled and swapped, bad numbers, truncations,
//! flipped bits. Nothing panics or hangs, through contours and parts, and no geometry changes in silence: wherever
//! an entity comes out different, something is reported, except where the damage left another well-formed file
//! (a changed digit), which cannot be distinguished from a drawing that was meant so.
//!
//! `KERFWAY_MUTATIONS=20` tries twenty times as many.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and tells what it did"
)]

use crate::testkit::mutate::{Mutation, is_well_formed, lines};
use crate::testkit::rng::seeded;
use kerfway::drawing::{Drawing, ReadOptions};
use kerfway::dxf;
use kerfway::finding::Code;
use kerfway::geometry::Segment;
use kerfway::sheet::{self, SheetOptions};
use std::collections::{BTreeMap, HashMap};
use std::path::PathBuf;

/// Bytes read per file and run: small files are mutated more often than large ones.
const BYTES_PER_FILE: usize = 3 << 20;
/// Mutations of a file, whatever its size.
const MOST: usize = 300;
const FEWEST: usize = 25;

/// The undamaged reading, and options with its unit given, so that damage to the header does not scale everything.
fn undamaged(bytes: &[u8]) -> (Drawing, ReadOptions) {
    let base = dxf::read(bytes, &ReadOptions::default()).unwrap();
    let options = ReadOptions { unit: Some(base.units.unit), ..ReadOptions::default() };
    (base, options)
}

/// The real drawings we carry, and the small ones of the oracle.
fn drawings() -> Vec<PathBuf> {
    let mut out = crate::testkit::files(&crate::testkit::fixtures().join("dxf-dev"), "dxf");
    out.extend(
        crate::testkit::files(&crate::testkit::fixtures().join("oracle"), "dxf").into_iter().step_by(4),
    );
    out
}

fn rounds(size: usize) -> usize {
    let wider = std::env::var("KERFWAY_MUTATIONS").ok().and_then(|v| v.parse().ok()).unwrap_or(1);
    (BYTES_PER_FILE / size).clamp(FEWEST, MOST) * wider
}

/// A shape as what can be compared: kind, layer, elements to a nanometre.
type Print = (&'static str, String, Vec<[i64; 5]>);

#[expect(clippy::cast_possible_truncation, reason = "coordinates are within 1e6 mm")]
fn prints(drawing: &Drawing) -> HashMap<Print, i32> {
    let grid = |v: f64| (v * 1e6).round() as i64;
    let element = |s: &Segment| {
        let (a, b, m) = (s.start(), s.end(), s.at(0.5));
        [grid(a.x), grid(a.y), grid(b.x), grid(b.y), grid(m.x) ^ grid(m.y).rotate_left(32)]
    };
    let mut out = HashMap::new();
    for s in &drawing.shapes {
        let layer = drawing.layers[s.layer as usize].name.clone();
        *out.entry((s.kind, layer, s.path.segments.iter().map(element).collect())).or_default() += 1;
    }
    out
}

/// How often each code is reported, those about units aside.
fn reports(drawing: &Drawing) -> BTreeMap<Code, u32> {
    let mut out = BTreeMap::new();
    for f in &drawing.findings {
        if !matches!(f.code, Code::UnitsGuessed | Code::UnitsDoubtful) {
            *out.entry(f.code).or_default() += f.count;
        }
    }
    out
}

/// Something is said that was not said before; or that the file ends early, where it did so before.
fn is_reported(mutation: &Mutation, before: &BTreeMap<Code, u32>, now: &BTreeMap<Code, u32>) -> bool {
    let truncated = matches!(mutation, Mutation::Truncate(_)) && now.contains_key(&Code::Truncated);
    truncated || now.iter().any(|(code, n)| before.get(code).unwrap_or(&0) < n)
}

#[derive(Default, Debug)]
struct Tally {
    tried: usize,
    refused: usize,
    same: usize,
    reported: usize,
    /// Of those reported: with an entity that is in neither drawing as it was.
    altered: usize,
    another_drawing: usize,
}

#[test]
fn damage_is_never_silent() {
    let mut silent = Vec::new();
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for (n, file) in drawings().iter().enumerate() {
        let bytes = std::fs::read(file).unwrap();
        if bytes.starts_with(b"AutoCAD Binary") {
            continue;
        }
        let (base, options) = undamaged(&bytes);
        let (base_prints, base_reports) = (prints(&base), reports(&base));
        let lines = lines(&bytes);
        // A flaw of the undamaged drawing is not due to the damage.
        let ending: &[u8] = if is_well_formed(&bytes) { b"" } else { b"  0\nENDSEC\n  0\nEOF\n" };
        let mut rng = seeded(n as u64 + 1);
        for _ in 0..rounds(bytes.len()) {
            let mutation = Mutation::draw(&mut rng, &bytes, &lines);
            let damaged = mutation.apply(&bytes, &lines);
            let tally = tallies.entry(mutation.kind()).or_default();
            tally.tried += 1;
            let Ok(drawing) = dxf::read(&damaged, &options) else {
                tally.refused += 1;
                continue;
            };
            let _ = sheet::build(&drawing, &SheetOptions::default());
            let now = prints(&drawing);
            if now == base_prints {
                tally.same += 1;
            } else if is_reported(&mutation, &base_reports, &reports(&drawing)) {
                tally.reported += 1;
                let altered = now.iter().any(|(p, n)| base_prints.get(p).unwrap_or(&0) < n);
                tally.altered += usize::from(altered);
            } else if is_well_formed(&[&damaged, ending].concat()) {
                tally.another_drawing += 1;
            } else {
                silent.push(format!("{}: {mutation:?}", crate::testkit::name(file)));
            }
        }
    }
    for (kind, tally) in &tallies {
        println!("{kind}: {tally:?}");
    }
    // Reported, although the drawing is cut differently: a layer's name when the code page is lost, a missing angle taken as
    // 0. Anything else touched is left out.
    let (tried, altered) = tallies.values().fold((0, 0), |(t, a), x| (t + x.tried, a + x.altered));
    assert!(altered * 200 <= tried, "{altered} of {tried} are cut differently");
    assert!(silent.is_empty(), "{} silent changes:\n{}", silent.len(), silent.join("\n"));
}

#[test]
fn damage_to_binary_files_causes_no_panic() {
    let binary = |f: &PathBuf| std::fs::read(f).unwrap().starts_with(b"AutoCAD Binary");
    let mut files = drawings();
    files.extend(crate::testkit::files(&crate::testkit::fixtures().join("oracle"), "dxf"));
    let mut rng = seeded(7);
    let mut truncated = 0;
    for file in files.into_iter().filter(binary) {
        let bytes = std::fs::read(&file).unwrap();
        let (base, options) = undamaged(&bytes);
        let base = prints(&base);
        for _ in 0..rounds(bytes.len()) {
            let mutation = Mutation::draw_binary(&mut rng, &bytes);
            let Ok(drawing) = dxf::read(&mutation.apply(&bytes, &[]), &options) else { continue };
            let _ = sheet::build(&drawing, &SheetOptions::default());
            if matches!(mutation, Mutation::Truncate(_)) && prints(&drawing) != base {
                truncated += 1;
                let said = drawing.findings.iter().any(|f| f.code == Code::Truncated);
                assert!(said, "{}: {mutation:?} is not reported", crate::testkit::name(&file));
            }
        }
    }
    assert!(truncated > 50, "only {truncated} truncations took something away");
}
