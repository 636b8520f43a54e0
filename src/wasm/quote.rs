//! Quotes for JavaScript.

use super::plain::plain;
use crate::fields;
use crate::quote;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "import type { Quote } from '../quote.js';";

/// The report of the plan in `plan_json` (`kerfway.plan/1`); `material` is a JSON object, see [`quote::Material`].
#[wasm_bindgen(js_name = quoteOf, unchecked_return_type = "Quote")]
pub fn quote_of(plan_json: &str, material: &str) -> Result<JsValue, JsError> {
    let material = fields::from_json(material).map_err(|e| JsError::new(&e))?;
    plain(&quote::quote(plan_json, &material).map_err(|e| JsError::new(&e))?)
}
