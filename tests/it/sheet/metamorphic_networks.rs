//! Forty seeded sheets of touching and nested parts, in every form in which a program may draw them: the same parts, areas,
//! nesting and quote. The areas are those of Shapely's `polygonize` (`tests/oracle/networks.py`).

use crate::testkit::dxf_text::{Entity, Scene};
use crate::testkit::rng::{Rng, seeded};
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, PlanOptions};
use kerfway::quote::Terms;
use kerfway::sheet::Sheet;
use rand::RngExt;
use rand::seq::SliceRandom;
use serde::Deserialize;

#[derive(Deserialize)]
struct Case {
    /// Closed outlines: vertices with bulges.
    outlines: Vec<Vec<[f64; 3]>>,
    /// Areas of the faces of their lines, mm2, sorted.
    faces: Vec<f64>,
}

/// The forms of a sheet, each with its name.
fn forms(case: &Case, rng: &mut Rng) -> Vec<(&'static str, Vec<Entity>)> {
    let vertex = |&[x, y, bulge]: &[f64; 3]| (DVec2::new(x, y), bulge);
    let polylines: Vec<Entity> =
        case.outlines.iter().map(|o| Entity::Polyline(o.iter().map(vertex).collect(), true)).collect();
    let exploded: Vec<Entity> = polylines.iter().flat_map(Entity::exploded).collect();
    let some_reversed = |list: &[Entity], rng: &mut Rng| -> Vec<Entity> {
        list.iter().map(|e| if rng.random_bool(0.5) { e.reversed() } else { e.clone() }).collect()
    };
    let shuffled = |mut list: Vec<Entity>, rng: &mut Rng| {
        list.shuffle(rng);
        list
    };
    let reversed = some_reversed(&exploded, rng);
    let doubled: Vec<Entity> = exploded.iter().chain(&some_reversed(&exploded, rng)).cloned().collect();
    let mixed: Vec<Entity> = polylines
        .iter()
        .flat_map(|p| if rng.random_bool(0.5) { p.exploded() } else { vec![p.clone()] })
        .collect();
    let polylines_shuffled = shuffled(some_reversed(&polylines, rng), rng);
    let doubled_polylines: Vec<Entity> = polylines.iter().chain(&polylines).cloned().collect();
    vec![
        ("LWPOLYLINE", polylines),
        ("LWPOLYLINE, reversed and shuffled", polylines_shuffled),
        ("LWPOLYLINE, doubled and shuffled", shuffled(doubled_polylines, rng)),
        ("LINE and ARC", exploded.clone()),
        ("LINE and ARC, reversed", reversed.clone()),
        ("LINE and ARC, reversed and shuffled", shuffled(reversed, rng)),
        ("LINE and ARC, doubled and shuffled", shuffled(doubled, rng)),
        ("both kinds, shuffled", shuffled(mixed, rng)),
    ]
}

/// What must not change: for each contour that bounds an area, its area, the area that is its own, its depth, the area of
/// what is around it.
fn census(sheet: &Sheet) -> Vec<[f64; 4]> {
    let rounded = |x: f64| (x * 1e3).round() / 1e3;
    let area = |id: Option<u32>| id.map_or(0.0, |i| sheet.contours[i as usize].area);
    let mut rows: Vec<[f64; 4]> = (0_u32..)
        .zip(&sheet.contours)
        .filter(|(_, c)| c.bounds_area())
        .map(|(id, c)| {
            let inside = sheet.contours.iter().filter(|o| o.inside == Some(id) && o.bounds_area());
            let own = c.area - inside.map(|o| o.area).sum::<f64>();
            [rounded(c.area), rounded(own), f64::from(c.depth), rounded(area(c.inside))]
        })
        .collect();
    rows.sort_by(|a, b| a.partial_cmp(b).unwrap());
    rows
}

/// The parts of the quote as text, without the numbers of contours, which follow the order of drawing. Figures are rounded to
/// 1e-6, because the sums run in other orders.
fn quoted(job: &mut Job) -> String {
    let plan = PlanOptions { moves: Some(1), ..PlanOptions::default() };
    job.start(&plan).unwrap();
    job.plan().unwrap();
    let quote = job.quote(&Terms::default()).unwrap();
    let mut parts = serde_json::to_value(&quote.parts).unwrap();
    for part in parts.as_array_mut().unwrap() {
        let part = part.as_object_mut().unwrap();
        part.remove("contours");
        // Of each single part its box, in hundredths of mm: seconds and piercings depend on the path.
        let items = part.remove("items").unwrap();
        let corners = |item: &serde_json::Value| {
            let corner =
                |c: &serde_json::Value| format!("{:.0}", (100.0 * c.as_f64().unwrap()).round() + 0.0);
            item["bounds"].as_array().unwrap().iter().map(corner).collect::<Vec<_>>().join(" ")
        };
        let mut boxes: Vec<String> = items.as_array().unwrap().iter().map(corners).collect();
        boxes.sort();
        part.insert("boxes".into(), serde_json::json!(boxes));
        for figure in ["net_area", "cut_length"] {
            let value = part[figure].as_f64().unwrap();
            part.insert(figure.into(), serde_json::json!(format!("{value:.6}")));
        }
    }
    // Parts of the same area follow the order of drawing, too.
    let mut parts: Vec<String> = parts.as_array().unwrap().iter().map(ToString::to_string).collect();
    parts.sort();
    parts.join("\n")
}

#[test]
fn forty_sheets_in_all_forms_give_the_parts_that_shapely_finds() {
    let file = format!("{}/tests/fixtures/networks.json", env!("CARGO_MANIFEST_DIR"));
    let cases: Vec<Case> = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    assert_eq!(cases.len(), 40);
    for (seed, case) in (0_u64..).zip(&cases) {
        let mut first: Option<(Vec<[f64; 4]>, String)> = None;
        for (form, entities) in forms(case, &mut seeded(seed)) {
            let entities = entities.into_iter().map(|e| (e, "CUT".to_owned())).collect();
            let bytes = Scene { entities, units: 4 }.dxf().into_bytes();
            let mut job = Job::load(bytes, "sheet.dxf", &LoadOptions::default()).unwrap();
            let found = census(job.sheet());
            let mut own: Vec<f64> = found.iter().map(|row| row[1]).collect();
            own.sort_by(f64::total_cmp);
            assert_eq!(
                own.len(),
                case.faces.len(),
                "sheet {seed}, {form}: {own:?} instead of {:?}",
                case.faces
            );
            for (a, b) in own.iter().zip(&case.faces) {
                assert!((a - b).abs() <= 2e-3, "sheet {seed}, {form}: {a} is not {b}");
            }
            let quote = quoted(&mut job);
            match &first {
                None => first = Some((found, quote)),
                Some((census, of_first)) => {
                    assert_eq!(&found, census, "sheet {seed}, {form}");
                    assert_eq!(&quote, of_first, "sheet {seed}, {form}");
                }
            }
        }
    }
}
