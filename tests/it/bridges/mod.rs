//! Bridges (`levers.bridges`): which parts are connected, what that saves, and what plans with them look like.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

mod checked;
mod choice;
mod later;
mod later_checked;
mod others;
mod tipping;
mod tipping_checked;

use crate::testkit::dialects::read_back;
use crate::testkit::dxf_text::{Entity, Scene, Similarity};
use crate::testkit::sheets::machine;
use kerfway::geometry::{DVec2, Segment, math};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{Bridges, Levers, Profile};
use kerfway::plan::{Move, Plan};
use kerfway::quote::quote;
use serde_json::Value;

fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn bridging(width: f64, reach: f64) -> Profile {
    let bridges = Bridges { width, reach, clearance: 1.0, most: None, cut_later: false };
    Profile { levers: Levers { bridges: Some(bridges), ..Levers::default() }, ..plain() }
}

fn plain() -> Profile {
    machine("fibre-6kw-thick")
}

/// Changes fields of an object, at any depth.
fn merge(into: &mut Value, change: &Value) {
    match (into, change) {
        (Value::Object(into), Value::Object(change)) => {
            for (key, value) in change {
                merge(into.entry(key.clone()).or_insert(Value::Null), value);
            }
        }
        (into, change) => *into = change.clone(),
    }
}

/// The machine with some fields of its JSON changed.
fn with(machine: &Profile, change: &Value) -> Profile {
    let mut json = serde_json::to_value(machine).unwrap();
    merge(&mut json, change);
    serde_json::from_value(json).unwrap()
}

fn rectangle(at: DVec2, size: DVec2) -> Entity {
    let corners = [p(0.0, 0.0), p(1.0, 0.0), p(1.0, 1.0), p(0.0, 1.0)];
    Entity::Polyline(corners.map(|c| (at + c * size, 0.0)).to_vec(), true)
}

/// Rectangles in columns and rows, this far apart.
fn nest(columns: u32, rows: u32, size: DVec2, gap: f64) -> Vec<Entity> {
    let at = |k: u32| p(f64::from(k % columns), f64::from(k / columns)) * (size + gap) + 10.0;
    (0..columns * rows).map(|k| rectangle(at(k), size)).collect()
}

/// The same with a hole in each.
fn nest_with_holes(columns: u32, rows: u32) -> Vec<Entity> {
    let size = p(60.0, 40.0);
    let at = |k: u32| p(f64::from(k % columns), f64::from(k / columns)) * (size + 8.0) + 10.0;
    let holes = (0..columns * rows).map(|k| Entity::Circle(at(k) + p(20.0, 15.0), 6.0));
    nest(columns, rows, size, 8.0).into_iter().chain(holes).collect()
}

fn drawn(drawing: &[Entity]) -> String {
    let entities = drawing.iter().map(|e| (e.clone(), "CUT".to_owned())).collect();
    Scene { entities, units: 4 }.dxf()
}

fn started(drawing: &[Entity], machine: Profile, load: &LoadOptions, moves: u64) -> Job {
    let mut job = Job::load(drawn(drawing).into(), "nest.dxf", load).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    let options =
        PlanOptions { machine, moves: Some(moves), seed: 1, allow_off_bed: true, ..PlanOptions::default() };
    job.start(&options).unwrap();
    job.run_mut().unwrap().step(moves);
    job
}

fn planned(drawing: &[Entity], machine: Profile) -> Job {
    started(drawing, machine, &LoadOptions::default(), 20_000)
}

/// The plan of a drawing, checked.
fn plan_of(drawing: &[Entity], machine: Profile) -> Plan {
    planned(drawing, machine).plan().unwrap()
}

/// The pairs of parts that are connected.
fn pairs(plan: &Plan) -> Vec<[u32; 2]> {
    let mut pairs: Vec<[u32; 2]> = plan.bridges.iter().map(|s| s.contours).collect();
    pairs.sort_unstable();
    pairs
}

fn cut(plan: &Plan) -> Vec<Segment> {
    plan.moves
        .iter()
        .flat_map(|m| if let Move::Cut { path, .. } = m { path.clone() } else { vec![] })
        .collect()
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * (1.0 + b.abs()), "{a} is not {b}");
}

#[test]
fn two_squares_are_one_cut() {
    let squares = nest(2, 1, p(20.0, 20.0), 8.0);
    // A head that stops in every corner.
    let stops = with(&bridging(3.0, 10.0), &serde_json::json!({ "junction_deviation": 0.0 }));
    let job = planned(&squares, stops.clone());
    let plan = job.plan().unwrap();
    let s = &plan.summary;
    assert_eq!((s.bridges, s.pierces, s.contours, s.parts), (1, 1, 2, 2));
    near(s.cut_length, 2.0 * 80.0 - 2.0 * 3.0 + 2.0 * 8.0);
    let [strip] = plan.bridges[..] else { panic!("{:?}", plan.bridges) };
    assert_eq!(strip.contours, [0, 1]);
    assert_eq!(strip.sides, [[p(30.0, 18.5), p(38.0, 18.5)], [p(38.0, 21.5), p(30.0, 21.5)]]);
    // Six whole sides, four halves of opened ones, and two sides of the strip, from rest to rest each.
    let run = |length: f64| length / 33.0 + 33.0 / 3000.0;
    near(s.cut_time, 6.0 * run(20.0) + 4.0 * run(8.5) + 2.0 * run(8.0));
    near(s.pierce_time, 0.8 + 0.2 + 0.1);
    // All of it is cut once: the sum of the elements by x and y.
    let upright: f64 = cut(&plan).iter().map(|e| (e.end() - e.start()).y.abs()).sum();
    near(upright, 2.0 * 20.0 + 2.0 * 17.0);
    let without = plan_of(&squares, with(&plain(), &serde_json::json!({ "junction_deviation": 0.0 })));
    assert_eq!((without.summary.bridges, without.summary.pierces), (0, 2));
    assert!(without.bridges.is_empty());
    near(without.summary.cut_time, 8.0 * run(20.0));
    assert!(without.summary.total_time > s.total_time + 0.8);
}

#[test]
fn with_a_kerf_the_strip_keeps_its_width() {
    let squares = nest(2, 1, p(20.0, 20.0), 8.0);
    let plan = plan_of(&squares, Profile { kerf_width: 0.4, ..bridging(3.0, 10.0) });
    // The beam runs 0.2 mm beside outlines and strip: sides of 20.4 mm, openings of 3.4 mm, 7.6 mm across the waste.
    near(plan.summary.cut_length, 8.0 * 20.4 - 2.0 * 3.4 + 2.0 * 7.6);
    let across: Vec<f64> = cut(&plan)
        .iter()
        .filter(|e| e.start().distance(e.end()) < 8.0 && (e.end() - e.start()).y.abs() < 1e-9)
        .map(|e| e.start().y)
        .collect();
    assert_eq!(across.len(), 2);
    near((across[0] - across[1]).abs(), 3.4);
}

#[test]
fn a_nest_is_pierced_once_and_holes_come_before() {
    let drawing = nest_with_holes(4, 2);
    let (plan, without) = (plan_of(&drawing, bridging(3.0, 10.0)), plan_of(&drawing, plain()));
    let s = &plan.summary;
    assert_eq!((s.bridges, s.pierces, s.contours, s.parts), (7, 8 + 1, 16, 8));
    assert_eq!(without.summary.pierces, 16);
    assert!(
        without.summary.total_time - s.total_time > 7.0 * 0.5,
        "{} {}",
        without.summary.total_time,
        s.total_time
    );
    let order: Vec<u32> = plan
        .moves
        .iter()
        .filter_map(|m| if let Move::Cut { contour, .. } = m { Some(*contour) } else { None })
        .collect();
    assert_eq!(order.last(), Some(&0));
    let all = plan
        .moves
        .iter()
        .rev()
        .find_map(|m| if let Move::Cut { with, .. } = m { Some(with.clone()) } else { None });
    assert_eq!(all.unwrap(), [1, 2, 3, 4, 5, 6, 7]);
}

#[test]
fn no_more_parts_than_asked_for_are_connected() {
    for most in [2_u32, 3, 4] {
        let machine =
            with(&bridging(3.0, 10.0), &serde_json::json!({ "levers": { "bridges": { "most": most } } }));
        let job = planned(&nest(4, 3, p(30.0, 20.0), 8.0), machine);
        job.plan().unwrap();
        let sizes: Vec<usize> = job.beam_sheet().bridged.iter().map(|b| b.outlines.len()).collect();
        assert_eq!(sizes.iter().max(), Some(&(most as usize)), "{sizes:?}");
    }
}

#[test]
fn what_saves_nothing_or_has_no_room_stays_apart() {
    let two = nest(2, 1, p(20.0, 20.0), 8.0);
    let connected = |drawing: &[Entity], machine: Profile| plan_of(drawing, machine).summary.bridges;
    assert_eq!(connected(&two, bridging(3.0, 8.0)), 1);
    assert_eq!(connected(&two, bridging(3.0, 7.9)), 0);
    // Beside a strip of 18 mm, a millimetre to either corner is left; less is too little.
    assert_eq!(connected(&two, bridging(18.0, 8.0)), 1);
    assert_eq!(connected(&two, bridging(18.1, 8.0)), 0);
    // Where piercing takes no time, the sides of the strip take longer than what it saves.
    let quick = Profile { pierce_time: 0.0, beam_on_delay: 0.0, beam_off_delay: 0.0, ..bridging(3.0, 8.0) };
    let plan = plan_of(&two, quick.clone());
    assert_eq!(plan.summary.bridges, 0);
    // The plan is that of the machine without bridges.
    assert_eq!(plan, plan_of(&two, Profile { levers: Levers::default(), ..quick }));
    // A small part, an open cut, or a mark across the waste between the two.
    let wall = Entity::Line(p(34.0, 0.0), p(34.0, 60.0));
    assert_eq!(connected(&[two.clone(), vec![wall.clone()]].concat(), bridging(3.0, 30.0)), 0);
    let small = rectangle(p(33.0, 19.0), p(2.0, 2.0));
    let plan = plan_of(&[two.clone(), vec![small]].concat(), bridging(3.0, 30.0));
    assert!(!plan.bridges.is_empty());
    for strip in plan.bridges.iter().filter(|s| s.contours == [0, 1]) {
        assert!(strip.sides[0][0].y <= 18.0 - 3.0 || strip.sides[0][0].y >= 22.0, "{strip:?}");
    }
    let marked = LoadOptions { mark: vec![2], ..LoadOptions::default() };
    let job = started(&[two.clone(), vec![wall]].concat(), bridging(3.0, 30.0), &marked, 20_000);
    assert_eq!(job.plan().unwrap().summary.bridges, 0);
}

#[test]
fn what_a_person_decided_of_an_outline_keeps_it_apart() {
    let three = nest(3, 1, p(20.0, 20.0), 8.0);
    let found =
        |load: LoadOptions| pairs(&started(&three, bridging(3.0, 10.0), &load, 5_000).plan().unwrap());
    assert_eq!(found(LoadOptions::default()), [[0, 1], [1, 2]]);
    for load in [
        LoadOptions { first: vec![0], ..LoadOptions::default() },
        LoadOptions { last: vec![0], ..LoadOptions::default() },
        LoadOptions { sequences: vec![vec![0, 1]], ..LoadOptions::default() },
        LoadOptions { together: vec![vec![0, 2]], ..LoadOptions::default() },
        LoadOptions {
            joints: vec![kerfway::sheet::HandJoint { contour: 0, at: 0.1 }],
            ..LoadOptions::default()
        },
        LoadOptions { mark: vec![0], ..LoadOptions::default() },
        LoadOptions { exclude: vec![0], ..LoadOptions::default() },
    ] {
        assert!(found(load.clone()).iter().all(|pair| !pair.contains(&0)), "{load:?}");
    }
}

#[test]
fn discs_and_slanted_sides_are_connected_too() {
    // Three discs and a rectangle in a row; a strip on a disc ends where its sides meet the circle.
    let mut drawing: Vec<Entity> =
        (0..3).map(|k| Entity::Circle(p(30.0 + 50.0 * f64::from(k), 30.0), 20.0)).collect();
    drawing.push(rectangle(p(160.0, 10.0), p(30.0, 40.0)));
    let plan = plan_of(&drawing, bridging(4.0, 12.0));
    assert_eq!(pairs(&plan), [[0, 1], [1, 2], [2, 3]]);
    let open = 2.0 * 20.0 * math::asin(0.1);
    let sagitta = 20.0 - (20.0_f64 * 20.0 - 4.0).sqrt();
    let circles = 3.0 * 40.0 * std::f64::consts::PI - 5.0 * open;
    let sides = 2.0 * (2.0 * (10.0 + 2.0 * sagitta) + 10.0 + sagitta);
    near(plan.summary.cut_length, circles + 140.0 - 4.0 + sides);
    assert_eq!(plan.summary.pierces, 1);
    // Two sides that lean towards each other by 8 degrees, and two by 23.
    let leaning = |lean: f64| {
        let corners = [p(60.0, 10.0), p(90.0, 10.0), p(90.0, 50.0), p(60.0 - lean, 50.0)];
        let leaning = Entity::Polyline(corners.map(|c| (c, 0.0)).to_vec(), true);
        plan_of(&[rectangle(p(10.0, 10.0), p(30.0, 40.0)), leaning], bridging(4.0, 30.0))
    };
    let plan = leaning(5.6);
    assert_eq!(plan.summary.bridges, 1);
    let [[a, b], [c, d]] = plan.bridges[0].sides;
    near((b - a).normalize().perp_dot(c - a), 4.0);
    near((b - a).normalize().perp_dot(d - b), 4.0);
    assert_eq!(leaning(17.0).summary.bridges, 0);
}

#[test]
fn moved_turned_and_mirrored_nests_have_the_same_bridges() {
    let drawing = nest_with_holes(3, 2);
    let wanted = plan_of(&drawing, bridging(3.0, 10.0));
    let quarter = std::f64::consts::FRAC_PI_2;
    for (mirror, turn, shift) in [
        (false, 0.0, p(31.7, 12.9)),
        (false, quarter, p(400.0, 0.0)),
        (true, 0.0, p(0.0, 300.0)),
        (false, 0.3, p(200.0, 50.0)),
    ] {
        let t = Similarity { mirror, turn, scale: 1.0, shift };
        let moved: Vec<Entity> = drawing.iter().map(|e| e.transformed(&t)).collect();
        let plan = plan_of(&moved, bridging(3.0, 10.0));
        assert_eq!(pairs(&plan), pairs(&wanted), "{t:?}");
        assert!((plan.summary.cut_length - wanted.summary.cut_length).abs() < 1e-6, "{t:?}");
        assert!((plan.summary.cut_time - wanted.summary.cut_time).abs() < 0.05, "{t:?}");
    }
}

#[test]
fn programs_of_all_dialects_are_read_back() {
    let drawing = nest_with_holes(2, 2);
    let planned = |machine: &Profile| {
        let job = planned(&drawing, machine.clone());
        (job.beam_sheet().clone(), job.plan().unwrap())
    };
    // One piece of material, with four holes in it.
    read_back(&bridging(3.0, 10.0), planned, 1, |dialect, plan, text| {
        assert_eq!(plan.summary.bridges, 3, "{dialect}");
        // The reader has compared the program with the plan, point by point; here every coordinate of a strip is in it.
        let Some(text) = text else { return };
        for place in plan.bridges.iter().flat_map(|s| s.sides).flatten() {
            let x = format!("{:.3}", place.x);
            assert!(text.contains(x.trim_end_matches('0').trim_end_matches('.')), "{dialect}: {x}");
        }
    });
}

#[test]
fn pictures_documents_and_quotes_know_the_parts() {
    let drawing = nest_with_holes(3, 1);
    let job = planned(&drawing, bridging(3.0, 10.0));
    let svg = job.output(OutputKind::Svg).unwrap();
    assert_eq!(svg.matches("class=\"bridge\"").count(), 1);
    assert!(svg.contains("Sides of bridges between parts"));
    assert!(!planned(&drawing, plain()).output(OutputKind::Svg).unwrap().contains("bridge"));
    for kind in [OutputKind::Dxf, OutputKind::Lbrn2] {
        assert!(!job.output(kind).unwrap().is_empty());
    }
    let json = job.output(OutputKind::Json).unwrap();
    let document: Value = serde_json::from_str(&json).unwrap();
    let schema: Value = serde_json::from_str(include_str!("../../../www/sdk/plan.schema.json")).unwrap();
    assert_eq!(crate::testkit::schema::fault(&schema, &schema, &document, "plan"), None);
    assert_eq!(document["bridges"].as_array().unwrap().len(), 2);
    let contours = document["contours"].as_array().unwrap();
    let of = |id: usize, field: &str| contours[id][field].clone();
    for id in 0..3 {
        assert_eq!((of(id, "bridged"), of(id, "operation")), (0.into(), "cut".into()));
        near(of(id, "length").as_f64().unwrap(), 200.0);
        near(of(id, "area").as_f64().unwrap(), 2400.0);
        assert_eq!(of(id + 3, "inside"), id);
    }
    // The quote has three equal parts, and their seconds add up to those of the job.
    let report = quote(&job.document().unwrap(), &kerfway::quote::Terms::default()).unwrap();
    assert_eq!((report.part_count, report.parts.len(), report.parts[0].count), (3, 1, 3));
    near(report.net_area, 3.0 * (2400.0 - std::f64::consts::PI * 36.0));
    let times: Vec<f64> = report.parts[0].items.iter().map(|i| i.times.total).collect();
    near(times.iter().sum::<f64>() + report.loose_times.total, report.times.total);
    let cuts: Vec<f64> = report.parts[0].items.iter().map(|i| i.times.cut).collect();
    assert!(cuts.iter().all(|c| (c - cuts[0]).abs() < 1e-6), "{cuts:?}");
}

#[test]
fn the_drawing_is_shown_with_the_sides_of_bridges() {
    let job = planned(&nest(3, 1, p(20.0, 20.0), 8.0), bridging(3.0, 10.0));
    assert_eq!(job.common_cuts().offsets.len() - 1, 4);
    let (contours, lines) = job.beam_paths().unwrap();
    assert_eq!(contours.len(), 3);
    // The first goes around all three; the others have no line of their own.
    assert_eq!(lines.offsets[1], lines.offsets[3]);
    let findings = &job.run().unwrap().findings;
    assert!(
        findings
            .iter()
            .any(|f| f.message == "3 parts are connected by 2 bridges to 1 piece, which a person separates.")
    );
    let apart = planned(&nest(2, 1, p(20.0, 20.0), 80.0), bridging(3.0, 10.0));
    assert!(apart.run().unwrap().findings.iter().any(|f| f.message.starts_with("No bridge saves time")));
}
