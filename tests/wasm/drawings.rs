//! A drawing crosses as a report and as typed arrays.

use crate::values::{circle, get, js, load, number, sentence};
use js_sys::{Array, Float64Array, Uint32Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn a_drawing_crosses_as_report_and_typed_arrays() {
    let job = load(&circle("ANSI_1252", b"0"), r#"{"units":"mm"}"#).ok().unwrap();
    let report = job.report().ok().unwrap();
    let contour = Array::from(&get(&report, "contours")).get(0);
    assert_eq!(get(&contour, "closed"), JsValue::TRUE);
    assert_eq!(get(&contour, "inside"), JsValue::NULL);
    assert!((number(&contour, "length") - 4.0 * std::f64::consts::PI).abs() < 1e-12);
    let geometry = job.geometry().ok().unwrap();
    let segments: Float64Array = get(&geometry, "segments").dyn_into().unwrap();
    let offsets: Uint32Array = get(&geometry, "offsets").dyn_into().unwrap();
    assert_eq!(offsets.to_vec(), [0, 1]);
    assert_eq!(segments.to_vec(), [7.0, 5.0, 7.0, 5.0, 5.0, 5.0, std::f64::consts::TAU]);
}

#[wasm_bindgen_test]
fn the_bytes_of_the_file_come_back() {
    let bytes = circle("ANSI_1252", b"0");
    assert_eq!(load(&bytes, "{}").ok().unwrap().bytes(), bytes);
}

#[wasm_bindgen_test]
fn ignored_layers_cross_with_their_geometry() {
    let options = r#"{"units":"mm","layers":[{"name":"0","operation":"ignore"}]}"#;
    let job = load(&circle("ANSI_1252", b"0"), options).ok().unwrap();
    let ignored = job.ignored().ok().unwrap();
    let layers: Uint32Array = get(&ignored, "layers").dyn_into().unwrap();
    assert_eq!(layers.to_vec(), [0]);
    let offsets: Uint32Array = get(&get(&ignored, "geometry"), "offsets").dyn_into().unwrap();
    assert_eq!(offsets.to_vec(), [0, 1]);
}

#[wasm_bindgen_test]
fn reloading_with_other_units_scales_the_drawing() {
    let mut job = load(&circle("ANSI_1252", b"0"), r#"{"units":"mm"}"#).ok().unwrap();
    assert!(job.reload(js(r#"{"units":"in"}"#)).is_ok());
    let segments: Float64Array = get(&job.geometry().ok().unwrap(), "segments").dyn_into().unwrap();
    assert!((segments.get_index(0) - 7.0 * 25.4).abs() < 1e-12);
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
        let job = load(&circle(page, bytes), r#"{"units":"mm"}"#).ok().unwrap();
        let contour = Array::from(&get(&job.report().ok().unwrap(), "contours")).get(0);
        assert_eq!(get(&contour, "layer").as_string().unwrap(), name, "{page}");
    }
}

#[wasm_bindgen_test]
fn files_that_are_no_drawing_are_one_sentence() {
    for bytes in [&b""[..], b"hello", b"%PDF-1.7", b"AC1032\0\0\0\0\0"] {
        let said = sentence(load(bytes, "{}"));
        assert!(said.len() > 10 && said.ends_with('.') && !said.contains('\n'), "{said}");
    }
}
