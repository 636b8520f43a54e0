//! Values that cross: plain objects through serde, arrays of numbers as typed arrays of their own memory, which the
//! receiver may transfer.

use crate::job::{BestPath, Geometry};
use js_sys::{Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::*;

/// Options from a plain object; nothing given is an empty object.
pub(super) fn options<T: DeserializeOwned>(value: JsValue) -> Result<T, JsError> {
    let value = if value.is_undefined() || value.is_null() { Object::new().into() } else { value };
    serde_wasm_bindgen::from_value(value)
        .map_err(|e| JsError::new(&format!("The options are not usable: {e}.")))
}

/// An object with these fields.
pub(super) fn object(fields: &[(&str, JsValue)]) -> Result<JsValue, JsError> {
    let object = Object::new();
    for (name, value) in fields {
        Reflect::set(&object, &JsValue::from_str(name), value)
            .map_err(|_| JsError::new("The report could not be passed on."))?;
    }
    Ok(object.into())
}

/// Chains of elements.
pub(super) fn geometry(g: &Geometry) -> Result<JsValue, JsError> {
    object(&[
        ("segments", Float64Array::from(g.segments.as_slice()).into()),
        ("offsets", Uint32Array::from(g.offsets.as_slice()).into()),
    ])
}

/// The order of the head.
pub(super) fn path(p: &BestPath) -> Result<JsValue, JsError> {
    object(&[
        ("contours", Uint32Array::from(p.contours.as_slice()).into()),
        ("points", Float64Array::from(p.points.as_slice()).into()),
        ("along", Float64Array::from(p.along.as_slice()).into()),
        ("until", Float64Array::from(p.until.as_slice()).into()),
        ("reversed", Uint8Array::from(p.reversed.as_slice()).into()),
        ("times", Float64Array::from(p.times.as_slice()).into()),
    ])
}
