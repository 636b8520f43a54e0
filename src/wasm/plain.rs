//! Reports for JavaScript.

use crate::output::json_text;
use js_sys::JSON;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A plain object. By way of JSON text: the writer of plans is there anyway, and a second one, which sets fields one by
/// one, is slower and larger.
pub(super) fn plain(value: &impl Serialize) -> Result<JsValue, JsError> {
    JSON::parse(&json_text(value)).map_err(|_| JsError::new("The report could not be passed on."))
}
