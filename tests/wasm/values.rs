//! JavaScript values for tests.

use js_sys::{JSON, Reflect, Uint8Array};
use kerfway::wasm::Job;
use wasm_bindgen::prelude::*;

/// The value of a JSON text.
pub(crate) fn js(json: &str) -> JsValue {
    JSON::parse(json).unwrap()
}

/// A field of an object.
pub(crate) fn get(value: &JsValue, name: &str) -> JsValue {
    Reflect::get(value, &name.into()).unwrap()
}

/// A numeric field.
pub(crate) fn number(value: &JsValue, name: &str) -> f64 {
    get(value, name).as_f64().unwrap()
}

/// A drawing loaded with options as JSON text.
pub(crate) fn load(bytes: &[u8], options: &str) -> Result<Job, JsValue> {
    Job::new(Uint8Array::from(bytes).into(), "drawing.dxf".into(), js(options)).map_err(JsValue::from)
}

/// The sentence of an error.
pub(crate) fn sentence<T>(result: Result<T, impl Into<JsValue>>) -> String {
    let error: JsValue = result.err().expect("an error").into();
    get(&error, "message").as_string().unwrap()
}

/// A circle of 4 mm in a drawing of millimetres, on a layer whose name is written in a code page.
pub(crate) fn circle(code_page: &str, layer: &[u8]) -> Vec<u8> {
    let head = format!("0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\n{code_page}\n0\nENDSEC\n");
    let circle = "\n10\n5\n20\n5\n40\n2\n0\nENDSEC\n0\nEOF\n";
    [head.as_bytes(), b"0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n", layer, circle.as_bytes()].concat()
}

/// A drawing of a keyboard plate.
pub(crate) const KEYBOARD: &[u8] =
    include_bytes!("../fixtures/dxf-dev/peej_lumberjack-keyboard__lumberjack-polaris.dxf");
