//! Reports and objects for JavaScript.

use crate::output::json_text;
use js_sys::JSON;
use js_sys::{Object, Reflect};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A plain object. By way of JSON text: the writer of plans is there anyway, and a second one, which sets fields one by
/// one, is slower and larger.
pub(super) fn plain(value: &impl Serialize) -> Result<JsValue, JsError> {
    JSON::parse(&json_text(value)).map_err(|_| JsError::new("The report could not be passed on."))
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
