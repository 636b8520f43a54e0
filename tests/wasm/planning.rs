//! A plan in slices: started, worked on, extended, offered paths, written and quoted.

use crate::values::{KEYBOARD, circle, get, js, load, number, sentence};
use js_sys::{Array, Uint32Array};
use kerfway::output::{OutputKind, WorkOrder, Written};
use kerfway::wasm::{Job, machines, methods, random_seed};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

fn keyboard(plan: &str) -> (Job, JsValue) {
    let mut job = load(KEYBOARD, "{}").ok().unwrap();
    let started = job.start(js(plan)).ok().unwrap();
    (job, started)
}

#[wasm_bindgen_test]
fn methods_and_machines_are_plain_objects() {
    let methods = Array::from(&methods().ok().unwrap());
    assert_eq!(get(&methods.get(0), "name").as_string().unwrap(), "tour-tree");
    assert_eq!(get(&methods.get(0), "source"), JsValue::NULL);
    let first = Array::from(&machines().ok().unwrap()).get(0);
    assert_eq!(get(&first, "name").as_string().unwrap(), "co2-100w");
    assert!(number(&get(&first, "cut"), "speed") > 0.0);
}

#[wasm_bindgen_test]
fn a_plan_runs_in_slices_and_is_written() {
    let (mut job, started) = keyboard(r#"{"seed":5,"moves":1000,"machine":"length"}"#);
    assert_eq!(number(&started, "seed"), 5.0);
    assert_eq!(get(&started, "method").as_string().unwrap(), "tour-tree");
    let baselines = get(&started, "baselines");
    let of = |name: &str| number(&get(&baselines, name), "total_time");
    assert!(of("greedy") < of("drawing"));
    let slice = job.step(400).ok().unwrap();
    assert_eq!(get(&slice, "end").as_string().unwrap(), "running");
    assert_eq!(number(&slice, "done"), 400.0);
    assert_eq!(job.moves().ok().unwrap(), 400.0);
    let best = job.best().ok().unwrap();
    let contours: Uint32Array = get(&get(&best, "path"), "contours").dyn_into().unwrap();
    assert_eq!(f64::from(contours.length()), number(&get(&best, "summary"), "contours"));
    // tests/package/golden.test.mjs hands work orders to the file with the writers.
    let order = WorkOrder::read(&job.work_order("gcode".into()).ok().unwrap()).unwrap();
    assert!(
        matches!(order.write(OutputKind::Gcode), Ok(Written::Text(text)) if text.starts_with("; Kerfway"))
    );
    assert!(matches!(order.write(OutputKind::Svg), Ok(Written::Text(text)) if text.contains("<svg")));
    assert!(sentence(job.work_order("pdf".into())).contains("pdf"));
}

#[wasm_bindgen_test]
fn the_last_slice_ends_at_the_budget_and_a_further_budget_goes_on() {
    let (mut job, _) = keyboard(r#"{"seed":5,"moves":1000}"#);
    let slice = job.step(5000).ok().unwrap();
    assert_eq!(get(&slice, "end").as_string().unwrap(), "budget");
    assert_eq!(number(&slice, "done"), 1000.0);
    assert_eq!(number(&job.step(10).ok().unwrap(), "done"), 0.0);
    assert!(job.extend(js(r#"{"moves":500}"#)).is_ok());
    assert_eq!(number(&job.step(5000).ok().unwrap(), "done"), 500.0);
}

#[wasm_bindgen_test]
fn a_better_path_is_taken_over_and_a_path_of_another_drawing_refused() {
    let (mut long, _) = keyboard(r#"{"seed":5,"moves":20000}"#);
    assert!(long.step(20_000).is_ok());
    let (mut short, _) = keyboard(r#"{"seed":6,"moves":10}"#);
    let total = |job: &Job| number(&get(&job.best().ok().unwrap(), "summary"), "total_time");
    assert!(total(&long) < total(&short));
    let path = get(&long.best().ok().unwrap(), "path");
    assert!(short.offer(path.clone()).ok().unwrap());
    assert_eq!(total(&long), total(&short));
    // Only a path from elsewhere is better by more than rounding, and is noted in the plan.
    let notes = |job: &Job| job.document().ok().unwrap().contains(r#""from_path":true"#);
    assert!(!short.take_over(path.clone()).ok().unwrap() && !notes(&short));
    let (mut third, _) = keyboard(r#"{"seed":7,"moves":10}"#);
    assert!(third.take_over(path.clone()).ok().unwrap() && notes(&third));
    assert_eq!(total(&long), total(&third));
    let mut other = load(&circle("ANSI_1252", b"0"), r#"{"units":"mm"}"#).ok().unwrap();
    assert!(other.start(js("{}")).is_ok());
    assert!(sentence(other.offer(path)).contains("does not fit this drawing"));
    assert!(sentence(other.offer(js("{}"))).ends_with('.'));
}

#[wasm_bindgen_test]
fn a_proof_of_the_bound_is_part_of_the_slices() {
    let (mut job, _) = keyboard(r#"{"seed":1,"moves":1200000,"machine":"length"}"#);
    assert_eq!(number(&job.step(999_999).ok().unwrap(), "bound"), 0.0);
    let bound = number(&job.step(200_000).ok().unwrap(), "bound");
    let total = number(&get(&job.best().ok().unwrap(), "summary"), "total_time");
    assert!(bound > 0.5 * total && bound <= total, "{bound} of {total}");
}

#[wasm_bindgen_test]
fn quotes_are_made_of_plans() {
    let (mut job, _) = keyboard(r#"{"seed":1,"moves":1000}"#);
    assert!(job.step(1000).is_ok());
    let quote = job.quote(js(r#"{"material":{"thickness":3,"density":7.85}}"#)).ok().unwrap();
    assert_eq!(get(&quote, "hash").as_string().unwrap().len(), 64);
    assert!(sentence(job.quote(js(r#"{"material":{"thicknes":3}}"#))).contains("thickness"));
}

#[wasm_bindgen_test]
fn seeds_come_from_the_platform() {
    let seeds: std::collections::BTreeSet<u32> = (0..8).map(|_| random_seed().ok().unwrap()).collect();
    // Two of eight 32-bit numbers are equal once in 150 million times.
    assert_eq!(seeds.len(), 8);
}
