//! The bindings under Node, by wasm-bindgen's own test runner: what crosses into JavaScript, and that wasm computes
//! what the native build does.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "counts are exact")]

use js_sys::{Array, Float64Array, JSON, Reflect, Uint32Array};
use kerfway::job::{self, LoadOptions, OutputKind, PlanOptions, SliceEnd};
use kerfway::wasm::{Job, machines, methods};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

const KEYBOARD: &[u8] =
    include_bytes!("../fixtures/dxf-dev/peej_lumberjack-keyboard__lumberjack-polaris.dxf");
const KEYBOARD_NAME: &str = "peej_lumberjack-keyboard__lumberjack-polaris.dxf";
const GOLDEN: &str = include_str!("../golden/keyboard.json");

fn js(json: &str) -> JsValue {
    JSON::parse(json).unwrap()
}

fn get(value: &JsValue, name: &str) -> JsValue {
    Reflect::get(value, &name.into()).unwrap()
}

/// A small drawing in a code page.
fn drawing(code_page: &str, layer: &[u8]) -> Vec<u8> {
    let head = format!("0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\n{code_page}\n0\nENDSEC\n");
    let circle = "\n10\n5\n20\n5\n40\n2\n0\nENDSEC\n0\nEOF\n";
    [head.as_bytes(), b"0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n", layer, circle.as_bytes()].concat()
}

#[wasm_bindgen_test]
fn the_golden_plan_is_the_same_bytes_in_wasm() {
    let mut job = job::Job::load(KEYBOARD.to_vec(), KEYBOARD_NAME, &LoadOptions::default()).unwrap();
    job.start(&PlanOptions { seed: 1, moves: Some(20_000), ..PlanOptions::default() }).unwrap();
    while job.run_mut().unwrap().step(777).end == SliceEnd::Running {}
    assert!(job.output(OutputKind::Json).unwrap() == GOLDEN);
}

#[wasm_bindgen_test]
fn methods_and_machines_are_plain_objects() {
    let methods = Array::from(&methods().ok().unwrap());
    assert!(get(&methods.get(0), "name").is_string());
    let first = Array::from(&machines().ok().unwrap()).get(0);
    assert_eq!(get(&first, "name").as_string().unwrap(), "co2-100w");
    assert!(get(&get(&first, "cut"), "speed").as_f64().unwrap() > 0.0);
}

#[wasm_bindgen_test]
fn a_drawing_crosses_as_report_and_typed_arrays() {
    let job = Job::new(drawing("ANSI_1252", b"0"), "a.dxf", js(r#"{"units":"mm"}"#)).ok().unwrap();
    let report = job.report().ok().unwrap();
    let contour = Array::from(&get(&report, "contours")).get(0);
    assert_eq!(get(&contour, "closed"), JsValue::TRUE);
    assert_eq!(get(&contour, "inside"), JsValue::NULL);
    let geometry = job.geometry().ok().unwrap();
    let segments: Float64Array = get(&geometry, "segments").dyn_into().unwrap();
    let offsets: Uint32Array = get(&geometry, "offsets").dyn_into().unwrap();
    assert_eq!(offsets.to_vec(), [0, 1]);
    assert_eq!(segments.to_vec(), [7.0, 5.0, 7.0, 5.0, 5.0, 5.0, std::f64::consts::TAU]);
}

#[wasm_bindgen_test]
fn a_plan_runs_in_slices_and_is_written() {
    let mut job = Job::new(KEYBOARD.to_vec(), "k.dxf", JsValue::UNDEFINED).ok().unwrap();
    let started = job.start(js(r#"{"seed":5,"moves":1000,"machine":"length"}"#)).ok().unwrap();
    assert_eq!(get(&started, "seed"), JsValue::from_f64(5.0));
    let slice = job.step(400).ok().unwrap();
    assert_eq!(get(&slice, "end"), JsValue::from_str("running"));
    assert_eq!(job.moves().ok().unwrap(), 400.0);
    let best = job.best().ok().unwrap();
    let contours: Uint32Array = get(&get(&best, "path"), "contours").dyn_into().unwrap();
    assert_eq!(f64::from(contours.length()), get(&get(&best, "summary"), "contours").as_f64().unwrap());
    assert!(job.output("gcode").ok().unwrap().starts_with("; Kerfway"));
    assert!(job.output("pdf").is_err());
}

#[wasm_bindgen_test]
fn wrong_options_are_an_error_and_not_the_end() {
    assert!(Job::new(drawing("ANSI_1252", b"0"), "a.dxf", js(r#"{"units":"parsec"}"#)).is_err());
    assert!(Job::new(drawing("ANSI_1252", b"0"), "a.dxf", js("7")).is_err());
    let mut job = Job::new(drawing("ANSI_1252", b"0"), "a.dxf", js("{}")).ok().unwrap();
    assert!(job.start(js(r#"{"machine":"none"}"#)).is_err());
    assert!(job.start(js(r#"{"moves":-1}"#)).is_err());
    assert!(job.step(1).is_err());
    assert!(job.start(js("{}")).is_ok());
}

/// Names in code pages whose tables the platform has.
#[wasm_bindgen_test]
fn layers_in_east_asian_code_pages_are_read() {
    let cases: [(&str, &[u8], &str); 4] = [
        ("ANSI_932", b"\x83\x8c\x81\x5b\x83\x55", "レーザ"),
        ("ANSI_936", b"\xc7\xd0\xb8\xee", "切割"),
        ("ANSI_949", b"\xc0\xfd\xb4\xdc", "절단"),
        ("ANSI_950", b"\xa4\xc1\xb3\xce", "切割"),
    ];
    for (page, bytes, name) in cases {
        let job = Job::new(drawing(page, bytes), "a.dxf", js(r#"{"units":"mm"}"#)).ok().unwrap();
        let contour = Array::from(&get(&job.report().ok().unwrap(), "contours")).get(0);
        assert_eq!(get(&contour, "layer").as_string().unwrap(), name, "{page}");
    }
}
