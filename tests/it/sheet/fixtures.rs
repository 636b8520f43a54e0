//! Nested sheets with known truth: every contour, its parent, its length, its layer.

use super::sketch::*;
use kerfway::drawing::ReadOptions;
use kerfway::dxf::read;
use kerfway::finding::Code;
use kerfway::sheet::{Operation, Sheet, SheetOptions};
use serde_json::Value;

fn options() -> SheetOptions {
    let layers =
        vec![("Sheet".to_owned(), Some(Operation::Ignore)), ("mark".to_owned(), Some(Operation::Mark))];
    SheetOptions { layers, ..SheetOptions::default() }
}

fn load(name: &str, options: &SheetOptions) -> (Sheet, Value) {
    let folder = format!("{}/tests/fixtures/sheets", env!("CARGO_MANIFEST_DIR"));
    let bytes = std::fs::read(format!("{folder}/{name}.dxf")).unwrap();
    let truth = std::fs::read(format!("{folder}/{name}.truth.json")).unwrap();
    let drawing = read(&bytes, &ReadOptions::default()).unwrap();
    (built(&drawing, options), serde_json::from_slice(&truth).unwrap())
}

/// The contour of each item of the truth: the one of its layer whose box and length are the same.
fn matched(sheet: &Sheet, items: &[Value]) -> Vec<u32> {
    let near = |a: f64, b: f64| (a - b).abs() < 0.02;
    items
        .iter()
        .map(|item| {
            let number = |v: &Value| v.as_f64().unwrap();
            let bounds: Vec<f64> = item["bbox"].as_array().unwrap().iter().map(number).collect();
            let same = |c: &kerfway::sheet::Contour| {
                let b = [c.bounds.min.x, c.bounds.min.y, c.bounds.max.x, c.bounds.max.y];
                sheet.layers[c.layer as usize].name == item["layer"].as_str().unwrap()
                    && (c.length / number(&item["length"]) - 1.0).abs() < 1e-3
                    && b.iter().zip(&bounds).all(|(x, y)| near(*x, *y))
            };
            let found: Vec<u32> =
                (0..).zip(&sheet.contours).filter(|(_, c)| same(c)).map(|(i, _)| i).collect();
            assert_eq!(found.len(), 1, "contour {} is there once", item["id"]);
            found[0]
        })
        .collect()
}

fn equals_truth(name: &str) {
    let (sheet, truth) = load(name, &options());
    let items = truth["items"].as_array().unwrap();
    assert_eq!(counts(&sheet), (items.len(), 0));
    // The truth is the length of fine polygons: a little short of arcs.
    let length = total_length(&sheet) / truth["cut_length_mm"].as_f64().unwrap();
    assert!((1.0..1.0001).contains(&length), "{length}");
    let ids = matched(&sheet, items);
    for (item, &id) in items.iter().zip(&ids) {
        let c = &sheet.contours[id as usize];
        let parent = item["parent"].as_u64().map(|p| ids[usize::try_from(p).unwrap()]);
        assert_eq!(c.inside, parent, "contour {}", item["id"]);
        assert_eq!(u64::from(c.depth), item["depth"].as_u64().unwrap());
        assert_eq!(c.operation, Operation::Cut);
    }
    let outer = items.iter().filter(|i| i["depth"].as_u64().unwrap() % 2 == 0).count();
    assert_eq!(sheet.parts.len(), outer);
    let codes: Vec<Code> = sheet.findings.iter().map(|f| f.code).collect();
    assert_eq!(codes, [Code::LayerIgnored], "nothing else is odd about it");
    assert_eq!((sheet.ignored.len(), sheet.outline), (1, None));
}

#[test]
fn the_sheet_of_100_contours_equals_its_truth() {
    equals_truth("sheet_100");
}

#[test]
fn the_sheet_of_500_contours_equals_its_truth() {
    equals_truth("sheet_500");
}

#[test]
fn the_border_of_a_sheet_is_ignored_and_comes_back_on_request() {
    let keep = SheetOptions { keep_border: true, ..SheetOptions::default() };
    let (with, _) = load("sheet_100", &keep);
    let border = with.outline.unwrap();
    assert_eq!(with.contours.len(), 101);
    assert!((with.contours[border as usize].area - 500_000.0).abs() < 1e-6);
    assert_eq!(findings(&with, Code::SheetOutline).len(), 1);
    assert_eq!(findings(&with, Code::LayerSuggestion)[0].layer.as_deref(), Some("SHEET"));
    let layers = vec![("mark".to_owned(), Some(Operation::Mark))];
    let (without, _) = load("sheet_100", &SheetOptions { layers, ..SheetOptions::default() });
    // The others keep their ids.
    let worked = || without.contours.iter().filter(|c| c.is_processed());
    assert_eq!((worked().count(), without.ignored.len(), without.outline), (100, 1, None));
    let (plain, _) = load("sheet_100", &options());
    for (c, p) in worked().zip(&plain.contours) {
        assert_eq!((&c.path, c.depth, c.inside.is_some()), (&p.path, p.depth, p.inside.is_some()));
    }
    assert_eq!(without.parts.len(), plain.parts.len());
}

/// Prints each decision with `-- --nocapture`. None of the real drawings has a border; each sheet has one.
#[test]
#[allow(clippy::print_stdout, reason = "a table for people")]
fn borders_of_all_drawings_are_decided_rightly() {
    for (folder, right) in [("dxf-dev", "no border"), ("sheets", "ignored")] {
        for path in crate::testkit::files(&crate::testkit::fixtures().join(folder), "dxf") {
            let name = crate::testkit::name(&path);
            let bytes = std::fs::read(&path).unwrap();
            let Ok(drawing) = read(&bytes, &ReadOptions::default()) else {
                continue;
            };
            let sheet = kerfway::sheet::build(&drawing, &SheetOptions::default());
            let told = findings(&sheet, Code::SheetOutline);
            let decision = match told.first() {
                None => "no border",
                Some(f) if f.severity == kerfway::finding::Severity::Warning => "asked",
                Some(_) if sheet.outline.is_none() => "ignored",
                Some(_) => "cut",
            };
            println!(
                "{name}: {decision}, {} parts. {}",
                sheet.parts.len(),
                told.first().map_or("", |f| &f.message)
            );
            assert_eq!(decision, right, "{name}");
        }
    }
}
