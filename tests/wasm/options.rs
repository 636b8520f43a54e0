//! Unusable options are an error with one sentence, and the job can be used afterwards.

use crate::values::{circle, js, load, sentence};
use js_sys::Uint8Array;
use kerfway::wasm::Job;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

fn one_circle() -> Vec<u8> {
    circle("ANSI_1252", b"0")
}

#[wasm_bindgen_test]
fn wrong_load_options_name_the_field() {
    for (options, field) in [
        (r#"{"units":"parsec"}"#, "units"),
        (r#"{"tolerance":0}"#, "tolerance"),
        (r#"{"joinTolerance":-1}"#, "joinTolerance"),
        (r#"{"unit":"mm"}"#, "units"),
        (r#"{"layers":7}"#, "layers"),
        (r#"{"first":[-1]}"#, "first"),
    ] {
        let said = sentence(load(&one_circle(), options));
        assert!(said.contains(field) && said.ends_with(['.', '?']), "{options}: {said}");
    }
}

#[wasm_bindgen_test]
fn wrong_plan_options_name_the_field_and_are_not_the_end() {
    let mut job = load(&one_circle(), r#"{"units":"mm"}"#).ok().unwrap();
    for (options, word) in [
        (r#"{"machine":"none"}"#, "none"),
        (r#"{"moves":-1}"#, "moves"),
        (r#"{"moves":1.5}"#, "moves"),
        (r#"{"seconds":-1}"#, "seconds"),
        (r#"{"seed":-1}"#, "seed"),
        (r#"{"workers":65}"#, "workers"),
        (r#"{"sede":1}"#, "seed"),
        (r#"{"method":"luck"}"#, "luck"),
        (r#"{"machine":{"kerf_witdh":0.2}}"#, "kerf_width"),
    ] {
        let said = sentence(job.start(js(options)));
        assert!(said.contains(word) && said.ends_with(['.', '?']), "{options}: {said}");
    }
    assert!(sentence(job.step(1)).contains("no plan"));
    assert!(job.start(js("{}")).is_ok());
}

#[wasm_bindgen_test]
fn values_of_a_wrong_kind_are_refused_at_the_boundary() {
    let bytes = || JsValue::from(Uint8Array::from(one_circle().as_slice()));
    let empty = || js("{}");
    for name in [JsValue::from(5), JsValue::TRUE, empty(), JsValue::NULL] {
        assert!(sentence(Job::new(bytes(), name, empty())).contains("name"));
    }
    for file in [JsValue::from("0\nEOF"), JsValue::from(5), empty(), JsValue::UNDEFINED] {
        assert!(sentence(Job::new(file, "a.dxf".into(), empty())).contains("file"));
    }
    for options in [JsValue::from(7), JsValue::from("mm"), js("[]")] {
        assert!(sentence(Job::new(bytes(), "a.dxf".into(), options)).ends_with('.'));
    }
    for seconds in [f64::NAN, f64::INFINITY] {
        let options = js_sys::Object::new();
        assert!(js_sys::Reflect::set(&options, &"seconds".into(), &seconds.into()).unwrap());
        let mut job = load(&one_circle(), r#"{"units":"mm"}"#).ok().unwrap();
        assert!(sentence(job.start(options.into())).contains("seconds"));
    }
}

#[wasm_bindgen_test]
fn limits_of_drawings_hold_in_wasm() {
    // Blocks that contain two of the next, forty levels deep.
    let mut text = String::from("0\nSECTION\n2\nBLOCKS\n");
    for k in 0..40 {
        text += &format!("0\nBLOCK\n2\nB{k}\n");
        for _ in 0..2 {
            text += &format!("0\nINSERT\n8\n0\n2\nB{}\n10\n0\n20\n0\n", k + 1);
        }
        text += "0\nENDBLK\n";
    }
    text += "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n8\n0\n2\nB0\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n";
    let job = load(text.as_bytes(), r#"{"units":"mm"}"#);
    // Refused with a sentence, or read with a finding: never out of memory.
    match job {
        Ok(job) => assert!(js_sys::JSON::stringify(&job.report().ok().unwrap()).unwrap().includes("nest", 0)),
        Err(error) => assert!(sentence::<()>(Err(error)).contains("deep")),
    }
}
