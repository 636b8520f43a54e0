//! The DXF, read back by the product's own reader: order, entries, direction, lengths, layers, unit.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::print_stdout,
    reason = "tests stop where they cannot go on and compare what must be equal"
)]

use crate::testkit::paths::{Element, assert_same_path};
use kerfway::drawing::{Drawing, ReadOptions, Unit, UnitsSource};
use kerfway::dxf::read;
use kerfway::geometry::Segment;
use kerfway::output;
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Sheet;

fn read_back(sheet: &Sheet, plan: &Plan) -> Drawing {
    read(output::dxf(plan, &output::SheetFacts::of(sheet)).as_bytes(), &ReadOptions::default()).unwrap()
}

fn element(s: &Segment) -> Element {
    match s {
        Segment::Line(l) => Element::line(l.start, l.end),
        Segment::Arc(a) => Element { from: a.start, to: a.end, arc: Some((a.center, a.sweep)) },
    }
}

#[test]
fn contours_come_back_in_cutting_order_entry_first() {
    crate::testkit::random_plans::each(200, |sheet, plan, _| assert_same(sheet, plan));
}

fn assert_same(sheet: &Sheet, plan: &Plan) {
    let drawing = read_back(sheet, plan);
    let mut shapes = drawing.shapes.iter();
    for step in &plan.moves {
        let Move::Cut { contour, path, .. } = step else { continue };
        let known = &sheet.contours[*contour as usize];
        let shape = shapes.next().unwrap();
        let elements: Vec<Element> = shape.path.segments.iter().map(element).collect();
        assert_same_path(&elements, path, 1e-4);
        // An open contour whose ends round to one place may be read as closed.
        let joined = path[0].start().distance(path[path.len() - 1].end()) < 1e-5;
        let length: f64 = path.iter().map(Segment::length).sum();
        let comes_back = path[0].start() == path[path.len() - 1].end();
        let closes = known.path.closed && comes_back && length > known.length - 1e-6;
        assert!(shape.path.closed == closes || (joined && shape.path.closed), "{known:?}");
        assert_eq!(drawing.layers[shape.layer as usize].name, sheet.layers[known.layer as usize].name);
    }
    assert!(shapes.next().is_none());
}

#[test]
fn layers_colours_and_unit_are_kept() {
    let (sheet, plan) = crate::testkit::plans::small();
    let drawing = read_back(&sheet, &plan);
    let layers: Vec<(&str, i16)> = drawing.layers.iter().map(|l| (l.name.as_str(), l.color)).collect();
    // Layer 0 belongs to every drawing; < and > may not stand in a name.
    assert_eq!(layers, [("0", 7), ("Cut 3mm", 1), ("Gravur _\u{df}_", 5)]);
    assert_eq!((drawing.units.unit, drawing.units.source), (Unit::Mm, UnitsSource::Header));
    assert_eq!(drawing.version.as_deref(), Some("AC1015"));
    assert_eq!(drawing.findings, []);
    let entities: Vec<(&str, u32)> = drawing.entities.iter().map(|e| (e.kind.as_str(), e.count)).collect();
    assert_eq!(entities, [("LWPOLYLINE", 3)]);
}

#[test]
fn layers_that_differ_in_case_or_forbidden_characters_stay_apart() {
    let (mut sheet, plan) = crate::testkit::plans::small();
    sheet.layers[0].name = "a/b".into();
    sheet.layers[1].name = "A:B".into();
    let drawing = read_back(&sheet, &plan);
    let names: Vec<&str> = drawing.layers.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(names, ["0", "a_b", "A_B_2"]);
    assert_eq!(drawing.shapes[0].layer, 2);
    // Letters beyond ASCII, which are escaped, are the same in both cases, too.
    sheet.layers[0].name = "Ätzen".into();
    sheet.layers[1].name = "ÄTZEN".into();
    let drawing = read_back(&sheet, &plan);
    let names: Vec<&str> = drawing.layers.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(names, ["0", "Ätzen", "ÄTZEN_2"]);
}

#[test]
fn handles_are_unique_and_below_the_seed() {
    let (sheet, plan) = crate::testkit::plans::small();
    let text = output::dxf(&plan, &output::SheetFacts::of(&sheet));
    let lines: Vec<&str> = text.lines().collect();
    let pairs: Vec<(&str, &str)> = lines.chunks(2).map(|c| (c[0], c[1])).collect();
    let hex = |s: &str| u32::from_str_radix(s, 16).unwrap();
    let seed_at = pairs.iter().position(|p| *p == ("9", "$HANDSEED")).unwrap() + 1;
    let seed = hex(pairs[seed_at].1);
    let mut handles: Vec<u32> = pairs
        .iter()
        .enumerate()
        .filter(|(i, p)| *i != seed_at && (p.0 == "5" || p.0 == "105"))
        .map(|(_, p)| hex(p.1))
        .collect();
    let count = handles.len();
    handles.sort_unstable();
    handles.dedup();
    assert_eq!(handles.len(), count);
    assert!(*handles.last().unwrap() < seed);
    assert!(text.is_ascii());
    // Every owner is an object, or 0 for the root.
    for (_, owner) in pairs.iter().filter(|p| p.0 == "330") {
        assert!(*owner == "0" || handles.contains(&hex(owner)), "{owner}");
    }
}
