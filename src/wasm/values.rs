//! Values that cross the boundary: options become checked values, and arrays of numbers become typed arrays with their own
//! memory, which the receiver may transfer.

use super::failure::Failure;
use super::plain::object;
use crate::fields::{self, Fault, FieldError, Shaped, Value};
use crate::job::{BestPath, Geometry, JobError, WarmPath};
use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

/// Reads options from a plain object. `undefined` and `null` are an empty object.
pub(super) fn options<T: Shaped>(given: &JsValue) -> Result<T, Failure> {
    let nothing = given.is_undefined() || given.is_null();
    let given = if nothing { Value::Object(Vec::new()) } else { value(given, DEEPEST) };
    Ok(fields::read(given)?)
}

/// Reads a text argument; `name` is used in the message. Bindings that take `&str` would read past their memory if they
/// were given something else.
pub(super) fn text(name: &str, given: &JsValue) -> Result<String, Failure> {
    let says = || format!("The {name} is {}. Give a text.", value(given, 1));
    Ok(given.as_string().ok_or_else(|| FieldError::new(Fault::WrongType, name, says()))?)
}

/// Reads the bytes of a file.
pub(super) fn bytes(given: &JsValue) -> Result<Vec<u8>, Failure> {
    let says = || format!("The file is {}. Give its bytes (Uint8Array).", value(given, 1));
    let bytes = given.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec);
    Ok(bytes.ok_or_else(|| FieldError::new(Fault::WrongType, "file", says()))?)
}

/// Depth to which nested objects are read; options need five levels. The limit ends objects that contain themselves.
const DEEPEST: u32 = 8;

/// Converts any value to `deepest` levels. Undefined fields are omitted.
fn value(given: &JsValue, deepest: u32) -> Value {
    if given.is_undefined() || given.is_null() {
        return Value::Null;
    }
    if let Some(flag) = given.as_bool() {
        return Value::Flag(flag);
    }
    if let Some(number) = given.as_f64() {
        return Value::Number(number);
    }
    if let Some(text) = given.as_string() {
        return Value::Text(text);
    }
    if !given.is_object() || given.is_function() {
        return Value::Other("neither a number nor a text");
    }
    let Some(deepest) = deepest.checked_sub(1) else { return Value::Other("too deep a structure") };
    let list = |array: &Array| Value::List(array.iter().map(|v| value(&v, deepest)).collect());
    if let Some(array) = given.dyn_ref::<Array>() {
        return list(array);
    }
    if js_sys::ArrayBuffer::is_view(given) {
        return list(&Array::from(given));
    }
    let Some(object) = given.dyn_ref::<Object>() else { return Value::Other("no plain object") };
    let entries = Object::entries(object).into_iter().filter_map(|entry| {
        let [name, given] = [0, 1].map(|k| Reflect::get_u32(&entry, k).unwrap_or_default());
        if given.is_undefined() { None } else { Some((name.as_string()?, value(&given, deepest))) }
    });
    Value::Object(entries.collect())
}

/// Paths as typed arrays.
pub(super) fn geometry(g: &Geometry) -> Result<JsValue, JsError> {
    object(&[
        ("segments", Float64Array::from(g.segments.as_slice()).into()),
        ("offsets", Uint32Array::from(g.offsets.as_slice()).into()),
    ])
}

/// The path of the head as typed arrays.
pub(super) fn path(p: &BestPath) -> Result<JsValue, JsError> {
    object(&[
        ("contours", Uint32Array::from(p.contours.as_slice()).into()),
        ("points", Float64Array::from(p.points.as_slice()).into()),
        ("along", Float64Array::from(p.along.as_slice()).into()),
        ("until", Float64Array::from(p.until.as_slice()).into()),
        ("reversed", Uint8Array::from(p.reversed.as_slice()).into()),
        ("times", Float64Array::from(p.times.as_slice()).into()),
        ("leads", Float64Array::from(p.leads.segments.as_slice()).into()),
        ("leadOffsets", Uint32Array::from(p.leads.offsets.as_slice()).into()),
        ("joints", Float64Array::from(p.joints.segments.as_slice()).into()),
        ("jointOffsets", Uint32Array::from(p.joints.offsets.as_slice()).into()),
        ("preCuts", Float64Array::from(p.pre_cuts.as_slice()).into()),
        ("pauses", Float64Array::from(p.pauses.as_slice()).into()),
    ])
}

/// Reads a path that another search hands over. Typed arrays take a millisecond for 10,000 contours, a thirtieth of the
/// time of single numbers.
pub(super) fn handed(value: &JsValue) -> Result<WarmPath, Failure> {
    let field = |name: &str| Reflect::get(value, &JsValue::from_str(name)).unwrap_or_default();
    let numbers = |name: &str| field(name).dyn_into::<Float64Array>().map(|a| a.to_vec());
    let contours = field("contours").dyn_into::<Uint32Array>().map(|a| a.to_vec());
    let reversed = field("reversed").dyn_into::<Uint8Array>().map(|a| a.to_vec());
    match (contours, numbers("along"), reversed) {
        (Ok(contours), Ok(along), Ok(reversed)) => {
            Ok(WarmPath { contours, along, until: numbers("until").unwrap_or_default(), reversed })
        }
        _ => Err(JobError::UnfitPath.into()),
    }
}
