//! Slots and holes too small for the beam are reported when a drawing is read, and again against the machine's kerf.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::dxf_text::{Entity, Scene};
use glam::DVec2;
use kerfway::finding::{Code, Severity};
use kerfway::job::{Job, LoadOptions, OutputKind, PlanOptions};
use kerfway::machine;
use serde_json::{Value, json};

const SLOTS: [f64; 4] = [0.02, 0.1, 0.2, 0.5];

/// A plate with a slot of each width, drawn as a polyline, 20 mm apart, and a round hole of 0.1 mm at (10, 30).
fn plate() -> Vec<u8> {
    let closed = |corners: &[(f64, f64)]| {
        Entity::Polyline(corners.iter().map(|&(x, y)| (DVec2::new(x, y), 0.0)).collect(), true)
    };
    let slot = |(k, w): (f64, f64)| {
        let x = 10.0 + 20.0 * k;
        closed(&[(x, 10.0), (x + 5.0, 10.0), (x + 5.0, 10.0 + w), (x, 10.0 + w)])
    };
    let mut entities = vec![closed(&[(0.0, 0.0), (100.0, 0.0), (100.0, 40.0), (0.0, 40.0)])];
    entities.extend([0.0, 1.0, 2.0, 3.0].into_iter().zip(SLOTS).map(slot));
    entities.push(Entity::Circle(DVec2::new(10.0, 30.0), 0.05));
    let entities = entities.into_iter().map(|e| (e, "CUT".to_owned())).collect();
    Scene { entities, units: 4 }.dxf().into_bytes()
}

/// Places along x and messages of the findings of a plan document.
fn too_small(kerf: f64) -> Vec<(f64, String)> {
    let mut job = Job::load(plate(), "plate.dxf", &LoadOptions::default()).unwrap();
    let mut profile = serde_json::to_value(machine::preset("co2-100w").unwrap()).unwrap();
    profile["kerf_width"] = json!(kerf);
    let options: PlanOptions = serde_json::from_value(json!({ "machine": profile, "moves": 100 })).unwrap();
    job.start(&options).unwrap();
    job.run_mut().unwrap().step(100);
    let document: Value = serde_json::from_str(&job.output(OutputKind::Json).unwrap()).unwrap();
    let all = document["findings"].as_array().unwrap().iter();
    all.filter(|f| f["code"] == "feature-too-small")
        .map(|f| (f["at"][0].as_f64().unwrap(), f["message"].as_str().unwrap().to_owned()))
        .collect()
}

#[test]
fn slots_narrower_than_a_tenth_of_a_millimetre_are_reported_when_a_drawing_is_read() {
    let job = Job::load(plate(), "plate.dxf", &LoadOptions::default()).unwrap();
    let found: Vec<_> =
        job.report().findings.into_iter().filter(|f| f.code == Code::FeatureTooSmall).collect();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].severity, found[0].layer.as_deref()), (Severity::Warning, Some("CUT")));
    let at = found[0].at.unwrap();
    assert!((10.0..15.0).contains(&at.x) && (at.y - 10.01).abs() < 1e-6, "{at}");
    assert!(
        found[0].message.starts_with("This contour is 0.02 mm wide at its widest place, less than 0.1 mm:")
    );
}

#[test]
fn features_narrower_than_the_kerf_of_the_machine_are_reported_with_the_plan() {
    let places = |kerf: f64| too_small(kerf).iter().map(|(x, _)| (x / 20.0).floor()).collect::<Vec<_>>();
    // Without a kerf width, and with one of 0.1 mm, only the slot of 0.02 mm is too narrow; what is as wide as the beam is not.
    assert_eq!(places(0.0), [0.0]);
    assert_eq!(places(0.1), [0.0]);
    // With a finer beam than the usual limit, what that beam can cut is not reported.
    assert_eq!(places(0.02), [0.0; 0]);
    // The slots of 0.02, 0.1 and 0.2 mm, and the hole of 0.1 mm, but not the slot of 0.5 mm.
    assert_eq!(places(0.3), [0.0, 1.0, 2.0, 0.0]);
    assert!(too_small(0.3)[3].1.contains("0.1 mm wide at its widest place, less than the kerf of 0.3 mm"));
}
