//! The plan document: by its schema, complete, and the same path as the plan bit for bit.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    clippy::cast_possible_truncation,
    reason = "tests stop where they cannot go on and compare what must be equal"
)]

use glam::DVec2;
use kerfway::geometry::{Arc, Path, Segment};
use kerfway::job::OutputKind;
use kerfway::plan::{Leads, Move, Turn};
use kerfway::sheet::Operation;
use serde_json::{Value, json};
use std::f64::consts::TAU;

fn published() -> Value {
    serde_json::from_str(include_str!("../../www/sdk/plan.schema.json")).unwrap()
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn point(v: &Value) -> DVec2 {
    DVec2::new(v[0].as_f64().unwrap(), v[1].as_f64().unwrap())
}

#[test]
fn documents_follow_the_published_schema() {
    let schema = published();
    let (sheet, plan) = crate::testkit::plans::small();
    assert_eq!(
        crate::testkit::schema::fault(
            &schema,
            &schema,
            &parsed(&crate::testkit::plans::document(&sheet, &plan)),
            ""
        ),
        None
    );
    for seed in 0..20 {
        let (sheet, plan) = crate::testkit::random_plans::random(seed);
        assert_eq!(
            crate::testkit::schema::fault(
                &schema,
                &schema,
                &parsed(&crate::testkit::plans::document(&sheet, &plan)),
                ""
            ),
            None
        );
    }
}

#[test]
fn documents_of_real_drawings_follow_the_published_schema() {
    let schema = published();
    for (name, job) in crate::testkit::plans::real() {
        let document = parsed(&job.output(OutputKind::Json).unwrap());
        assert_eq!(crate::testkit::schema::fault(&schema, &schema, &document, &name), None);
        for (read, planned) in moves(&document).iter().zip(&job.plan().unwrap().moves) {
            assert_same(read, planned);
        }
    }
}

#[test]
fn the_schema_is_strict() {
    let schema = published();
    let (sheet, plan) = crate::testkit::plans::small();
    let good = parsed(&crate::testkit::plans::document(&sheet, &plan));
    let fault = |change: fn(&mut Value)| {
        let mut bad = good.clone();
        change(&mut bad);
        crate::testkit::schema::fault(&schema, &schema, &bad, "").unwrap_or_else(|| panic!("accepted: {bad}"))
    };
    assert_eq!(
        fault(|d| d["schema"] = json!("kerfway.plan/2")),
        "/schema: \"kerfway.plan/2\" is not \"kerfway.plan/1\""
    );
    assert_eq!(fault(|d| d["extra"] = json!(1)), ": extra is unknown");
    assert_eq!(
        fault(|d| drop(d["summary"].as_object_mut().unwrap().remove("gap"))),
        "/summary: \"gap\" is missing"
    );
    assert!(fault(|d| d["moves"][0]["to"] = json!([1.0])).starts_with("/moves/0"));
    assert!(fault(|d| d["moves"][0]["to"] = json!([1.0, 2.0, 3.0])).starts_with("/moves/0"));
    assert!(fault(|d| d["moves"][1]["path"] = json!([])).starts_with("/moves/1"));
    assert!(fault(|d| d["contours"][0]["inside"] = json!("2")).starts_with("/contours/0/inside"));
}

#[test]
fn a_plan_document_contains_everything_it_was_made_from() {
    let (sheet, plan) = crate::testkit::plans::small();
    let document = parsed(&crate::testkit::plans::document(&sheet, &plan));
    assert_eq!(
        document["input"],
        json!({
            "sha256": "0123456789abcdef".repeat(4), "name": "plate.dxf", "units": "in", "units_source": "header"
        })
    );
    assert_eq!((&document["seed"], &document["method"]), (&json!(1), &json!("greedy")));
    assert_eq!(document["budget"], json!({ "moves": 1000, "seconds": null, "done": 1000 }));
    assert_eq!(document["machine"]["cut"], json!({ "speed": 25, "accel": 1000, "power": 0.8 }));
    assert_eq!(document["options"]["tolerance"], json!(0.005));
    assert_eq!(document["summary"]["bounds"], json!([10, 10, 50, 40]));
    assert_eq!(
        document["contours"][1],
        json!({
            "id": 1, "closed": true, "layer": "Cut 3mm", "operation": "cut", "inside": 2,
            "length": sheet.contours[1].length, "area": sheet.contours[1].area
        })
    );
    // The drawing's findings, then the sheet's.
    assert_eq!(document["findings"][0]["code"], "unsupported-entity");
    assert_eq!(document["findings"][1]["at"], json!([10, 40]));
}

#[test]
fn moves_read_back_are_the_plan() {
    for seed in 0..200 {
        let (sheet, plan) = crate::testkit::random_plans::random(seed);
        let document = parsed(&crate::testkit::plans::document(&sheet, &plan));
        let read = moves(&document);
        assert_eq!(read.len(), plan.moves.len());
        for (read, planned) in read.iter().zip(&plan.moves) {
            assert_same(read, planned);
        }
    }
}

/// The moves of a document, arcs made of ends, centre and direction as any reader would.
fn moves(document: &Value) -> Vec<Move> {
    let mut at = DVec2::ZERO;
    let read = |m: &Value| match m["kind"].as_str().unwrap() {
        "air" => {
            at = point(&m["to"]);
            Move::air(at)
        }
        "pierce" => Move::Pierce,
        "moving-start" => Move::MovingStart,
        "pre-cut" => {
            let (contour, to) = (m["contour"].as_u64().unwrap() as u32, point(&m["to"]));
            let mut from = to;
            let ahead = m["ahead"].as_array().into_iter().flatten().map(|e| element(e, &mut from)).collect();
            Move::PreCut { contour, to, ahead }
        }
        "macro" => Move::Macro { contour: m["contour"].as_u64().unwrap() as u32, at: point(&m["at"]) },
        "joint" => {
            let contour = m["contour"].as_u64().unwrap() as u32;
            let path = m["path"].as_array().unwrap().iter().map(|e| element(e, &mut at)).collect();
            Move::Joint { contour, path, flying: m["flying"].as_bool().unwrap_or(false) }
        }
        "fly" => {
            let path = m["path"].as_array().unwrap().iter().map(|e| element(e, &mut at)).collect();
            Move::Fly { path }
        }
        "chain" => {
            let path = m["path"].as_array().unwrap().iter().map(|e| element(e, &mut at)).collect();
            Move::Chain { path }
        }
        "cut" => {
            let all = m["contour"].as_array().cloned().unwrap_or_else(|| vec![m["contour"].clone()]);
            let mut all = all.iter().map(|c| c.as_u64().unwrap() as u32);
            let (contour, with) = (all.next().unwrap(), all.collect());
            let path = m["path"].as_array().unwrap().iter().map(|e| element(e, &mut at)).collect();
            let mark = document["contours"][contour as usize]["operation"] == "mark";
            let count = |name: &str| usize::try_from(m[name].as_u64().unwrap_or(0)).unwrap();
            let leads =
                Leads { lead_in: count("lead_in"), overcut: count("overcut"), lead_out: count("lead_out") };
            let turn = |c: &Value| Turn {
                kind: serde_json::from_value(c["kind"].clone()).unwrap(),
                at: point(&c["at"]),
                first: usize::try_from(c["first"].as_u64().unwrap()).unwrap(),
                count: usize::try_from(c["count"].as_u64().unwrap()).unwrap(),
            };
            let turns = m["corners"].as_array().into_iter().flatten().map(turn).collect();
            Move::Cut { contour, with, path, mark, leads, turns }
        }
        other => panic!("{other}"),
    };
    document["moves"].as_array().unwrap().iter().map(read).collect()
}

fn element(e: &Value, at: &mut DVec2) -> Segment {
    let start = *at;
    if let Some(to) = e.get("line") {
        *at = point(to);
        return Segment::line(start, *at);
    }
    *at = point(&e["arc"]);
    Segment::Arc(Arc::new(start, *at, point(&e["center"]), e["ccw"].as_bool().unwrap()))
}

/// The same contour; every end of the plan an end of the document, bit for bit; the same length.
fn assert_same(read: &Move, planned: &Move) {
    let (Move::Cut { path: a, contour: c, mark: m, .. }, Move::Cut { path: b, contour: d, mark: n, .. }) =
        (read, planned)
    else {
        assert_eq!(read, planned);
        return;
    };
    assert_eq!((c, m), (d, n));
    let mut ends = a.iter().map(Segment::end);
    for segment in b {
        assert!(ends.any(|end| end == segment.end()), "{segment:?} is lost");
    }
    let length = |path: &[Segment]| path.iter().map(Segment::length).sum::<f64>();
    let (read, planned) = (length(a), length(b));
    assert!((read - planned).abs() <= 1e-6 * planned.max(1.0), "{read} mm read, {planned} mm planned: {b:?}");
}

/// A reader has only ends, centre and direction. These must never describe a circle where there is none, or none where
/// there is one.
#[test]
fn arcs_next_to_nothing_and_next_to_a_turn_keep_their_length() {
    let center = DVec2::new(123.456, 654.321);
    let small = [0.0, 1e-15, 1e-12, 1e-8, 1e-6];
    let sweeps = small.into_iter().flat_map(|d| [d, -d, TAU - d, d - TAU]).filter(|s| *s != 0.0);
    let mut arcs: Vec<Arc> =
        sweeps.flat_map(|s| [1e-3, 1.0, 1e5].map(|r| Arc::from_angles(center, r, 1.0, s))).collect();
    // A hair short of a turn, with ends that differ by one rounding across it: they alone say next to nothing.
    arcs.push(Arc {
        start: DVec2::new(560.1296865549168, -702.1898360400562),
        end: DVec2::new(560.1296865549166, -702.1898360400564),
        center: DVec2::new(582.6419999999999, -722.0189999999999),
        sweep: TAU - 2e-15,
    });
    for arc in arcs {
        let lead = Segment::line(arc.start - DVec2::X, arc.start);
        let path = Path::new(vec![lead, Segment::Arc(arc)], false);
        let stop = crate::testkit::plans::Stop { layer: 0, operation: Operation::Cut, path };
        let (sheet, plan) =
            crate::testkit::plans::plan_of(vec![stop], &[("0", 7)], &crate::testkit::plans::machine());
        let read = moves(&parsed(&crate::testkit::plans::document(&sheet, &plan)));
        for (read, planned) in read.iter().zip(&plan.moves) {
            assert_same(read, planned);
        }
    }
}

#[test]
fn the_same_plan_gives_the_same_bytes_and_no_minus_zero() {
    let (sheet, mut plan) = crate::testkit::plans::small();
    let text = crate::testkit::plans::document(&sheet, &plan);
    assert_eq!(text, crate::testkit::plans::document(&sheet, &plan));
    let Some(Move::Air { to, .. }) = plan.moves.last_mut() else { panic!() };
    *to = DVec2::new(-0.0, -0.0);
    assert_eq!(text, crate::testkit::plans::document(&sheet, &plan));
}
