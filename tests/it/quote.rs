//! The report of a quote: figures known by hand, its schema, its hash.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    reason = "a test fails by panicking; what must be equal is"
)]

use crate::testkit::dxf_text::{Entity, Scene, Similarity};
use glam::DVec2;
use kerfway::finding::Code;
use kerfway::job::{Job, LoadOptions, OutputKind, PlanOptions};
use kerfway::plan::document::Document;
use kerfway::quote::{
    CheckCode, Confidence, Level, Limits, Material, Quote, ReasonCode, Terms, Times, quote,
};
use serde_json::{Value, json};

fn job(bytes: Vec<u8>, load: Value, plan: Value) -> Job {
    let load: LoadOptions = serde_json::from_value(load).unwrap();
    let plan: PlanOptions = serde_json::from_value(plan).unwrap();
    let mut job = Job::load(bytes, "drawing.dxf", &load).unwrap();
    job.start(&plan).unwrap();
    job.run_mut().unwrap().step(500);
    job
}

/// In millimetres.
fn drawn(entities: &[Entity]) -> Vec<u8> {
    let entities = entities.iter().map(|e| (e.clone(), "CUT".to_owned())).collect();
    Scene { entities, units: 4 }.dxf().into_bytes()
}

fn of(job: &Job, material: &Material) -> Quote {
    job.quote(&material.clone().into()).unwrap()
}

fn messages(confidence: &Confidence) -> Vec<&str> {
    confidence.reasons.iter().map(|r| r.message.as_str()).collect()
}

fn steel(thickness: f64) -> Material {
    Material { name: Some("Steel".into()), thickness: Some(thickness), density: Some(7.85) }
}

/// A plate of 100 x 50 with a hole of 10 at `hole` and a slot 4 mm wide, 2 mm from the left edge.
fn plate(hole: DVec2, put: &Similarity) -> Vec<Entity> {
    let at = |x, y| DVec2::new(x, y);
    let round = |corners: &[(f64, f64, f64)]| {
        Entity::Polyline(corners.iter().map(|&(x, y, bulge)| (at(x, y), bulge)).collect(), true)
    };
    let outer = round(&[(0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (100.0, 50.0, 0.0), (0.0, 50.0, 0.0)]);
    let slot = round(&[(2.0, 10.0, 0.0), (6.0, 10.0, 0.0), (6.0, 40.0, 0.0), (2.0, 40.0, 0.0)]);
    let all = [outer, slot, Entity::Circle(hole, 5.0)];
    all.iter().map(|e| e.transformed(put)).collect()
}

#[test]
fn plates_are_measured_weighed_and_counted() {
    let put = |mirror, turn, x| Similarity { mirror, turn, scale: 1.0, shift: DVec2::new(x, 0.0) };
    let mut drawing = plate(DVec2::new(60.0, 30.0), &put(false, 0.0, 0.0));
    drawing.extend(plate(DVec2::new(60.0, 30.0), &put(true, 1.0, 300.0)));
    drawing.extend(plate(DVec2::new(50.0, 30.0), &put(false, 2.5, 600.0)));
    let job = job(drawn(&drawing), json!({ "units": "mm" }), json!({ "moves": 500 }));
    let quote = of(&job, &steel(4.0));

    let net = 5000.0 - 120.0 - std::f64::consts::PI * 25.0;
    assert_eq!(quote.part_count, 3);
    let counts: Vec<u32> = quote.parts.iter().map(|g| g.count).collect();
    assert_eq!(counts.iter().sum::<u32>(), 3);
    assert_eq!(
        counts.iter().max(),
        Some(&2),
        "turned and mirrored the same, with its hole elsewhere another"
    );
    assert!(quote.parts.iter().all(|g| g.holes == 2 && (g.net_area - net).abs() < 1e-6));
    assert!((quote.net_area - 3.0 * net).abs() < 1e-6);
    assert!((quote.weight.unwrap() - 3.0 * net * 4.0 / 1000.0 * 7.85).abs() < 1e-6);
    let hole = quote.smallest_hole.unwrap();
    assert!((hole.width - 4.0).abs() < 1e-6 && (hole.over_thickness.unwrap() - 1.0).abs() < 1e-6);
    let web = quote.narrowest_web.unwrap();
    assert!((web.width - 2.0).abs() < 1e-6 && (web.over_thickness.unwrap() - 0.5).abs() < 1e-6);
    only_the_setting_is_missing(&quote);
    assert_eq!(quote.pierces, 9);
    let plan = job.plan().unwrap().summary;
    assert_eq!((quote.times.total, quote.cut_length), (plan.total_time, plan.cut_length));
}

/// They were taken for open contours, which make no part: a row of plates was quoted as none or one.
#[test]
fn parts_that_share_sides_are_parts() {
    let at = |k: u32| {
        plate(
            DVec2::new(60.0, 30.0),
            &Similarity {
                mirror: false,
                turn: 0.0,
                scale: 1.0,
                shift: DVec2::new(100.0 * f64::from(k), 0.0),
            },
        )
    };
    let row: Vec<Entity> = (0..3).flat_map(at).collect();
    let hole = std::f64::consts::PI * 25.0;
    for machine in ["co2-100w", "fibre-6kw-plate"] {
        let quote = of(&job(drawn(&row), json!({}), json!({ "machine": machine })), &steel(2.0));
        assert_eq!((quote.part_count, quote.parts.len()), (3, 1), "{machine}");
        assert!(
            (quote.net_area - 3.0 * (5000.0 - 120.0 - hole)).abs() < 1e-6,
            "{machine}: {}",
            quote.net_area
        );
        assert_eq!(quote.parts[0].holes, 2, "{machine}");
        assert_eq!(quote.layers[0].open, 0, "{machine}");
        only_the_setting_is_missing(&quote);
    }
}

/// The presets have no library, so a named material has no setting; nothing else is doubtful.
fn only_the_setting_is_missing(quote: &Quote) {
    let Confidence { level, reasons } = &quote.confidence;
    assert!(
        *level == Level::Medium
            && reasons.len() == 1
            && reasons[0].message.starts_with("The machine has no setting for Steel"),
        "{reasons:?}"
    );
}

#[test]
fn parts_in_holes_are_parts_and_marks_are_not() {
    let square = |half: f64| {
        let c = |x, y| (DVec2::new(x, y) * half, 0.0);
        Entity::Polyline(vec![c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)], true)
    };
    let open = Entity::Line(DVec2::new(300.0, 0.0), DVec2::new(310.0, 0.0));
    let drawing = [square(100.0), square(50.0), square(20.0), open];
    let job = job(drawn(&drawing), json!({}), json!({ "moves": 500 }));
    let quote = of(&job, &Material::default());
    assert_eq!(quote.part_count, 2);
    assert_eq!(quote.net_area, 40_000.0 - 10_000.0 + 1_600.0);
    assert_eq!(quote.parts.iter().map(|p| p.net_area).collect::<Vec<_>>(), [30_000.0, 1_600.0]);
    assert_eq!(quote.weight, None);
    assert_eq!((quote.layers.len(), quote.layers[0].contours, quote.layers[0].open), (1, 4, 1));
    assert_eq!(quote.confidence.level, Level::Medium);
    assert_eq!(messages(&quote.confidence), ["1 contour that is cut is open: it encloses no part."]);
    assert_eq!(quote.confidence.reasons[0].code, ReasonCode::OpenCuts);
}

#[test]
fn reasons_of_confidence_are_words_and_not_codes() {
    let bytes =
        std::fs::read(crate::testkit::fixtures().join("../../www/app/public/samples/gaps-and-copies.dxf"));
    let job = job(bytes.unwrap(), json!({}), json!({ "moves": 500 }));
    let confidence = of(&job, &Material::default()).confidence;
    assert_eq!(confidence.level, Level::Medium);
    let expected = [
        "1 contour that is cut is open: it encloses no part.",
        "1 text or other object without an outline was skipped.",
        "2 places were found where two contours cross.",
    ];
    assert_eq!(messages(&confidence), expected);
    assert_eq!(confidence.reasons[2].finding, Some(Code::Crossing));
}

#[test]
fn lengths_of_a_sheet_are_those_of_its_generator() {
    let bytes = std::fs::read(crate::testkit::fixtures().join("sheets/sheet_100.dxf")).unwrap();
    let truth: Value = serde_json::from_slice(
        &std::fs::read(crate::testkit::fixtures().join("sheets/sheet_100.truth.json")).unwrap(),
    )
    .unwrap();
    let layers =
        json!([{ "name": "SHEET", "operation": "ignore" }, { "name": "MARK", "operation": "ignore" }]);
    let quote = of(&job(bytes, json!({ "layers": layers }), json!({ "moves": 500 })), &Material::default());
    let told = truth["cut_length_mm"].as_f64().unwrap();
    assert!((quote.cut_length / told - 1.0).abs() < 1e-3, "{} and {told}", quote.cut_length);
    let by_layer: f64 = quote.layers.iter().map(|l| l.length).sum();
    assert!((by_layer / quote.cut_length - 1.0).abs() < 1e-9);
    let even =
        truth["items"].as_array().unwrap().iter().filter(|i| i["depth"].as_u64().unwrap() % 2 == 0).count();
    assert_eq!(quote.part_count, even);
    assert_eq!(quote.parts.iter().map(|g| g.count as usize).sum::<usize>(), even);
}

#[test]
fn the_hash_covers_everything_in_the_report_and_nothing_else() {
    let bytes = std::fs::read(crate::testkit::fixtures().join("dxf-dev/mozman_ezdxf__forms.dxf")).unwrap();
    let made =
        |load: Value, plan: Value, material: &Material| of(&job(bytes.clone(), load, plan), material).hash;
    let plain = json!({ "moves": 500, "seed": 1 });
    let hash = made(json!({}), plain.clone(), &steel(2.0));
    assert_eq!(hash.len(), 64);
    assert_eq!(hash, made(json!({}), plain.clone(), &steel(2.0)));
    // Seconds are only reported; the number of moves decides.
    assert_eq!(hash, made(json!({}), json!({ "moves": 500, "seconds": 9.0, "seed": 1 }), &steel(2.0)));
    assert_ne!(hash, made(json!({}), json!({ "moves": 500, "seed": 2 }), &steel(2.0)));
    assert_ne!(hash, made(json!({ "joinTolerance": 0.1 }), plain.clone(), &steel(2.0)));
    assert_ne!(hash, made(json!({}), plain, &steel(3.0)));
}

#[test]
fn reports_follow_the_published_schema_and_list_defects() {
    let schema: Value = serde_json::from_str(include_str!("../../www/sdk/quote.schema.json")).unwrap();
    for name in ["mozman_ezdxf__forms.dxf", "peej_lumberjack-keyboard__lumberjack-polaris.dxf"] {
        let bytes = std::fs::read(crate::testkit::fixtures().join("dxf-dev").join(name)).unwrap();
        let job = job(bytes, json!({}), json!({ "moves": 500 }));
        for material in [Material::default(), steel(3.0)] {
            let report = serde_json::to_value(of(&job, &material)).unwrap();
            assert_eq!(crate::testkit::schema::fault(&schema, &schema, &report, name), None);
        }
        let bad = job.quote(&Material { thickness: Some(0.0), ..Material::default() }.into());
        let says = bad.unwrap_err().to_string();
        assert!(
            says.starts_with("The material's field \"thickness\" is 0. Give a number from 0.001"),
            "{says}"
        );
    }
    assert!(Document::read("{}").unwrap_err().starts_with("This is not a plan"));
}

#[test]
fn a_document_read_from_text_is_the_one_written_and_gives_the_same_quote() {
    for (name, job) in crate::testkit::plans::real() {
        let text = job.output(OutputKind::Json).unwrap();
        let read = Document::read(&text).unwrap();
        assert_eq!(read, job.document().unwrap(), "{name}");
        assert_eq!(kerfway::output::json_text(&read), text, "{name}");
        assert_eq!(quote(&read, &steel(2.0).into()).unwrap(), of(&job, &steel(2.0)), "{name}");
    }
}

/// One kind of time.
type Kind = fn(&Times) -> f64;

#[test]
fn seconds_of_parts_add_up_to_the_job() {
    let sum = |all: &[Times], of: Kind| all.iter().map(of).sum::<f64>();
    for (name, job) in crate::testkit::plans::real() {
        let quote = of(&job, &Material::default());
        let items: Vec<_> = quote.parts.iter().flat_map(|g| &g.items).collect();
        let mut all: Vec<Times> = items.iter().map(|i| i.times).collect();
        all.push(quote.loose_times);
        let kinds: [(Kind, f64); 6] = [
            (|t| t.total, quote.times.total),
            (|t| t.cut, quote.times.cut),
            (|t| t.air, quote.times.air),
            (|t| t.pierce, quote.times.pierce),
            (|t| t.pre_cut, quote.times.pre_cut),
            (|t| t.macros, quote.times.macros),
        ];
        for (of, whole) in kinds {
            let parts = sum(&all, of);
            assert!((parts - whole).abs() <= 1e-9 * whole.max(1.0), "{name}: {parts}, {whole}");
        }
        assert!(all.iter().all(|t| t.total >= 0.0 && t.cut >= 0.0 && t.air >= 0.0), "{name}");
        assert_eq!(items.len(), quote.part_count, "{name}");
    }
}

#[test]
fn equal_parts_take_equal_seconds_and_marks_belong_to_the_part_around_them() {
    let put = |x| Similarity { mirror: false, turn: 0.0, scale: 1.0, shift: DVec2::new(x, 0.0) };
    let mut entities = plate(DVec2::new(60.0, 30.0), &put(0.0));
    entities.extend(plate(DVec2::new(60.0, 30.0), &put(200.0)));
    let mut on_layers: Vec<(Entity, String)> = entities.into_iter().map(|e| (e, "CUT".to_owned())).collect();
    let line = |x| Entity::Line(DVec2::new(x, 20.0), DVec2::new(x + 20.0, 20.0));
    on_layers.push((line(20.0), "MARK".into()));
    on_layers.push((line(220.0), "MARK".into()));
    // In no part.
    on_layers.push((line(400.0), "MARK".into()));
    let bytes = Scene { entities: on_layers, units: 4 }.dxf().into_bytes();
    let layers = json!([{ "name": "MARK", "operation": "mark" }]);
    let quote = of(
        &job(bytes, json!({ "layers": layers }), json!({ "moves": 500, "machine": "length" })),
        &Material::default(),
    );
    assert_eq!((quote.parts.len(), quote.parts[0].count), (1, 2));
    let [a, b] = [&quote.parts[0].items[0], &quote.parts[0].items[1]];
    assert!((a.times.total - b.times.total).abs() < 1e-9, "{a:?} {b:?}");
    // A mark is not pierced.
    assert_eq!((a.pierces, b.pierces), (3, 3));
    assert!(quote.loose_times.cut > 0.0);
    // 20 mm of mark of 3 x 20, all at one speed from rest to rest.
    let plain = of(
        &job(
            Scene {
                entities: plate(DVec2::new(60.0, 30.0), &put(0.0))
                    .into_iter()
                    .map(|e| (e, "CUT".into()))
                    .collect(),
                units: 4,
            }
            .dxf()
            .into_bytes(),
            json!({}),
            json!({ "moves": 500, "machine": "length" }),
        ),
        &Material::default(),
    );
    assert!((a.times.cut - plain.times.cut - quote.loose_times.cut).abs() < 1e-9);
    assert_eq!(a.bounds, [0.0, 0.0, 100.0, 50.0]);
}

#[test]
fn the_hash_does_not_depend_on_the_name_of_the_file_or_the_version() {
    let bytes = std::fs::read(crate::testkit::fixtures().join("dxf-dev/mozman_ezdxf__forms.dxf")).unwrap();
    let named = |name: &str| {
        let mut job = Job::load(bytes.clone(), name, &LoadOptions::default()).unwrap();
        job.start(&serde_json::from_value(json!({ "moves": 500, "seed": 1 })).unwrap()).unwrap();
        job.run_mut().unwrap().step(500);
        of(&job, &Material::default())
    };
    let (a, b) = (named("a.dxf"), named("b.dxf"));
    assert_eq!((a.input.name.as_str(), b.input.name.as_str()), ("a.dxf", "b.dxf"));
    assert_eq!(a.hash, b.hash);
    assert_eq!(a.version, env!("CARGO_PKG_VERSION"));
}

#[test]
fn limits_that_are_exceeded_are_named_with_place_measure_and_limit() {
    let put = Similarity { mirror: false, turn: 0.0, scale: 1.0, shift: DVec2::ZERO };
    // The slot is 4 mm wide, 2 mm from the left edge; the hole of 10 mm ends 1.5 mm beside the slot.
    let job = job(drawn(&plate(DVec2::new(12.5, 30.0), &put)), json!({}), json!({ "moves": 500 }));
    let exceeded =
        |limits: Limits| job.quote(&Terms { limits, ..Terms::default() }).unwrap().checks.unwrap().exceeded;
    let one = |limits: Limits| {
        let mut all = exceeded(limits);
        assert_eq!(all.len(), 1, "{all:?}");
        all.remove(0)
    };
    let hole = one(Limits { smallest_hole: Some(5.0), ..Limits::default() });
    assert_eq!((hole.code, hole.limit, hole.at), (CheckCode::HoleTooSmall, Some(5.0), [4.0, 25.0]));
    assert!((hole.measured.unwrap() - 4.0).abs() < 1e-6);
    assert_eq!(hole.message, "The hole is 4.00 mm wide; the least is 5 mm.");
    let web = one(Limits { smallest_web: Some(2.0), ..Limits::default() });
    assert_eq!(web.code, CheckCode::WebTooThin);
    assert!((web.measured.unwrap() - 1.5).abs() < 0.02 && (web.at[0] - 6.75).abs() < 0.1, "{web:?}");
    let edge = one(Limits { hole_to_edge: Some(3.0), ..Limits::default() });
    assert_eq!(edge.code, CheckCode::HoleTooCloseToEdge);
    assert!((edge.measured.unwrap() - 2.0).abs() < 1e-6 && (edge.at[0] - 1.0).abs() < 1e-6);
    let large = one(Limits { largest_part: Some([40.0, 90.0]), ..Limits::default() });
    assert_eq!((large.code, large.measured, large.limit), (CheckCode::PartTooLarge, Some(100.0), Some(90.0)));
    let small = one(Limits { smallest_part: Some([100.0, 60.0]), ..Limits::default() });
    assert_eq!((small.code, small.measured, small.limit), (CheckCode::PartTooSmall, Some(50.0), Some(60.0)));
    // At the limit is within it.
    let met = Limits {
        smallest_hole: Some(4.0),
        smallest_web: Some(1.5),
        hole_to_edge: Some(2.0),
        smallest_part: Some([100.0, 50.0]),
        largest_part: Some([100.0, 50.0]),
        floating_pieces: Some(false),
    };
    assert_eq!(exceeded(met), []);
    assert_eq!(job.quote(&Terms::default()).unwrap().checks, None);
    let says = job.quote(&Terms {
        limits: Limits { smallest_web: Some(-1.0), ..Limits::default() },
        ..Terms::default()
    });
    assert!(
        says.unwrap_err().to_string().starts_with("The limits' field \"smallest_web\" is -1. Give a number")
    );
}

#[test]
fn pieces_in_holes_float_and_findings_count_for_the_part_they_lie_on() {
    let square = |half: f64, x: f64| {
        let c = |u: f64, v: f64| (DVec2::new(x + u * half, v * half), 0.0);
        Entity::Polyline(vec![c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)], true)
    };
    let job = job(
        drawn(&[square(100.0, 0.0), square(50.0, 0.0), square(20.0, 0.0), square(5.0, 300.0)]),
        json!({}),
        json!({ "moves": 500 }),
    );
    let limits = Limits { floating_pieces: Some(false), ..Limits::default() };
    let quote = job.quote(&Terms { limits, ..Terms::default() }).unwrap();
    let found = &quote.checks.unwrap().exceeded;
    assert_eq!(
        found.iter().map(|e| (e.code, e.part, e.at)).collect::<Vec<_>>(),
        [(CheckCode::FloatingPiece, 2, [0.0, 0.0])]
    );
    assert!(quote.parts.iter().flat_map(|g| &g.items).all(|i| i.confidence.level == Level::High));
}

/// A plate of 100 x 100 with round holes of these radii at these places from its middle.
fn square_plate(holes: &[(f64, f64, f64)], put: &Similarity) -> Vec<Entity> {
    let corner = |x, y| (DVec2::new(x, y) * 50.0, 0.0);
    let outer = Entity::Polyline(
        vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)],
        true,
    );
    let holes = holes.iter().map(|&(x, y, r)| Entity::Circle(DVec2::new(x, y), r));
    std::iter::once(outer).chain(holes).map(|e| e.transformed(put)).collect()
}

/// Parts were compared by the areas of their holes and their distances from the middle alone.
#[test]
fn parts_whose_holes_lie_at_other_angles_are_different() {
    let opposite = [(-30.0, 0.0, 5.0), (30.0, 0.0, 5.0)];
    let diagonal = [(-18.0, -24.0, 5.0), (18.0, 24.0, 5.0)];
    let adjacent = [(-30.0, 0.0, 5.0), (0.0, 30.0, 5.0)];
    let large_first = [(-30.0, 0.0, 6.0), (0.0, 30.0, 5.0), (30.0, 0.0, 5.0)];
    let large_between = [(-30.0, 0.0, 5.0), (0.0, 30.0, 6.0), (30.0, 0.0, 5.0)];
    let crooked = [(-30.0, 0.0, 5.0), (0.0, 30.0, 4.0), (10.0, -20.0, 3.0)];
    let kinds: [&[(f64, f64, f64)]; 6] =
        [&opposite, &diagonal, &adjacent, &large_first, &large_between, &crooked];
    let mut entities = Vec::new();
    for (row, holes) in (0_u8..).zip(kinds) {
        for (column, turn) in (0_u8..).zip([0.0, 0.7, 1.9, 4.0]) {
            let shift = DVec2::new(200.0 * f64::from(column), 200.0 * f64::from(row));
            let mut part =
                square_plate(holes, &Similarity { mirror: column % 2 == 1, turn, scale: 1.0, shift });
            if column > 1 {
                part.reverse();
            }
            entities.extend(part);
        }
    }
    let quote = of(&job(drawn(&entities), json!({}), json!({ "moves": 500 })), &Material::default());
    assert_eq!(quote.parts.iter().map(|g| g.count).collect::<Vec<_>>(), [4; 6]);
}

/// Its width was that of its hull, 29 mm, so that no limit found it.
#[test]
fn a_bent_slot_is_as_wide_as_the_slot() {
    let closed = |corners: &[(f64, f64)]| {
        Entity::Polyline(corners.iter().map(|&(x, y)| (DVec2::new(x, y), 0.0)).collect(), true)
    };
    let plate = closed(&[(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)]);
    let slot = closed(&[(20.0, 20.0), (60.0, 20.0), (60.0, 21.0), (21.0, 21.0), (21.0, 60.0), (20.0, 60.0)]);
    let job = job(drawn(&[plate, slot]), json!({}), json!({ "moves": 500 }));
    let limits = Limits { smallest_hole: Some(3.0), ..Limits::default() };
    let quote = job.quote(&Terms { limits, ..Terms::default() }).unwrap();
    let width = quote.smallest_hole.unwrap().width;
    assert!((1.0..1.18).contains(&width), "{width}");
    let exceeded = quote.checks.unwrap().exceeded;
    assert_eq!(
        exceeded.iter().map(|e| (e.code, e.measured)).collect::<Vec<_>>(),
        [(CheckCode::HoleTooSmall, Some(width))]
    );
}
