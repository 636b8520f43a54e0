//! Values that cross the boundary: options become checked values.

use super::failure::Failure;
use crate::fields::{self, Fault, FieldError, Shaped, Value};
use js_sys::{Array, Object, Reflect};
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

/// Depth to which nested objects are read; options need five levels. The limit ends objects that contain themselves.
const DEEPEST: u32 = 8;

/// Converts any value to `deepest` levels. Undefined fields are omitted.
pub(super) fn value(given: &JsValue, deepest: u32) -> Value {
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
