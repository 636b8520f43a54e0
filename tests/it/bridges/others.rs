//! Bridges beside everything else that a machine or a person may ask for: every plan passes the checker, or is refused in a sentence.

use super::{bridging, drawn, nest, nest_with_holes, p, pairs, plan_of, planned, rectangle, started, with};
use crate::testkit::dxf_text::Entity;
use crate::testkit::jobs::each_planned;
use crate::testkit::sheets::XorShift;
use crate::testkit::{files, fixtures};
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::Profile;
use kerfway::sheet::PassOrder;
use serde_json::{Value, json};

/// What machines may have besides.
pub(super) fn kinds() -> Vec<(&'static str, Value)> {
    let lead = json!({ "kind": "line", "length": 2.0 });
    let slats = json!({ "pitch": 60.0 });
    vec![
        ("nothing", json!({})),
        (
            "leads",
            json!({ "leads": { "clearance": 0.5, "rules": [{ "lead_in": lead, "lead_out": lead, "overcut": 0.5 }] } }),
        ),
        ("kerf", json!({ "kerf_width": 0.4 })),
        (
            "kerf and leads",
            json!({ "kerf_width": 0.3, "leads": { "clearance": 0.5, "rules": [{ "lead_in": lead }] } }),
        ),
        (
            "moving pierce",
            json!({ "levers": { "moving_pierce": { "overcut": 0.5 } }, "beam_off_delay": 0.8 }),
        ),
        ("chains", json!({ "levers": { "chains": { "reach": 30.0, "edge_starts": true } } })),
        (
            "common cuts",
            json!({ "kerf_width": 0.4, "levers": { "common_cuts": { "shift": 2.0, "shift_parts": true } } }),
        ),
        (
            "tips",
            json!({ "z_speed": 100.0, "levers": { "lift": { "height": 10.0 }, "tips": { "slats": slats } } }),
        ),
        ("heat", json!({ "levers": { "heat": { "distance": 10.0, "seconds": 2.0, "charge": 0.5 } } })),
        ("heat that waits", json!({ "levers": { "heat": { "distance": 10.0, "seconds": 2.0 } } })),
        ("corners", json!({ "levers": { "corners": { "outer": "loop", "hole": "round" } } })),
        ("rounded corners", json!({ "levers": { "corners": { "outer": "round" } } })),
        ("joints", json!({ "joints": { "rules": [{ "width": 0.5, "count": 3 }] } })),
        (
            "skeleton",
            json!({ "skeleton": { "spacing_x": 50.0, "spacing_y": 50.0, "clearance": 2.0 }, "bed": [0.0, 0.0, 500.0, 400.0] }),
        ),
        (
            "sharp corners",
            json!({ "sharp_corner": { "angle": 1.6, "time": 0.01 }, "beam_on_delay": 0.01, "beam_off_delay": 0.01 }),
        ),
        ("passes", json!({ "cut": { "passes": 3 } })),
        ("passes that lower the head", json!({ "z_speed": 50.0, "cut": { "passes": 2, "z_step": 1.0 } })),
    ]
}

#[test]
fn every_kind_of_machine_connects_parts_in_plans_that_pass() {
    let drawing = nest_with_holes(3, 2);
    for (name, change) in kinds() {
        let machine = with(&bridging(3.0, 10.0), &change);
        for order in [PassOrder::Contour, PassOrder::Sheet] {
            let load = LoadOptions { pass_order: order, ..LoadOptions::default() };
            let job = started(&drawing, machine.clone(), &load, 5_000);
            let plan = job.plan().unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(plan.summary.bridges, 5, "{name}");
            assert_eq!((plan.summary.contours, plan.summary.parts), (12, 6), "{name}");
        }
    }
}

/// The second pass of a cut through a bridge begins where the first one ends, with the beam off in between, and runs back.
#[test]
fn passes_over_cuts_through_bridges_turn_in_no_sharp_corner() {
    let mut machine = with(
        &bridging(3.0, 10.0),
        &json!({ "pierce_time": 10.0, "levers": { "bridges": { "cut_later": true } } }),
    );
    machine.cut.passes = 2;
    let machine = with(&machine, &json!({ "sharp_corner": { "angle": 1.2, "time": 0.2 } }));
    let job = started(&nest(2, 1, p(60.0, 40.0), 8.0), machine, &LoadOptions::default(), 1_000);
    assert_eq!(job.plan().unwrap().summary.bridges, 1);
}

#[test]
fn layers_have_bridges_and_parts_one_by_one_do_not() {
    let drawing = nest_with_holes(3, 1);
    let by_layer = LoadOptions { order_by_layer: true, ..LoadOptions::default() };
    assert_eq!(started(&drawing, bridging(3.0, 10.0), &by_layer, 5_000).plan().unwrap().summary.bridges, 2);
    let by_part = LoadOptions { part_by_part: true, ..LoadOptions::default() };
    assert_eq!(
        refused(&by_part, json!({})),
        "Parts that bridges connect are finished together. Leave out \"levers.bridges\", or do not cut part by part."
    );
}

#[test]
fn parts_in_a_hole_are_connected_to_each_other_only() {
    // A frame with two squares in its window, and a square beside it.
    let mut drawing = vec![rectangle(p(10.0, 10.0), p(100.0, 60.0)), rectangle(p(20.0, 20.0), p(80.0, 40.0))];
    drawing.extend([rectangle(p(28.0, 28.0), p(20.0, 20.0)), rectangle(p(56.0, 28.0), p(20.0, 20.0))]);
    drawing.push(rectangle(p(118.0, 20.0), p(20.0, 20.0)));
    let plan = plan_of(&drawing, bridging(3.0, 10.0));
    assert_eq!(pairs(&plan), [[0, 4], [2, 3]]);
}

#[test]
fn outlines_that_share_a_cut_or_stand_one_kerf_apart_are_not_connected() {
    // Two that touch, two that are one kerf apart, and two that are free.
    let mut drawing = nest(2, 1, p(20.0, 20.0), 0.0);
    drawing.extend([rectangle(p(10.0, 38.0), p(20.0, 20.0)), rectangle(p(30.4, 38.0), p(20.0, 20.0))]);
    drawing.extend([rectangle(p(10.0, 66.0), p(20.0, 20.0)), rectangle(p(38.0, 66.0), p(20.0, 20.0))]);
    let machine = with(&bridging(3.0, 10.0), &json!({ "kerf_width": 0.4, "levers": { "common_cuts": {} } }));
    assert_eq!(pairs(&plan_of(&drawing, machine)), [[4, 5]]);
}

#[test]
fn machines_that_cut_outlines_in_pieces_refuse_bridges() {
    let refused = |change: Value| refused(&LoadOptions::default(), change);
    assert_eq!(
        refused(json!({ "pre_cut_time": 0.5 })),
        "The machine has levers.bridges and pre_cut_time. Outlines that bridges connect are cut in one go: give one of them."
    );
    assert_eq!(
        refused(json!({ "levers": { "fly": { "reach": 20.0 } } })),
        "The machine has levers.bridges and levers.fly. Outlines that bridges connect are cut in one go: give one of them."
    );
    let far = refused(json!({ "levers": { "bridges": { "width": 0.01 } } }));
    assert!(far.contains("levers.bridges.width"), "{far}");
}

/// What is said of a job that is not planned.
pub(super) fn refused(load: &LoadOptions, change: Value) -> String {
    let machine = MachineChoice::Profile(Box::new(with(&bridging(3.0, 10.0), &change)));
    let mut job = Job::load(drawn(&nest(2, 1, p(20.0, 20.0), 8.0)).into(), "two.dxf", load).unwrap();
    job.start(&PlanOptions { machine, ..PlanOptions::default() }).err().unwrap().to_string()
}

/// Parts of several shapes at random places, with holes in some.
pub(super) fn random(rng: &mut XorShift) -> Vec<Entity> {
    let mut drawing = Vec::new();
    for k in 0..12_u32 {
        let at = p(f64::from(k % 4), f64::from(k / 4)) * p(52.0, 46.0) + 10.0;
        let at = at + p(rng.between(0.0, 4.0), rng.between(0.0, 4.0));
        let size = p(rng.between(24.0, 44.0), rng.between(20.0, 38.0));
        match rng.below(4) {
            0 => drawing.push(Entity::Circle(at + size.min_element() / 2.0, size.min_element() / 2.0)),
            1 => {
                let corners = [p(0.0, 0.0), p(1.0, 0.0), p(0.9, 1.0), p(0.0, 0.8)];
                drawing.push(Entity::Polyline(corners.map(|c| (at + c * size, 0.0)).to_vec(), true));
            }
            2 => {
                // A slot with round ends.
                let r = size.y / 2.0;
                let corners =
                    [(p(r, 0.0), 0.0), (p(size.x, 0.0), 1.0), (p(size.x, size.y), 0.0), (p(r, size.y), 1.0)];
                drawing.push(Entity::Polyline(
                    corners.map(|(c, b)| (at + c - p(r / 2.0, 0.0), b)).to_vec(),
                    true,
                ));
            }
            _ => drawing.push(rectangle(at, size)),
        }
        if rng.below(2) == 0 {
            drawing.push(Entity::Circle(at + size * 0.4, 3.0));
        }
    }
    drawing
}

#[test]
fn random_nests_pass_on_every_kind_of_machine() {
    let mut bridges = 0;
    for seed in 0..34_u64 {
        let mut rng = XorShift::new(900 + seed);
        let drawing = random(&mut rng);
        let kinds = kinds();
        let (name, change) = &kinds[usize::try_from(seed).unwrap() % kinds.len()];
        let own = json!({ "levers": { "bridges": { "width": rng.between(1.0, 5.0), "reach": rng.between(8.0, 30.0), "clearance": rng.between(0.0, 2.0) } } });
        let machine = with(&with(&bridging(3.0, 10.0), change), &own);
        let job = planned(&drawing, machine);
        let plan = job.plan().unwrap_or_else(|e| panic!("seed {seed}, {name}: {e}"));
        bridges += plan.summary.bridges;
        for kind in
            [kerfway::job::OutputKind::Svg, kerfway::job::OutputKind::Dxf, kerfway::job::OutputKind::Json]
        {
            job.output(kind).unwrap();
        }
    }
    assert!(bridges > 200, "{bridges}");
}

#[test]
fn real_drawings_and_sheets_pass() {
    let kinds = kinds();
    let paths = ["dxf-dev", "sheets"].map(|folder| files(&fixtures().join(folder), "dxf")).concat();
    let small = |path: &std::path::PathBuf| std::fs::metadata(path).unwrap().len() < 300_000;
    let paths: Vec<_> = paths.into_iter().filter(small).collect();
    let machine = |k: usize| {
        let width = [2.0, 5.0][k % 2];
        let own = json!({ "levers": { "bridges": { "width": width, "reach": 40.0, "clearance": 0.5 } } });
        with(&with(&bridging(3.0, 10.0), &kinds[k % kinds.len()].1), &own)
    };
    let (mut bridged, mut bridges) = (0, 0);
    each_planned(&paths, machine, |_, _, plan| {
        bridged += u32::from(plan.summary.bridges > 0);
        bridges += plan.summary.bridges;
    });
    assert!(bridged >= 5 && bridges > 40, "{bridged} {bridges}");
}

#[test]
fn ten_thousand_parts_are_connected_in_seconds() {
    let machine: Profile = bridging(3.0, 10.0);
    let mut job =
        Job::load(drawn(&nest(100, 100, p(20.0, 20.0), 8.0)).into(), "many.dxf", &LoadOptions::default())
            .unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, moves: Some(100), allow_off_bed: true, ..PlanOptions::default() })
        .unwrap();
    job.run_mut().unwrap().step(100);
    assert_eq!(job.run().unwrap().plan(job.beam_sheet()).summary.bridges, 9_999);
}
